// Measures a program on the PDP-7 by marks at addresses of the program.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "emulators/core/time.hpp"
#include "emulators/machines/pdp7.hpp"

namespace sightline::machines {

// An observer with a table of marks. cycle() is also called for the cycles that need no mark (pdp7::Observer).
class ProgramWatch : public pdp7::Observer {
 public:
  ProgramWatch() { marks = table_.data(); }
  // Not copyable, because a run keeps the address of the table.
  ProgramWatch(const ProgramWatch&) = delete;
  ProgramWatch& operator=(const ProgramWatch&) = delete;

  bool stop(core::Instant, pdp7::Address) override { return std::exchange(stop_, false); }

 protected:
  ~ProgramWatch() = default;

  // `what`: one or several of pdp7::mark.
  void mark(pdp7::Address address, std::uint8_t what) { table_[address & pdp7::address_mask] |= what; }
  // Ends the run at the boundary after the current instruction; for use in cycle().
  void request_stop() { stop_ = true; }

 private:
  std::vector<std::uint8_t> table_ = std::vector<std::uint8_t>(std::size_t{pdp7::address_mask} + 1);
  bool stop_ = false;
};

}  // namespace sightline::machines
