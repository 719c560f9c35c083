#!/bin/sh
# The page as one file: the module packed, the scripts as data: addresses of an import map, the examples as JSON.
#
#   make_page.sh MODULE.wasm VERSION PAGE.html
#
# Beside it PAGE.html.gz. The same files give the same bytes.
set -eu

root=$(cd "$(dirname "$0")/../../.." && pwd)
module=$1
version=$2
page=$3
parts=$(mktemp -d)
trap 'rm -rf "$parts"' EXIT
export LC_ALL=C

gzip -9 -n -c "$module" | base64 -w 0 > "$parts/module"
printf '%s' "$version" > "$parts/version"
cp "$root"/host/live/web/page/page.css "$root"/host/explain/player/player.css "$parts/"

# Modules import each other by names that the map knows: a data: address has no neighbours.
{
  printf '{"imports":{'
  comma=""
  for script in "$root"/host/live/web/page/*.js "$root"/host/explain/player/player.js; do
    printf '%s"sightline/%s":"data:text/javascript;base64,' "$comma" "$(basename "$script")"
    sed "s|from '\./|from 'sightline/|" "$script" | base64 -w 0
    printf '"'
    comma=","
  done
  printf '}}'
} > "$parts/importmap"

# Texts as JSON strings; < as an escape, so that none can end the script element.
text_as_json() {
  cat "$@" | sed 's/\\/\\\\/g; s/"/\\"/g; s/\t/\\t/g; s/\r/\\r/g; s/\f/\\f/g; s/</\\u003c/g' | awk '{ printf "%s\\n", $0 }'
}
{
  printf '['
  comma=""
  grep -v '^#' "$root/host/live/web/examples.txt" | while IFS='|' read -r files machine title more; do
    name=$(basename "${files%% *}")
    printf '%s{"name":"%s","machine":"%s","title":"%s"' "$comma" "$name" "$machine" "${title:-$name}"
    [ -z "$more" ] || printf ',%s' "$more"
    printf ',"text":"'
    (cd "$root" && text_as_json $files)
    printf '"}'
    comma=","
  done
  printf ']'
} > "$parts/examples"

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
  gzip -9 -n -c "$page.new" > "$page.gz.new"
  mv "$page.gz.new" "$page.gz"
  mv "$page.new" "$page"
fi
