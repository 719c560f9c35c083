#!/bin/sh
# The section "Statements of the paper and where they are shown" of a NOTES.md: runs its commands, which are in backquotes and begin
# with sightline, in a temporary folder; each must exit with code 0. Looks for the tables of the report, which are in square brackets,
# in the experiments. A text with fewer than LEAST commands and tables is an error.
#
#   run_notes.sh TEXT BINARY REPOSITORY LEAST
set -u
text=$1
binary=$2
repository=$3
least=$4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
ln -s "$repository/host" "$folder/host"
mkdir "$folder/out"
PATH=$(dirname "$binary"):$PATH
cd "$folder" || exit 1

failed=0
found=0
awk '/^## /{inside = $0 == "## Statements of the paper and where they are shown"} inside' "$text" > section
grep -o '`sightline [^`]*`' section | tr -d '`' > commands
while read -r line; do
  found=$((found + 1))
  eval "$line" > output 2>&1 < /dev/null || { printf '%s\n' "$line"; cat output; failed=1; }
done < commands
for table in $(grep -o '\[[a-z0-9-]*\]' section | tr -d '[]'); do
  found=$((found + 1))
  grep -q "\"$table\"" "$repository"/host/report/experiments/*.cpp || { echo "$table: no such table of the report"; failed=1; }
done
[ "$found" -ge "$least" ] || { echo "$text: $found commands and tables, expected at least $least"; failed=1; }
exit $failed
