#include "host/programs/skala/program.hpp"

#include "host/machines/i8080_program.hpp"

namespace sightline::programs::skala {

Program assemble_program(bool direct_masks) {
  const machines::I8080Program assembled(embedded_sources(), direct_masks ? "direct.asm" : "skala.asm", "the Skala program");
  Labels labels;
  labels.start = assembled.at("START");
  labels.status = assembled.at("STATUS");
  labels.link_switch = assembled.at("LINKSW");
  labels.drawing = assembled.at("DRAWIT");
  labels.mask_top = assembled.at("MT");
  labels.mask_bottom = assembled.at("MB");
  labels.previous_row = assembled.at("MP");
  labels.previous_level = assembled.at("IP");
  return {assembled.memory(), labels, direct_masks};
}

const Program& resident_program(bool direct_masks) {
  if (direct_masks) {
    static const Program direct = assemble_program(true);
    return direct;
  }
  static const Program program = assemble_program();
  return program;
}

}  // namespace sightline::programs::skala
