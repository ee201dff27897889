#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What find_package says where the installed polhode is not what was asked for.
set -euo pipefail
scratch=$1

# refused ARGUMENTS OF FIND_PACKAGE, WORDS OF THE MESSAGE
refused() {
  mkdir -p "$scratch/refused"
  printf 'cmake_minimum_required(VERSION 3.16)\nproject(refused LANGUAGES CXX)\nfind_package(polhode %s)\n' "$1" \
    >"$scratch/refused/CMakeLists.txt"
  local said
  if said=$(cmake -S "$scratch/refused" -B "$scratch/refused/build" -DCMAKE_PREFIX_PATH="$scratch/prefix" 2>&1); then
    echo "find_package(polhode $1) is not refused" >&2
    return 1
  fi
  said=$(tr -s ' \n' ' ' <<<"$said") # CMake breaks its lines
  if ! grep -qF -- "$2" <<<"$said"; then
    printf 'find_package(polhode %s) says:\n%s\nwithout: %s\n' "$1" "$said" "$2" >&2
    return 1
  fi
}

refused '0.1 CONFIG REQUIRED COMPONENTS physics chemistry' 'has no component "chemistry"; it has: physics'
refused '0.2 CONFIG REQUIRED COMPONENTS physics' 'compatible with requested version "0.2"'
refused '1.0 CONFIG REQUIRED' 'compatible with requested version "1.0"'
