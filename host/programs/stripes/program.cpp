#include "host/programs/stripes/program.hpp"

#include <utility>

#include "host/machines/i8080_program.hpp"

namespace sightline::programs::stripes {

Program assemble_program() {
  const machines::I8080Program assembled(embedded_sources(), "stripes.asm", "the program of stripes");
  const auto at = [&assembled](std::string_view label) { return assembled.at(label); };
  std::vector<std::uint8_t> memory = assembled.memory();
  if (memory.size() > program_room) base::give_up("the program of stripes reaches into its data");
  return {std::move(memory), {at("START"), at("STATUS"), at("FAULT"), at("CHECK"), at("DRAWIT"), at("ORDER")}};
}

}  // namespace sightline::programs::stripes
