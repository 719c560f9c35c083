#!/bin/sh
# Counts host instructions per guest instruction by valgrind, and fails where one is more than bounds.txt allows. A count does
# not depend on the load of the host, only on the code that a compiler makes.
#
#   check.sh SOURCE_FOLDER COMPILER...
set -eu

source=$1
shift
here=$source/tests/emulators/host_instructions
command -v valgrind >/dev/null || { echo "host_instructions: no valgrind here; tools/dev deps installs it" >&2; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

for compiler in "$@"; do
  command -v "$compiler" >/dev/null || { echo "host_instructions: no $compiler here" >&2; exit 77; }
  "$compiler" -std=c++20 -O2 -DNDEBUG -I"$source" "$here/programs.cpp" "$source"/emulators/machines/*.cpp "$source"/emulators/devices/*.cpp "$source"/emulators/type340/*.cpp -o "$work/programs"
  (cd "$work" && valgrind --tool=callgrind --callgrind-out-file=counts --collect-atstart=no --toggle-collect='count_*' \
    ./programs >/dev/null 2>log) || { cat "$work/log" >&2; exit 1; }
  callgrind_annotate --inclusive=yes --threshold=100 "$work/counts" > "$work/table"
  for program in pdp7_loop pdp7_mix pdp7_eae pdp7_refreshing i8080_mix; do
    count=$(sed -n "s/^ *\([0-9,]*\) .*:count_$program .*/\1/p" "$work/table" | tr -d ,)
    [ -n "$count" ] || { echo "host_instructions: valgrind counted nothing in count_$program" >&2; exit 1; }
    bound=$(awk -v p="$program" -v c="$compiler" '$1 == c && $2 == p { print $3 }' "$here/bounds.txt")
    [ -n "$bound" ] || { echo "host_instructions: bounds.txt has no line for $compiler $program" >&2; exit 1; }
    echo "$compiler $program: $((count / 1000))e-2 host instructions per guest instruction, at most $bound"
    if [ "$(awk -v n="$count" -v b="$bound" 'BEGIN { print (n > b * 100000) }')" = 1 ]; then
      echo "host_instructions: $compiler $program is above its bound; see what the compiler made of the instructions" >&2
      failed=1
    fi
  done
done
exit $failed
