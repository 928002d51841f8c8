#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# same_words.sh SONDE OTHER...: runs command lines by the sonde of this computer and by that of another
# platform (OTHER: its command, by absolute paths), each in a folder of its own, and compares exit
# codes, what is written on both streams, and files. Times are left out, and paths have one kind of
# separators.
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
here=$1
shift
there=("$@")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
letters=$'a b é深\U0001d6fc'
failed=0

prepare() {
  mkdir -p "$1/$letters" "$1/full"
  ln -s "$root/resources/models" "$root/resources/scenes" "$1/"
  cp "$root/resources/models/peg.ply" "$1/$letters/peg ö.ply"
  cp "$root/resources/models/block.ply" "$1/$letters/"
  : >"$1/empty.obj"
  printf 'v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n' >"$1/crlf.obj"
  printf 'v 0 0 0\nf 1 2 9\n' >"$1/wrong.obj"
  printf 'px,py,pz,qw,qx,qy,qz\n0,0,0.2,1,0,0,0\n0.001,0,0,1,0,0,0\n' >"$1/poses.csv"
  printf 'px,py,pz,qw,qx,qy,qz\n0,0,zero,1,0,0,0\n' >"$1/wrong.csv"
  printf '{"probe": {"mesh": "none.ply"}, "fixed": {"mesh": "crlf.obj"}}' >"$1/wrong.sonde.json"
}
told() { # the streams and the exit code of a command, in a folder
  local folder=$1 code=0
  shift
  (cd "$folder" && "$@" <poses.csv >out.txt 2>err.txt) || code=$?
  echo "exit $code"
  # By cat -A, so that an added carriage return is seen.
  for stream in out err; do
    echo "$stream:"
    sed -E 's/[0-9.]+ (ns|µs|us|ms|s)\b/TIME/g; s#\\#/#g' "$folder/$stream.txt" | cat -A
  done
  rm "$folder/out.txt" "$folder/err.txt"
}
same() {
  local one two
  one=$(told "$work/here" "$here" "$@")
  two=$(told "$work/there" "${there[@]}" "$@")
  if [[ $one == "$two" ]]; then
    printf 'same, %s: sonde %s\n' "$(head -1 <<<"$one")" "$*"
    return
  fi
  failed=1
  printf 'differs: sonde %s\n' "$*"
  diff <(echo "$one") <(echo "$two") || true
}

prepare "$work/here"
prepare "$work/there"
query=(query --probe "$letters/peg ö.ply" --fixed "$letters/block.ply" --budget-steps 20 --quiet)
same --version
same
same nonsense
same query
same query --threads -1
same info "models/nut.ply"
same info "$letters/peg ö.ply" "$letters/block.ply"
same info crlf.obj
same info empty.obj
same info wrong.obj
same info none.obj
same info full
same info ''
same info --frobnicate
same touch
same "${query[@]}" --touch --poses poses.csv
same "${query[@]}" --touch --poses -
same "${query[@]}" --clearance --touch --poses poses.csv --json --out "$letters/ü.json"
same "${query[@]}" --touch --poses poses.csv --out "$letters/ü.csv"
same "${query[@]}" --touch --poses poses.csv --out "$letters/ü.csv"
same "${query[@]}" --touch --poses poses.csv --out none/out.csv
same "${query[@]}" --touch --poses poses.csv --out full
same "${query[@]}" --touch --poses wrong.csv
same "${query[@]}" --touch --poses none.csv
same query wrong.sonde.json --poses poses.csv
same replay wrong.sonde.json
same replay none.sonde.json
same replay scenes/terrain.sonde.json --frobnicate
same replay scenes/terrain.sonde.json --out none/replay.csv --quiet
same tune scenes/spoon-in-cup.sonde.json --device none --out tuned
if ! diff -r --exclude=models --exclude=scenes "$work/here" "$work/there"; then
  echo "files differ"
  failed=1
fi
exit "$failed"
