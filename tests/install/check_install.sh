#!/bin/sh
# Installs a build into a separate folder and uses it as an outside user would: the command with its man pages and completion, the
# machines and hidden-line removal as libraries (CMake package, pkg-config, add_subdirectory), a Debian package.
#
#   check_install.sh BUILD_DIRECTORY CXX REPORT        REPORT: ON if sightline-report is built
set -eu

build=$1
cxx=$2
report=$3
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() { echo "install: $*" >&2; exit 1; }
quietly() { "$@" > "$work/log" 2>&1 || { cat "$work/log" >&2; fail "$* failed"; }; }

# The output of an example. $1: the program.
check_example() {
  case $1 in
    */pdp7_square) expected="halted: 508 flashes" ;;
    */i8080_hello) expected="halted after 636 T-states, 83 instructions" ;;
    */hidden_lines) expected="14 edges, 12 visible parts, 3 hidden" ;;
    */i8080_watched) expected="PC 0007 after 86 T-states: 5 times DCR B" ;;
  esac
  [ "$(cd "$work" && "$1" | tail -1)" = "$expected" ] || fail "$1 printed something else"
}

# The installed tree can be moved: it contains no absolute path.
quietly cmake --install "$build" --prefix "$work/tree"
mv "$work/tree" "$work/moved"
tree=$work/moved

for file in bin/sightline share/man/man1/sightline.1 share/man/man1/sightline-draw-exact.1 \
            share/bash-completion/completions/sightline share/doc/sightline/LICENSE share/doc/sightline/host/manual/dap.md \
            share/doc/sightline/host/examples/hello.asm include/sightline/i8080/pin_bus.hpp \
            include/sightline/hidden_lines.hpp; do
  [ -s "$tree/$file" ] || fail "$file is missing"
done
"$tree/bin/sightline" --version | grep -q '^sightline [0-9.]*$' || fail "--version"
if [ "$report" = ON ]; then
  "$tree/bin/sightline" report --help | grep -q '^Usage: sightline report' || fail "the installed report is not found"
  [ -s "$tree/share/man/man1/sightline-report.1" ] || fail "sightline-report.1 is missing"
fi

# Man pages: every subcommand has one, and groff gives no warning.
for subcommand in $("$tree/bin/sightline" --help | awk '/^[^ ]/ { l = $0 == "Subcommands:" } l && /^  [^ ]/ { print $1 }'); do
  [ "$subcommand" = report ] || [ -s "$tree/share/man/man1/sightline-$subcommand.1" ] || fail "no man page of $subcommand"
