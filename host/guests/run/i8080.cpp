// See i8080.hpp.
#include "host/guests/run/i8080.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "emulators/core/inline.hpp"
#include "emulators/i8080/bus.hpp"
#include "emulators/machines/i8080_hold.hpp"
#include "emulators/machines/i8080_machine.hpp"
#include "host/base/text.hpp"
#include "host/guests/run/cpm.hpp"
#include "host/guests/run/i8080_vcd.hpp"
#include "host/picture/pen_drawing.hpp"
#include "host/picture/png.hpp"
#include "host/picture/raster_image.hpp"
#include "host/picture/stroke_log.hpp"
#include "tools/disasm/i8080.hpp"
#include "tools/image/binary.hpp"

namespace sightline::guests::run {

namespace {

using machines::DeviceKind;

// Emulated in some ten milliseconds: short enough for Ctrl-C, long enough to cost nothing.
constexpr core::TStates time_between_questions{1 << 25};
constexpr std::size_t most_kept_of_console = std::size_t{1} << 24;

// --- Ports ---

// A sink that writes what a plotter's pen does and keeps the lines it draws, as far as the run asks for them.
// Strokes tell nothing of a lifted pen: marks one step apart are joined.
class PlotterTaker {
 public:
  static constexpr bool consumes = true;
  // Corners kept of a program that draws for ever.
  static constexpr std::size_t most_corners = std::size_t{1} << 22;

  explicit PlotterTaker(bool drawing) : drawing_(drawing) {}

  void begin_pass(core::Instant) {}
  void stroke(const core::Stroke& stroke) {
    if (log_.wanted()) log(stroke);
    if (drawing_) draw({stroke.x, stroke.y});
    if (live_) fresh_.push_back(stroke);
  }
  void keep_strokes(bool keep) { live_ = keep; }
  [[nodiscard]] std::span<const core::Stroke> take_strokes() {
    taken_.swap(fresh_);
    fresh_.clear();
    return taken_;
  }
  void end_pass(core::Instant) {}

  void take(TextTaker taker) { log_.take(std::move(taker)); }
  void finish() { log_.finish(); }
  [[nodiscard]] const std::vector<picture::PenPath>& paths() const { return paths_; }
  // Marks beyond what is kept.
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }

  // The drawing is an output: where it ends is enough to go back to, as corners are only added or moved at the end. A
  // machine that has not drawn so much begins a new drawing.
  template <class Visitor>
  void visit_state(Visitor& visit) {
    End end;
    if (!paths_.empty()) {
      end = {paths_.size(), paths_.back().corners.size(), paths_.back().corners.back(), last_, left_out_};
    }
    visit("paths", end.paths);
    visit("corners", end.corners);
    for (picture::PenPoint* const point : {&end.corner, &end.last}) {
      visit("x", point->x);
      visit("y", point->y);
    }
    visit("left_out", end.left_out);
    if constexpr (Visitor::restores) {
      if (visit.cuts_outputs()) go_back_to(end);
    }
  }

 private:
  void log(const core::Stroke& stroke) {
    log_.write([&stroke](std::string& text) { picture::append_stroke_line(text, stroke); });
  }
  struct End {
    std::uint64_t paths = 0;
    std::uint64_t corners = 0;  // of the last path
    picture::PenPoint corner{};  // its last one
    picture::PenPoint last{};    // mark
    std::uint64_t left_out = 0;
  };

  void go_back_to(const End& end) {
    fresh_.clear();
    if (end.paths > paths_.size() || end.paths == 0 ||
        end.corners > paths_[static_cast<std::size_t>(end.paths) - 1].corners.size() || end.corners == 0) {
      paths_.clear();
    } else {
      paths_.resize(static_cast<std::size_t>(end.paths));
      paths_.back().corners.resize(static_cast<std::size_t>(end.corners));
      paths_.back().corners.back() = end.corner;
    }
    last_ = end.last;
    left_out_ = paths_.empty() ? 0 : end.left_out;
    corners_ = 0;
    for (std::size_t n = 0; n + 1 < paths_.size(); ++n) corners_ += paths_[n].corners.size();
  }

  void draw(picture::PenPoint point) {
    const bool joined =
        !paths_.empty() && std::abs(point.x - last_.x) <= 1 && std::abs(point.y - last_.y) <= 1;
    const std::size_t kept = corners_ + (paths_.empty() ? 0 : paths_.back().corners.size());
    if (kept >= most_corners) {
      ++left_out_;
      return;
    }
    if (!joined) {
      corners_ = kept;
      paths_.push_back({{point}});
    } else if (point != last_) {
      picture::extend(paths_.back(), point);
    }
    last_ = point;
  }

  bool live_ = false;
  std::vector<core::Stroke> fresh_;  // since they were last taken
  std::vector<core::Stroke> taken_;
  bool drawing_;
  TextBlocks log_;
  std::vector<picture::PenPath> paths_;
  picture::PenPoint last_;
  std::size_t corners_ = 0;  // of all paths but the last, which is counted when the next begins
  std::uint64_t left_out_ = 0;
};

using Devices = machines::SkalaPorts<PlotterTaker>;

struct PortCall {
  std::uint8_t port;
  std::uint8_t value;
  core::TStateInstant at;
};

// The machine's devices, and before them the ports of CP/M's entries and the watch of --strict.
//
// Ports see no registers, so a call of CP/M only ends the run at the next instruction boundary; the
// caller then reads the registers there and continues the run. An OUT to those ports that turns out to be none of an
// entry's is handed back to the devices.
class RunPorts {
 public:
  static constexpr bool waits = Devices::waits;

