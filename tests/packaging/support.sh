# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Sourced by the tests of this folder.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

complain() {
  echo "$*" >&2
  exit 1
}

need() {
  command -v "$1" >/dev/null || complain "$1 is missing: packaging/deps installs it"
}

# Whether there is a display to open a window on. In CI there is one.
has_display() {
  [[ -z ${DISPLAY:-} ]] || return 0
  [[ ${CI:-} != true ]] || complain "no display: packaging/test starts one"
  return 1
}

# same_output EXPECTED COMMAND...
same_output() {
  local expected=$1 got
  shift
  got=$("$@")
  [[ $got == "$expected" ]] || complain "$*: \"$got\" instead of \"$expected\""
}

# One pose of the spoon in the cup, penetrating; the depth that the program of the build finds.
poses=$work/poses.csv
sed -n '1p;3000p' "$SOURCE/resources/scenes/spoon-in-cup.path.csv" | cut -d, -f2- >"$poses"
