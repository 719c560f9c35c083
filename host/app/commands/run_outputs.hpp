// The files a PDP-7 run writes: opened before it, filled during and after it, put in their places at the end.
#pragma once

#include <memory>
#include <optional>

#include "host/app/command.hpp"
#include "host/app/commands/run_arguments.hpp"
#include "host/guests/run/pdp7.hpp"
#include "host/guests/run/screen.hpp"

namespace sightline::app {

class RunOutputs {
 public:
  // Failure usage if a path is named twice or more than one goes to standard output; Failure io if one cannot
  // be written.
  explicit RunOutputs(const RunArguments& arguments);

  // Hangs the takers of trace and strokes on the job; this object then outlives the run.
  void attach(harness::Pdp7Job& job);
  // Writes what the run left behind, and puts all files in their places. Failure io.
  void write(const harness::Pdp7Report& report);

  // Standard output is taken by one of the files.
  [[nodiscard]] bool uses_stdout() const { return uses_stdout_; }

 private:
  void write_picture(const harness::Pdp7Report& report);
  void write_photograph(const harness::Pdp7Report& report);

  std::optional<Output> dump_;
  std::optional<Output> trace_;
  std::optional<Output> strokes_;
  std::optional<Output> png_;
  std::optional<Output> phosphor_;
  std::optional<Output> svg_;
  std::optional<Output> punch_;
  std::optional<Output> teletype_;
  std::unique_ptr<harness::Screen> screen_;
  bool uses_stdout_ = false;
};

}  // namespace sightline::app
