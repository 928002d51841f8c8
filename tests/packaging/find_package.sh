#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A project outside finds the installed library, compiles against its one header with only Eigen
# beside it, links without naming another library, and finds the depth that the same
# source finds with the engine of the build.
source "$(dirname "$0")/support.sh"

example=$PREFIX/share/doc/libsonde-dev/examples/depth_of_two_files.cpp
cmake -S "$here/outside" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$PREFIX" \
  -DEXAMPLE="$example" -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
  >"$work/log" || complain "$(cat "$work/log")"
cmake --build "$work/build" >"$work/log" || complain "$(cat "$work/log")"
! grep -qiE 'cgal|hidapi|qt|vtk' "$work/build/compile_commands.json" || complain "more than Eigen"
"$work/build/every"

models=$SOURCE/resources/models
outside=$("$work/build/outside" "$models/trefoil.ply" "$models/torus.ply")
awk -v depth="$outside" 'BEGIN { exit !(depth > 0) }' || complain "no depth: $outside"
same_output "$outside" "$BUILD/bin/sonde_example" "$models/trefoil.ply" "$models/torus.ply"
