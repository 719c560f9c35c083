// Any bytes as a PDP-7 with a Type 340: its configuration, registers, tape and keys, and the words in its core. It runs
// twice: once without observer in one piece, and once with every cycle and flash observed, in many pieces. Both runs must end in
// the same state at the same instant, and the observations must satisfy the machine's invariants.
//
// Input: a header of 24 bytes (Header), then words of three bytes, high byte first, from Header::load on.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/machines/pdp7.hpp"
#include "emulators/pdp7/paper_tape.hpp"
#include "emulators/pdp7/teletype.hpp"
#include "emulators/type340/display.hpp"

namespace {

using namespace sightline;

constexpr std::uint64_t most_instructions = 3000;
constexpr core::Instant latest = core::at_nanoseconds(100'000'000);  // long EAE steps do not lengthen a run

void require(bool holds) {
  if (!holds) std::abort();
}

// Takes bytes from the front; zeros after the end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
  [[nodiscard]] bool empty() const { return at_ == end_; }
  std::uint32_t take(int count) {
    std::uint32_t value = 0;
    for (; count > 0; --count) value = value << 8 | (at_ == end_ ? 0U : *at_++);
    return value;
  }

 private:
  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

// Members in the order of the input; each comment begins with the number of bytes.
struct Header {
  explicit Header(Bytes& in)
      : machine(in.take(1)),
        devices(in.take(1)),
        modes(in.take(1)),
        core_seed(in.take(1)),
        start(in.take(2)),
        load(in.take(2)),
        display_file(in.take(2)),
        ac(in.take(3)),
        mq(in.take(3)),
        sc(in.take(1)),
        switches(in.take(3)),
        switches_later(in.take(3)),
        pen(in.take(1)) {}

