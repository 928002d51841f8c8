#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# packaging/fuzz fails where a target does, and where one prints a runtime error and goes on. The
# targets are played by scripts, in a tree of their own; nothing is built.
source "$(dirname "$0")/support.sh"

tree=$work/tree
mkdir -p "$tree"/{packaging,programs,tests/fuzz,build/fuzz/bin}
cp "$SOURCE/packaging/fuzz" "$tree/packaging"
printf '#!/bin/sh\n' >"$tree/programs/cmake"
target() {
  touch "$tree/tests/fuzz/$1_fuzz.cpp"
  printf '#!/bin/sh\necho "stat::number_of_executed_units: 10"\n%s\n' "$2" \
    >"$tree/build/fuzz/bin/fuzz_$1"
}
target sound 'exit 0'
target undefined 'echo "a.cpp:1:2: runtime error: signed integer overflow"'
target crashing 'echo "==1==ERROR: AddressSanitizer: heap-use-after-free"; exit 77'
target strict 'case $UBSAN_OPTIONS in *halt_on_error=1*) exit 0 ;; esac; exit 1'
chmod +x "$tree/programs/cmake" "$tree"/build/fuzz/bin/*
fuzz() { PATH="$tree/programs:$PATH" "$tree/packaging/fuzz" 10 "$@"; }

said=$(fuzz sound strict) || complain "two that find nothing: $said"
[[ $(grep -c 'nothing found' <<<"$said") -eq 2 ]] || complain "two that find nothing: $said"
! said=$(fuzz undefined) || complain "undefined behaviour is no failure"
[[ $said == *'signed integer overflow'* ]] || complain "it is not told: $said"
! said=$(fuzz crashing) || complain "a crash is no failure"
! said=$(fuzz) || complain "one of several is no failure"