done
if command -v groff > /dev/null; then
  warnings=$(groff -man -ww -z "$tree"/share/man/man1/*.1 2>&1)
  [ -z "$warnings" ] || fail "man pages: $warnings"
fi

# Completion.
if command -v bash > /dev/null; then
  complete_line() {
    bash -c '. "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _sightline; echo "${COMPREPLY[*]}"' - \
      "$tree/share/bash-completion/completions/sightline" "$@"
  }
  [ "$(complete_line sightline dis)" = disasm ] || fail "completion of a subcommand"
  [ "$(complete_line sightline draw exact --orth)" = --orthographic ] || fail "completion of an option"
  [ -z "$(complete_line sightline draw --orth)" ] || fail "an option of a method is completed before its name"
  [ "$(complete_line sightline asm pdp7 --format h)" = hri ] || fail "completion of a value"
  [ "$(complete_line sightline help draw mont)" = montani-re ] || fail "completion of what help explains"
  [ -z "$(complete_line sightline draw exact part.o)" ] || fail "completion of a file name is bash's own"
fi

# The test vectors, in the folders that their README.md names, with the counts that it states.
vectors=$tree/share/sightline/vectors
[ -r "$vectors/README.md" ] || fail "the test vectors have no README.md"
for file in $(sed -n 's/^| `\([^`]*\)` .*/\1/p' "$vectors/README.md"); do
  # shellcheck disable=SC2086 # a pattern, such as type340/events/*.txt
  for found in "$vectors"/$file; do [ -s "$found" ] && [ -r "$found" ] || fail "the README.md of the test vectors names $file, which is missing"; done
done
[ "$(grep -vc '^#' "$vectors/pdp7/instruction-vectors.csv")" = 6688 ] || fail "not the 6,688 instruction vectors that the README.md names"
[ "$(ls "$vectors"/type340/events | grep -c '\.txt$')" -gt 0 ] || fail "no events of the Type 340"
for folder in pdp7 type340 i8080 transcripts/pdp7; do
  [ -s "$vectors/$folder/README.md" ] || fail "no description of the format of the vectors in $folder"
done
[ ! -e "$vectors/approved" ] && [ ! -e "$vectors/meshes" ] || fail "files that say nothing of a machine are among the test vectors"

# The library: by CMake's package, as a folder of another project, by pkg-config.
cmake_build() { # cmake_build DIRECTORY "EXAMPLE..." OPTION...
  directory=$work/$1
  examples=$2
  shift 2
  quietly cmake -S "$here/examples" -B "$directory" -G Ninja -DCMAKE_CXX_COMPILER="$cxx" -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS_DEBUG=-O0 "$@"
  # shellcheck disable=SC2086 # the list is split on purpose
  quietly cmake --build "$directory" --target $examples
  for example in $examples; do check_example "$directory/$example"; done
}
cmake_build package "pdp7_square i8080_hello i8080_watched hidden_lines" -DCMAKE_PREFIX_PATH="$tree"
grep -q '<path' "$work/hidden_lines.svg" || fail "the drawing of the example has no lines"
cmake_build subdirectory pdp7_square -DSIGHTLINE_SOURCE="$source"
# A project that contains the machines as a folder installs only its own files.
quietly cmake --install "$work/subdirectory" --prefix "$work/of-a-project"
[ ! -e "$work/of-a-project" ] || fail "a project with add_subdirectory(emulators) installs $(find "$work/of-a-project" -type f | wc -l) files of it"
if command -v pkg-config > /dev/null; then
  flags=$(PKG_CONFIG_PATH=$(dirname "$(find "$tree" -name sightline.pc)") pkg-config --cflags --libs sightline)
  mkdir "$work/pkg-config"
  # shellcheck disable=SC2086 # the flags are split on purpose
  quietly "$cxx" -std=c++20 "$here/examples/i8080_hello.cpp" $flags -o "$work/pkg-config/i8080_hello"
  check_example "$work/pkg-config/i8080_hello"
  flags=$(PKG_CONFIG_PATH=$(dirname "$(find "$tree" -name sightline-hidden-lines.pc)") pkg-config --cflags --libs sightline-hidden-lines)
  # shellcheck disable=SC2086 # the flags are split on purpose
  quietly "$cxx" -std=c++20 -Wall -Wextra -Wpedantic -Werror "$here/examples/hidden_lines.cpp" $flags \
    "-Wl,-rpath,$(dirname "$(find "$tree" -name 'libsightline_hidden_lines.so')")" -o "$work/pkg-config/hidden_lines"
  check_example "$work/pkg-config/hidden_lines"
fi
# The shared library exports its own functions only.
if command -v nm > /dev/null; then
  foreign=$(nm -DC --defined-only "$(find "$tree" -name 'libsightline_hidden_lines.so')" | cut -d' ' -f3- |
            grep -v '^\(vtable for \|typeinfo for \|typeinfo name for \)\{0,1\}sightline::[A-Z_a-z]*\(::\|(\|\[\|$\)' || true)
  [ -z "$foreign" ] || fail "the library exports $foreign"
fi

# The headers use no exceptions and run-time types, and include no streams, files, threads or clocks. (<memory> includes
# <stdexcept>.)
find "$tree/include" -name '*.hpp' ! -name hidden_lines.hpp | sort | sed 's/.*/#include "&"/' > "$work/all.cpp"
quietly "$cxx" -std=c++20 -fno-exceptions -fno-rtti -Wall -Wextra -Werror -fsyntax-only "$work/all.cpp"
heavy=$("$cxx" -std=c++20 -M "$work/all.cpp" | tr -s ' ' '\n' |
        grep -E '/(iostream|fstream|sstream|locale|filesystem|thread|mutex|regex|chrono)$' || true)
[ -z "$heavy" ] || fail "the machines' headers read $heavy"

# A Debian package of the same files.
if command -v dpkg-deb > /dev/null && command -v dpkg-shlibdeps > /dev/null; then
  quietly cpack --config "$build/CPackConfig.cmake" -B "$work/deb" -D CPACK_INSTALL_CMAKE_PROJECTS= \
    -D "CPACK_INSTALLED_DIRECTORIES=$tree;/usr"
  deb=$(find "$work/deb" -maxdepth 1 -name '*.deb')
  dpkg-deb -f "$deb" Depends | grep -q 'libpng' || fail "the package does not depend on libpng"
  dpkg-deb -x "$deb" "$work/root"
  cmp -s "$vectors/i8080/single-step.txt" "$work/root/usr/share/sightline/vectors/i8080/single-step.txt" || fail "the package has no test vectors"
  "$work/root/usr/bin/sightline" --version > /dev/null || fail "the packaged command does not run"
  [ -s "$work/root/usr/include/sightline/hidden_lines.hpp" ] || fail "the package has no header of the library"
  [ -n "$(find "$work/root/usr" -name 'libsightline_hidden_lines.so.0')" ] || fail "the package has no library"
fi
