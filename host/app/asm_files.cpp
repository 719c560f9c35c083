// See asm_files.hpp.
#include "host/app/asm_files.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include "host/app/command.hpp"

namespace sightline::app {

namespace {

// Also of files not there yet, and by way of links.
bool are_one_file(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  if (a == "-" || b == "-") return a == b;
  std::error_code failed;  // what cannot be looked at is told when it is opened
  if (fs::exists(a, failed) && !fs::is_regular_file(a, failed)) return false;
  if (fs::equivalent(a, b, failed)) return true;
  const fs::path place = fs::weakly_canonical(fs::absolute(a, failed), failed);
  return !place.empty() && place == fs::weakly_canonical(fs::absolute(b, failed), failed);
}

}  // namespace

void refuse_clashing_files(const std::vector<std::string>& sources, const std::string& output,
                           const std::string& listing, const std::string& symbols) {
  const std::array<std::pair<const char*, const std::string*>, 3> outputs{
      {{"-o", &output}, {"--listing", &listing}, {"--symbols", &symbols}}};
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto& [option, name] = outputs[i];
    if (name->empty()) continue;
    for (std::size_t other = 0; other < i; ++other) {
      if (!outputs[other].second->empty() && are_one_file(*name, *outputs[other].second))
        throw Failure(ExitCode::usage, fmt::format("{}: found {}, expected another file than that of {}",
                                                   option, shown_name(*name), outputs[other].first));
    }
    for (const std::string& source : sources) {
      if (*name != "-" && are_one_file(*name, source))
        throw Failure(ExitCode::usage,
                      fmt::format("{}: found {}, expected no file that is a source", option, *name));
    }
  }
}

}  // namespace sightline::app
