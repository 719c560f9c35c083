// The options of the PDP-7 processor.
#pragma once

namespace sightline::pdp7 {

struct Model {
  bool eae = true;         // Type 177; without it class 64 does nothing in one cycle
  bool extend = false;     // Type 148 memory extension control
  bool trap_mode = false;  // without it ITON is ION
  bool strict = false;     // an instruction that nothing obeys stops the machine

  friend constexpr bool operator==(const Model&, const Model&) = default;
};

}  // namespace sightline::pdp7
