#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# one_name.sh FOLDER...: refuses two types of one name in one namespace, in headers of these folders.
# Each may be alone in what includes it, and the linker still takes the code of one for both: a
# std::vector of the smaller is then written as of the larger.
set -euo pipefail

twice=$(grep -rnE --include='*.hpp' '^(inline )?namespace|^(struct|class|enum class) [A-Za-z0-9].*\{' "$@" |
  awk -F: '
    $3 ~ /namespace/ {
      sub(/^[^:]*:[^:]*:/, ""); sub(/^(inline )?namespace */, ""); sub(/ *\{.*/, "")
      space = $0
      next
    }
    space == "" { next } # of no name: the file is its own
    {
      file = $1
      sub(/^[^:]*:[^:]*:(struct|class|enum class) /, "")
      sub(/^alignas\([^)]*\) /, "")
      sub(/[^A-Za-z0-9:].*|:[^:].*/, "")
      print space "::" $0, file
    }' | sort -u | awk '{ n[$1]++; where[$1] = where[$1] " " $2 }
                        END { for (t in n) if (n[t] > 1) print t ":" where[t] }')
if [[ -n $twice ]]; then
  echo "types of one name:" >&2
  echo "$twice" >&2
  exit 1
fi
