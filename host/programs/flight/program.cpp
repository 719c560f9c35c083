#include "host/programs/flight/program.hpp"

#include "host/machines/i8080_program.hpp"

namespace sightline::programs::flight {

Program assemble_program() {
  const machines::I8080Program assembled(embedded_sources(), "flight.asm", "the flight program");
  Program program;
  program.memory = assembled.memory();
  program.start = assembled.at("START");
  program.status = assembled.at("STATUS");
  program.count = assembled.at("COUNT");
  program.list_end = static_cast<i8080::Address>(assembled.at("LIST") + 0x100U);
  if (assembled.at("CODEND") > assembled.at("SQL")) base::give_up("the flight program overlaps its tables");
  return program;
}

const Program& resident_program() {
  static const Program program = assemble_program();
  return program;
}

}  // namespace sightline::programs::flight