  RunPorts(Devices& devices, const machines::HoldTimes& hold, bool cpm, bool strict)
      : devices_(devices), hold_(hold), cpm_(cpm), strict_(strict) {}

  [[nodiscard]] std::uint8_t in(std::uint8_t port, core::TStateInstant at) {
    const std::uint64_t before = devices_.unanswered()[port].reads;
    const std::uint8_t value = devices_.in(port, at);
    if (strict_ && devices_.unanswered()[port].reads != before) unanswered_ = true;
    return value;
  }
  void out(std::uint8_t port, std::uint8_t value, core::TStateInstant at) {
    if (cpm_ && port <= Cpm::last_port) {
      call_ = {port, value, at};
      return;
    }
    pass_on({port, value, at});
  }
  [[nodiscard]] core::TStateInstant deadline() const { return devices_.deadline(); }
  void advance(core::TStateInstant now) { devices_.advance(now); }
  [[nodiscard]] bool interrupt() const { return devices_.interrupt(); }
  [[nodiscard]] std::uint8_t acknowledge(core::TStateInstant now) { return devices_.acknowledge(now); }
  [[nodiscard]] core::TStateInstant next_hold(core::TStateInstant t) const { return hold_.next_hold(t); }
  [[nodiscard]] core::TStateInstant hold_ends(core::TStateInstant t) const { return hold_.hold_ends(t); }
  [[nodiscard]] bool stopped() const { return call_.has_value() || unanswered_; }

  // The OUT to a port of an entry that ended the run, once.
  [[nodiscard]] std::optional<PortCall> take_call() { return std::exchange(call_, std::nullopt); }
  // An OUT as if there were no CP/M.
  void pass_on(const PortCall& call) {
    const std::uint64_t before = devices_.unanswered()[call.port].writes;
    devices_.out(call.port, call.value, call.at);
    if (strict_ && devices_.unanswered()[call.port].writes != before) unanswered_ = true;
  }
  // A port did not answer and the run is strict.
  [[nodiscard]] bool unanswered() const { return unanswered_; }

  // Between two runs no call waits; that a run has stopped is not kept.
  template <class Visitor>
  void visit_state(Visitor& visit) {
    devices_.visit_state(visit);
    if constexpr (Visitor::restores) {
      call_.reset();
      unanswered_ = false;
    }
  }

 private:
  Devices& devices_;
  machines::HoldTimes hold_;
  std::optional<PortCall> call_;
  bool cpm_;
  bool strict_;
  bool unanswered_ = false;
};

// --- Trace and bus log ---

// Writes what has a taker, in blocks.
class Recorder {
 public:
  void take(std::string_view option, TextTaker taker) {
    if (option == "--vcd" && vcd) {
      vcd->take(std::move(taker));
    } else {
      (option == "--trace" ? trace_ : bus_).take(std::move(taker));
    }
  }
  void finish(core::TStateInstant now) {
    trace_.finish();
    bus_.finish();
    if (vcd) vcd->finish(now);
  }

  // T of the fetch in decimal, address and bytes, the instruction, registers after it. INT is before an
  // instruction that a device supplied, * before an opcode that Intel left undefined and that does the same
  // as another.
  void instruction(const machines::I8080InstructionRecord& record) {
    if (trace_.wanted()) write(record);
    if (vcd) vcd->instruction(record);
  }
  // T of the cycle's T1 in decimal, status byte, address, data; -- in the halt cycle.
  void cycle(const machines::I8080Cycle& cycle) {
    if (bus_.wanted()) write(cycle);
    if (vcd) vcd->cycle(cycle);
  }
  void hold(const machines::I8080HoldPins& pins) {
    if (vcd) vcd->hold(pins);
  }

  std::optional<I8080Vcd> vcd;

 private:
  struct Remembered {
    std::array<i8080::Byte, 3> bytes;
    int length = 0;  // 0: nothing remembered
    std::string text;
  };

  // A loop meets the same bytes at the same places.
  const Remembered& disassembled(const machines::I8080InstructionRecord& record) {
    Remembered& known = remembered_[record.pc];
    if (known.length == 0 || known.bytes != record.bytes) {
      const disassembler::I8080Line line = disassembler::disassemble_i8080_instruction(record.bytes);
      known = {record.bytes, line.bytes, (line.duplicate ? "*" : "") + line.text};
    }
    return known;
  }

  // Out of line: every access of every instruction calls them.
  [[gnu::noinline]] void write(const machines::I8080InstructionRecord& record) {
    const Remembered& known = disassembled(record);
    const i8080::State& s = record.after;
    trace_.write([&](std::string& text) {
      base::append(text, "{:>12} {:04X} ", core::t_states_of(record.time), record.pc);
      for (std::size_t i = 0; i < record.bytes.size(); ++i) {
        if (static_cast<int>(i) < known.length) {
          base::append(text, "{:02X}", record.bytes[i]);
        } else {
          text += "  ";
        }
      }
      base::append(text,
                   " {}{:<{}} {:02X} {:02X} {:02X} {:02X} {:02X} {:02X} {:02X} {:02X} {:04X} {:04X} {}\n",
                   record.acknowledged ? "INT " : "", known.text, record.acknowledged ? 16 : 20, s.a, s.f,
                   i8080::high(s.bc), i8080::low(s.bc), i8080::high(s.de), i8080::low(s.de),
                   i8080::high(s.hl), i8080::low(s.hl), s.sp, s.pc, s.interrupts_on ? 1 : 0);
    });
  }
  [[gnu::noinline]] void write(const machines::I8080Cycle& cycle) {
    bus_.write([&](std::string& text) {
      base::append(text, "{} {:02X} {:04X} ", core::t_states_of(cycle.time), cycle.status, cycle.address);
      if (cycle.status == i8080::status::halt_cycle) {
        text += "--\n";
      } else {
        base::append(text, "{:02X}\n", cycle.data);
      }
    });
  }

