#!/bin/sh
# Makes the man pages and the bash completion of `sightline` from the --help of every subcommand.
#
#   help_files.sh COMMAND DIRECTORY VERSION
#
# writes DIRECTORY/man1/sightline[-SUBCOMMAND...].1 and DIRECTORY/completions/sightline. The help is the only source: a new option
# is in
# both after the next build. `report` has a page if its program is built.
set -eu

# Lines are not wrapped: the pages and the completion read one entry per line.
COLUMNS=100000
export COLUMNS
command=$1
directory=$2
version=$3
here=$(dirname "$0")

rm -rf "$directory/man1" "$directory/completions"
mkdir -p "$directory/man1" "$directory/completions"
words=$directory/completions/words

# write_files SUBCOMMAND... : writes the files of a subcommand and of its subcommands.
write_files() {
  "$command" "$@" --help > "$directory/help" 2> /dev/null || return 0
  name=$(echo sightline "$@" | tr ' ' '-')
  parent=""
  [ $# -eq 0 ] || parent=${name%"-$(eval "echo \${$#}")"}
  awk -f "$here/man_page.awk" -v name="$name" -v parent="$parent" -v version="$version" "$directory/help" > "$directory/man1/$name.1"
  awk -f "$here/completion.awk" -v command="$(echo sightline "$@")" "$directory/help" >> "$words"
  for subcommand in $(awk '/^[^ ]/ { listed = $0 == "Subcommands:" } listed && /^  [^ ]/ { print $1 }' "$directory/help"); do
    write_files "$@" "$subcommand"
  done
}

write_files
cat "$here/completion_head.bash" "$words" "$here/completion_tail.bash" > "$directory/completions/sightline"
rm "$words" "$directory/help"
