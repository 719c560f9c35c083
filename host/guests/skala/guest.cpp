#include "host/guests/skala/guest.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <type_traits>

#include "emulators/machines/i8080_machine.hpp"
#include "host/guests/skala/guest_ports.hpp"

namespace sightline::guests::skala {

namespace {

// The way from the last byte's IN to DRAWIT is a few dozen instructions.
constexpr int longest_way_to_drawing = 200;

// How many bytes the program has taken at the end of each block, by its rule of receipt (SPECIFICATION,
// section 1). A stream with an unknown command or without END has fewer blocks than bytes.
std::vector<std::size_t> block_ends(std::span<const std::uint8_t> stream) {
  std::vector<std::size_t> ends;
  std::size_t begin = 0;
  for (std::size_t at = 0; at < stream.size();) {
    const auto row = find_command(stream[at]);
    if (!row) break;
    std::size_t length = 1 + static_cast<std::size_t>(row->leading_arguments);
    if (row->bytes_per_item != 0) {
      if (at + length > stream.size()) break;
      length += static_cast<std::size_t>(count_of(stream[at + length - 1]) * row->bytes_per_item);
    }
    at += length;
    if (at > stream.size()) break;
    const bool last = row->command == Command::end;
    if (last || at - begin + buffer_reserve > buffer_bytes) {
      ends.push_back(at);
      begin = at;
    }
    if (last) break;
  }
  return ends;
}

// Generous: a command of three bytes steps through 255 points at most.
std::int64_t limit_for(std::size_t bytes, const GuestOptions& options) {
  const std::int64_t seconds = is_raster(options.device) ? 60 + static_cast<std::int64_t>(bytes) / 20
                                                         : 600 + static_cast<std::int64_t>(bytes);
  return seconds * std::max(options.clock.hertz, core::ClockRate{}.hertz);
}

machines::SkalaConfiguration configuration_for(std::span<const std::uint8_t> stream,
                                               const GuestOptions& options) {
  machines::SkalaConfiguration configuration;
  configuration.clock = options.clock;
  configuration.ef9365 = options.device == Device::ef9365;
  configuration.alt256 = options.device == Device::alt256;
  configuration.calcomp565 = options.device == Device::calcomp;
  configuration.minigraf0507 = options.device == Device::minigraf;
  (options.link == Link::serial ? configuration.serial : configuration.parallel) = stream;
  return configuration;
}

template <class Ports>
class GuestMachine {
 public:
  GuestMachine(const Program& program, std::span<const std::uint8_t> stream, const GuestOptions& options)
      : program_(program),
        blocks_(block_ends(stream)),
        ports_(std::make_unique<Ports>(configuration_for(stream, options))),
        machine_(*ports_, observer_) {
    std::copy(program.memory.begin(), program.memory.end(), machine_.memory().begin());
    machine_.deposit(program.labels.link_switch, options.link == Link::serial ? 1 : 0);
    machine_.registers().pc = program.labels.start;
    ports_->keep_strokes(options.keep_strokes);
    limits_.until = core::at_t_state(options.t_state_limit > 0 ? options.t_state_limit
                                                               : limit_for(stream.size(), options));
  }

  GuestPicture picture() {
    GuestPicture result;
    machines::I8080StopReason reason = machines::I8080StopReason::ports;
    for (std::size_t block = 0; block < blocks_.size() && reason == machines::I8080StopReason::ports;
         ++block) {
      ports_->stop_after_bytes(blocks_[block]);
      reason = machine_.run(limits_);
      if (reason != machines::I8080StopReason::ports || !go_to_drawing()) break;
      ++result.blocks;
      const core::TStateInstant begun = machine_.now();
      ports_->stop_at_link();
      reason = machine_.run(limits_);
      result.drawing += end_of_drawing(begun, reason) - begun;
    }
    ports_->never_stop();
    if (reason == machines::I8080StopReason::ports) reason = machine_.run(limits_);
    result.ended = reason == machines::I8080StopReason::halt;
    report(result);
    return result;
  }

 private:
  // From the byte that completes a block.
  bool go_to_drawing() {
    ports_->never_stop();
    machines::I8080Limits one = limits_;
    one.instructions = 1;
    for (int n = 0; n < longest_way_to_drawing; ++n) {
      if (machine_.registers().pc == program_.labels.drawing) return true;
      if (machine_.run(one) != machines::I8080StopReason::instruction_limit) return false;
    }
    return false;
  }

  // The last block's drawing ends with its last dot, the others' with the next look at the link.
  [[nodiscard]] core::TStateInstant end_of_drawing(core::TStateInstant begun,
                                                   machines::I8080StopReason reason) {
    if (reason != machines::I8080StopReason::halt) return machine_.now();
    core::TStateInstant end = machine_.now();
    if (ports_->ef9365() != nullptr) end = ports_->ef9365()->busy_until();
    if (ports_->calcomp565() != nullptr) end = ports_->calcomp565()->busy_until();
    return end > begun ? end : machine_.now();
  }

  void report(GuestPicture& result) {
    const auto page = [&](i8080::Address from, std::array<std::uint8_t, 256>& to) {
      std::copy_n(machine_.memory().begin() + from, to.size(), to.begin());
    };
    result.status = static_cast<Status>(machine_.peek(program_.labels.status));
    page(program_.labels.mask_top, result.columns.mask_top);
    page(program_.labels.mask_bottom, result.columns.mask_bottom);
    page(program_.labels.previous_row, result.columns.previous_y);
    page(program_.labels.previous_level, result.columns.previous_level);
    result.total = machine_.now().time_since_epoch();
    result.instructions = machine_.instructions();
    ports_->report(result);
  }

  const Program& program_;
  std::vector<std::size_t> blocks_;
  std::unique_ptr<Ports> ports_;  // large
  machines::NoI8080Observer observer_;
  machines::I8080Machine<Ports> machine_;
  machines::I8080Limits limits_;
};

}  // namespace

GuestPicture run_guest(const Program& program, std::span<const std::uint8_t> stream,
                       const GuestOptions& options) {
  if (is_raster(options.device)) return GuestMachine<RasterPorts>(program, stream, options).picture();
  return GuestMachine<PlotterPorts>(program, stream, options).picture();
}

}  // namespace sightline::guests::skala
