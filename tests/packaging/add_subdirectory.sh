#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A project with Sonde's sources in a folder configures and compiles against sonde::engine. Of Sonde
# it builds the library alone, without what the programs need (CLI11); its own folder for libraries
# stays as it is. add_subdirectory_whole builds all of it.
source "$(dirname "$0")/support.sh"

cmake -S "$here/inside" -B "$work/build" -G Ninja -DSONDE="$SOURCE" -DCMAKE_CXX_COMPILER="$CXX" \
  -DEXAMPLE="$SOURCE/tests/engine/depth_of_two_files.cpp" -DCMAKE_INSTALL_LIBDIR=lib \
  -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON >"$work/log" 2>&1 || complain "$(cat "$work/log")"
linked() {
  ninja -C "$work/build" -t commands all | grep -oE ' (-o|qc) [^ ]+' | grep -v '\.o$' | sort
}
same_output " -o inside
 qc sonde/engine/libsonde_engine.a" linked
grep -q '^CMAKE_INSTALL_LIBDIR:[A-Z]*=lib$' "$work/build/CMakeCache.txt" ||
  complain "another folder for libraries"
goal=inside
[[ ${WHOLE:-} == yes ]] || goal=$(ninja -C "$work/build" -t targets all |
  sed -n 's/^\(CMakeFiles\/inside.*depth_of_two_files\.cpp\.o\):.*/\1/p')
[[ -n $goal ]] || complain "no such object"
cmake --build "$work/build" --target "$goal" >"$work/log" || complain "$(cat "$work/log")"
if [[ ${WHOLE:-} == yes ]]; then
  models=$SOURCE/resources/models
  same_output "$("$BUILD/bin/sonde_example" "$models/trefoil.ply" "$models/torus.ply")" \
    "$work/build/inside" "$models/trefoil.ply" "$models/torus.ply"
fi
