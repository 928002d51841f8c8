#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What is installed is hardened as by Debian's hardening=+all: loaded anywhere (PIE), its tables
# closed to writing once linked (RELRO, BIND_NOW), stacks guarded, libc's checked functions in use;
# no stack may be run.
source "$(dirname "$0")/support.sh"

check() {
  local file=$1 header dynamic symbols
  header=$(readelf -hlW "$file")
  dynamic=$(readelf -dW "$file")
  symbols=$(nm -D --undefined-only "$file")
  grep -q 'Type: *DYN' <<<"$header" || complain "$file is not position-independent"
  grep -q 'GNU_RELRO' <<<"$header" || complain "$file: no RELRO"
  grep -qE 'FLAGS.*(BIND_NOW|NOW)' <<<"$dynamic" || complain "$file: not bound at once"
  grep -q 'GNU_STACK.* RW ' <<<"$header" || complain "$file: a stack that may be run"
  ! grep -qE '(RPATH|RUNPATH|TEXTREL)' <<<"$dynamic" || complain "$file: RPATH or TEXTREL"
  grep -q '__stack_chk_fail' <<<"$symbols" || complain "$file: no stack protector"
  grep -qE '__[a-z]+_chk@' <<<"$symbols" || complain "$file: no checked functions of libc"
}
checked=0
for file in "$PREFIX"/bin/* "$PREFIX/$LIBDIR"/libsonde.so.*.* \
  $(find "$PREFIX" -name '_sonde*.so'); do
  check "$file"
  checked=$((checked + 1))
done
[[ $checked -ge 2 ]] || complain "nothing was checked"
