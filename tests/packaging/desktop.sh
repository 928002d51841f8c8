#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The installed desktop program draws an installed scene; its desktop entry, metainfo, icons and
# MIME type are what desktops read, and a scene file is known by its name.
source "$(dirname "$0")/support.sh"

[[ -n ${DISPLAY:-} ]] || complain "no display: packaging/test starts one"
need desktop-file-validate
need appstreamcli
need update-mime-database
cd "$work"
HOME=$work XDG_CONFIG_HOME=$work XDG_DATA_HOME=$work "$PREFIX/bin/sonde-view" \
  "$PREFIX/share/sonde/scenes/linked-tori.sonde.json" --screenshot picture.png
file picture.png | grep -q 'PNG image data' || complain "no picture"

share=$PREFIX/share
desktop-file-validate "$share/applications/org.sonde.View.desktop"
appstreamcli validate --no-net "$share/metainfo/org.sonde.View.metainfo.xml" >validated ||
  complain "$(cat validated)"
mkdir -p share/mime/packages
cp "$share/mime/packages/sonde.xml" share/mime/packages/
update-mime-database share/mime
grep -q 'application/x-sonde-scene+json:.*\.sonde\.json' share/mime/globs2 ||
  complain "no MIME type"
for size in 48 256; do
  file "$share/icons/hicolor/${size}x$size/apps/org.sonde.View.png" | grep -q "$size x $size" ||
    complain "no icon of $size pixels"
done
