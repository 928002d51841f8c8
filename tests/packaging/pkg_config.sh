#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The same by pkg-config and a compiler alone.
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
