#!/usr/bin/env bash
# build.sh SOURCES OUT: builds the page of the browser host into OUT/page, from the Debian source packages in SOURCES.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
# Debian's emscripten finds its own JavaScript by these.
export NODE_PATH=/usr/share/nodejs CCACHE_COMPILERTYPE=clang
# A build inside one of CMake: the outer one's jobs are not ours.
unset MAKEFLAGS

if [[ ! -f $2/build.ninja ]]; then
    emcmake cmake -G Ninja -S "$here" -B "$2" -DRUBBLE_SOURCES="$1" >"$2.log" 2>&1 || {
        cat "$2.log" >&2
        exit 1
    }
fi
NINJA_STATUS='rubble: building the page %p (%f of %t, %es) ' cmake --build "$2" --target host_web_page
