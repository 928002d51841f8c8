#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A dry run of a release names every step and does none; it refuses versions that differ, a tag that
# is there and changes that are not committed, new files among them. In a repository of its own.
source "$(dirname "$0")/support.sh"

need git
root=$work/root
mkdir -p "$root/packaging/debian"
cp "$SOURCE/CMakeLists.txt" "$SOURCE/CHANGELOG.md" "$root/"
cp "$SOURCE/packaging/release" "$root/packaging/"
cp "$SOURCE/packaging/debian/changelog" "$root/packaging/debian/"
cd "$root"
export GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b.c GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@b.c
git init -q .
git add .
git commit -qm "all"

same_output "cmake --preset dev -Wno-dev
cmake --build build/dev
.ci/run
packaging/package
git tag -a v$VERSION -m Sonde $VERSION
git push origin v$VERSION   # by hand, when you are sure" packaging/release --dry-run
same_output "" git tag

refused() { # WORDS
  if packaging/release --dry-run >"$work/out" 2>"$work/err"; then complain "taken: $1"; fi
  grep -qF "$1" "$work/err" || complain "not \"$1\": $(cat "$work/err")"
  [[ ! -s $work/out ]] || complain "a step after a refusal: $(cat "$work/out")"
}
echo "# more" >>CMakeLists.txt
refused "not committed"
git checkout -q CMakeLists.txt
touch "packaging/not known to git"
refused "not committed"
rm "packaging/not known to git"
git tag "v$VERSION"
refused "the tag v$VERSION is there already"
git tag -d "v$VERSION" >/dev/null
sed -i "s/^## $VERSION/## 99.0.0/" CHANGELOG.md
refused 'CHANGELOG.md: the newest version is "99.0.0"'
git checkout -q CHANGELOG.md
sed -i "1s/$VERSION/99.0.0/" packaging/debian/changelog
refused 'packaging/debian/changelog:1: "99.0.0"'