  TextBlocks trace_;
  TextBlocks bus_;
  std::vector<Remembered> remembered_ = std::vector<Remembered>(65536);
};

// What a monitor's marks leave of the boundaries and cycles of a run. The status of a cycle is known where it is compiled
// in, so that one test is left of each.
struct I8080Marked {
  const std::uint8_t* places;
  const std::uint8_t* ports;

  explicit I8080Marked(const Probe& probe) : places(probe.marks()), ports(probe.port_marks()) {}
  SIGHTLINE_INLINE bool arrives(i8080::Address next) const { return (places[next] & Probe::executed) != 0; }
  SIGHTLINE_INLINE bool wants(const machines::I8080Cycle& cycle) const {
    namespace status = i8080::status;
    // The bytes of the instruction itself are not asked for.
    if (cycle.operand || (cycle.status & status::halt) != 0) return false;
    if ((cycle.status & status::first) != 0)
      return (cycle.status & status::acknowledge) != 0 && (places[0] & Probe::at_interrupt) != 0;
    if ((cycle.status & status::input) != 0) return (ports[port_of(cycle)] & Probe::is_read) != 0;
    if ((cycle.status & status::output) != 0) return (ports[port_of(cycle)] & Probe::is_written) != 0;
    if ((cycle.status & status::read) != 0) return (places[cycle.address] & Probe::is_read) != 0;
    return (places[cycle.address] & Probe::is_written) != 0;
  }
  static std::uint8_t port_of(const machines::I8080Cycle& cycle) { return static_cast<std::uint8_t>(cycle.address); }
};

// The observer of a monitor that has marked instructions alone: it is asked between them.
class I8080Breaker {
 public:
  static constexpr bool instructions = false;
  static constexpr bool cycles = false;
  static constexpr bool stops = true;
  using Filter = I8080Marked;

  explicit I8080Breaker(Probe& probe) : probe_(probe) {}
  [[nodiscard]] I8080Marked filter() const { return I8080Marked(probe_); }

  // A run begins here: an instruction at this place is passed over.
  void begin(core::TStateInstant now) { begun_ = now; }
  [[gnu::noinline]] bool stop(core::TStateInstant now, i8080::Address next) {
    if (now == begun_ || !filter().arrives(next)) return false;
    probe_.add({Probe::Kind::execution, core::t_states_of(now), next, 0});
    return true;
  }

 private:
  Probe& probe_;
  core::TStateInstant begun_{};
};

// What is left of the boundaries of a run that is looked at: marked instructions, and where a register has a value.
struct I8080Guarded {
  const std::uint8_t* places;
  std::uint32_t a = 0;  // masks
  std::uint32_t hl = 0;
  std::uint32_t bc = 0;
  std::uint32_t de = 0;
  std::uint32_t first = 0;
  std::uint32_t span = ~std::uint32_t{0};

  explicit I8080Guarded(const Probe& probe) : places(probe.marks()) {
    if (!probe.guard) return;
    const Probe::Guard& guard = *probe.guard;
    constexpr std::size_t first_half = 2, last_half = 7;
    if (guard.register_number == 0) {
      a = 0xFF & guard.mask;
      first = guard.first;
      span = guard.span;
      return;
    }
    if (guard.register_number < first_half || guard.register_number > last_half) return;
    std::uint32_t& pair = guard.register_number < 4 ? bc : guard.register_number < 6 ? de : hl;
    const bool high = !guard.pair && guard.register_number % 2 == 0;
    // Of a high half only ranges that fit: what is compared lies eight bits higher.
    const bool fits = guard.first <= 0xFF && guard.first + std::uint64_t{guard.span} <= 0xFF;
    if (high && !fits) return;
    pair = guard.pair ? 0xFFFFU & guard.mask : high ? (0xFF & guard.mask) << 8 : 0xFF & guard.mask;
    first = high ? guard.first << 8 : guard.first;
    span = high ? guard.span << 8 : guard.span;
  }
  SIGHTLINE_INLINE bool arrives(i8080::Address next, const machines::I8080View& view) const {
    const std::uint32_t value = (view.a & a) | (view.hl & hl) | (view.others->bc & bc) | (view.others->de & de);
    return value - first <= span || (places[next] & Probe::executed) != 0;
  }
};

// The observer of a monitor that looks at the machine between instructions.
class I8080Looker {
 public:
  static constexpr bool instructions = false;
  static constexpr bool cycles = false;
  static constexpr bool stops = true;
  static constexpr bool looks = true;
  using Filter = I8080Guarded;

  explicit I8080Looker(Probe& probe) : probe_(probe) {}
  [[nodiscard]] I8080Guarded filter() const { return I8080Guarded(probe_); }

