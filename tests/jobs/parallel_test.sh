#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# assets/jobs/export-parallel: the bytes of one process; goes on where it stopped; a shard that fails is told.
set -euo pipefail
# shellcheck source=tests/jobs/common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"
trap 'rm -rf -- "$scratch"' EXIT
need parallel
export HOME=$scratch PARALLEL_HOME=$scratch/parallel  # leaves nothing behind

run() { "$jobs/export-parallel" "$@" >"$scratch/log" 2>&1; }

export_alone "$scratch/alone"
run 4 "$lesson" "$scratch/shared" "${options[@]}" || { cat "$scratch/log"; fail "four shards"; }
expect_equal "$scratch/alone" "$scratch/shared"
expect_shares "$scratch/log"

kept=$(export_shard 2/3 "$scratch/resumed")
run 3 "$lesson" "$scratch/resumed" "${options[@]}" || { cat "$scratch/log"; fail "going on where it stopped"; }
expect_equal "$scratch/alone" "$scratch/resumed"
expect_kept "$kept" "$scratch/resumed"

if run 4 "$lesson" "$scratch/failed" --size 1x0; then fail "a shard failed, and nobody was told"; fi
if run four "$lesson" "$scratch/failed"; then fail "four is no number of shards"; fi
