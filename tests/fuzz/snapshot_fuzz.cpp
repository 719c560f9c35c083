// Any changes to the state in a snapshot, with a correct checksum: either the snapshot is rejected and the machine is unchanged,
// or the machine runs from the restored state, which can be saved and restored again. Snapshots with a wrong checksum are
// rejected.
//
// Input: one byte, even for the PDP-7, odd for the 8080; then changes of four bytes: the section, the offset in it (two bytes,
// high first) and a byte to XOR there. A section number of 200 or more means section minus 200, which gets the offset as its
// new length.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <utility>

#include "host/machines/i8080.hpp"
#include "host/live/snapshot.hpp"
#include "tests/host/machines/i8080_setup.hpp"
#include "tests/host/live/small_pdp7.hpp"

namespace {

using namespace sightline;

void require(bool holds) {
  if (!holds) std::abort();
}

std::unique_ptr<machines::Machine> i8080_machine() {
  machines::I8080Setup setup;
  for (const char* device : {"ef9365", "calcomp565", "minigraf0507"}) test::attach(setup, device);
  test::attach_link(setup, "parallel", machines::Bytes(20, 0x55));
  test::attach_link(setup, "serial", machines::Bytes(20, 0xAA));
  test::wire(setup, "ef9365", 1);
  test::wire(setup, "calcomp", 2);
  test::wire(setup, "parallel", 3);
  test::wire(setup, "serial-receive", 4);
  setup.drawing = true;
  auto machine = machines::make_i8080(std::move(setup));
  std::uint32_t at = 0;
  // 8251 and 8255 set, the pen of the CalComp down, a vector of the EF9365, EI, HLT, JMP to the last four
  for (const int byte : {0x3E, 0x4D, 0xD3, 0xED, 0x3E, 0x37, 0xD3, 0xED, 0xD3, 0xEC, 0x3E, 0xB4, 0xD3, 0xE7,
                         0xD3, 0xE5, 0x3E, 0x09, 0xD3, 0xE7, 0xD3, 0x60, 0x3E, 0x73, 0xD3, 0x41, 0x3E, 0xFF,
                         0xD3, 0x45, 0x3E, 0x10, 0xD3, 0x40, 0xFB, 0x76, 0xD3, 0x60, 0xC3, 0x22, 0x00})
    machine->put(at++, static_cast<std::uint32_t>(byte));
  machine->start(0);
  return machine;
}

machines::Bytes save_state(machines::Machine& machine) {
  return live::save_snapshot("fuzz", machine);
}

void run_on(machines::Machine& machine) {
  static_cast<void>(machine.run({machine.instructions() + 60, machine.ticks() + 1'000'000}, true));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  require(!live::decode_snapshot({data, size}, "fuzz").has_value());
  if (size == 0) return 0;
  const auto machine = (data[0] & 1U) == 0 ? test::small_pdp7() : i8080_machine();
  run_on(*machine);
  const machines::Bytes before = save_state(*machine);
  auto snapshot = live::decode_snapshot(before, "fuzz");
  require(snapshot.has_value());
  machines::MachineState& state = snapshot->state;
  for (std::size_t n = 1; n + 4 <= size; n += 4) {
    const std::size_t place = std::size_t{data[n + 1]} << 8 | data[n + 2];
    const bool sizes = data[n] >= 200;
    base::Bytes& bytes =
        state[static_cast<std::size_t>(sizes ? data[n] - 200 : data[n]) % state.size()].bytes;
    if (sizes) {
      bytes.resize(place, data[n + 3]);
    } else if (!bytes.empty()) {
      std::uint8_t& byte = bytes[place % bytes.size()];
      byte = static_cast<std::uint8_t>(byte ^ data[n + 3]);
    }
  }
  const machines::Bytes changed = live::encode_snapshot(*snapshot);
  const auto done = live::restore_snapshot("fuzz", *machine, changed, "fuzz");
  if (!done) {
    require(done.error().file == "fuzz" && !done.error().place.empty() && !done.error().expected.empty());
    require(save_state(*machine) == before);
    return 0;
  }
  run_on(*machine);
  const machines::Bytes later = save_state(*machine);
  require(live::restore_snapshot("fuzz", *machine, later, "fuzz").has_value());
  require(save_state(*machine) == later);
  return 0;
}
