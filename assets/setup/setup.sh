# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# What ./play and ./check share: the packages of packages.txt, and building a preset. Sourced, never run.

root=$(realpath -- "$(dirname -- "${BASH_SOURCE[0]}")/../..")

say() { printf '%s\n' "${0##*/}: $*"; }
fail() { printf '%s\n' "${0##*/}: $*" >&2; exit 1; }

# packages_of SECTION…: the names in those sections of packages.txt, `?` still on them.
packages_of() {
  awk -v wanted=" $* " '
    /^[[:space:]]*(#|$)/ { next }
    /^\[/ { on = index(wanted, " " substr($1, 2, length($1) - 2) " "); next }
    on { print $1 }' "$root/assets/setup/packages.txt"
}

# missing_of NAME…: those that are not installed.
missing_of() {
  local installed
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${@%\?}" 2>/dev/null | sed -n 's/^installed //p') || true
  local name
  for name in "$@"; do
    grep -Fxq -- "${name%\?}" <<<"$installed" || printf '%s\n' "$name"
  done
}

# unknown_of NAME…: those that apt has no version of, as far as its lists tell.
unknown_of() {
  local known name
  known=$(apt-cache policy "${@%\?}" 2>/dev/null |
    awk '/^[^ ]/ { name = $1; sub(/:$/, "", name) } /^  Candidate:/ && $2 != "(none)" { print name }')
  for name in "$@"; do
    grep -Fxq -- "${name%\?}" <<<"$known" || printf '%s\n' "$name"
  done
}

# as_root COMMAND…: as it is for root, else through sudo.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

may_install() {
  [ "$(id -u)" -eq 0 ] || { command -v sudo >/dev/null && sudo env true; }
}

apt_get() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=120 "$@"
}

update_lists() {
  say "fetching the package lists (apt-get update)"
  apt_get update || fail "apt-get update failed; is the network there? Nothing was installed."
}

have_lists() {
  compgen -G '/var/lib/apt/lists/*_Packages*' >/dev/null
}

# install_packages NAME…: all in one go; if that fails, with fresh lists; if that fails too, one by one, to name the one.
install_packages() {
  apt_get install --no-install-recommends -y "$@" && return
  update_lists
  apt_get install --no-install-recommends -y "$@" && return
  local name
  for name in "$@"; do
    apt_get install --no-install-recommends -y "$name" || fail "apt-get could not install the package $name (its reason is above)."
  done
}

# set_up SECTION…: makes sure that the packages of those sections are there. Says what it installs; silent and quick
# when nothing is missing.
set_up() {
  local wanted missing unknown name
  mapfile -t wanted < <(packages_of "$@")
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "no apt-get here, so nothing is installed; polhode needs what Debian calls: ${wanted[*]%\?}"
    return
  fi
  mapfile -t missing < <(missing_of "${wanted[@]}")
  [ ${#missing[@]} -gt 0 ] || return 0

  # Who may not install is told the command, unless only what may be left out is missing.
  if ! may_install; then
    printf '%s\n' "${missing[@]}" | grep -q '[^?]$' || return 0
    fail "packages are missing, and this user can be root neither by itself nor through sudo. As root, run:
  apt-get update && apt-get install --no-install-recommends -y ${missing[*]%\?}"
  fi

  # The lists are fetched only if there are none, or if they lack something that has to be there.
  have_lists || update_lists
  mapfile -t unknown < <(unknown_of "${missing[@]}")
  if printf '%s\n' "${unknown[@]}" | grep -q '[^?]$'; then
    update_lists
    mapfile -t unknown < <(unknown_of "${missing[@]}")
  fi
  for name in "${unknown[@]}"; do
    case $name in
      *\?) say "left out: this release has no package ${name%\?}" ;;
      *) fail "apt knows no package $name: its lists could not be fetched, or this release has none (Ubuntu: \"universe\" is off?)" ;;
    esac
  done

  local install=()
  for name in "${missing[@]}"; do
    printf '%s\n' "${unknown[@]}" | grep -Fxq -- "$name" || install+=("${name%\?}")
  done
  [ ${#install[@]} -gt 0 ] || return 0
  say "installing ${#install[@]} packages: ${install[*]}"
  install_packages "${install[@]}"
}

# configure PRESET: makes build/PRESET ready. Starts afresh if the repository was moved or copied with it.
configure() {
  local dir=$root/build/$1 fresh=()
  if [ -f "$dir/CMakeCache.txt" ] && ! grep -Fxq "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$dir/CMakeCache.txt"; then
    fresh=(--fresh)
  fi
  mkdir -p "$root/build"
  cmake --preset "$1" "${fresh[@]}" >"$root/build/configure-$1.log" 2>&1 ||
    { cat "$root/build/configure-$1.log" >&2; fail "cmake could not configure the preset $1"; }
}

# build PRESET [TARGET…]: configures and builds build/PRESET, or those targets of it.
build() {
  say "building in build/$1"
  configure "$1"
  local targets=("${@:2}")
  cmake --build --preset "$1" ${targets[@]+--target "${targets[@]}"} || fail "the build failed"
}
