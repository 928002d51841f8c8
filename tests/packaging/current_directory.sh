#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Nothing is loaded from the current directory: in a folder with libraries of all names that the
# programs load, plugins of Qt, settings and resources, planted there, they answer as in an empty
# one.
source "$(dirname "$0")/support.sh"

sonde=$PREFIX/bin/sonde view=$PREFIX/bin/sonde-view programs=("$PREFIX"/bin/sonde*)
if [[ ! -x $view ]]; then
  view=
elif ! has_display; then
  echo "no display: without the window"
  view=
fi

# A library that leaves a mark where it is loaded. Where it stands for one that a program is linked
# with, the program does not start: its functions are not there.
mark=$work/loaded
planted=$work/planted.so
"$CXX" -shared -fPIC -x c++ -o "$planted" - <<END
#include <cstdio>
[[gnu::constructor]] static void loaded() { std::fclose(std::fopen("$mark", "w")); }
END
folder=$work/here
mkdir "$folder" "$work/empty"
linked=$(ldd "${programs[@]}" | awk '$2 == "=>" { print $1 }' | sort -u)
makers=$(grep -ohE '"lib[A-Za-z]+\.so[.0-9]*"' "$SOURCE"/engine/devices/*.cpp | tr -d '"')
[[ $linked == *libhidapi-hidraw* && $makers == *libdhd.so* ]] || complain "names: $linked $makers"
for name in $linked $makers "libsonde.so.${VERSION%.*}"; do cp "$planted" "$folder/$name"; done
if [[ -n $view ]]; then
  plugins=$(dirname "$(ldd "$view" | awk '$1 ~ /^libQt5Core/ { print $3 }')")/qt5/plugins
  for plugin in $(cd "$plugins" && find . -name '*.so'); do
    mkdir -p "$folder/$(dirname "$plugin")"
    # Qt loads a library that says in this section that it is a plugin.
    objcopy --dump-section .qtmetadata="$work/metadata" "$plugins/$plugin" /dev/null
    objcopy --add-section .qtmetadata="$work/metadata" "$planted" "$folder/$plugin"
  done
fi
printf '[Paths]\nPrefix=.\nPlugins=.\n' >"$folder/qt.conf"
mkdir -p "$folder/sonde" "$folder/share" "$work/share"
for file in sonde-view.conf sonde/sonde-view.conf; do echo '[General]' >"$folder/$file"; done
for share in "$folder/share" "$work/share"; do
  cp -r "$PREFIX/share/sonde" "$share/"
  cp "$share/sonde/devices/sigma.7.json" "$share/sonde/devices/planted.json"
done
# The times of reading are put back, to see what is read.
touch -d '2 days ago' "$work/began"
find "$folder" "$work/share" -type f -exec touch -a -d '3 days ago' {} +
read_since() { find "$folder" "$work/share" -type f -anewer "$work/began"; }

run() { # [VARIABLE=VALUE...] COMMAND...
  env -u LD_LIBRARY_PATH -u LD_PRELOAD -u QT_PLUGIN_PATH HOME="$work/home" \
    XDG_CONFIG_HOME="$work/home/config" XDG_DATA_HOME="$work/home/data" "$@"
}
answers() { # FOLDER
  cd "$1"
  run "$sonde" info "$PREFIX/share/sonde/models/cup.ply"
  run "$sonde" devices
  run "$sonde" tune "$PREFIX/share/sonde/scenes/terrain.sonde.json" --device nothing --out t 2>&1 ||
    true
  [[ -z $view ]] || run "$view" "$PREFIX/share/sonde/scenes/linked-tori.sonde.json" \
    --screenshot "$work/picture.png" 2>"$work/err" || cat "$work/err"
}
elsewhere=$(answers "$work/empty")
[[ $elsewhere == *libdhd*'known are:'* ]] || complain "no answers: $elsewhere"
rm -f "$work/picture.png"
same_output "$elsewhere" answers "$folder"
[[ -z $view || -s $work/picture.png ]] || complain "no picture: $(cat "$work/err")"
[[ ! -e $mark ]] || complain "a library of the current directory was loaded"
[[ -z $(read_since) ]] || complain "read in the current directory: $(read_since)"

# All of this would be seen.
cat "$folder/qt.conf" >/dev/null
[[ $(read_since) == "$folder/qt.conf" ]] || echo "no times of reading here: only loading is seen"
seen() { # WHAT VARIABLE=VALUE COMMAND...
  rm -f "$mark"
  run "${@:2}" >/dev/null 2>&1 || true
  [[ -e $mark ]] || complain "it is not seen where $1 is loaded"
}
seen "a maker's library" SONDE_LIBDHD="$folder/libdhd.so" "$sonde" devices
ulimit -c 0 # Qt aborts
[[ -z $view ]] || seen "a plugin" QT_PLUGIN_PATH="$folder" "$view" --screenshot "$work/picture.png"
if LD_LIBRARY_PATH=$folder "$sonde" --version >"$work/out" 2>&1; then
  complain "it is not seen where a library is loaded that the program is linked with"
fi