  // A run begins here: an instruction at this place is passed over.
  void begin(core::TStateInstant now) { begun_ = now; }
  [[gnu::noinline]] bool stop(core::TStateInstant now, i8080::Address next) {
    if (now == begun_) return false;
    const std::size_t before = probe_.events().size();
    if ((probe_.marks()[next] & Probe::executed) != 0) probe_.add({Probe::Kind::execution, core::t_states_of(now), next, 0});
    if (probe_.look()) probe_.add({Probe::Kind::look, core::t_states_of(now), next, 0});
    return probe_.events().size() != before;
  }

 private:
  Probe& probe_;
  core::TStateInstant begun_{};
};

// The observer of a monitor that has marked places.
class I8080Watcher {
 public:
  static constexpr bool instructions = false;
  static constexpr bool cycles = true;
  static constexpr bool stops = true;
  static constexpr bool ends_of_halts = false;
  using Filter = I8080Marked;

  explicit I8080Watcher(Probe& probe) : probe_(probe) {}
  [[nodiscard]] I8080Marked filter() const { return I8080Marked(probe_); }

  // A run begins here: an instruction at this place is passed over.
  void begin(core::TStateInstant now) {
    begun_ = now;
    stops_ = !probe_.events().empty();
  }
  [[gnu::noinline]] bool stop(core::TStateInstant now, i8080::Address next) {
    if (now != begun_ && filter().arrives(next)) add(Probe::Kind::execution, now, next, 0);
    return stops_;
  }
  [[gnu::noinline]] void cycle(machines::I8080Cycle cycle) {
    namespace status = i8080::status;
    if ((cycle.status & status::first) != 0) return add(Probe::Kind::interrupt, cycle.time, cycle.address, 0);
    if ((cycle.status & status::input) != 0)
      return add(Probe::Kind::port_read, cycle.time, I8080Marked::port_of(cycle), cycle.data);
    if ((cycle.status & status::output) != 0)
      return add(Probe::Kind::port_write, cycle.time, I8080Marked::port_of(cycle), cycle.data);
    const bool reads = (cycle.status & status::read) != 0;
    add(reads ? Probe::Kind::read : Probe::Kind::write, cycle.time, cycle.address, cycle.data);
  }

 private:
  void add(Probe::Kind kind, core::TStateInstant time, std::uint32_t address, std::uint32_t value) {
    probe_.add({kind, core::t_states_of(time), address, value});
    stops_ = true;
  }

  Probe& probe_;
  core::TStateInstant begun_{};
  bool stops_ = false;
};

// The same, and tells each instruction.
class I8080Listener {
 public:
  explicit I8080Listener(Probe& probe) : probe_(probe), watcher_(probe) {}

  void begin(core::TStateInstant now) { watcher_.begin(now); }
  bool stop(core::TStateInstant now, i8080::Address next) { return watcher_.stop(now, next); }
  void instruction(const machines::I8080InstructionRecord& record) {
    entry_.time = core::t_states_of(record.time);
    entry_.pc = record.pc;
    entry_.word = record.bytes[0] | static_cast<std::uint32_t>(record.bytes[1]) << 8 |
                  static_cast<std::uint32_t>(record.bytes[2]) << 16;
    entry_.accumulator = record.after.a;
    entry_.link = record.after.f;
    entry_.supplied = record.acknowledged;
    if (probe_.on_instruction) probe_.on_instruction(entry_);
    entry_.has_address = false;
  }
  void cycle(const machines::I8080Cycle& cycle) {
    namespace status = i8080::status;
    if (watcher_.filter().wants(cycle)) watcher_.cycle(cycle);
    if (probe_.on_cycle) {
      const std::int64_t least = (cycle.status & status::first) != 0 ? 4 : 3;
      probe_.on_cycle({core::t_states_of(cycle.time), least, name_of(cycle.status), true, cycle.address, cycle.data});
    }
    constexpr i8080::Status not_memory = status::first | status::halt | status::input | status::output;
    if ((cycle.status & not_memory) != 0 || cycle.operand) return;
    entry_.has_address = true;
    entry_.address = cycle.address;
    entry_.value = cycle.data;
  }

 private:
  static std::string_view name_of(i8080::Status cycle) {
    namespace status = i8080::status;
    if ((cycle & status::acknowledge) != 0) return "acknowledge";
    if ((cycle & status::first) != 0) return "fetch";
    if ((cycle & status::halt) != 0) return "halt";
    if ((cycle & status::input) != 0) return "input";
    if ((cycle & status::output) != 0) return "output";
    const bool reads = (cycle & status::read) != 0;
    if ((cycle & status::stack) != 0) return reads ? "stack read" : "stack write";
    return reads ? "read" : "write";
  }

  Probe& probe_;
  I8080Watcher watcher_;
  Probe::Entry entry_;
};

// The observer of all that hear every instruction and every cycle. One for them all: a machine is compiled for each observer, which
// takes long, and they are slow for what they write.
class I8080Reporter {
 public:
  static constexpr bool instructions = true;
  static constexpr bool cycles = true;
  static constexpr bool stops = true;

  explicit I8080Reporter(Recorder& recorder) : recorder_(&recorder) {}
  explicit I8080Reporter(Probe& probe) : listener_(std::in_place, probe) {}

  void begin(core::TStateInstant now) {
    if (listener_) listener_->begin(now);
  }
  bool stop(core::TStateInstant now, i8080::Address next) { return listener_ && listener_->stop(now, next); }
  [[gnu::noinline]] void instruction(const machines::I8080InstructionRecord& record) {
    if (recorder_ != nullptr) recorder_->instruction(record);
    if (listener_) listener_->instruction(record);
  }
  [[gnu::noinline]] void cycle(const machines::I8080Cycle& cycle) {
    if (recorder_ != nullptr) recorder_->cycle(cycle);
    if (listener_) listener_->cycle(cycle);
  }
  void hold(const machines::I8080HoldPins& pins) {
    if (recorder_ != nullptr) recorder_->hold(pins);
  }

