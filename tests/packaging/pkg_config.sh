#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The same by pkg-config and a compiler alone. A folder for libraries that is named on CMake's
# command line is where they are installed, and where pkg-config says that they are.
source "$(dirname "$0")/support.sh"

need pkg-config
export PKG_CONFIG_PATH=$PREFIX/$LIBDIR/pkgconfig
same_output "$VERSION" pkg-config --modversion sonde
read -ra flags < <(pkg-config --cflags --libs sonde)
example=$PREFIX/share/doc/libsonde-dev/examples/depth_of_two_files.cpp
"$CXX" -std=c++20 "$example" -o "$work/depth" "${flags[@]}"
models=$SOURCE/resources/models
export LD_LIBRARY_PATH=$PREFIX/$LIBDIR
same_output "$("$BUILD/bin/sonde_example" "$models/trefoil.ply" "$models/torus.ply")" \
  "$work/depth" "$models/trefoil.ply" "$models/torus.ply"

cmake -S "$SOURCE" -B "$work/build" -G Ninja -DCMAKE_CXX_COMPILER="$CXX" \
  -DCMAKE_INSTALL_LIBDIR=lib -DSONDE_BUILD_VIEW=OFF -DSONDE_BUILD_TESTS=OFF \
  >"$work/log" 2>&1 || complain "$(cat "$work/log")"
# shellcheck disable=SC2016
grep -qxF 'libdir=${prefix}/lib' "$work/build/sonde.pc" ||
  complain "not in lib: $(cat "$work/build/sonde.pc")"
# shellcheck disable=SC2016
same_output '"${CMAKE_INSTALL_PREFIX}/lib"' sh -c "grep -oE '\"[^\"]*\" TYPE SHARED_LIBRARY' \
  '$work/build/cmake_install.cmake' | cut -d' ' -f1 | sort -u"
