#include "host/programs/skala/program.hpp"

#include "host/machines/i8080_program.hpp"

namespace sightline::programs::skala {

Program assemble_program() {
  const machines::I8080Program assembled(embedded_sources(), "skala.asm", "the Skala program");
  Labels labels;
  labels.start = assembled.at("START");
  labels.status = assembled.at("STATUS");
  labels.link_switch = assembled.at("LINKSW");
  labels.drawing = assembled.at("DRAWIT");
  labels.mask_top = assembled.at("MT");
  labels.mask_bottom = assembled.at("MB");
  labels.previous_row = assembled.at("MP");
  labels.previous_level = assembled.at("IP");
  return {assembled.memory(), labels};
}

const Program& resident_program() {
  static const Program program = assemble_program();
  return program;
}

}  // namespace sightline::programs::skala
