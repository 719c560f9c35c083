// Shared by the tests of `sightline run pdp7`: small programs, and runs that return their report.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "tests/host/app/command_line.hpp"

namespace sightline::test {

class RunPdp7 : public CommandLine {
 protected:
  // LAC 103, TAD 104, HLT; 3 and 5.
  static constexpr const char* add = "00100: 200103 340104 740040 000003 000005\n";
  // JMP .
  static constexpr const char* forever = "00100: 600100\n";
  // Starts the display at 106 and waits for its stop interrupt, repeatedly. The file: scale 0, intensity 7; y 400; x 400, lit; a
  // vector
  // of 100 to the right, lit, then mode 0; stop and interrupt.
  static constexpr const char* picture =
      "00100: 200105 700606 700601 600102 600100 000106 020117 220400 102400 600100 003000\n";
  // The same without a stop: mode 0 words from 106 on, around all of core.
  static constexpr const char* endless =
      "00100: 200105 700606 600102\n00105: 000106 020117 220400 102400 600100\n";

  Ran run(Arguments options) {
    options.insert(options.begin(), {"run", "pdp7"});
    return sightline(options);
  }
  nlohmann::json report(Arguments options) {
    options.push_back("--json");
    const Ran ran = run(std::move(options));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return nlohmann::json::parse(ran.out, nullptr, false);
  }
};

}  // namespace sightline::test
