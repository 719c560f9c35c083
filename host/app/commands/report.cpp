#include <unistd.h>

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include "host/app/commands/commands.hpp"

namespace sightline::app {

void add_report_command(const Command& program) {
  program.add_command("report", help_page("report").summary);
}

std::optional<std::string> report_program() {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const char* place : {"sightline-report", SIGHTLINE_LIBEXEC_FROM_BIN "/sightline-report"}) {
    const std::filesystem::path program = folder / place;
    if (std::filesystem::exists(program, error)) return program.string();
  }
  return std::nullopt;
}

ExitCode run_report_program(char** argv) {
  if (const auto program = report_program()) execv(program->c_str(), argv);
  print_message(
      "found no program sightline-report, which makes the report; `tools/dev report` in the source tree "
      "builds and runs it");
  return ExitCode::io;
}

}  // namespace sightline::app
