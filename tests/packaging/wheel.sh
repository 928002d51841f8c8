#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A wheel of the Python module, made by pip from the sources: it needs no library that a machine with
# Python does not have, gives the bits of this build, and passes the module's own tests.
source "$(dirname "$0")/support.sh"

python=/usr/bin/python3
$python -m pip --version >/dev/null 2>&1 || complain "pip is missing: packaging/deps installs it"
cd "$work"
$python -m pip wheel --quiet --no-deps --disable-pip-version-check "$SOURCE" --wheel-dir "$work/wheels"
wheel=("$work"/wheels/sonde-"$VERSION"-*.whl)
[[ -f ${wheel[0]} ]] || complain "no wheel was made"
$python -m pip install --quiet --no-deps --no-index --disable-pip-version-check \
  --target "$work/site" "${wheel[0]}"

module=("$work"/site/sonde/_sonde.*.so)
needed=$(readelf -d "${module[0]}" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p')
for library in $needed; do
  case $library in
    libstdc++.so.6 | libm.so.6 | libgcc_s.so.1 | libc.so.6 | ld-linux*.so.*) ;;
    *) complain "the wheel needs $library" ;;
  esac
done
[[ $(stat -c %s "${wheel[0]}") -lt 8000000 ]] || complain "the wheel is over 8 MB"

export PYTHONPATH=$work/site SONDE=$BUILD/bin/sonde SOURCE
for part in module pair; do
  $python "$SOURCE/tests/app/python/${part}_test.py"
done
