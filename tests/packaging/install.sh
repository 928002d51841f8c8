#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is built below PREFIX, for the tests that follow: the public header and no other.
source "$(dirname "$0")/support.sh"

rm -rf "$PREFIX"
cmake --install "$BUILD" --prefix "$PREFIX" >"$work/log"
same_output "$PREFIX/include/sonde/sonde.hpp" find "$PREFIX/include" -type f
if broken=$(find "$PREFIX" -xtype l | grep .); then complain "links that lead nowhere: $broken"; fi
