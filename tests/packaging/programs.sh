#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The installed program finds its resources and answers as the one of the build does, to the bit; no
# installed file knows where it was built.
source "$(dirname "$0")/support.sh"

cd "$work"
sonde=$PREFIX/bin/sonde
same_output "sonde $VERSION" "$sonde" --version
query() { env -i "$1" query "$2/scenes/spoon-in-cup.sonde.json" --poses "$poses" --quiet; }
query "$sonde" "$PREFIX/share/sonde" | cut -d, -f1-15 >installed.csv
query "$BUILD/bin/sonde" "$SOURCE/resources" | cut -d, -f1-15 >built.csv
grep -q '^0,penetrating,' installed.csv || complain "no depth: $(cat installed.csv)"
cmp installed.csv built.csv
# By a link the examples of the manual, which name files of the sources, run as they stand.
mkdir own
(cd own && ln -s "$PREFIX/share/sonde" resources && query "$sonde" resources) | cut -d, -f1-15 |
  cmp installed.csv -
# The Python module of there finds the same depth.
modules=$PREFIX/lib/python3/dist-packages
if [[ -d $modules/sonde ]]; then
  env -i PYTHONPATH="$modules" /usr/bin/python3 -B - "$SOURCE/resources/models" "$poses" installed.csv <<'END'
import csv, sys, numpy, sonde
models, poses, found = sys.argv[1:]
probe, fixed = (sonde.Body.read(f"{models}/{name}.ply") for name in ("spoon", "cup"))
depth = sonde.depth(probe, fixed, numpy.loadtxt(poses, delimiter=",", skiprows=1, ndmin=2)).depth[0]
wanted = float(next(csv.DictReader(open(found)))["depth"])
sys.exit(0 if depth == wanted else f"{sonde.__file__}: {depth} instead of {wanted}")
END
fi
# A profile by its name comes from share/sonde: an unknown one is answered with those there are.
"$sonde" tune "$PREFIX/share/sonde/scenes/terrain.sonde.json" --device nothing --out t 2>err && exit 1
grep -q 'known are:.* sigma\.7' err || complain "profiles are not found: $(cat err)"

known=(-e "$BUILD")
for folder in app engine resources ui; do known+=(-e "$SOURCE/$folder"); done
if knowing=$(grep -rlF "${known[@]}" "$PREFIX"); then
  complain "the folder of the build is named in $knowing"
fi
