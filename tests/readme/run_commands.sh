#!/bin/sh
# Runs the commands of a text, which are its lines indented by four blanks, one after the other, in a temporary folder that has
# the
# repository's host/. Each must exit with code 0, print something or write a file, and every file that it names with -o or > must
# not be
# empty. Two kinds are only checked: for `ninja` that the targets exist, for `ctest` that the filter finds tests. Commands in
# not_run.txt
# are not run; a command that is neither run nor listed is an error.
#
#   run_commands.sh TEXT BINARY REPOSITORY BUILD_FOLDER [LEAST PICTURES]
#
# For a page of the manual: LEAST is the least number of commands that it must have; its other indented lines are examples of file
# contents. PICTURES is a folder of approved pictures: each that the page shows as pictures/NAME must be among them, and the
# commands must
# make an equal file NAME. SIGHTLINE_APPROVE=1 replaces the approved pictures by the new ones; check them before you commit them.
set -u
text=$1
binary=$2
repository=$3
build=$4
least=${5:-1}
pictures=${6:-}
list=$(cd "$(dirname "$0")" && pwd)/not_run.txt
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
ln -s "$repository/host" "$folder/host"
PATH=$(dirname "$binary"):$PATH
cd "$folder" || exit 1

failed=0
run=0
listed=0
fail() { # fail COMMAND WHY
  printf '%s\n  %s\n' "$1" "$2"
  failed=1
}

# The beginning of a line in not_run.txt, up to its tab.
is_listed() {
  while IFS="$(printf '\t')" read -r beginning reason; do
    case $beginning in '' | '#'*) continue ;; esac
    case $1 in "$beginning"*) return 0 ;; esac
  done < "$list"
  return 1
}

sed -n 's/^    \([^ ].*\)/\1/p' "$text" | sed 's/   *# .*//' > commands
while read -r line; do
  if is_listed "$line"; then
    listed=$((listed + 1))
    continue
  fi
  case $line in
    sightline\ * | parallel\ * | printf\ * | mkdir\ *) command=$line ;;
    build/release/host/app/sightline\ *) command=${line#build/release/host/app/} ;;
    ninja\ -C\ build/release\ *) command="ninja -n -C $build ${line#ninja -C build/release }" ;;
    ctest\ --test-dir\ build/re*) command="ctest --test-dir $build -N ${line#ctest --test-dir build/re* } | grep 'Total Tests: [1-9]'" ;;
    *)
      [ -n "$pictures" ] && continue
      fail "$line" "is neither a known kind of command nor in tests/readme/not_run.txt"
      continue
      ;;
  esac
  run=$((run + 1))
  touch before
  sleep 0.02  # file times have only this resolution
  if ! sh -c "$command" > printed 2> complaint < /dev/null; then
    fail "$line" "fails: $(cat printed complaint | tail -3)"
    continue
  fi
  written=$(find . -mindepth 1 -newer before ! -name before ! -name printed ! -name complaint | head -1)
  if [ ! -s printed ] && [ ! -s complaint ] && [ -z "$written" ]; then fail "$line" "prints nothing and writes nothing"; fi
  for output in $(printf '%s\n' "$command" | grep -oE '(-o|>|--listing|--png|--phosphor|--trace) +[^ ]+' | sed 's/.* //'); do
    [ -s "$output" ] || fail "$line" "leaves $output empty, or does not write it"
  done
done < commands
rm -f before
if [ "$run" -lt "$least" ]; then fail "$text" "has $run commands that can be run, expected at least $least: is its form another?"; fi
if [ -n "$pictures" ]; then
  grep -oE '"pictures/[^"]+"|\(pictures/[^)]+\)' "$text" | sed 's/^.pictures.//; s/.$//' | sort -u > shown
  while read -r picture; do
    made=$(find . -name "$picture" -type f | head -1)
    if [ -z "$made" ]; then
      fail "$picture" "is shown, but no command makes it"
    elif [ "${SIGHTLINE_APPROVE:-}" = 1 ]; then
      cp "$made" "$pictures/$picture"
    elif ! cmp "$made" "$pictures/$picture"; then
      fail "$picture" "is another than the commands make; SIGHTLINE_APPROVE=1 replaces it, after a look"
    fi
  done < shown
fi
echo "$text: $run commands run, $listed not"
exit $failed
