#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# mypy, as strict as it is, finds nothing to complain of in the package and the examples, knows the
# types of what is asked, and does complain of a name that is not there.
#   PYTHONPATH=FOLDER SOURCE=FOLDER types.sh
set -euo pipefail

command -v mypy >/dev/null || {
  echo "mypy is missing: packaging/deps installs it" >&2
  exit 1
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export MYPYPATH=$PYTHONPATH MYPY_CACHE_DIR=$work/cache
unset PYTHONPATH
check() { mypy --python-executable /usr/bin/python3 "$@"; }

check --strict -p sonde
check --ignore-missing-imports "$SOURCE"/app/python/*.py
cat >"$work/caller.py" <<'END'
import numpy
import sonde

body = sonde.Body.read("spoon.ply")
pair = sonde.Pair(body, body)
depth: float = pair.separate(numpy.zeros(7)).depth
word: int = pair.separate(numpy.zeros(7)).status
pair.depths(numpy.zeros((3, 7)))
END
said=$(check "$work/caller.py" || true)
for expected in 'caller.py:7: error: Incompatible types' 'caller.py:8: error: "Pair" has no' \
  'Found 2 errors'; do
  [[ $said == *"$expected"* ]] || {
    printf 'instead of "%s":\n%s\n' "$expected" "$said" >&2
    exit 1
  }
done