  std::uint32_t
      machine;  // 1: bits 0-1 memory, 2 EAE, 3 trap mode, 4 strict, 5 type 347, 6 type 342, 7 flash again
  std::uint32_t
      devices;  // 1: bits 0-3 clock, reader, punch, teletype; 4 60 Hz; 5 slow IOTs; 6 quick; 7 display
  std::uint32_t
      modes;  // 1: bits 0 link, 1 interrupts, 2 extend, 3 trap mode, 4 IDLA first, 5 pen, 6 key, 7 tape
  std::uint32_t core_seed;       // 1: 0 core is zero
  std::uint32_t start;           // 2
  std::uint32_t load;            // 2
  std::uint32_t display_file;    // 2
  std::uint32_t ac, mq;          // 3, 3
  std::uint32_t sc;              // 1
  std::uint32_t switches;        // 3
  std::uint32_t switches_later;  // 3: after 1 ms
  std::uint32_t pen;             // 1: delay of the light, in tens of nanoseconds
};

[[nodiscard]] bool has(std::uint32_t bits, unsigned n) {
  return (bits >> n & 1U) != 0;
}

pdp7::Options options_of(const Header& header) {
  pdp7::Options machine;
  machine.core_words = 4096U << (header.machine & 3U);
  machine.model.eae = has(header.machine, 2);
  machine.model.trap_mode = has(header.machine, 3);
  machine.model.strict = has(header.machine, 4);
  constexpr std::array<std::string_view, 4> devices{"clock", "reader", "punch", "keyboard"};
  machine.devices.clear();
  for (unsigned n = 0; n < devices.size(); ++n)
    if (has(header.devices, n)) machine.devices.push_back(devices[n]);
  if (has(header.devices, 3)) machine.devices.emplace_back("printer");
  if (has(header.devices, 4)) machine.timing.clock_hertz = 60;
  if (has(header.devices, 5)) machine.timing.iot_stretch.fill(core::Duration(777));
  if (has(header.devices, 6)) {  // so that flags rise and ticks come within a short run
    machine.timing.clock_hertz = 10'000;
    machine.timing.reader_line = core::Duration(3'333);
    machine.timing.punch_line = core::Duration(15'797);
    machine.timing.teletype_character = core::Duration(100'000);
  }
  return machine;
}

void set_up(pdp7::Machine& machine, const Header& header, Bytes words) {
  require(machine.error().empty());
  if (!has(header.devices, 7)) {
    const std::array settings{core::Setting{"347", has(header.machine, 5) ? 1 : 0},
                              core::Setting{"342", has(header.machine, 6) ? 1 : 0},
                              core::Setting{"flash-again", has(header.machine, 7) ? 0 : 1}};
    require(machine.attach("display", settings).empty());
  }
  if (header.core_seed != 0) machine.randomise_core(header.core_seed);
  for (pdp7::Address at = header.load & pdp7::address_mask; !words.empty(); ++at)
    machine.deposit(at & pdp7::address_mask, core::Word18(words.take(3)));
  auto* const reader = machine.find<pdp7::Reader>();
  if (reader != nullptr && has(header.modes, 7)) reader->load({0300, 0201, 0, 0377, 0212, 0100, 0205, 0206, 0207});
  auto* const keyboard = machine.find<pdp7::Keyboard>();
  if (keyboard != nullptr && has(header.modes, 6)) keyboard->press(core::at_nanoseconds(50'000), 0101);
  machine.console().set(core::Word18(header.switches));
  machine.console().schedule({{core::at_nanoseconds(1'000'000), core::Word18(header.switches_later)}});
  machine.start(header.start);
  pdp7::State& registers = machine.registers();
  registers.ac = core::Word18(header.ac);
  registers.mq = core::Word18(header.mq);
  registers.sc = core::Word<6>(header.sc);
  registers.link = has(header.modes, 0);
  registers.interrupts_on = has(header.modes, 1);
  registers.extend = has(header.modes, 2) && machine.options().model.extend;
  registers.trap_mode = has(header.modes, 3) && machine.options().model.trap_mode;
  auto* const display = machine.find<type340::Display>();
  if (display == nullptr) return;
  if (has(header.modes, 5))
    display->point_light_pen(type340::LightPen{0, 0, 700, 700, core::Duration(10) * static_cast<int>(header.pen)});
  if (has(header.modes, 4)) display->load_address_and_start(machine.now(), core::Word18(header.display_file));
}

struct Screen final : core::StrokeTaker {
  core::Instant last{};
  void strokes(std::span<const core::Stroke> strokes) override {
    for (const core::Stroke& stroke : strokes) {
      require(stroke.x < 1024 && stroke.y < 1024 && stroke.intensity < 8);
      require(stroke.address < 8192 && stroke.time >= last);
      last = stroke.time;
    }
  }
};

// Cycles follow each other without overlap or gap; instructions begin and end at cycle boundaries.
struct Watcher final : pdp7::Observer {
  Watcher() { instructions = true; }
  core::Instant reached{};
  core::Instant last_end{};
  std::uint64_t count = 0;
  void cycle(const pdp7::Cycle& cycle) override {
    require(cycle.time == reached && cycle.length.count() >= 0);
    require(cycle.address <= pdp7::address_mask);
    reached = cycle.time + cycle.length;
  }
  void instruction(const pdp7::InstructionRecord& record) override {
    require(record.time >= last_end && record.end - record.time >= pdp7::machine_cycle);
    require(record.end == reached && record.after.pc <= pdp7::address_mask);
    last_end = record.end;
    ++count;
  }
};

// Runs to a stop or to the limits, `part` instructions at a time, observed if there is a watcher.
pdp7::StopReason run(pdp7::Machine& machine, std::uint64_t part, Watcher* watcher) {
  pdp7::StopReason reason = pdp7::StopReason::instruction_limit;
  std::uint64_t left = most_instructions;
  while (left != 0 && reason == pdp7::StopReason::instruction_limit) {
    const pdp7::Limits limits{std::min(part, left), latest};
    reason = watcher != nullptr ? machine.run(limits, *watcher) : machine.run(limits);
    left -= limits.instructions;
  }
  return reason;
}

void check_laws(const pdp7::Machine& machine) {
  const pdp7::Counts counts = machine.counts();
  require(counts.instructions <= most_instructions);
  require(counts.machine_cycles >= counts.instructions + counts.stolen_cycles);
  const auto core = machine.core();
  require(core.size() == machine.options().core_words);
  require(std::all_of(core.data() + core.size(), core.data() + pdp7::address_mask + 1,
                      [](core::Word18 word) { return word.value() == 0; }));
}

// Compares a part of the state of a device that both or neither have.
template <class Device, class Part>
void check_same_part(const pdp7::Machine& a, const pdp7::Machine& b, Part part) {
  const Device* const of_a = a.find<Device>();
  const Device* const of_b = b.find<Device>();
  require((of_a == nullptr) == (of_b == nullptr));
  if (of_a != nullptr) require(part(*of_a) == part(*of_b));
}

void check_same(const pdp7::Machine& a, const pdp7::Machine& b) {
  require(a.registers() == b.registers() && a.now() == b.now());
  require(a.counts().instructions == b.counts().instructions);
  require(a.counts().stolen_cycles == b.counts().stolen_cycles);
  require(std::equal(a.core().begin(), a.core().end(), b.core().begin(), b.core().end()));
  check_same_part<pdp7::Punch>(a, b, [](const pdp7::Punch& punch) { return punch.tape(); });
  check_same_part<pdp7::Printer>(a, b, [](const pdp7::Printer& printer) { return printer.printed(); });
  check_same_part<type340::Display>(a, b, [](const type340::Display& display) { return display.counters().words; });
  check_same_part<type340::Display>(a, b, [](const type340::Display& display) { return display.counters().passes_stopped; });
  require(std::equal(a.unanswered().begin(), a.unanswered().end(), b.unanswered().begin(),
                     b.unanswered().end(), [](const pdp7::Unanswered& x, const pdp7::Unanswered& y) {
                       return x.word == y.word && x.count == y.count && x.first_pc == y.first_pc;
                     }));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes words(data, size);
  const Header header(words);
  pdp7::Machine alone(options_of(header));
  set_up(alone, header, words);
  const pdp7::StopReason reason = run(alone, most_instructions, nullptr);
  check_laws(alone);

  Screen screen;
  Watcher watcher;
  pdp7::Machine watched(options_of(header));
  set_up(watched, header, words);
  watched.strokes().hand_to(&screen);
  require(run(watched, 7, &watcher) == reason);
  check_laws(watched);
  require(watcher.count == watched.counts().instructions && watcher.reached == watched.now());
  check_same(alone, watched);
  return 0;
}
