#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The same members at the same places, and the same answers to the bit, whatever flags a program is
# compiled with, linked to the one library that is installed.
source "$(dirname "$0")/support.sh"

need pkg-config
export PKG_CONFIG_PATH=$PREFIX/$LIBDIR/pkgconfig LD_LIBRARY_PATH=$PREFIX/$LIBDIR
read -ra library < <(pkg-config --cflags --libs sonde)
program=$SOURCE/tests/packaging/outside/layout.cpp
warnings=(-Wall -Wextra -Wconversion -Wpedantic -Werror)

# build COMPILER FLAG...
build() { "$1" "${@:2}" "$program" -o "$work/program" "${library[@]}"; }
# runs_here FLAG: this processor has what the flag lets the compiler use.
runs_here() {
  case $1 in
    -mavx*) grep -qw "${1#-m}" /proc/cpuinfo ;;
    *) true ;;
  esac
}

# (Eigen itself is not clean with other instruction sets.)
build "$CXX" -std=c++20 "${warnings[@]}"
want=$("$work/program")
[[ $want == *"followed 0.01"* ]] || complain "no overlap of 10 mm: $want"
[[ $want == *"mended: "* ]] || complain "nothing mended: $want"
tried=0
for flags in "-std=c++20 -O0" "-std=c++20 -O0 -D_GLIBCXX_ASSERTIONS" "-std=c++23 -O2" \
  "-std=c++20 -O3 -march=native" "-std=c++20 -O1 -mavx2" "-std=c++20 -O1 -mfma -mavx512f" \
  "-std=c++20 -O1 -DEIGEN_DONT_ALIGN" "-std=c++20 -O1 -DEIGEN_MAX_ALIGN_BYTES=0" \
  "-std=c++20 -O1 -mavx -DEIGEN_MAX_ALIGN_BYTES=64" "-std=c++20 -O1 -DEIGEN_DONT_VECTORIZE" \
  "-std=c++20 -O1 -D_GLIBCXX_DEBUG" "-std=c++20 -O1 -DEIGEN_DEFAULT_TO_ROW_MAJOR" \
  "-std=c++20 -O1 -DEIGEN_NO_DEBUG -DNDEBUG"; do
  read -ra each <<<"$flags"
  runs_here "${each[-1]}" || continue
  # -ffp-contract=off: what the header itself computes, a pose that is made a unit, is no matter of
  # the layout.
  build "$CXX" "${each[@]}" -ffp-contract=off
  same_output "$want" "$work/program"
  tried=$((tried + 1))
done
[[ $tried -ge 11 ]] || complain "only $tried of the flags could be tried here"
if command -v clang++ >/dev/null; then
  build clang++ -std=c++20 -O2 -ffp-contract=off
  same_output "$want" "$work/program"
fi

# Before C++20 there is one line that says so.
if said=$("$CXX" -std=c++17 -fsyntax-only "$program" "${library[@]}" 2>&1); then
  complain "a program in C++17 was accepted"
fi
[[ $(grep -c 'error' <<<"$said") -eq 1 && $said == *"C++20"* ]] ||
  complain "not one line for a program in C++17: $(head -5 <<<"$said")"
