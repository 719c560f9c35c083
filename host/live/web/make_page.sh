#!/bin/sh
# Makes the page as one file: the module, the scripts and the examples are compressed together, the styles are not compressed.
#
#   make_page.sh MODULE.wasm VERSION PAGE.html
#
# Also writes PAGE.html.gz. The same inputs give the same bytes; libdeflate, if it is installed, compresses 5 % better than gzip.
set -eu

root=$(cd "$(dirname "$0")/../../.." && pwd)
module=$1
version=$2
page=$3
parts=$(mktemp -d)
trap 'rm -rf "$parts"' EXIT
export LC_ALL=C

# Compresses standard input, without a name and a time.
compress() {
  if command -v libdeflate-gzip >/dev/null; then libdeflate-gzip -12 -c; else gzip -9 -n -c; fi
}

printf '%s' "$version" > "$parts/version"
cp "$root"/host/live/web/page/page.css "$root"/host/explain/player/player.css "$parts/"
cp "$module" "$parts/module"
for script in "$root"/host/live/web/page/*.js "$root"/host/explain/player/player.js; do
  sed "s|from '\./|from 'sightline/|" "$script" > "$parts/$(basename "$script")"
done

# Writes texts as JSON strings; < is escaped, so that no text can end the script element.
text_as_json() {
  cat "$@" | sed 's/\\/\\\\/g; s/"/\\"/g; s/\t/\\t/g; s/\r/\\r/g; s/\f/\\f/g; s/</\\u003c/g' | awk '{ printf "%s\\n", $0 }'
}
# The module contains the firmware: of such files only the names are written, before the other texts.
{
  printf '['
  comma=""
  grep -v '^#' "$root/host/live/web/examples.txt" | while IFS='|' read -r files machine title more; do
    # Several files have the name of their folder, because two programs may have sources of the same name.
    name=$(basename "${files%% *}")
    [ "$files" = "${files%% *}" ] || name=$(basename "$(dirname "${files%% *}")").s
    printf '%s{"name":"%s","machine":"%s","title":"%s"' "$comma" "$name" "$machine" "${title:-$name}"
    [ -z "$more" ] || printf ',%s' "$more"
    sources=""
    own=""
    for file in $files; do
      case $file in
        firmware/*/scenes/*) own="$own $file" ;;
        firmware/*) sources="$sources${sources:+,}\"${file#firmware/*/}\"" ;;
        *) own="$own $file" ;;
      esac
    done
    [ -z "$sources" ] || printf ',"sources":[%s]' "$sources"
    printf ',"text":"'
    [ -z "$own" ] || (cd "$root" && text_as_json $own)
    printf '"}'
    comma=","
  done
  printf ']'
} > "$parts/examples"

# The compressed part: a line that lists the files, then the files.
{
  printf '['
  comma=""
  for file in examples module "$parts"/*.js; do
    printf '%s["%s",%d]' "$comma" "$(basename "$file")" "$(wc -c < "$parts/$(basename "$file")")"
    comma=","
  done
  printf ']\n'
  cat "$parts/examples" "$parts/module" "$parts"/*.js
} | compress | base64 -w 0 > "$parts/files"

mkdir -p "$(dirname "$page")"
awk -v parts="$parts" '
  {
    line = $0
    while (match(line, /\{\{[a-z.]+\}\}/)) {
      printf "%s", substr(line, 1, RSTART - 1)
      file = parts "/" substr(line, RSTART + 2, RLENGTH - 4)
      first = 1
      while ((getline text < file) > 0) { printf "%s%s", first ? "" : "\n", text; first = 0 }
      close(file)
      line = substr(line, RSTART + RLENGTH)
    }
    print line
  }' "$root/host/live/web/page/page.html" > "$page.new"
# An unchanged page keeps its time, so that nothing is rebuilt.
if [ -f "$page" ] && [ -f "$page.gz" ] && cmp -s "$page.new" "$page"; then
  rm "$page.new"
else
  compress < "$page.new" > "$page.gz.new"
  mv "$page.gz.new" "$page.gz"
  mv "$page.new" "$page"
fi
