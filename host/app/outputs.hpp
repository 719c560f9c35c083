// Opens and writes the outputs of subcommands that have several: files named by options, pictures and their folder.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "host/app/command.hpp"
#include "host/picture/image.hpp"
#include "host/picture/png.hpp"

namespace sightline::app {

// The path of an option (empty: not given) and the output to be opened there.
struct NamedOutput {
  const std::string* path = nullptr;
  std::optional<Output>* output = nullptr;
};

// Checks all paths, then opens the outputs that were named; true if one of them is standard output. Error usage: two have the
// same path (for standard output with the text `stdout_twice`), or one is standard output and `json` needs it. Error io: one
// cannot be written.
[[nodiscard]] bool open_outputs(std::span<const NamedOutput> outputs, bool json,
                                std::string_view stdout_twice = "-: named for two outputs");

// Whether two paths lead to the same file; follows links, and works for files that do not exist yet. `-` is one file, and what is
// not a regular file (/dev/null) is none.
[[nodiscard]] bool are_one_file(const std::string& a, const std::string& b);

// Error io: the image exceeds the size limit of PNG.
void write_png(Output& output, const picture::Image& image, const picture::TextEntries& text);

// The name of a scene or model as part of a file name: every character except letters, digits, - and _ becomes _.
[[nodiscard]] std::string file_stem(const std::string& name);

// The message of --check when nothing differs, on standard error: what the machine made equals what the same program in C++ makes.
void report_equal(const std::string& name);

// Creates a directory with its parents, unless it exists. Error io.
void make_directory(const std::string& directory);

}  // namespace sightline::app
