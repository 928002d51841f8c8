# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Sourced by run and test: a virtual X server, on a free number, for as long as the script runs. Its
# screen is of display_size pixels, 1280x800 where that is not set.

start_display() {
  display_folder=$(mktemp -d)
  trap stop_display EXIT
  mkfifo "$display_folder/number"
  Xvfb -displayfd 3 -screen 0 "${display_size:-1280x800}x24" -nolisten tcp \
    3>"$display_folder/number" >"$display_folder/log" 2>&1 &
  display_server=$!
  local number
  # The server writes its number once it answers; the pipe closes without one where it dies.
  if ! read -r -t 60 number <"$display_folder/number"; then
    echo "the virtual display did not start:" >&2
    cat "$display_folder/log" >&2
    return 1
  fi
  export DISPLAY=:$number
  unset WAYLAND_DISPLAY
}

stop_display() {
  if [[ -n ${display_server:-} ]]; then
    kill "$display_server" 2>/dev/null || true
    wait "$display_server" 2>/dev/null || true
  fi
  rm -rf "$display_folder"
}
