#include "host/programs/flight/program.hpp"

#include "host/machines/i8080_program.hpp"

namespace sightline::programs::flight {

Program assemble_program() {
  const machines::I8080Program assembled(embedded_sources(), "flight.asm", "the flight program");
  Program program;
  program.memory = assembled.memory();
  for (const auto& symbol : assembled.assembly().symbols) program.symbols.emplace(symbol.name, symbol.value);
  program.start = assembled.at("START");
  program.status = assembled.at("STATUS");
  if (assembled.at("CODEND") > assembled.at("SQL")) base::give_up("the flight program reaches into its tables");
  return program;
}

}  // namespace sightline::programs::flight
