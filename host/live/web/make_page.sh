#!/bin/sh
# The page as one file: the module, the scripts and the examples packed in one piece, the styles as they are.
#
#   make_page.sh MODULE.wasm VERSION PAGE.html
#
# Beside it PAGE.html.gz. The same files give the same bytes; libdeflate, where it is installed, makes 5 % fewer of them than gzip.
set -eu

root=$(cd "$(dirname "$0")/../../.." && pwd)
module=$1
version=$2
page=$3
parts=$(mktemp -d)
trap 'rm -rf "$parts"' EXIT
export LC_ALL=C

# Standard input compressed, with neither name nor time in it.
compress() {
  if command -v libdeflate-gzip >/dev/null; then libdeflate-gzip -12 -c; else gzip -9 -n -c; fi
}

printf '%s' "$version" > "$parts/version"
cp "$root"/host/live/web/page/page.css "$root"/host/explain/player/player.css "$parts/"
cp "$module" "$parts/module"
for script in "$root"/host/live/web/page/*.js "$root"/host/explain/player/player.js; do
  sed "s|from '\./|from 'sightline/|" "$script" > "$parts/$(basename "$script")"
done

# Texts as JSON strings; < as an escape, so that none can end the script element.
text_as_json() {
  cat "$@" | sed 's/\\/\\\\/g; s/"/\\"/g; s/\t/\\t/g; s/\r/\\r/g; s/\f/\\f/g; s/</\\u003c/g' | awk '{ printf "%s\\n", $0 }'
}
# What the module has of the firmware is taken from there: of such files only the names, and they come first.
{
  printf '['
  comma=""
  grep -v '^#' "$root/host/live/web/examples.txt" | while IFS='|' read -r files machine title more; do
    # Of several files the folder's name: two programs may have sources of the same name.
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

# One piece: a line that says what is in it, then the files.
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
# What has not changed stays as old as it is: nothing is built again for it.
if [ -f "$page" ] && [ -f "$page.gz" ] && cmp -s "$page.new" "$page"; then
  rm "$page.new"
else
  compress < "$page.new" > "$page.gz.new"
  mv "$page.gz.new" "$page.gz"
  mv "$page.new" "$page"
fi
