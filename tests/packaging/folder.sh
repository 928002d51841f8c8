# SPDX-License-Identifier: GPL-3.0-or-later
# The folder with all libraries, unpacked from its archive in the root of another distribution, which
# has neither Qt nor VTK: sonde gives the bits that it gives here, and sonde-view draws. In Ubuntu
# 24.04 both, in 22.04, whose C library is older than this machine's, sonde alone.
source "$(dirname "$0")/support.sh"

need mmdebstrap
[[ $EUID -eq 0 ]] || complain "as root only: mmdebstrap and chroot"
archive=http://archive.ubuntu.com/ubuntu
mounted=()
clean_up() {
  for root in "${mounted[@]}"; do umount "$root/proc" || return; done
  rm -rf "$work"
}
trap clean_up EXIT
"$SOURCE/packaging/folder" "$BUILD" "$work/sonde" >"$work/log" 2>&1 || complain "$(<"$work/log")"

scene=share/sonde/scenes/spoon-in-cup.sonde.json
"$BUILD/bin/sonde" query "$SOURCE/resources/scenes/spoon-in-cup.sonde.json" --poses "$poses" \
  --budget-steps 20 --quiet | cut -d, -f1-15 >"$work/expected.csv"
for suite in jammy noble; do
  root=$work/$suite
  # Its key is not Debian's: what is fetched serves this test alone.
  mmdebstrap --quiet --variant=apt --aptopt='APT::Install-Recommends "false"' \
    --include=xvfb,xauth,libgl1,libgl1-mesa-dri,libglx-mesa0,fonts-dejavu-core "$suite" "$root" \
    "deb [trusted=yes] $archive $suite main universe"
  mount -t proc proc "$root/proc" # by it a program finds the folder that it lies in
  mounted+=("$root")
  inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root "$@"; }
  if inside sh -c 'ldconfig -p' | grep -E 'libQt5|libvtk'; then complain "$suite has them"; fi
  mkdir "$root/somewhere else"
  tar -C "$root/somewhere else" -xf "$work/sonde.tar.xz"
  cp "$poses" "$root/poses.csv"
  program="/somewhere else/sonde/bin/sonde"
  inside "$program" query "/somewhere else/sonde/$scene" --poses /poses.csv --budget-steps 20 \
    --quiet | cut -d, -f1-15 >"$work/got.csv"
  cmp "$work/expected.csv" "$work/got.csv" || complain "$suite: other bits"
  if [[ $suite == jammy ]]; then continue; fi
  inside xvfb-run -a -s '-screen 0 1280x800x24' "$program-view" "/somewhere else/sonde/$scene" \
    --screenshot /picture.png
  cp "$root/picture.png" "$work/"
  # As large as the window's picture, and not of one colour.
  [[ $(file "$work/picture.png") == *PNG* && $(stat -c %s "$work/picture.png") -gt 20000 ]] ||
    complain "$suite: no picture"
done
