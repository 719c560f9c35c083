// A board of 64K of RAM that records the pins of an 8080, for tests.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "emulators/i8080/pin_bus.hpp"

namespace sightline::tests {

struct Transfer {
  i8080::Status status;
  i8080::Address address;
  i8080::Byte data;
  friend bool operator==(const Transfer&, const Transfer&) = default;
};

struct MemoryBoard {
  std::array<i8080::Byte, 65536> memory{};
  std::vector<i8080::PinInputs> levels;  // inputs of the coming T-states; then no INT, ready, no HOLD
  std::vector<i8080::PinState> rows;
  std::vector<Transfer> transfers;
  i8080::Byte port_data = 0;
  std::vector<i8080::Byte> acknowledge_data;  // taken in turn by cycles with INTA or without MEMR; the last one stays
  std::size_t acknowledged = 0;

  i8080::PinInputs inputs() const {
    return rows.size() < levels.size() ? levels[rows.size()] : i8080::PinInputs{};
  }
  i8080::Byte read(i8080::Status status, i8080::Address address) {
    const i8080::Byte byte = answer(status, address);
    transfers.push_back({status, address, byte});
    return byte;
  }
  void write(i8080::Status status, i8080::Address address, i8080::Byte byte) {
    transfers.push_back({status, address, byte});
    if ((status & i8080::status::output) == 0) memory[address] = byte;
  }
  void t_state(const i8080::PinState& row) { rows.push_back(row); }

 private:
  i8080::Byte answer(i8080::Status status, i8080::Address address) {
    if ((status & i8080::status::input) != 0) return port_data;
    if ((status & i8080::status::memory_read) != 0) return memory[address];
    if (acknowledge_data.empty()) return 0xFF;
    return acknowledge_data[acknowledged + 1 < acknowledge_data.size() ? acknowledged++ : acknowledged];
  }
};

}  // namespace sightline::tests
