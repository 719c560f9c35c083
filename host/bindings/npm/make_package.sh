#!/bin/sh
# Makes the package for npm: a tar with the folder package/.
#
#   make_package.sh MODULE.wasm VERSION PACKAGE.tgz
#
# The same inputs give the same bytes.
set -eu

root=$(cd "$(dirname "$0")/../../.." && pwd)
module=$1
version=$2
archive=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LC_ALL=C

mkdir "$work/package"
for file in index.js mesh.js module.js worker.js index.d.ts package.json README.md example.html; do
  sed "s/@VERSION@/$version/" "$root/host/bindings/npm/$file" > "$work/package/$file"
done
cp "$module" "$work/package/sightline.wasm"
cp "$root/LICENSE" "$work/package/LICENSE"
chmod 644 "$work"/package/*

mkdir -p "$(dirname "$archive")"
# The time is that of all files in archives that npm makes, 1985-10-26.
tar -C "$work" --sort=name --owner=0 --group=0 --numeric-owner --mtime=@499162500 --format=ustar -cf - package | gzip -9 -n > "$work/archive"
mv "$work/archive" "$archive"
chmod 644 "$archive"
