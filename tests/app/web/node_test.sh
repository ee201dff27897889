#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# node_test.sh NODE SOURCES POLHODE: what ./web has built, run in node.
set -euo pipefail
node=$1 sources=$2 polhode=$3
skip() { printf 'LiveInNode: skipped: %s\n' "$*" && exit 0; }
[ -f "$sources/build/web/polhode.js" ] || skip "the program for browsers is not built here (./web builds it)"
[ -x "$node" ] || skip "there is no node"
# What emscripten of Debian 12 writes takes a fetch for a browser's.
if [ -f "$sources/build/web/web_tests.js" ]; then
  "$node" -e 'delete globalThis.fetch; require(process.argv[1])' "$sources/build/web/web_tests.js"
fi
exec "$node" "$sources/tests/app/web/live_test.js" "$sources/build/web/polhode.js" "$polhode" "$sources/lessons"
