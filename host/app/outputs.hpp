// What subcommands with several outputs share: files named by options, pictures, the folder they go to.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "host/app/command.hpp"
#include "host/picture/image.hpp"
#include "host/picture/png.hpp"

namespace sightline::app {

// The path of an option, empty if it was not given, and what is to be opened there.
struct NamedOutput {
  const std::string* path = nullptr;
  std::optional<Output>* output = nullptr;
};

// Opens those that were named, once all names have been looked at; true if one of them is standard output.
// Error usage if two have one name (said with `stdout_twice` of standard output), or if one is standard
// output and `json` needs it; Error io if one cannot be written.
[[nodiscard]] bool open_outputs(std::span<const NamedOutput> outputs, bool json,
                                std::string_view stdout_twice = "-: named for two outputs");

// Error io if the image is larger than a PNG may be.
void write_png(Output& output, const picture::Image& image, const picture::TextEntries& text);

// The name of a scene or model as part of a file name: all but letters, digits, - and _ becomes _.
[[nodiscard]] std::string file_stem(const std::string& name);

// With those above it; no error if it is there. Error io.
void make_directory(const std::string& directory);

}  // namespace sightline::app
