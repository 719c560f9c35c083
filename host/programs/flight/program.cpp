#include "host/programs/flight/program.hpp"

#include "host/machines/i8080_program.hpp"

namespace sightline::programs::flight {

Program assemble_program(bool facing) {
  const machines::I8080Program assembled(embedded_sources(), facing ? "facing.asm" : "flight.asm", "the flight program");
  Program program;
  program.facing = facing;
  program.memory = assembled.memory();
  program.start = assembled.at("START");
  program.status = assembled.at("STATUS");
  program.first = assembled.at("FIRST");
  program.list_end = static_cast<i8080::Address>(assembled.at("LIST") + 0x100U);
  if (assembled.at("CODEND") > assembled.at("SQL")) base::give_up("the flight program overlaps its tables");
  if (facing && assembled.at("MOREND") > assembled.at("ENTRIES")) base::give_up("the facing test overlaps its entries");
  return program;
}

const Program& resident_program(bool facing) {
  if (facing) {
    static const Program program = assemble_program(true);
    return program;
  }
  static const Program program = assemble_program();
  return program;
}

}  // namespace sightline::programs::flight
