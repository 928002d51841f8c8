#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# packaging/coverage counts the lines that ran, names the files of which few did, and fails where
# too few did in all. The engine is two files that this compiles, its test a program that calls
# them; cmake and ctest are played by scripts, in a tree of their own.
source "$(dirname "$0")/support.sh"

need gcov
tree=$work/tree
objects=$tree/build/coverage/engine
mkdir -p "$tree"/{packaging,engine/part} "$work/programs" "$objects"
cp "$SOURCE/packaging/coverage" "$tree/packaging"

# half: 20 lines for an argument of 0, and as many for any other. whole: 300 for all.
lines() { for ((i = 0; i < $1; ++i)); do echo '  x += x % 7;'; done; }
{ echo 'int half(int x) { if (x) {' && lines 20 && echo '} else {' && lines 20 &&
  echo '} return x; }'; } >"$tree/engine/part/half.cpp"
{ echo 'int whole(int x) {' && lines 300 && echo 'return x; }'; } >"$tree/engine/part/whole.cpp"
cat >"$tree/test.cpp" <<'END'
int half(int);
int whole(int);
int main(int count, char** of) {
  for (int i = 1; i < count; ++i) *of[i] == 'w' ? whole(1) : half(*of[i] - '0');
}
END
cat >"$work/programs/cmake" <<END
#!/bin/bash
if [[ \$1 == --preset ]]; then exit; fi
cd "$objects"
for name in half whole; do
  $CXX --coverage -c "$tree/engine/part/\$name.cpp" -o "\$name.o" || exit
done
$CXX --coverage "$tree/test.cpp" half.o whole.o -o ../test
END
cat >"$work/programs/ctest" <<'END'
#!/bin/sh
./build/coverage/test $RUNS
exit ${FAILED:-0}
END
chmod +x "$work"/programs/*
coverage() { PATH="$work/programs:$PATH" "$tree/packaging/coverage"; }

RUNS='0 1 w' same_output "engine/part                  100.0 % of   344 lines
engine 100.0 % of 344 lines" coverage
# A test that failed counts with what it ran, and nothing is left of the run before.
FAILED=1 RUNS='0 w' same_output "engine/part                   94.2 % of   344 lines
below 90 %: engine/part/half.cpp 52.38% of 42
engine 94.2 % of 344 lines" coverage
! said=$(RUNS='0 1' coverage) || complain "too few lines are no failure: $said"
[[ $said == *"below 90 %: engine/part/whole.cpp 0.00% of 302"* ]] || complain "not named: $said"
! said=$(RUNS='' coverage) || complain "no line that ran is no failure: $said"
