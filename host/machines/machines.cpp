// The machines of the command, one row each.
#include <array>

#include "host/machines/machine.hpp"

namespace sightline::machines {

std::span<const MachineDescription* const> machines() {
  static const std::array table{&pdp7(), &i8080()};
  return table;
}

}  // namespace sightline::machines
