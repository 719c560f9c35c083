// See asm_files.hpp.
#include "host/app/commands/asm_files.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <system_error>
#include <utility>

#include "host/base/file.hpp"

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

void refuse_clashing_files(const AsmFiles& files) {
  const std::array<std::pair<const char*, const std::string*>, 3> outputs{
      {{"-o", &files.output}, {"--listing", &files.listing}, {"--symbols", &files.symbols}}};
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto& [option, name] = outputs[i];
    if (name->empty()) continue;
    for (std::size_t other = 0; other < i; ++other) {
      if (!outputs[other].second->empty() && are_one_file(*name, *outputs[other].second))
        throw Failure(ExitCode::usage, fmt::format("{}: found {}, expected another file than that of {}",
                                                   option, shown_name(*name), outputs[other].first));
    }
    for (const std::string& source : files.sources) {
      if (*name != "-" && are_one_file(*name, source))
        throw Failure(ExitCode::usage,
                      fmt::format("{}: found {}, expected no file that is a source", option, *name));
    }
  }
}

std::vector<assembler::SourceFile> read_sources(const AsmFiles& files) {
  std::vector<assembler::SourceFile> sources;
  for (const std::string& path : files.sources) sources.push_back({shown_name(path), read_input_text(path)});
  return sources;
}

void report_diagnostics(std::span<const assembler::Diagnostic> diagnostics) {
  for (const auto& diagnostic : diagnostics) fmt::print(stderr, "{}\n", assembler::to_string(diagnostic));
  if (assembler::any_errors(diagnostics))
    throw Failure(ExitCode::bad_input, "the source has errors; nothing was written");
}

void write_asm_files(const AsmFiles& files, const base::Bytes& program, std::string_view listing,
                     std::string_view symbols) {
  std::vector<Output> outputs;
  if (!files.output.empty()) outputs.emplace_back(files.output).write(std::span(program));
  if (!files.listing.empty()) outputs.emplace_back(files.listing).write(listing);
  if (!files.symbols.empty()) outputs.emplace_back(files.symbols).write(symbols);
  for (Output& output : outputs) output.commit();
}

}  // namespace sightline::app
