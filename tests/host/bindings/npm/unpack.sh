#!/bin/sh
# Unpacks the package into the node_modules of an empty folder, and runs a command there with the package's folder after its
# first two words.
#
#   unpack.sh PACKAGE.tgz PROGRAM SCRIPT [ARGUMENT...]
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
package=$folder/node_modules/sightline-hidden-lines
mkdir -p "$package"
tar -xzf "$1" --strip-components=1 -C "$package"
program=$2
script=$3
shift 3
cd "$folder"
"$program" "$script" "$package" "$@"