 private:
  Recorder* recorder_ = nullptr;
  std::optional<I8080Listener> listener_;
};

// --- Texts ---

// Nine digits behind the point, rounded down. From T-states: nanoseconds end after 292 years.
std::string seconds_text(core::TStateInstant t, core::ClockRate clock) {
  constexpr std::int64_t second = 1'000'000'000;
  const std::int64_t t_states = core::t_states_of(t);
  return fmt::format("{}.{:09}", t_states / clock.hertz, t_states % clock.hertz * second / clock.hertz);
}

// Bytes as the characters of Latin-1, in UTF-8: JSON has no bytes.
std::string as_utf8(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text.push_back(c);
    } else {
      text.push_back(static_cast<char>(0xC0U | byte >> 6));
      text.push_back(static_cast<char>(0x80U | (byte & 0x3FU)));
    }
  }
  return text;
}

std::string times(std::uint64_t n, std::string_view what) {
  return n == 1 ? fmt::format("once {}", what) : fmt::format("{} times {}", n, what);
}

// Registers B to L, numbers 2 to 7: halves of pairs.
i8080::Address& pair_of(i8080::State& state, std::size_t number) {
  return number < 4 ? state.bc : number < 6 ? state.de : state.hl;
}

// --- The machine ---

// Lives on the heap: the raster boards are large.
class I8080Run final : public Machine {
 public:
  explicit I8080Run(I8080Setup setup)
      : setup_(std::move(setup)),
        plotter_(setup_.drawing),
        devices_(setup_.machine, plotter_),
        ports_(devices_, setup_.hold, setup_.cpm.has_value(), setup_.strict),
        processor_(ports_, nobody_) {
    if (setup_.monitored) probe_.emplace(std::size_t{0x10000}, std::size_t{0x100});
    if (setup_.observed) recorder_.emplace();
    if (setup_.cpm) {
      setup_.cpm->journal = setup_.monitored;
      cpm_.emplace(*setup_.cpm, [this](std::string_view text) { print(text); }, [this](char c) { list(c); });
    }
    if (setup_.vcd) recorder_->vcd.emplace(std::move(*setup_.vcd), setup_.machine.clock, [this] { return ports_.interrupt(); });
  }

  [[nodiscard]] std::uint32_t words() const override { return image::byte_memory_size; }
  [[nodiscard]] std::uint32_t word(std::uint32_t address) const override {
    return processor_.memory()[address];
  }
  void put(std::uint32_t address, std::uint32_t word) override {
    processor_.memory()[address] = static_cast<i8080::Byte>(word);
    loaded_.set(address);
  }

  [[nodiscard]] std::uint32_t get(std::size_t number) const override {
    i8080::State s = processor_.registers();
    switch (number) {
      case 0: return s.a;
      case 1: return s.f;
      case 8: return s.sp;
      case 9: return s.pc;
      case 10: return s.interrupts_on ? 1 : 0;
      default: return number % 2 == 0 ? i8080::high(pair_of(s, number)) : i8080::low(pair_of(s, number));
    }
  }
  // Bits of F that the machine does not have are passed over.
  void set(std::size_t number, std::uint32_t value) override {
    i8080::State& s = processor_.registers();
    const auto byte = static_cast<i8080::Byte>(value);
    switch (number) {
      case 0: s.a = byte; break;
      case 1: s.f = i8080::as_flags(byte); break;
      case 8: s.sp = static_cast<i8080::Address>(value); break;
      case 9: s.pc = static_cast<i8080::Address>(value); break;
      case 10: s.interrupts_on = value != 0; break;
      default: {
        i8080::Address& pair = pair_of(s, number);
        pair =
            number % 2 == 0 ? i8080::joined(byte, i8080::low(pair)) : i8080::joined(i8080::high(pair), byte);
      }
    }
  }

  [[nodiscard]] std::uint32_t start_address(std::optional<std::uint32_t> loaded) const override {
    return cpm_ ? image::com_origin : loaded.value_or(0);
  }
  void start(std::uint32_t address) override {
    processor_.registers().pc = static_cast<i8080::Address>(address);
  }
  [[nodiscard]] Result<Done> ready() override {
    if (!cpm_) return Done{};
    for (const auto& [address, byte] : cpm_->entries()) {
      if (loaded_[address] && processor_.memory()[address] != byte) {
        return bad_input(fmt::format(
            "--load: found a byte for {:04X}, expected none: --cpm has its entry to CP/M there", address));
      }
    }
    cpm_->start(processor_.registers(), processor_.memory());
    return Done{};
  }

  void take(std::string_view option, TextTaker taker) override {
    if (option == "--console-out") {
      console_ = std::move(taker);
    } else if (option == "--list") {
      list_ = std::move(taker);
    } else if (option == "--strokes") {
      plotter_.take(std::move(taker));
    } else {
      if (recorder_) recorder_->take(option, std::move(taker));
    }
  }

