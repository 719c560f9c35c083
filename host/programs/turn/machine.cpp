#include "host/programs/turn/machine.hpp"

#include <utility>

#include "emulators/machines/pdp7.hpp"
#include "emulators/pdp7/paper_tape.hpp"
#include "emulators/type340/display.hpp"
#include "host/base/result.hpp"
#include "host/machines/stroke_keeper.hpp"
#include "host/machines/pdp7_watch.hpp"

namespace sightline::programs::turn {

// A named namespace, because a member of a class with linkage cannot have a type without linkage.
namespace machine_watch {

// Observes the stores that end pictures, the waiting for the display, and stores into display files.
class Watch final : public machines::ProgramWatch {
 public:
  // Stores into display files are observed from `first_file` on.
  explicit Watch(const Labels& labels, std::uint32_t first_file, std::uint32_t file_words) : labels_(labels), file_words_(file_words) {
    for (const pdp7::Address label : {labels.wait, labels.waited, labels.line, labels.junction}) mark(label, pdp7::mark::fetched);
    mark(labels.file, pdp7::mark::written);
    for (pdp7::Address address = first_file; address < model_end(Memory::words_8k); ++address)
      mark(address, pdp7::mark::written);
  }

  void cycle(const pdp7::Cycle& cycle) override {
    if (cycle.verb == pdp7::Verb::fetch) {
      if (cycle.address == labels_.wait && !waits_) {
        waits_ = true;
        wait_begun_ = cycle.time;
      } else if (cycle.address == labels_.waited) {
        waits_ = false;
        waiting_ += cycle.time - wait_begun_;
      } else if (cycle.address == labels_.line) {
        ++lines_;
      } else if (cycle.address == labels_.junction) {
        ++junctions_;
      }
    } else if (cycle.verb != pdp7::Verb::write) {
      return;
    } else if (cycle.address == labels_.file) {
      published_ = cycle.data.value();
      ended_ = cycle.time + cycle.length;
      if (published_ == 0) return;
      ++pictures_;
      request_stop();
    } else if (inside(cycle.address, shown_) || inside(cycle.address, published_)) {
      ++torn_;
    }
  }

  void pass_begins() {
    shown_ = published_;
    ++passes_;
  }
  // The number of pictures complete so far.
  [[nodiscard]] std::uint32_t pictures() const { return pictures_; }
  [[nodiscard]] core::Instant ended() const { return ended_; }
  [[nodiscard]] core::Duration take_waiting() { return std::exchange(waiting_, core::Duration(0)); }
  [[nodiscard]] std::uint32_t take_passes() { return std::exchange(passes_, 0U); }
  [[nodiscard]] std::uint32_t take_lines() { return std::exchange(lines_, 0U); }
  [[nodiscard]] std::uint32_t take_junctions() { return std::exchange(junctions_, 0U); }
  [[nodiscard]] std::uint64_t torn() const { return torn_; }

 private:
  [[nodiscard]] bool inside(pdp7::Address address, std::uint32_t file) const {
    return file != 0 && address >= file && address < file + file_words_;
  }

  Labels labels_;
  std::uint32_t file_words_;
  bool waits_ = false;
  core::Instant wait_begun_{};
  core::Instant ended_{};
  core::Duration waiting_{};
  std::uint32_t published_ = 0;
  std::uint32_t shown_ = 0;
  std::uint32_t passes_ = 0;
  std::uint32_t lines_ = 0;
  std::uint32_t junctions_ = 0;
  std::uint32_t pictures_ = 0;
  std::uint64_t torn_ = 0;
};

class Passes final : public machines::StrokeKeeper {
 public:
  Passes(Watch& watch, bool keeps) : watch_(watch), keeps_(keeps) {}
  void begin_pass(core::Instant) override {
    watch_.pass_begins();
    keep(keeps_ && watch_.pictures() != pictures_);
    pictures_ = watch_.pictures();
  }
  void end_pass(core::Instant) override {
    if (keeping_) shown_.push_back({pictures_ - 1, take_strokes()});
    keep(false);
  }
  [[nodiscard]] std::vector<ShownPass> take() { return std::exchange(shown_, {}); }

 private:
  void keep(bool keeping) {
    keeping_ = keeping;
    keep_strokes(keeping);
  }

