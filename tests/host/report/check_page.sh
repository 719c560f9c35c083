#!/bin/sh
# Opens a report in headless Chromium at 1280 and 390 pixels and prints it. Fails if an element is wider than the page (except in
# scrolling
# frames), folded or unfolded, if the folded page is longer than 40 screens of 1280 x 900, if it is larger than 4 MB, or if it
# cannot
# be printed. Succeeds with a message without Chromium.
#
#   check_page.sh [PAGE.html]    without a page: builds the report and checks that
set -eu

page=${1:-}
most_bytes=4000000
most_screens=40

browser=""
for name in chromium chromium-browser google-chrome; do
  if command -v "$name" >/dev/null; then browser=$name; break; fi
done
if [ -z "$browser" ]; then
  echo "check page: skipped, Chromium is not installed (Debian: chromium)"
  exit 0
fi

if [ -z "$page" ]; then
  "$(dirname "$0")/../../../tools/dev" report --quiet -o build/page >&2
  page=$(dirname "$0")/../../../build/page/index.html
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failed=0
fail() { echo "check page: $*" >&2; failed=1; }

bytes=$(wc -c < "$page")
[ "$bytes" -lt "$most_bytes" ] || fail "$bytes bytes, expected fewer than $most_bytes"

# A copy of the page that measures itself: the report has no script.
# $1: width in pixels, $2: folded, unfolded or print. Prints "HEIGHT" and a line for each element that is too wide.
measure() {
  {
    cat "$page"
    cat <<SCRIPT
<script>
if ('$2' !== 'folded') for (const d of document.querySelectorAll('details')) d.open = true;
const width = document.documentElement.clientWidth;
const scrolls = e => { for (let p = e.parentElement; p; p = p.parentElement)
  if (p !== document.body && /auto|scroll|hidden/.test(getComputedStyle(p).overflowX)) return true; return false; };
const wide = [...document.body.querySelectorAll('*')].filter(e => {
  const box = e.getBoundingClientRect();
  return box.width > 0 && (box.right > width + 0.5 || box.left < -0.5) && !scrolls(e); });
const lines = wide.slice(0, 5).map(e => '<' + e.tagName.toLowerCase() + ' class=' + e.className + '> at ' +
  Math.round(e.getBoundingClientRect().right) + ': ' + e.textContent.slice(0, 50).replace(/\s+/g, ' '));
if (document.documentElement.scrollWidth > width) lines.push('the page scrolls sideways: ' + document.documentElement.scrollWidth);
const height = Math.ceil(document.documentElement.scrollHeight);
const said = document.createElement('pre');
said.textContent = 'MEASURED ' + height + ' ' + width + '\n' + lines.map(l => 'WIDE ' + l).join('\n') + '\nEND';
document.body.replaceChildren(said);
</script>
SCRIPT
  } > "$folder/measured.html"
  # A window is at least 500 pixels wide, so the page is measured in a frame of the requested width.
  cat > "$folder/frame.html" <<FRAME
<body style="margin:0"><iframe id="f" src="measured.html" style="width:$1px;height:900px;border:0"></iframe>
<script>f.onload = () => { document.body.innerText = f.contentDocument.body.innerText; };</script>
FRAME
  "$browser" --headless --no-sandbox --disable-gpu --allow-file-access-from-files --user-data-dir="$folder/profile" \
    --virtual-time-budget=20000 --window-size=1400,900 --dump-dom "file://$folder/frame.html" 2>/dev/null > "$folder/dom.txt" || true
  grep -q "MEASURED" "$folder/dom.txt" || { fail "$1 pixels, $2: the page was not measured"; return; }
  height=$(sed -n 's/.*MEASURED \([0-9]*\) .*/\1/p' "$folder/dom.txt" | head -n 1)
  if grep "WIDE" "$folder/dom.txt" | sed 's/<br>/\n/g' | grep "WIDE" >&2; then fail "$1 pixels, $2: wider than the page"; fi
  echo "check page: $1 pixels, $2: $height pixels high"
}

measure 1280 folded
screens=$(( (height + 899) / 900 ))
[ "$screens" -le "$most_screens" ] || fail "$screens screens of 1280 x 900, expected $most_screens at most"
measure 1280 unfolded
measure 390 folded
measure 390 unfolded

# Print: A4 between margins is 718 CSS pixels wide; the print rules are applied to the screen.
cp "$page" "$folder/page.html"
sed 's/@media print/@media all/' "$page" > "$folder/print.html"
page=$folder/print.html
measure 718 unfolded
"$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$folder/profile" --no-pdf-header-footer \
  --print-to-pdf="$folder/page.pdf" "file://$folder/page.html" >/dev/null 2>&1 || true
if [ -s "$folder/page.pdf" ]; then
  echo "check page: printed, $(wc -c < "$folder/page.pdf") bytes of PDF"
else
  fail "the page cannot be printed"
fi

[ "$failed" -eq 0 ] || exit 1
echo "check page: $bytes bytes, $screens screens of 1280 x 900: passed"
