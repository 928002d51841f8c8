#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# packaging/deps installs what is missing of the groups that it is asked for, says what and how
# large, and waits for another program that installs. dpkg-query, apt-get and sudo are played by
# scripts: nothing is installed.
source "$(dirname "$0")/support.sh"

mkdir "$work/programs"
cat >"$work/programs/dpkg-query" <<'END'
#!/bin/bash
for package in "${@:3}"; do
  case " $NOT_THERE " in *" $package "*) continue ;; esac
  echo "installed $package"
done
exit 1 # as where one is not known
END
cat >"$work/programs/apt-get" <<END
#!/bin/bash
echo "\$*" >>"$work/log"
case "\$1 \$*" in
  update*)
    if [[ -s "$work/busy" ]]; then
      sed -i 1d "$work/busy"
      echo "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 7 (apt-get)" >&2
      exit 100
    fi
    if [[ -e "$work/offline" ]]; then echo "Temporary failure resolving" >&2 && exit 100; fi ;;
  *--assume-no*)
    echo "0 upgraded, 2 newly installed, 0 to remove and 9 not upgraded."
    echo "Need to get 31.4 MB of archives."
    exit 1 ;;
esac
END
printf '#!/bin/sh\nexec "$@"\n' >"$work/programs/sudo"
chmod +x "$work"/programs/*
deps() { PATH="$work/programs:$PATH" DEPS_PAUSE=0 "$SOURCE/packaging/deps" "$@"; }

NOT_THERE='' deps >"$work/said" 2>&1
[[ ! -s $work/said && ! -e $work/log ]] || complain "something is done where all is there"
NOT_THERE='clang-tidy mypy' deps build window >"$work/said" 2>&1
[[ ! -s $work/said && ! -e $work/log ]] || complain "what running does not need is asked for"

printf '1\n2\n' >"$work/busy"
NOT_THERE='libvtk9-dev xvfb clang-tidy' deps build window >"$work/said" 2>&1
grep -qx 'deps: installing libvtk9-dev xvfb' "$work/said" || complain "$(cat "$work/said")"
grep -q 'Need to get 31.4 MB' "$work/said" || complain "not how large: $(cat "$work/said")"
[[ $(grep -c 'waiting for another program' "$work/said") -eq 2 ]] || complain "$(cat "$work/said")"
[[ $(grep -c '^update' "$work/log") -eq 3 ]] || complain "not tried again: $(cat "$work/log")"
tail -n 1 "$work/log" | grep -q ' -y libvtk9-dev xvfb$' || complain "$(cat "$work/log")"

touch "$work/offline"
if NOT_THERE=cmake deps build >"$work/said" 2>&1; then complain "no list of packages is no failure"; fi
grep -q 'Temporary failure resolving' "$work/said" || complain "no reason: $(cat "$work/said")"
if deps everything >"$work/said" 2>&1; then complain "a group that is none is taken"; fi
grep -q 'no group everything' "$work/said" || complain "$(cat "$work/said")"
