#!/bin/sh
# Runs check_page.py. Succeeds with a message where Chromium, its driver or Selenium are not installed.
#
#   check_page.sh PACKAGE_FOLDER
set -eu

for needed in chromium chromedriver; do
  command -v "$needed" >/dev/null || { echo "check page: skipped, $needed is not installed (Debian: chromium chromium-driver python3-selenium)"; exit 0; }
done
/usr/bin/python3 -c 'import selenium' 2>/dev/null || { echo "check page: skipped, python3-selenium is not installed"; exit 0; }
run() { timeout 200 /usr/bin/python3 "$(dirname "$0")/check_page.py" "$@"; }
# A browser that got too little processor time is tried again; an error of the page fails twice.
run "$@" || { echo "check page: failed, tried again"; run "$@"; }
