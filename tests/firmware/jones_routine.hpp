// Single routines of Jones's program, called through their labels on a PDP-7: arguments are deposited in the cells that the
// routine's comment names, a JMS and a HLT replace the display file, and the machine runs until it halts.
//
// It also halts at `fault`, which is reached with the status in AC whenever a view stops, and at the first word of `piece`,
// where a clipped line would be drawn.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "emulators/machines/pdp7.hpp"
#include "host/programs/jones/twin/number.hpp"
#include "tests/firmware/jones_core.hpp"

namespace sightline::programs::jones {

class RoutineMachine {
 public:
  explicit RoutineMachine(bool eae)
      : program_(assemble_jones("house", eae)), eae_(eae), machine_(options(eae)) {
    machine_.load(0, program_.core);
    call_ = at("filea");
    fault_ = at("fault");
    piece_ = at("piece") + 1;
    machine_.deposit(call_ + 1, core::Word18(hlt));
    machine_.deposit(fault_, core::Word18(hlt));
  }

  enum class End : std::uint8_t { returned, fault, piece, runaway };

  // Runs `routine` with `ac` in AC. At `fault`, ac() is the status.
  End call(std::string_view routine, std::int32_t ac = 0) {
    machine_.deposit(call_, core::Word18(jms | at(routine)));
    machine_.registers().ac = word_of(ac);
    machine_.registers().pc = call_;
    pdp7::Limits limits;
    limits.instructions = 1'000'000;
    if (machine_.run(limits) != pdp7::StopReason::halt) return End::runaway;
    const pdp7::Address halted = machine_.registers().pc - 1;
    return halted == fault_ ? End::fault : halted == piece_ ? End::piece : End::returned;
  }
  // Halts where a line would be drawn, instead of drawing it.
  void halt_at_piece() { machine_.deposit(piece_, core::Word18(hlt)); }

  [[nodiscard]] std::int32_t ac() const { return machine_.registers().ac.twos_complement(); }
  [[nodiscard]] std::int32_t cell(std::string_view name) const {
    return machine_.peek(at(name)).twos_complement();
  }
  [[nodiscard]] core::Word18 word(pdp7::Address address) const { return machine_.peek(address); }
  void set(std::string_view name, std::int32_t value) { machine_.deposit(at(name), word_of(value)); }
  void set(pdp7::Address address, std::int32_t value) { machine_.deposit(address, word_of(value)); }
  [[nodiscard]] pdp7::Address at(std::string_view name) const { return tag(program_, name); }
  [[nodiscard]] bool eae() const { return eae_; }

  // The double accumulator, 36 bits, two's complement.
  [[nodiscard]] std::int64_t accumulator() const {
    return std::int64_t{cell("acch")} * (std::int64_t{1} << 18) + machine_.peek(at("accl")).value();
  }
  // Without the EAE double products are scaled by 2^(8 - fraction bits).
  [[nodiscard]] std::int64_t product_unit() const {
    return eae_ ? 1 : std::int64_t{1} << (8 - machine_fraction_bits);
  }

 private:
  static constexpr std::uint32_t hlt = 0740040;
  static constexpr std::uint32_t jms = 0100000;

  static pdp7::Options options(bool eae) {
    pdp7::Options options;
    options.model.eae = eae;
    options.model.strict = true;
    return options;
  }

  Program program_;
  bool eae_;
  pdp7::Machine machine_;
  pdp7::Address call_ = 0;
  pdp7::Address fault_ = 0;
  pdp7::Address piece_ = 0;
};

}  // namespace sightline::programs::jones
