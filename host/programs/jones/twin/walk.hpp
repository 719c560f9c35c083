// The walk of Jones's program on the PDP-7 (-D WALK=1), in C++: the same cell, eye and status for every step, written only
// from firmware/pdp7/jones/SPECIFICATION.md section 9. It reads and writes an image of core, as the machine does; run_twin
// then draws the view from it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "emulators/core/word.hpp"
#include "host/programs/jones/specification.hpp"

namespace sightline::programs::jones {

class Walk {
 public:
  // core: 8192 words with a scene tape for the walk; scene_header: address of its header; first_cell: of its first cell. The
  // eye is that of the header.
  Walk(std::vector<core::Word18> core, std::uint32_t scene_header, std::uint32_t first_cell);

  // A view begins: finds the cell if none is known, then takes the steps. Statuses: complete, bad_data_element,
  // eye_in_no_cell; unfinished if a damaged scene has no end.
  Status take(const std::array<std::int32_t, 3>& steps);

  [[nodiscard]] const std::array<std::int32_t, 3>& eye() const { return eye_; }
  [[nodiscard]] std::uint32_t cell() const;  // its address; 0: none
  [[nodiscard]] std::uint32_t stops() const { return stops_; }  // 1, 2, 4: a wall ended the leg along x, y, z
  // With the cell and its box in the header, as the machine has them after these steps.
  [[nodiscard]] const std::vector<core::Word18>& core() const { return core_; }

 private:
  struct Side {
    std::int32_t low = 0, high = 0;
  };
  // Of an opening, relative to the eye.
  struct Extent {
    std::array<Side, 3> sides;
  };

  Status locate();
  Status move_inside();
  Status take_leg(std::size_t axis, std::int32_t steps);
  Status end_leg(std::size_t axis, std::int32_t steps, std::int32_t target);
  [[nodiscard]] bool is_between_planes(std::size_t axis, std::int32_t target) const;
  Status pass(std::size_t axis, std::int32_t steps, std::int32_t& passed, bool& passes);
  Status extent_of(std::uint32_t element, Extent& extent) const;
  [[nodiscard]] std::uint32_t list_of(std::uint32_t cell) const;
  [[nodiscard]] core::Word18 word(std::uint32_t address) const;
  [[nodiscard]] std::int32_t number(std::uint32_t address) const { return word(address).twos_complement(); }
  void put(std::uint32_t address, std::int32_t number);

  std::vector<core::Word18> core_;
  std::uint32_t header_;
  std::uint32_t first_cell_;
  std::uint32_t cell_ = 0;
  std::array<std::int32_t, 3> eye_{};
  std::uint32_t stops_ = 0;
};

}  // namespace sightline::programs::jones
