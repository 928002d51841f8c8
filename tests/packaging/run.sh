#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# packaging/run installs what is missing, builds the programs and opens a spoon in a cup, or what
# its arguments say; where there is no display, the window of this build saves a picture on one of
# its own. In a tree of its own, in which deps and cmake are played by scripts: nothing is installed
# or built. A preset and targets that this build does not have are refused.
source "$(dirname "$0")/support.sh"

tree=$work/tree log=$work/log
mkdir -p "$tree/packaging" "$work/programs"
cp "$SOURCE"/packaging/{run,display.sh} "$tree/packaging"
ln -s "$SOURCE/resources" "$tree/resources"
cat >"$tree/packaging/deps" <<END
#!/bin/sh
echo "deps \$*" | tee -a "$log"
exit \${NO_DEPS:-0}
END
cat >"$work/programs/cmake" <<END
#!/bin/bash
set -euo pipefail
[[ \$PWD == "$tree" ]] || { echo "not in the folder of the sources: \$PWD" >&2; exit 1; }
echo "cmake \$1" | tee -a "$log"
if [[ \$1 == --preset ]]; then
  (cd "$SOURCE" && "$(command -v cmake)" --list-presets) | grep "^ *\"\$2\""
  mkdir -p "$tree/build/\$2/bin"
  touch "$tree/build/\$2/build.ninja"
  exit
fi
[[ \$1 == --build && -d \$2/bin && \$3 == --target && \${NO_BUILD:-} != 1 ]] || exit 1
for target in "\${@:4}"; do
  grep -q "^build \$target:" "$BUILD/build.ninja" || { echo "no target \$target" >&2; exit 1; }
  ln -sf "\${PROGRAMS:-$work/programs}/\$target" "\$2/bin/"
done
END
# Says what it was run with, and whether on a display of the caller's or another.
cat >"$work/programs/sonde-view" <<'END'
#!/bin/sh
case $DISPLAY$WAYLAND_DISPLAY in given) on=given ;; ?*) on=another ;; *) on=none ;; esac
echo "$PWD, $on: $*"
END
chmod +x "$tree/packaging/deps" "$work"/programs/*
run() { # [VARIABLE=VALUE...] -- ARGUMENT...: packaging/run in another folder
  local variables=()
  while [[ $1 != -- ]]; do variables+=("$1") && shift; done
  shift
  (cd "$work" && env -u DISPLAY -u WAYLAND_DISPLAY PATH="$work/programs:$PATH" \
    XDG_CONFIG_HOME="$work" XDG_DATA_HOME="$work" "${variables[@]}" "$tree/packaging/run" "$@")
}

spoon=$tree/resources/scenes/spoon-in-cup.sonde.json
same_output "$work, given: $spoon" run DISPLAY=given --
same_output "deps build window
cmake --preset
cmake --build" cat "$log"
same_output "$work, given: $spoon" run WAYLAND_DISPLAY=given --
# What is configured is not configured again.
same_output "deps build window
cmake --build" tail -n 2 "$log"
same_output "$work, given: a b.ply --k 3" run DISPLAY=given -- "a b.ply" --k 3
same_output "$work, another: a.ply --screenshot a.png" run -- a.ply --screenshot a.png
same_output "$work, another: --demo $tree/build/sonde-view.png a.ply" run -- a.ply

! run NO_DEPS=1 DISPLAY=given -- >"$work/out" || complain "goes on without what it needs"
[[ ! -s $work/out ]] || complain "a window without what it needs: $(cat "$work/out")"
! run NO_BUILD=1 DISPLAY=given -- >"$work/out" || complain "a build that fails is no failure"
[[ ! -s $work/out ]] || complain "a window of a build that failed: $(cat "$work/out")"

picture=$tree/build/sonde-view.png
said=$(run PROGRAMS="$BUILD/bin" --)
[[ $(head -n 1 <<<"$said") == "$picture" ]] || complain "the picture is not named: $said"
file "$picture" | grep -q 'PNG image data' || complain "no picture: $(file "$picture")"
