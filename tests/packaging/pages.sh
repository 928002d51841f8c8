#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The manual pages hold every command and flag that --help lists, and groff reads them without a
# warning; bash completes commands, flags and words.
source "$(dirname "$0")/support.sh"

need groff
flags_of() { "$@" --help | grep -oE -- '(^|[ ,])--[a-z][a-z-]*' | tr -d ' ,' | sort -u; }
page_of() {
  gzip -dc "$PREFIX/share/man/man1/$1.1.gz" >"$work/$1.1"
  groff -man -Kutf8 -Tutf8 -ww -rLL=200n -P-cbou "$work/$1.1" 2>"$work/warnings"
  [[ ! -s $work/warnings ]] || complain "$1.1: $(cat "$work/warnings")"
}
check_page() { # PROGRAM [COMMAND...]
  local program=$1 page flag
  page=$(page_of "$program")
  shift
  for flag in $(flags_of "$BUILD/bin/$program" "$@" | grep -vxF -- --help); do
    grep -qF -- "$flag" <<<"$page" || complain "$program.1 does not know $flag ($*)"
  done
}
commands=$({ "$BUILD/bin/sonde" nothing 2>&1 || true; } | sed -n 's/.*the commands are //p' | tr -d ,)
[[ $(wc -w <<<"$commands") -eq 11 ]] || complain "not the commands: $commands"
check_page sonde
for command in $commands; do check_page sonde "$command"; done
if [[ -x $BUILD/bin/sonde-view ]]; then check_page sonde-view; fi

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
