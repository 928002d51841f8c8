#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Whatever can be configured by a preset can be built by one of that name, and CONTRIBUTING.md names
# it; a commit's subject fits on a line.
source "$(dirname "$0")/support.sh"

cd "$SOURCE"
names() { cmake --list-presets="$1" | sed -n 's/^ *"\([^"]*\)".*/\1/p' | sort; }
[[ $(names configure | wc -l) -gt 5 ]] || complain "no presets are listed"
diff <(names configure) <(names build) || complain "presets that are configured and not built, or the other way"
for name in $(names configure); do
  grep -q "^| \`$name\`" CONTRIBUTING.md || complain "CONTRIBUTING.md does not say what $name is for"
done

# A copy without its history, as a package's sources are, has none to look at.
if git rev-parse --git-dir >/dev/null 2>&1; then
  long=$(git log -20 --format=%s | awk 'length > 72')
  [[ -z $long ]] || complain "subjects of more than 72 characters: $long"
fi
