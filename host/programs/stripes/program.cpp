#include "host/programs/stripes/program.hpp"

#include <string>
#include <utility>

#include "host/machines/i8080_program.hpp"

namespace sightline::programs::stripes {

namespace {

// The main source of each build.
std::string_view source_of(Build build) {
  switch (build) {
    case Build::plain: return "stripes.asm";
    case Build::coverage: return "coverage.asm";
    case Build::overwrite: return "overwrite.asm";
  }
  return {};
}

}  // namespace

Program assemble_program(Build build) {
  const machines::I8080Program assembled(embedded_sources(), std::string(source_of(build)), "the stripes program");
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
  return {std::move(memory), labels, build};
}

const Program& resident_program(Build build) {
  if (build == Build::coverage) {
    static const Program program = assemble_program(Build::coverage);
    return program;
  }
  if (build == Build::overwrite) {
    static const Program program = assemble_program(Build::overwrite);
    return program;
  }
  static const Program program = assemble_program();
  return program;
}

}  // namespace sightline::programs::stripes
