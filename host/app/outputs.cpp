#include "host/app/outputs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <vector>

namespace sightline::app {

bool open_outputs(std::span<const NamedOutput> outputs, bool json, std::string_view stdout_twice) {
  std::vector<std::string_view> named;
  for (const NamedOutput& wanted : outputs) {
    if (wanted.path->empty()) continue;
    if (std::find(named.begin(), named.end(), *wanted.path) != named.end()) {
      throw base::usage_error(*wanted.path == "-"
                                         ? std::string(stdout_twice)
                                         : fmt::format("{}: named for two outputs", *wanted.path));
    }
    named.push_back(*wanted.path);
  }
  const bool uses_stdout = std::find(named.begin(), named.end(), "-") != named.end();
  if (uses_stdout && json)
    throw base::usage_error("--json needs standard output; an output cannot be `-`");
  for (const NamedOutput& wanted : outputs) {
    if (!wanted.path->empty()) wanted.output->emplace(*wanted.path);
  }
  return uses_stdout;
}

bool are_one_file(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  if (a == "-" || b == "-") return a == b;
  std::error_code failed;  // an error is reported when the file is opened
  if (fs::exists(a, failed) && !fs::is_regular_file(a, failed)) return false;
  if (fs::equivalent(a, b, failed)) return true;
  const fs::path place = fs::weakly_canonical(fs::absolute(a, failed), failed);
  return !place.empty() && place == fs::weakly_canonical(fs::absolute(b, failed), failed);
}

void write_png(Output& output, const picture::Image& image, const picture::TextEntries& text) {
  const auto bytes = picture::encode_png(image, text);
  if (!bytes) throw base::io_error(bytes.error().message());
  output.write(std::span<const std::uint8_t>(*bytes));
}

void report_equal(const std::string& name) {
  print_message(fmt::format("{}: checked: equal to the same program in C++", name));
}

void make_directory(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw base::io_error(directory + ": " + error.message());
}

std::string file_stem(const std::string& name) {
  std::string stem = name;
  std::replace_if(
      stem.begin(), stem.end(),
      [](char c) {
        return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                 c == '_');
      },
      '_');
  return stem;
}

}  // namespace sightline::app
