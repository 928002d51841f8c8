#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The packages into a fresh Debian made from this machine's own package sources: apt installs them
# with what they need, both programs and the Python module run there, a program is compiled against
# the library, apt removes them, and nothing of Sonde is left.
source "$(dirname "$0")/support.sh"

need mmdebstrap
[[ $EUID -eq 0 ]] || complain "as root only: mmdebstrap and chroot"
packages=$work/packages root=$work/root
"$SOURCE/packaging/make-packages" "$BUILD" "$packages" >"$work/log" 2>&1 ||
  complain "$(cat "$work/log")"
# shellcheck disable=SC1091
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
apt-get indextargets --format 'deb $(SITE) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' \
  'Origin: Debian' | sort -u >"$work/sources"
mmdebstrap --quiet --variant=apt --skip=cleanup/apt/lists \
  --include=xvfb,xauth,libgl1-mesa-dri --aptopt='APT::Install-Recommends "false"' "$suite" "$root" - <"$work/sources"
cp /etc/resolv.conf "$root/etc/"
cp /etc/apt/apt.conf.d/*proxy* "$root/etc/apt/apt.conf.d/" 2>/dev/null || true
mkdir "$root/packages"
cp "$packages"/*.deb "$poses" "$root/packages/"
names=()
for package in "$packages"/*.deb; do names+=("$(dpkg-deb -f "$package" Package)"); done
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root "$@"; }
of_sonde() { inside find / -xdev -not -path '/proc/*' -not -path '/packages*' -iname '*sonde*'; }

inside sh -c 'apt-get install -q -y --no-install-recommends /packages/*.deb' >"$work/log" 2>&1 ||
  complain "$(cat "$work/log")"
inside sonde query /usr/share/sonde/scenes/spoon-in-cup.sonde.json --poses /packages/poses.csv \
  --quiet >"$work/result.csv"
grep -q '^0,penetrating,' "$work/result.csv" || complain "no depth"
inside xvfb-run -a -s '-screen 0 1280x800x24' sonde-view \
  /usr/share/sonde/scenes/linked-tori.sonde.json --screenshot /packages/picture.png
[[ -s $root/packages/picture.png ]] || complain "no picture"
if [[ " ${names[*]} " == *" python3-sonde "* ]]; then
  inside python3 -c 'import sonde; print(sonde.__version__)' >"$work/version"
  [[ $(<"$work/version") == "$VERSION" ]] || complain "the Python module is of another version"
  inside python3 - >"$work/depth" <<'END'
import numpy, sonde
probe, fixed = (sonde.Body.read(f"/usr/share/sonde/models/{name}.ply") for name in ("spoon", "cup"))
poses = numpy.loadtxt("/packages/poses.csv", delimiter=",", skiprows=1, ndmin=2)
print(f"{sonde.depth(probe, fixed, poses).depth[0]:.17g}")
END
  grep -qF "0,penetrating,$(<"$work/depth")," "$work/result.csv" ||
    complain "the Python module finds $(<"$work/depth"): $(cat "$work/result.csv")"
fi
# The compiler comes last: it may bring along what the packages fail to ask for.
inside apt-get install -q -y --no-install-recommends g++ pkg-config >"$work/log" 2>&1 ||
  complain "$(cat "$work/log")"
# shellcheck disable=SC2016
inside sh -c 'c++ -std=c++20 /usr/share/doc/libsonde-dev/examples/depth_of_two_files.cpp \
  -o /packages/depth $(pkg-config --cflags --libs sonde)'
models=/usr/share/sonde/models
same_output "$("$BUILD/bin/sonde_example" "$SOURCE/resources/models/"{trefoil,torus}.ply)" \
  inside /packages/depth $models/trefoil.ply $models/torus.ply
inside sh -c "apt-get purge -qq -y 'sonde*' 'libsonde*' '*-sonde'" >"$work/log" 2>&1 ||
  complain "$(cat "$work/log")"
left=$(of_sonde | grep -v -e '^/root/' -e '^/var/cache/apt' || true)
[[ -z $left ]] || complain "left behind: $left"
