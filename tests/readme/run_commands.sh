#!/bin/sh
# Runs the commands of a text in its indented blocks that begin with `sightline` or `parallel`, one after the other, in
# a temporary folder that has the repository's host/. Each must end with exit code 0, print something or write a file,
# and every file that it names with -o or > must not be empty.
#
#   run_commands.sh TEXT BINARY REPOSITORY
set -u
text=$1
binary=$2
repository=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
ln -s "$repository/host" "$folder/host"
PATH=$(dirname "$binary"):$PATH
cd "$folder" || exit 1

failed=0
count=0
sed -n 's/^    \(\(sightline\|parallel\) .*\)/\1/p' "$text" | sed 's/  *# .*//' > commands
while read -r command; do
  count=$((count + 1))
  touch before
  if ! sh -c "$command" > printed 2> complaint < /dev/null; then
    echo "$command"
    echo "  fails: $(tail -3 complaint)"
    failed=1
    continue
  fi
  written=$(find . -newer before -type f ! -name before ! -name printed ! -name complaint | head -1)
  if [ ! -s printed ] && [ ! -s complaint ] && [ -z "$written" ]; then
    echo "$command"
    echo "  prints nothing and writes nothing"
    failed=1
  fi
  for output in $(printf '%s\n' "$command" | grep -oE '(-o|>|--listing|--png|--trace) +[^ ]+' | sed 's/.* //'); do
    if [ ! -s "$output" ]; then
      echo "$command"
      echo "  leaves $output empty, or does not write it"
      failed=1
    fi
  done
done < commands
rm -f before
if [ "$count" -lt 15 ]; then
  echo "found $count commands in $text, expected at least 15: is the text's form another?"
  failed=1
fi
echo "$count commands of $text"
exit $failed
