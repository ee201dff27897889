#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs the physics, moves what was installed elsewhere, and builds against it what a stranger would:
#   examples/              a project of its own, by find_package
#   docs/interface.md      its program, by its CMakeLists.txt and by its line with pkg-config
#   each public header     the example in its comment, which includes nothing else of ours
# The programs are left in SCRATCH/programs for examples_test.cpp to run.
set -euo pipefail
sources=$1 build=$2 scratch=$3

rm -rf -- "$scratch"
mkdir -p "$scratch"/{programs,headers,page}
cmake --install "$build" --component physics --prefix "$scratch/first" >"$scratch/install.log"
mv -- "$scratch/first" "$scratch/prefix"
if grep -rIlF -e "$sources" -e "$build" -e "$scratch/first" "$scratch/prefix"; then
  echo "the files above name a folder that their user does not have" >&2
  exit 1
fi

# by_cmake FOLDER PROGRAMS...
by_cmake() {
  local folder=$1
  shift
  cmake -S "$folder" -B "$scratch/build/$1" -DCMAKE_PREFIX_PATH="$scratch/prefix"
  cmake --build "$scratch/build/$1"
  (cd "$scratch/build/$1" && cp -- "$@" "$scratch/programs")
}

# by_pkg_config SOURCE PROGRAM FLAGS...
by_pkg_config() {
  local flags
  flags=$(PKG_CONFIG_PATH=$(dirname "$(find "$scratch/prefix" -name polhode-physics.pc)") \
    pkg-config --cflags --libs --static polhode-physics | sed 's|-I\([^ ]*/eigen3\)|-isystem \1|') # its warnings are its own
  # shellcheck disable=SC2086  # flags are words
  "$CXX" -std=c++20 "${@:3}" -o "$scratch/programs/$2" "$1" $flags
}

# block LANGUAGE: what stands in the page between ```LANGUAGE and ```
block() {
  sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/{/^\`\`\`/d;p}" "$sources/docs/interface.md"
}

by_cmake "$sources/examples" tumbling_phone work_precision asteroids heavy_top polhode_csv

block cpp >"$scratch/page/main.cpp"
block cmake >"$scratch/page/CMakeLists.txt"
by_cmake "$scratch/page" thrown_book
by_pkg_config "$scratch/page/main.cpp" thrown_book_by_pkg_config -O2

for header in body motion method poinsot errors; do
  {
    echo "#include <polhode/$header.h>"
    echo 'int main() {'
    sed -n '/^\/\/ Example:/,/^#pragma/s|^//     ||p' "$sources/physics/public/$header.h"
    echo 'return is_sane ? 0 : 1; }'
  } >"$scratch/headers/$header.cpp"
  by_pkg_config "$scratch/headers/$header.cpp" "header_$header" -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
done
