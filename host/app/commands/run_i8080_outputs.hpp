// The files an 8080 run writes: opened before it, filled during and after it, put in their places at the end.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "host/app/command.hpp"
#include "host/app/commands/run_i8080_arguments.hpp"
#include "host/guests/run/i8080.hpp"

namespace sightline::app {

class RunI8080Outputs {
 public:
  // What CP/M programs print goes to --console, else to standard output, else (with --json) into the report.
  // Failure usage if a path is named twice or more than one output goes to standard output; Failure io if one
  // cannot be written.
  explicit RunI8080Outputs(const RunI8080Arguments& arguments);

  // Hangs the takers of texts on the job; this object then outlives the run.
  void attach(harness::I8080Job& job);
  // Writes what the run left behind, and puts all files in their places. Failure io.
  void write(const harness::I8080Report& report);

  // Standard output is taken by one of the outputs.
  [[nodiscard]] bool uses_stdout() const { return uses_stdout_; }
  // What was printed, as far as the report has it: its first 16 MiB.
  [[nodiscard]] const std::optional<std::string>& kept_console() const { return kept_console_; }

 private:
  void keep(std::string_view printed);

  std::optional<Output> dump_;
  std::optional<Output> trace_;
  std::optional<Output> bus_;
  std::optional<Output> console_;
  std::optional<Output> png_;
  std::optional<Output> strokes_;
  std::optional<Output> svg_;
  std::optional<Output> parallel_out_;
  std::optional<Output> serial_out_;
  std::optional<std::string> kept_console_;
  std::uint64_t console_left_out_ = 0;  // bytes
  bool grey_ = false;
  bool minigraf_ = false;
  bool uses_stdout_ = false;
};

}  // namespace sightline::app
