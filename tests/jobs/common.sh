# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# What the tests of job scripts share. Sourced with the program as $1. Everything happens in $scratch, which goes away.

skip() { echo "skipped: $*"; exit 77; }
fail() { echo "FAILED: $*"; exit 1; }
need() {
  local name
  for name in "$@"; do command -v "$name" >/dev/null || skip "$name is not installed"; done
}

[ $# -eq 1 ] || { echo "usage: ${0##*/} PROGRAM" >&2; exit 2; }
POLHODE=$(realpath -- "$1")
source_root=$(realpath -- "$(dirname -- "${BASH_SOURCE[0]}")/../..")
jobs=$source_root/assets/jobs
scratch=$(mktemp -d)
chmod 755 "$scratch"
export POLHODE POLHODE_LESSONS=$source_root/lessons

# Ten small frames and their names in a lesson's text; 320 x 180 makes the start of a process the longest part.
lesson=euler-equations
options=(--what figure --stage poinsot --each frame --fps 5 --seconds 2 --size 320x180)

# export_alone DIR: by one process, without shards.
export_alone() {
  "$POLHODE" export "$lesson" -o "$1" "${options[@]}" 2>"$1.log" || { cat "$1.log"; fail "one process alone failed"; }
}

# export_shard I/N DIR: one shard alone, as a run leaves it that was cut short. Prints its pictures and their times.
export_shard() {
  "$POLHODE" export "$lesson" -o "$2" --shard "$1" "${options[@]}" 2>"$2.log" || { cat "$2.log"; fail "shard $1 failed"; }
  times_of "$2"
}

# times_of DIR: names and times of its pictures.
times_of() { find "$1" -name '*.png' -printf '%f %T@\n' | sort; }

# expect_kept TIMES DIR: pictures with these times are there still.
expect_kept() {
  [ -n "$1" ] || fail "no picture was there before"
  [ "$(comm -23 <(printf '%s\n' "$1") <(times_of "$2"))" = "" ] || fail "pictures that were there were drawn again"
}

# expect_shares LOG…: the processes made ten pictures in all, not ten each; each ends by saying how many it made.
expect_shares() {
  local made
  made=$(cat -- "$@" | sed -n 's/^\([0-9]*\) pictures\{0,1\} .*/\1/p' | awk '{ sum += $1 } END { print sum }')
  [ "$made" = 10 ] || { cat -- "$@"; fail "$made pictures were made, not 10"; }
}

# expect_equal WANT GOT: the same names and the same bytes, the manifest included, and nothing else left behind.
expect_equal() {
  diff -r "$1" "$2" || fail "$2 differs from what one process made"
  [ "$(find "$1" -name '*.png' | wc -l)" -eq 10 ] || fail "ten frames were to be compared"
}
