// What `sightline run pdp7` was asked for, and the job it makes of it.
#pragma once

#include <string>
#include <vector>

#include "host/guests/run/pdp7.hpp"

namespace sightline::app {

// Options as typed; an empty text is an option not given.
struct RunArguments {
  std::vector<std::string> loads;
  std::string start;
  std::string memory = "8k";
  bool no_eae = false;
  std::vector<std::string> sets;
  std::vector<std::string> timings;
  std::string switches;
  std::string max_instructions;
  std::string max_time;
  bool display = false;
  std::vector<std::string> display_options;
  std::string light_pen;
  bool strict = false;
  std::string dump;
  std::string trace;
  std::string strokes;
  std::string png;
  std::string phosphor;
  std::string svg;
  std::string reader;
  std::string punch;
  std::string keyboard;
  std::string teletype;
  bool json = false;

  [[nodiscard]] bool wants_strokes() const {
    return !strokes.empty() || !png.empty() || !phosphor.empty() || !svg.empty();
  }
  [[nodiscard]] bool wants_display() const {
    return display || !display_options.empty() || !light_pen.empty() || wants_strokes();
  }
};

// Everything but the takers of trace and strokes; reads all input files. Failures as they come.
[[nodiscard]] harness::Pdp7Job job_from(const RunArguments& arguments);

}  // namespace sightline::app
