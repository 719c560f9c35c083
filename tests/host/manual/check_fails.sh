#!/bin/sh
# manual_facts must find each kind of error: a changed fact, an unknown section, a section without end, an end without beginning,
# a
# missing file. --write must correct the first.
#
#   check_fails.sh MANUAL_FACTS REPOSITORY
set -u
facts=$1
root=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0

# $1: the expected error message; $2: the page.
expect() {
  if "$facts" --check "$root" "$2" > /dev/null 2> "$folder/said"; then
    echo "accepted: $1"
    failed=1
  elif ! grep -q -- "$1" "$folder/said"; then
    echo "said something else than $1:"
    cat "$folder/said"
    failed=1
  fi
}

page=$folder/page.md
sed 's/| `dac` Y | 040000 /| `dac` Y | 050000 /' "$root/host/manual/pdp7.md" > "$page"
expect "ninja write_manual" "$page"
expect "dac. Y | 040000" "$page"
"$facts" --write "$root" "$page" > /dev/null && cmp "$page" "$root/host/manual/pdp7.md" || failed=1

printf '<!-- begin no-such -->\n<!-- end no-such -->\n' > "$page"
expect 'section "no-such"' "$page"
printf '<!-- begin pdp7-iots -->\n' > "$page"
expect 'without an end' "$page"
printf '<!-- begin pdp7-iots -->\n<!-- begin pdp7-eae -->\n<!-- end pdp7-iots -->\n' > "$page"
expect 'without an end' "$page"
printf '<!-- end pdp7-iots -->\n' > "$page"
expect 'does not begin' "$page"
printf '<!-- begin source host/examples/none.s -->\n<!-- end source host/examples/none.s -->\n' > "$page"
expect 'none.s: line 1: cannot be read' "$page"
printf '<!-- begin source host/examples/square.s from nowhere -->\n<!-- end source host/examples/square.s from nowhere -->\n' > "$page"
expect 'no line that begins with nowhere' "$page"
printf 'no section\n' > "$page"
expect 'no generated section' "$page"
expect 'cannot be read' "$folder/none.md"
exit $failed
