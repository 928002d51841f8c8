#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The packages are made, lintian finds neither error nor warning in them, together they hold what
# `cmake --install` installs, both programs run from them (the window where there is a display), and
# dpkg removes all of it again.
source "$(dirname "$0")/support.sh"

need lintian
"$SOURCE/packaging/make-packages" "$BUILD" "$work/packages" >"$work/log" 2>&1 ||
  complain "$(cat "$work/log")"

# dpkg works on a root of its own, that has nothing but its records: what is to be there first is not.
root=$work/root
mkdir -p "$root/var/lib/dpkg/"{info,updates,triggers} "$root/var/log"
touch "$root/var/lib/dpkg/status"
in_root() {
  local as_root=()
  [[ $EUID -eq 0 ]] || { need fakeroot; as_root=(fakeroot); }
  "${as_root[@]}" dpkg --root="$root" --force-depends --force-script-chrootless --log=/dev/null "$@" \
    >"$work/log" 2>&1 || complain "$(cat "$work/log")"
}
in_root --install "$work"/packages/*.deb
files_of() { (cd "$1" && find . -not -type d | sort); }
diff <(files_of "$PREFIX") <(files_of "$root/usr") || complain "packages hold other files than --install"
cd "$work"
"$root/usr/bin/sonde" query "$root/usr/share/sonde/scenes/spoon-in-cup.sonde.json" \
  --poses "$poses" --quiet >result.csv
grep -q '^0,penetrating,' result.csv || complain "no depth: $(cat result.csv)"
view=$root/usr/bin/sonde-view
if [[ -x $view ]] && has_display; then
  HOME=$work XDG_CONFIG_HOME=$work XDG_DATA_HOME=$work "$view" \
    "$root/usr/share/sonde/scenes/linked-tori.sonde.json" --screenshot picture.png
  file picture.png | grep -q 'PNG image data' || complain "no picture"
fi
mapfile -t names < <(dpkg-query --admindir="$root/var/lib/dpkg" -W -f '${Package}\n')
[[ ${#names[@]} -ge 3 ]] || complain "packages: ${names[*]}"
in_root --purge "${names[@]}"
if left=$(find "$root" -mindepth 1 -not -path "$root/var*" | grep .); then
  complain "left behind: $left"
fi
