// What `sightline run i8080` was asked for, and the job it makes of it.
#pragma once

#include <string>
#include <vector>

#include "host/guests/run/i8080.hpp"

namespace sightline::app {

// Options as typed; an empty text is an option not given.
struct RunI8080Arguments {
  std::vector<std::string> loads;
  std::string start;
  bool cpm = false;
  std::string clock = "3000000";
  std::vector<std::string> sets;
  std::string max_instructions;
  std::string max_states;
  bool strict = false;
  std::string board;    // "ef9365" or "alt256"
  std::string plotter;  // "calcomp" or "minigraf"
  std::string plotter_start;
  std::string parallel;
  std::string serial;
  std::vector<std::string> interrupts;
  std::string dump;
  std::string trace;
  std::string bus;
  std::string console;
  std::string png;
  bool grey = false;
  std::string strokes;
  std::string svg;
  std::string parallel_out;
  std::string serial_out;
  bool json = false;
};

// Everything but the takers of texts; reads all input files. Failures as they come.
[[nodiscard]] harness::I8080Job i8080_job_from(const RunI8080Arguments& arguments);

}  // namespace sightline::app
