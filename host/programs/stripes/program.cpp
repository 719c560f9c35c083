#include "host/programs/stripes/program.hpp"

#include <utility>

#include "host/machines/i8080_program.hpp"

namespace sightline::programs::stripes {

Program assemble_program() {
  const machines::I8080Program assembled(embedded_sources(), "stripes.asm", "the stripes program");
  const auto at = [&assembled](std::string_view label) { return assembled.at(label); };
  std::vector<std::uint8_t> memory = assembled.memory();
  if (memory.size() > program_room) base::give_up("the stripes program overlaps its data");
  Labels labels{at("START"), at("STATUS"), at("FAULT"), at("CHECK"), at("DRAWIT"), at("ORDER")};
  labels.tests = at("TESTS");
  labels.sides = at("SIDES");
  labels.common = at("TEST6");
  labels.first_hides = at("IFIRST");
  labels.second_hides = at("JFIRST");
  labels.hides = at("HIDES");
  labels.classes = at("CLASS");
  labels.deleted = at("DELETE");
  labels.line_done = at("DRAW8");
  labels.cuts = at("NCUT");
  labels.lines = at("YLO");
  labels.face_slots = at("FS");
  labels.silhouette_slots = at("SS");
  labels.face_line = at("FPTR");
  labels.shadow_line = at("SPTR");
  labels.difference = at("VTOP");
  return {std::move(memory), labels};
}

const Program& resident_program() {
  static const Program program = assemble_program();
  return program;
}

}  // namespace sightline::programs::stripes