  Watch& watch_;
  bool keeps_;
  bool keeping_ = false;
  std::uint32_t pictures_ = 0;
  std::vector<ShownPass> shown_;
};

}  // namespace machine_watch

namespace {

constexpr std::uint32_t stop_word = 0003000;

pdp7::Options options_for(const Program& program) {
  pdp7::Options options;
  options.model.eae = program.eae;
  if (program.memory == Memory::words_32k) options.core_words = 32768;
  options.devices.push_back(type340::Display::info.name);
  return options;
}

}  // namespace

class Machine::Parts {
 public:
  Parts(const Program& program, std::uint32_t first_file, std::uint32_t file_words, bool strokes)
      : program_(program),
        watch_(program.labels, first_file, file_words),
        passes_(watch_, strokes),
        machine_(options_for(program)) {
    if (!machine_.error().empty()) base::give_up(machine_.error());
    machine_.strokes().hand_to(&passes_);
    machine_.load(0, program.core);
  }

  Program program_;
  machine_watch::Watch watch_;
  machine_watch::Passes passes_;
  pdp7::Machine machine_;
  core::Instant last_{};
  bool first_ = true;
  bool halted_ = false;
};

Machine::Machine(const Program& program, const Tape& tape, Observation observation)
    : parts_(std::make_unique<Parts>(
          program, model_end(Memory::words_8k) - (observation.torn_stores ? tape.files * tape.file_words : 0), tape.file_words,
          observation.strokes)) {
  auto& machine = parts_->machine_;
  const Labels& labels = program.labels;
  const std::uint32_t base = model_base(program.memory);
  machine.load(base, tape.words);
  machine.deposit(labels.count, core::Word18(static_cast<std::uint32_t>(tape.words.size())));
  machine.deposit(labels.checksum, checksum(tape.words));
  machine.start(labels.begin);
}

Machine::Machine(const Program& program, const base::Bytes& tape)
    : parts_(std::make_unique<Parts>(program, model_end(Memory::words_8k), 0, false)) {
  parts_->machine_.find<pdp7::Reader>()->load(tape);
  parts_->machine_.start(program.labels.start);
}

Machine::~Machine() = default;
Machine::Machine(Machine&&) noexcept = default;

bool Machine::next(std::uint32_t switches, Picture& picture, core::Duration limit) {
  Parts& m = *parts_;
  const Labels& labels = m.program_.labels;
  m.machine_.console().set(core::Word18(switches));
  pdp7::Limits limits;
  limits.until = m.machine_.now() + limit;
  const auto reason = m.machine_.run(limits, m.watch_);
  m.halted_ = reason == pdp7::StopReason::halt;
  if (reason != pdp7::StopReason::observer) return false;
  const auto peek = [&m](pdp7::Address address) { return m.machine_.peek(address).value(); };
  picture.angle = peek(labels.angle);
  picture.wire = (peek(labels.switches) & wire_switch) != 0;
  picture.status = static_cast<Status>(peek(labels.status));
  const core::Instant ended = m.watch_.ended();
  picture.time = std::exchange(m.first_, false) ? core::Duration(0) : ended - m.last_;
  m.last_ = ended;
  picture.waiting = m.watch_.take_waiting();
  picture.passes = m.watch_.take_passes();
  picture.lines = m.watch_.take_lines();
  picture.junctions = m.watch_.take_junctions();
  picture.shown = m.passes_.take();
  picture.display_file.clear();
  for (pdp7::Address address = peek(labels.file_begun); address < model_end(Memory::words_8k); ++address) {
    picture.display_file.push_back(m.machine_.peek(address));
    if (picture.display_file.back().value() == stop_word) break;
  }
  return true;
}

Status Machine::status() const {
  return static_cast<Status>(parts_->machine_.peek(parts_->program_.labels.status).value());
}
bool Machine::halted() const { return parts_->halted_; }
core::Instant Machine::now() const { return parts_->machine_.now(); }
core::Word18 Machine::peek(pdp7::Address address) const { return parts_->machine_.peek(address); }
std::uint64_t Machine::torn_stores() const { return parts_->watch_.torn(); }

}  // namespace sightline::programs::turn
