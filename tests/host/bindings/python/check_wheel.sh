#!/bin/sh
# Makes the wheel, installs it into an empty folder, and runs a program of ten lines there that knows only what the README says.
#
#   check_wheel.sh PYTHON PACKAGE        PACKAGE: the folder of the package in the build
set -eu
python=$1
package=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() { echo "wheel: $*" >&2; exit 1; }

# A copy, because setup.py writes into its folder.
cp -RL "$package" "$work/package"
(cd "$work/package" && "$python" setup.py -q bdist_wheel -d "$work/wheel") > "$work/log" 2>&1 || { cat "$work/log" >&2; fail "setup.py failed"; }
wheel=$(echo "$work"/wheel/*.whl)
tag=$("$python" -c 'import sys, sysconfig; v = "cp%d%d" % sys.version_info[:2]; print(v, v, sysconfig.get_platform().replace("-", "_").replace(".", "_"), sep="-")')
case $wheel in
  "$work"/wheel/sightline-[0-9]*-"$tag".whl) ;;
  *) fail "the wheel is $wheel, expected sightline-VERSION-$tag.whl" ;;
esac
files=$("$python" -m zipfile -l "$wheel" | awk 'NR > 1 { print $1 }' | sed 's/^sightline-[0-9.]*dist-info/INFO/; s/_core\..*\.so/_core.so/' | sort | tr '\n' ' ')
expected="INFO/LICENSE INFO/METADATA INFO/RECORD INFO/WHEEL INFO/top_level.txt sightline/__init__.py sightline/_arguments.py sightline/_core.so sightline/_errors.py sightline/py.typed "
[ "$files" = "$expected" ] || fail "the wheel contains $files, expected $expected"

if "$python" -m pip --version > /dev/null 2>&1; then
  "$python" -m pip install -q --no-deps --no-index --no-cache-dir --disable-pip-version-check --target "$work/installed" "$wheel" > "$work/log" 2>&1 ||
    { cat "$work/log" >&2; fail "pip cannot install the wheel"; }
else
  "$python" -m zipfile -e "$wheel" "$work/installed"
fi

mkdir "$work/empty"
cd "$work/empty"
cat > program.py << 'END'
import numpy as np
import sightline

corners = np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)], np.float32)
faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
drawing = sightline.hidden_lines(corners, faces, view="iso", hidden=True)
drawing.save("cube.svg")
print(len(drawing.lines), drawing.line_hidden.sum(), sightline.__version__)
END
found=$(PYTHONPATH="$work/installed" "$python" program.py)
version=$(echo "$wheel" | sed 's/.*sightline-\([0-9.]*\)-.*/\1/')
[ "$found" = "12 3 $version" ] || fail "the program printed $found, expected 12 3 $version"
# On 220 mm of paper six lines of a cube are silhouettes, three are creases, and the hidden ones are dashes.
"$python" - cube.svg << 'END'
import re
import sys
import xml.etree.ElementTree as tree

name = "{http://www.w3.org/2000/svg}"
svg = tree.parse(sys.argv[1]).getroot()
assert svg.tag == name + "svg" and svg.get("width") == svg.get("height") == "220.000mm", svg.attrib
lines = {}
for group in svg.iter(name + "g"):
    paths = [path.get("d") for path in group.iter(name + "path")]
    points = sum(len(re.findall(r"-?[0-9.]+", path)) // 2 for path in paths)
    lines[group.get("{http://www.inkscape.org/namespaces/inkscape}label")] = points - len(paths)
dashes = lines.pop("3 hidden")
assert lines == {"1 silhouette": 6, "2 crease": 3}, lines
assert dashes > 30, dashes
END
