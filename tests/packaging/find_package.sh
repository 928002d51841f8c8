#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A project outside finds the installed library, compiles against its one header with only Eigen
# beside it, links without naming another library, and finds the depth that the same
# source finds with the engine of the build.
source "$(dirname "$0")/support.sh"

example=$PREFIX/share/doc/libsonde-dev/examples/depth_of_two_files.cpp
cmake -S "$here/outside" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$PREFIX" \
  -DEXAMPLE="$example" -DCMAKE_CXX_COMPILER="$CXX" >"$work/log" || complain "$(cat "$work/log")"
cmake --build "$work/build" >"$work/log" || complain "$(cat "$work/log")"
# Every header that the compiler read (its -M). Most of what Sonde is built with lies in
# /usr/include, where a compiler looks without being told.
ninja -C "$work/build" -t deps >"$work/read"
grep -q '/Eigen/' "$work/read" || complain "no header of Eigen: $(cat "$work/read")"
foreign='/((boost|cgal|cli|hidapi|nlohmann|qt[0-9]|tbb|vtk[^/]*)/|(gmp[^/]*|mpfr|zlib)\.h$)'
if more=$(grep -iE "$foreign" "$work/read"); then complain "more than Eigen: $more"; fi
"$work/build/every"

models=$SOURCE/resources/models
outside=$("$work/build/outside" "$models/trefoil.ply" "$models/torus.ply")
awk -v depth="$outside" 'BEGIN { exit !(depth > 0) }' || complain "no depth: $outside"
same_output "$outside" "$BUILD/bin/sonde_example" "$models/trefoil.ply" "$models/torus.ply"
