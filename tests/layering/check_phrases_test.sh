#!/bin/sh
# The test of check_phrases.pl: it finds phrases across line ends, in names and in file names, and refuses a bad list.
#
#   check_phrases_test.sh CHECK_PHRASES_PL PHRASES
set -eu
check=$1 phrases=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "$1" >&2; cat "$folder/out" >&2; exit 1; }

# expect STATUS TEXT NAME CONTENT: a folder with this one file; TEXT must be in the output.
expect() {
  rm -rf "$folder/root" && mkdir "$folder/root"
  printf "$4" > "$folder/root/$3"
  status=0
  perl "$check" "$phrases" "$folder/root" > "$folder/out" 2>&1 || status=$?
  [ "$status" = "$1" ] || fail "$3: exit $status, expected $1"
  grep -qF -e "$2" "$folder/out" || [ -z "$2" ] || fail "$3: the output lacks: $2"
}
h=held p="$h against"  # put together here, so that this file passes the check
expect 1 "a.cpp:2: \"$p\", write: compared with" a.cpp "int a;\n// A line $h against a face.\n"
expect 1 "a.hpp:1: \"$p\"" a.hpp "// A line is $h\n// against a face.\n"
expect 1 "a.s:1: \"$p\"" a.s "/ A line is $h\n/ Against a face.\n"
expect 1 "a.cpp:1: \"$p\"" a.cpp "auto a = \"is $h \"\n    \"against\";\n"
expect 1 "a.cpp:1: \"$p\"" a.cpp "void ${h}_against();\n"
expect 1 "${h}_against.cpp:0: \"$p\"" "${h}_against.cpp" "int a;\n"
expect 1 'CMakeLists.txt:3: "made an'  CMakeLists.txt "\n\n# made ane""w\n"
expect 0 '' a.cpp "// up${h} against; ${h}, against; ${h} againsts\n"
expect 2 'none of the files' a.bin "held\n"

printf 'no standard wording\n' > "$folder/list"
phrases=$folder/list
expect 2 'list:1: expected a phrase' a.cpp "int a;\n"
printf 'one\ttwo\none\ttwo\n' > "$folder/list"
expect 2 'list:2: "one" is listed twice' a.cpp "int a;\n"
