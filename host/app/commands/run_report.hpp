// What `sightline run pdp7` says about a run that is over.
#pragma once

#include <string>

#include "host/app/command.hpp"
#include "host/app/commands/run_arguments.hpp"
#include "host/guests/run/pdp7.hpp"

namespace sightline::app {

// One JSON document, schema sightline/run-pdp7/1. Addresses and words are octal strings, counts numbers;
// "timing" has what --timing set.
[[nodiscard]] std::string json_report(const RunArguments& arguments, const harness::Pdp7Job& job,
                                      const harness::Pdp7Report& report);

// The same for a person, some lines.
[[nodiscard]] std::string table_report(const harness::Pdp7Job& job, const harness::Pdp7Report& report);

// Warnings on standard error: codes nothing obeyed, a reader without tape.
void warn_about(const harness::Pdp7Report& report);

// Complains about a stop that is a failure.
[[nodiscard]] ExitCode judge(const harness::Pdp7Report& report);

}  // namespace sightline::app
