#!/bin/sh
# Tests the page of live machines in headless Chromium (check_page.py). Succeeds with a message where Chromium, its driver or
# Selenium are not installed.
#
#   check_page.sh [PAGE.html SIGHTLINE [FOLDER]]    default: the page of build/release
set -eu

root=$(cd "$(dirname "$0")/../../../.." && pwd)
page=${1:-$root/build/release/sightline.html}
sightline=${2:-$root/build/release/host/app/sightline}
for needed in chromium chromedriver; do
  command -v "$needed" >/dev/null || { echo "check page: skipped, $needed is not installed (Debian: chromium chromium-driver python3-selenium)"; exit 0; }
done
/usr/bin/python3 -c 'import selenium' 2>/dev/null || { echo "check page: skipped, python3-selenium is not installed"; exit 0; }
[ -f "$page" ] || { echo "check page: skipped, the page was not built: clang 14 and wasi-libc are not installed"; exit 0; }
run() { timeout 1200 /usr/bin/python3 "$root/tests/host/live/web/check_page.py" "$page" "$sightline" ${3:+"$3"}; }
# A browser that got too little processor time is tried again; an error of the page fails twice.
run "$@" || { echo "check page: failed, tried again"; run "$@"; }
