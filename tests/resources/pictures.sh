#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# pictures.sh SOURCE BUILD: packaging/pictures, in a copy of the tree, draws every picture of the
# manual that takes no longer than a minute. Those that show no figure of a long run are, to the
# byte, those that are committed.
set -euo pipefail

source=$1 build=$2
complain() {
  echo "pictures.sh: $1" >&2
  exit 1
}
[[ -n ${DISPLAY:-} ]] || complain "no display: packaging/test starts one"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
copy=$work/copy
mkdir "$copy"
cp -r "$source/"{packaging,resources,engine,ui,app,CMakeLists.txt} "$copy"
rm "$copy"/resources/docs/images/{sonde-view,mended}.png "$copy"/resources/scenes/*.png \
  "$copy"/resources/docs/images/{compare,traces}-spoon-in-cup.svg \
  "$copy"/packaging/desktop/hicolor/*/apps/*.png
"$copy/packaging/pictures" "$build"
for name in two-depths architecture; do
  cmp "$source/resources/docs/images/$name.svg" "$copy/resources/docs/images/$name.svg" ||
    complain "$name.svg is not what its program draws: packaging/pictures BUILD $name"
done
icons=packaging/desktop/hicolor
for size in 48x48 256x256; do
  # As a picture, not by the byte: another librsvg may round otherwise.
  likeness=$(ffmpeg -i "$source/$icons/$size/apps/org.sonde.View.png" \
    -i "$copy/$icons/$size/apps/org.sonde.View.png" -lavfi psnr -f null - 2>&1 |
    grep -oE 'average:[0-9.a-z]+' | cut -d: -f2)
  awk -v db="$likeness" 'BEGIN { exit !(db == "inf" || db > 35) }' ||
    complain "an icon is not its SVG ($likeness dB): packaging/pictures BUILD icons"
done
for name in {compare,traces}-spoon-in-cup; do
  grep -q '</svg>' "$copy/resources/docs/images/$name.svg" || complain "no $name.svg"
done
for picture in docs/images/{sonde-view,mended} \
  scenes/{crumpled-soup,linked-tori,nut-on-bolt,peg-in-hole,spoon-in-cup,terrain,torus-knots}; do
  file "$copy/resources/$picture.png" | grep -q 'PNG image data' || complain "no $picture.png"
done
