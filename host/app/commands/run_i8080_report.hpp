// What `sightline run i8080` says about a run that is over.
#pragma once

#include <optional>
#include <string>

#include "host/app/command.hpp"
#include "host/guests/run/i8080.hpp"

namespace sightline::app {

// One JSON document, schema sightline/run-i8080/1. Addresses and registers are hexadecimal strings, counts
// numbers; emulated_ns is null beyond 292 years. `console`: what the program printed, a character a byte; absent if it went elsewhere.
[[nodiscard]] std::string json_report(const harness::I8080Job& job, const harness::I8080Report& report,
                                      const std::optional<std::string>& console);

// The same for a person, some lines.
[[nodiscard]] std::string table_report(const harness::I8080Job& job, const harness::I8080Report& report);

// Warnings on standard error: ports that nothing answered, bytes that were not kept.
void warn_about(const harness::I8080Report& report);

// Complains about a stop that is a failure.
[[nodiscard]] ExitCode judge(const harness::I8080Report& report);

}  // namespace sightline::app
