// The ports of a run: the machine's devices, and before them the two ports of the CP/M stub and the watch of
// --strict.
//
// Ports see no registers, so a call of the stub only ends the run at the next instruction boundary; whoever
// drives the machine looks at the registers there, and goes on. An OUT to 0 or 1 that turns out to be none of
// the stub's is handed back to the devices.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "emulators/core/tstates.hpp"

namespace sightline::harness {

struct StubCall {
  std::uint8_t port;
  std::uint8_t value;
  core::TStateInstant at;
};

// `Devices` is a Ports that counts unanswered accesses as machines::SkalaPorts does.
template <class Devices>
class I8080RunPorts {
 public:
  static constexpr bool waits = Devices::waits;
  static constexpr std::uint8_t exit_port = 0;
  static constexpr std::uint8_t bdos_port = 1;

  I8080RunPorts(Devices& devices, bool cpm, bool strict) : devices_(devices), cpm_(cpm), strict_(strict) {}

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) {
    const std::uint64_t before = devices_.unanswered()[port].reads;
    const std::uint8_t value = devices_.in(port, at);
    if (strict_ && devices_.unanswered()[port].reads != before) unanswered_ = true;
    return value;
  }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    if (cpm_ && port <= bdos_port) {
      call_ = {port, value, at};
      return;
    }
    pass_on({port, value, at});
  }
  [[nodiscard]] core::TStateInstant deadline() const { return devices_.deadline(); }
  void advance(core::TStateInstant now) { devices_.advance(now); }
  [[nodiscard]] bool interrupt() const { return devices_.interrupt(); }
  [[nodiscard]] std::uint8_t acknowledge(core::TStateInstant now) { return devices_.acknowledge(now); }
  [[nodiscard]] bool stopped() const { return call_.has_value() || unanswered_; }

  // The OUT to a port of the stub that ended the run, once.
  [[nodiscard]] std::optional<StubCall> take_call() { return std::exchange(call_, std::nullopt); }
  // An OUT as if there were no stub.
  void pass_on(const StubCall& call) {
    const std::uint64_t before = devices_.unanswered()[call.port].writes;
    devices_.out(call.port, call.value, call.at);
    if (strict_ && devices_.unanswered()[call.port].writes != before) unanswered_ = true;
  }
  // A port did not answer and the run is strict.
  [[nodiscard]] bool unanswered() const { return unanswered_; }

 private:
  Devices& devices_;
  std::optional<StubCall> call_;
  bool cpm_;
  bool strict_;
  bool unanswered_ = false;
};

}  // namespace sightline::harness
