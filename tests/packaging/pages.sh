#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The manual pages hold every command and, in its own section, the flags that its --help lists and
# no others; groff reads them without a warning; bash completes commands, flags and words.
source "$(dirname "$0")/support.sh"

need groff
# The lists of both, not what their descriptions mention.
flags_of() { "$@" --help | sed -nE 's/^  (-[^ ]*).*/\1/p' | tr , '\n' | grep '^--' | sort -u; }
flags_on_page() { # PAGE SECTION
  awk -v name="$2" '/^\.S[HS] / { inside = $2 == name } inside && title; { title = /^\.TP/ }' \
    "$work/$1.1" | sed 's/\\-/-/g' | grep -oE -- '--[a-z][a-z-]*' | sort -u
}
read_page() {
  gzip -dc "$PREFIX/share/man/man1/$1.1.gz" >"$work/$1.1"
  groff -man -Kutf8 -Tutf8 -ww -rLL=200n -P-cbou "$work/$1.1" >/dev/null 2>"$work/warnings"
  [[ ! -s $work/warnings ]] || complain "$1.1: $(cat "$work/warnings")"
}
check_flags() { # PROGRAM [COMMAND]
  diff <(flags_of "$BUILD/bin/$1" "${@:2}") <(flags_on_page "$1" "${2:-OPTIONS}") >"$work/differ" ||
    complain "$1.1: --help of \"$*\" lists other flags: $(cat "$work/differ")"
}
commands=$({ "$BUILD/bin/sonde" nothing 2>&1 || true; } | sed -n 's/.*the commands are //p' | tr -d ,)
sources=("$SOURCE"/app/command_*.cpp) # one for each command, and command_line.cpp
[[ $(wc -w <<<"$commands") -eq $((${#sources[@]} - 1)) ]] || complain "not the commands: $commands"
read_page sonde
check_flags sonde
for command in $commands; do check_flags sonde "$command"; done
if [[ -x $BUILD/bin/sonde-view ]]; then
  read_page sonde-view
  check_flags sonde-view
fi

# complete LINE...: what the completion answers for the last word.
complete_words() {
  local program=$1
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
  "_${program//-/_}"
  echo "${COMPREPLY[*]:-}"
}
# shellcheck disable=SC1090
source "$PREFIX/share/bash-completion/completions/sonde"
same_output "$commands" complete_words sonde ""
same_output "trade traces tune" complete_words sonde t
same_output "--budget-us --budget-steps" complete_words sonde query --bu
same_output "pdg pdt" complete_words sonde query --method ""
same_output "" complete_words sonde query scene
if [[ -x $BUILD/bin/sonde-view ]]; then
  # shellcheck disable=SC1090
  source "$PREFIX/share/bash-completion/completions/sonde-view"
  same_output "--screenshot" complete_words sonde-view --s
fi