  // Each call of BDOS ends a slice: a program that prints all the time never comes to the end of a long one.
  [[nodiscard]] std::optional<Stop> run(const Limits& limits, bool asked) override {
    if (cpm_ && !watching_host([this] { return cpm_->goes_on(processor()); })) return std::nullopt;
    const core::TStateInstant limit = core::at_t_state(limits.until);
    const core::TStateInstant until =
        asked ? std::min(limit, processor_.now() + time_between_questions) : limit;
    const std::uint64_t left = limits.instructions - std::min(processor_.instructions(), limits.instructions);
    const auto reason = run_observed({left, until});
    each_terminal([this](auto& terminal) {
      const auto bytes = terminal.take_printed();
      if (!bytes.empty()) print({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    });
    // A call of CP/M is answered before a monitor looks at the machine.
    if (probe_ && !probe_->events().empty() && reason != machines::I8080StopReason::ports) return Stop{stopped_by_probe, {}};
    switch (reason) {
      case machines::I8080StopReason::halt: return Stop{"halt", {}};
      case machines::I8080StopReason::instruction_limit: return Stop{"instruction_limit", {}};
      case machines::I8080StopReason::time_limit:
        if (processor_.now() < limit) return std::nullopt;
        return Stop{"state_limit", {}, true};
      case machines::I8080StopReason::ports: {
        const auto call = ports_.take_call();
        const auto stop = call ? answer(*call) : unanswered();
        if (stop || !probe_ || !probe_->looks() || !probe_->look()) return stop;
        probe_->add({Probe::Kind::look, ticks(), processor_.registers().pc, 0});
        return Stop{stopped_by_probe, {}};
      }
      case machines::I8080StopReason::observer: break;
    }
    return Stop{"interrupted", {}};
  }
  void finish() override {
    if (recorder_) recorder_->finish(processor_.now());
    plotter_.finish();
  }

  [[nodiscard]] Probe* probe() override { return probe_ ? &*probe_ : nullptr; }
  [[nodiscard]] Instruction instruction_at(std::uint32_t address) const override {
    const auto at = [&](std::uint32_t n) { return processor_.memory()[static_cast<i8080::Address>(address + n)]; };
    const disassembler::I8080Line line = disassembler::disassemble_i8080_instruction({at(0), at(1), at(2)});
    return {(line.duplicate ? "*" : "") + line.text, static_cast<unsigned>(line.bytes)};
  }
  [[nodiscard]] Flow flow_of(std::uint32_t word) const override {
    using i8080::Operation;
    switch (i8080::lookup(static_cast<i8080::Byte>(word)).operation) {
      case Operation::call:
      case Operation::conditional_call:
      case Operation::rst: return Flow::call;
      case Operation::ret:
      case Operation::conditional_return: return Flow::leave;
      default: return Flow::plain;
    }
  }
  [[nodiscard]] std::string history_line(const Probe::Entry& entry) const override {
    const auto byte = [&entry](unsigned n) { return static_cast<std::uint8_t>(entry.word >> (8 * n)); };
    const disassembler::I8080Line line = disassembler::disassemble_i8080_instruction({byte(0), byte(1), byte(2)});
    std::string bytes;
    for (unsigned n = 0; n < static_cast<unsigned>(line.bytes); ++n) bytes += fmt::format("{:02X}", byte(n));
    const std::string used =
        entry.has_address ? fmt::format("{:04X}={:02X}", entry.address, entry.value) : std::string();
    return fmt::format("{:>12} {:04X} {:<6} {:<20} {:<7} {:02X} {:02X}", entry.time, entry.pc, bytes,
                       (entry.supplied ? "INT " : "") + line.text, used, entry.accumulator, entry.link);
  }
  [[nodiscard]] std::vector<ReportLine> device_lines() const override { return lines(); }

  void type(std::uint8_t code) override {
    if (cpm_) cpm_->type(code);
    each_terminal([code](auto& terminal) { terminal.type(code); });
    if (probe_) probe_->keys.push_back({ticks(), code});
  }
  [[nodiscard]] bool wants_key() const override {
    bool wants = cpm_ && cpm_->wants_key();
    each_terminal([&wants](const auto& terminal) { wants = wants || terminal.wants_key(); });
    return wants;
  }
  [[nodiscard]] bool waits_for_key() const override { return cpm_ && cpm_->waits_for_key(); }
  [[nodiscard]] std::string take_printed() override { return std::exchange(printed_, {}); }

  [[nodiscard]] std::int64_t trim_journal(std::size_t most) override { return cpm_ ? cpm_->trim_journal(most) : 0; }

  [[nodiscard]] std::uint64_t instructions() const override { return processor_.instructions(); }
  [[nodiscard]] core::Instant now() const override {
    return setup_.machine.clock.to_nanoseconds(processor_.now());
  }
  [[nodiscard]] std::int64_t ticks() const override { return core::t_states_of(processor_.now()); }
  [[nodiscard]] std::int64_t ticks_a_second() const override { return setup_.machine.clock.hertz; }

  [[nodiscard]] std::vector<std::string> configuration() const override { return setup_.configuration; }
  [[nodiscard]] MachineState save() override {
    StateWriter writer;
    visit_state(writer);
    return writer.take();
  }
  [[nodiscard]] base::Result<Done> restore(const MachineState& state) override {
    const auto done = restore_state(state, [this](auto& visit) { this->visit_state(visit); });
    if (done) printed_.clear();
    return done;
  }

  [[nodiscard]] std::vector<ReportLine> lines() const override {
    const core::ClockRate clock = setup_.machine.clock;
    std::vector<ReportLine> lines{
        {"T-states", fmt::format("{}", core::t_states_of(processor_.now()))},
        {"emulated time", fmt::format("{} s at {} Hz", seconds_text(processor_.now(), clock), clock.hertz)},
        {"instructions", fmt::format("{}", processor_.instructions())}};
    if (setup_.hold.length != 0) lines.push_back({"held", fmt::format("{} T-states", processor_.held())});
    devices_.each_device([&lines](auto row, const auto& device) {
      std::string counts;
      row.count(device, [&counts](std::string_view name, std::uint64_t count) {
        if (count == 0) return;
        std::string spoken(name);
        std::replace(spoken.begin(), spoken.end(), '_', ' ');
        counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", spoken, count);
      });
      lines.push_back({std::string(row.name), counts.empty() ? "nothing" : counts});
    });
    return lines;
  }
  void add_times(base::Json& report) const override {
    const core::ClockRate clock = setup_.machine.clock;
    const std::int64_t t_states = core::t_states_of(processor_.now());
    report["t_states"] = t_states;
    if (setup_.hold.length != 0) report["held_t_states"] = processor_.held();
    report["clock_hz"] = clock.hertz;
    // null where no 64 bits hold it
    report["emulated_ns"] = now() == core::never ? base::Json() : base::Json(core::nanoseconds_of(now()));
    report["emulated_seconds"] = static_cast<double>(t_states) / static_cast<double>(clock.hertz);
  }
  void add_details(base::Json& report) const override {
    report["cpm"] = cpm_.has_value();
    if (cpm_) cpm_->add_details(report);
    if (setup_.keep_console) report["console"] = as_utf8(kept_console_);
    base::Json& devices = report["devices"] = base::Json::object();
    devices_.each_device([&devices](auto row, const auto& device) {
      base::Json& counts = devices[row.name];
      row.count(device, [&counts](std::string_view name, std::uint64_t count) { counts[name] = count; });
    });
    base::Json& unanswered = report["unanswered"] = base::Json::array();
    each_unanswered([&unanswered](std::size_t port, const machines::UnansweredPort& counts) {
      unanswered.push_back(base::Json{
          {"port", fmt::format("{:02X}", port)}, {"reads", counts.reads}, {"writes", counts.writes}});
    });
  }

  [[nodiscard]] std::vector<std::string> warnings() const override {
    std::vector<std::string> warnings;
    devices_.each_device([&warnings](auto row, const auto& device) {
      row.count(device, [&warnings, row](std::string_view name, std::uint64_t count) {
        if (name == machines::not_kept && count != 0) {
          warnings.push_back(
              fmt::format("{}: the last {} bytes from the program were not kept", row.name, count));
        }
      });
    });
    each_unanswered([&warnings](std::size_t port, const machines::UnansweredPort& counts) {
      const auto warn = [&](std::uint64_t count, std::string_view what) {
        if (count != 0)
          warnings.push_back(fmt::format("port {:02X}: no device at this port, {}", port, times(count, what)));
      };
      warn(counts.reads, "read as FF");
      warn(counts.writes, "written without effect");
    });
    if (console_left_out_ != 0) {
      warnings.push_back(
          fmt::format("the report's \"console\" lacks the last {} bytes printed; --console-out FILE takes all",
                      console_left_out_));
    }
    if (list_dropped_ != 0)
      warnings.push_back(fmt::format("the list device: {} characters went nowhere; --list FILE takes them", list_dropped_));
    if (plotter_.left_out() != 0)
      warnings.push_back(fmt::format("the drawing lacks the last {} marks of the pen", plotter_.left_out()));
    return warnings;
  }

  void keep_strokes(bool keep) override { plotter_.keep_strokes(keep); }
  std::span<const core::Stroke> take_strokes() override { return plotter_.take_strokes(); }
  [[nodiscard]] const core::Raster* raster() const override {
    const core::Raster* shown = nullptr;
    devices_.each_device([&shown](auto row, const auto& device) {
      if constexpr (decltype(row)::kind == DeviceKind::raster_board) shown = &device.raster();
    });
    return shown;
  }

  // --png of the raster board, --svg of the plotter, --parallel-out and its like of the links.
  [[nodiscard]] Bytes output(std::string_view option) const override {
    Bytes bytes;
    devices_.each_device([&](auto row, const auto& device) {
      using Row = decltype(row);
      if constexpr (Row::kind == DeviceKind::raster_board) {
        if (option == "--png") bytes = png(device.raster());
      } else if constexpr (Row::kind == DeviceKind::plotter) {
        if (option == "--svg") bytes = svg(Row::micrometres_a_step);
      } else if constexpr (Row::kind == DeviceKind::link) {
        if (option != fmt::format("--{}-out", Row::name)) return;
        row.received(device, [&bytes](const devices::KeptBytes& received) {
          bytes.insert(bytes.end(), received.bytes().begin(), received.bytes().end());
        });
      }
    });
    return bytes;
  }

 private:
  machines::I8080StopReason run_observed(const machines::I8080Limits& limits) {
    if (recorder_) return run_watched(limits, I8080Reporter(*recorder_));
    if (probe_ && probe_->watches_instructions()) return run_watched(limits, I8080Reporter(*probe_));
    if constexpr (few_observers) {
      if (probe_ && probe_->watches_places()) return run_watched(limits, I8080Reporter(*probe_));
    } else {
      if (probe_ && probe_->looks()) return run_watched(limits, I8080Looker(*probe_));
      if (probe_ && probe_->watches_arrival()) return run_watched(limits, I8080Breaker(*probe_));
      if (probe_ && probe_->watches_places()) return run_watched(limits, I8080Watcher(*probe_));
    }
    return processor_.run(limits);
  }
  template <class Observer>
  machines::I8080StopReason run_watched(const machines::I8080Limits& limits, Observer observer) {
    observer.begin(processor_.now());
    return processor_.run(limits, observer);
  }

  template <class Visitor>
  void visit_state(Visitor& visit) {
    processor_.visit_state(visit);
    ports_.visit_state(visit);
    visit.section("drawing", plotter_);
    visit.section("console", [this](auto& fields) {
      fields.output("printed", kept_console_, console_before_);
      fields("left_out", console_left_out_);
      fields("list_dropped", list_dropped_);
    });
    if (cpm_) visit.section("cpm", *cpm_);
  }

  // What CP/M changes in a watched place is an access like the program's own; writing the same byte again is none.
  template <class Work>
  std::invoke_result_t<Work> watching_host(Work work) {
    if (!probe_ || probe_->written_places().empty()) return work();
    std::vector<i8080::Byte> before;
    for (const std::uint32_t at : probe_->written_places()) before.push_back(processor_.memory()[at]);
    const std::invoke_result_t<Work> done = work();
    for (std::size_t n = 0; n < before.size(); ++n) {
      const std::uint32_t at = probe_->written_places()[n];
      const i8080::Byte now = processor_.memory()[at];
      if (now != before[n]) probe_->add({Probe::Kind::write, ticks(), at, now});
    }
    return done;
  }

  // Nothing: the run goes on.
  std::optional<Stop> answer(const PortCall& call) {
    switch (watching_host([this, &call] { return cpm_->out(call.port, processor()); })) {
      case Cpm::Called::answered: return std::nullopt;
      case Cpm::Called::stopped: return cpm_->stop();
      case Cpm::Called::no: break;
    }
    ports_.pass_on(call);
    return ports_.unanswered() ? unanswered() : std::nullopt;
  }
  template <class Visit>
  void each_terminal(Visit visit) {
    devices_.each_device([&visit](auto row, auto& device) {
      if constexpr (decltype(row)::kind == DeviceKind::terminal) visit(device);
    });
  }
  template <class Visit>
  void each_terminal(Visit visit) const {
    devices_.each_device([&visit](auto row, const auto& device) {
      if constexpr (decltype(row)::kind == DeviceKind::terminal) visit(device);
    });
  }
  [[nodiscard]] Cpm::Processor processor() { return {processor_.registers(), processor_.memory(), ticks()}; }
  // The IN or OUT is before PC.
  std::optional<Stop> unanswered() const {
    return Stop{"strict", fmt::format("PC {:04X}: stopped by --strict: no device at that port",
                                      static_cast<i8080::Address>(processor_.registers().pc - 2))};
  }

  void print(std::string_view text) {
    if (console_) console_(text);
    if (setup_.console) printed_ += text;
    if (!setup_.keep_console) {
      console_before_ += text.size();
      return;
    }
    const std::string_view kept = text.substr(0, most_kept_of_console - kept_console_.size());
    kept_console_ += kept;
    console_left_out_ += text.size() - kept.size();
  }

  void list(char c) {
    if (list_) list_(std::string_view(&c, 1));
    else ++list_dropped_;
  }

  template <class Visit>
  void each_unanswered(Visit visit) const {
    for (std::size_t port = 0; port < 256; ++port) {
      const machines::UnansweredPort& counts = devices_.unanswered()[port];
      if (counts.reads + counts.writes != 0) visit(port, counts);
    }
  }

  [[nodiscard]] Bytes png(const core::Raster& raster) const {
    const auto palette = setup_.grey ? picture::RasterPalette::grey : picture::RasterPalette::colour;
    return *picture::encode_png(
        picture::raster_image(raster, palette, 1),
        {{"Software", "sightline " SIGHTLINE_VERSION},
         {"End of run", fmt::format("T-state {}", core::t_states_of(processor_.now()))}});
  }
  // The paper is as large as the drawing needs, from step (0, 0) on.
  [[nodiscard]] Bytes svg(std::int64_t micrometres_a_step) const {
    picture::PlotterPaper paper{.micrometres_a_step = micrometres_a_step};
    for (const picture::PenPath& path : plotter_.paths()) {
      for (const picture::PenPoint corner : path.corners)
        paper.steps = std::max({paper.steps, corner.x + 1, corner.y + 1});
    }
    const std::string drawing =
        picture::pen_svg(plotter_.paths(), paper,
                         fmt::format("8080: plotter at T-state {}", core::t_states_of(processor_.now())));
    return {drawing.begin(), drawing.end()};
  }

  I8080Setup setup_;
  PlotterTaker plotter_;
  Devices devices_;
  RunPorts ports_;
  std::optional<Recorder> recorder_;
  std::optional<Probe> probe_;
  machines::NoI8080Observer nobody_;
  machines::I8080Machine<RunPorts> processor_;
  std::bitset<0x10000> loaded_;
  TextTaker console_;
  std::string kept_console_;
  std::uint64_t console_before_ = 0;  // bytes printed before the first of kept_console_
  std::uint64_t console_left_out_ = 0;  // bytes
  std::string printed_;  // on the console, and not yet handed out
  TextTaker list_;
  std::uint64_t list_dropped_ = 0;  // characters, without a taker
  std::optional<Cpm> cpm_;
};

}  // namespace

std::unique_ptr<Machine> make_i8080(I8080Setup setup) {
  return std::make_unique<I8080Run>(std::move(setup));
}

}  // namespace sightline::guests::run
