// The DEC Type 340 precision display: fetches its words by data break and flashes the beam, pulse by pulse in time.
//
// All eight modes. A mode without its option hangs the display, without request and flag, until IDLA: 3 without the Type
// 342, 7 without the Type 347, and always 2 (the Type 343 is not built; words.hpp decodes its words). An IDLA during a word
// abandons the word cleanly; the real outcome is not defined. Left out: the tube, which the stroke taker models.
//
// One shortcut, which cannot be observed: a word that nothing can disturb is executed as a whole when time passes its end.
// If the display is accessed before, the same pulses are made one by one, so that every register is exact.
//
// Source: logic drawings as modelled pulse by pulse, confirmed by 501 display files; IOT actions from the PDP-7 Users
// Handbook and two Cambridge and DEC programs. Inferred, not confirmed: the state that IDCF and START keep, IDRD.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "../core/iot_device.hpp"
#include "../core/stroke.hpp"
#include "../core/time.hpp"
#include "../core/word.hpp"
#include "characters.hpp"
#include "delays.hpp"
#include "registers.hpp"

namespace sightline::type340 {

struct Options {
  bool subroutines_347 = false;
  bool characters_342 = false;
  // Pulses of a vector that do not move the beam flash the same spot again, once the word has moved it. True follows the
  // drawings; false: only pulses that move flash.
  bool flash_again = true;
};

// The light pen of the Type 340 (Type 370): its field of view and its response time.
//
// The field of view is a rectangle in display points, which a test can state exactly; a real pen sees a disc of about forty
// points. A flash inside it gives one light pulse.
struct LightPen {
  std::uint16_t left = 0;  // points, all borders included
  std::uint16_t bottom = 0;
  std::uint16_t right = 0;
  std::uint16_t top = 0;
  // Beam on -> light pulse. Flashes are at least 1.5 us apart, and only one pulse is pending at a time: a longer delay is
  // taken as 1.499 us, a negative one as 0.
  core::Duration delay{100};

  [[nodiscard]] constexpr bool sees(std::uint16_t x, std::uint16_t y) const {
    return left <= x && x <= right && bottom <= y && y <= top;
  }

  void visit_state(core::StateVisitor& visit) {
    visit("left", left);
    visit("bottom", bottom);
    visit("right", right);
    visit("top", top);
    visit("delay", delay);
    visit.require(delay < timing::pulse, "delay", "less than 1500");
  }
};

// The counts of a Type 340 for reports: words, passes, and when the last passes began.
struct Counters {
  std::uint64_t words = 0;           // display words received
  std::uint64_t passes_started = 0;  // IDLA and IDRD
  std::uint64_t passes_stopped = 0;  // by a stop word, or by an edge in vector or increment mode
  std::uint64_t stop_codes = 0;      // words with STOP that ended a pass
  std::uint64_t edges = 0;           // edges that ended a pass, in vector or increment mode
  std::uint64_t characters_met = 0;  // words of mode 3 without the Type 342: the display hangs
  std::uint64_t subroutines_met = 0;  // words of mode 7 without the Type 347, likewise
  std::uint64_t asked_in_vain = 0;  // IDSI since the display was stopped by a word that asks for no stop interrupt
  std::uint64_t starts_ored = 0;    // 700604 that started at another address than that in AC
  core::Instant last_start = core::never;      // never: no pass yet
  core::Instant previous_start = core::never;  // the one before
};

class Display final : public core::IotDevice {
  static constexpr std::array<std::uint8_t, 4> codes{005, 006, 007, 010};
  static constexpr std::array iots{
      core::IotName{"idve", 0700501, "skip if vertical edge flag"},
      core::IotName{"idrs", 0700504, "resume after light-pen stop"},
      core::IotName{"idra", 0700512, "AC from display address counter"},
      core::IotName{"idsi", 0700601, "skip if stop interrupt"},
      core::IotName{"idla", 0700606, "load address and start"},
      core::IotName{"idrd", 0700614, "restart at the address counter"},
      core::IotName{"idsp", 0700701, "skip if light-pen flag"},
      core::IotName{"idcf", 0700704, "clear display control"},
      core::IotName{"idrc", 0700712, "AC from X/2, Y/2"},
      core::IotName{"idhe", 0701001, "skip if horizontal edge flag"},
  };
  static constexpr std::array settings{
      core::DeviceOption{"342", "the Type 342 character generator", 0, 0, 1},
      core::DeviceOption{"347", "the Type 347 subroutine option", 0, 0, 1},
      core::DeviceOption{"flash-again", "pulses of a vector that do not move the beam flash the same spot again", 1, 0, 1},
  };

 public:
  static constexpr core::IotDeviceInfo info{"display", "Type 340 precision display", codes, iots, settings};

  // The display puts its strokes into `strokes`, which must outlive it.
  Display(Options options, core::StrokeBuffer& strokes) : options_(options), strokes_(strokes) {}
  explicit Display(const core::IotDeviceSetup& setup);

  // --- On the IOT bus
  void iot(core::Instant now, std::uint32_t word, core::IotReply& reply) override;
  // The actions of single IOTs; each first brings the display up to `now`.
  void load_address_and_start(core::Instant now, core::Word18 ac) { start(now, ac.value()); }  // IDLA
  void restart(core::Instant now) { start(now, address_counter(now).value()); }                // IDRD
  void clear_flags(core::Instant now) override;  // IDCF and CAF: clears flags and a waiting request; a running word continues
  void resume(core::Instant now);  // IDRS: clears pen flag, find and enable; the word continues after 1 us
  void power_clear(core::Instant now) override;  // stops everything; keeps position, scale and intensity

  bool stop_interrupt(core::Instant now) { return flags_at(now).stop_interrupt(); }
  bool vertical_edge(core::Instant now) { return flags_at(now).vertical_edge; }
  bool horizontal_edge(core::Instant now) { return flags_at(now).horizontal_edge; }
  bool light_pen_flag(core::Instant now) { return flags_at(now).pen_flag; }
  core::Word18 address_counter(core::Instant now) { return core::Word18(flags_at(now).address); }
  core::Word18 return_address(core::Instant now) { return core::Word18(flags_at(now).return_address); }
  // X/2 in bits 0-8, Y/2 in bits 9-17, as IDRC reads them.
  core::Word18 coordinates(core::Instant now);
  // IORS reads the light-pen flag.
  [[nodiscard]] std::uint32_t status(core::Instant now) override { return light_pen_flag(now) ? 0010000 : 0; }
  [[nodiscard]] bool interrupt_request() const override {
    if (whole_) return false;  // a whole word begins without flags
    return registers_.pen_flag || registers_.edge() || registers_.stop_interrupt();
  }

  // --- Time. A machine that calls `advance` only when the deadline has passed lets words be executed as a whole.
  void advance(core::Instant now) override {
    if (whole_ && now >= whole_until_) execute_whole_word();
    if (!delays_.none()) make_pulses(now);
  }
  void finish_strokes(core::Instant now) override { advance(now); }
  [[nodiscard]] core::Instant deadline() const override {
    if (whole_) return whole_until_;  // a whole word begins without a request
    return data_break() != nullptr ? request_since_ : deadline_of_delays();
  }

  // --- Data breaks: for display words, and for the word that DDS of the Type 347 writes
  [[nodiscard]] const core::DataBreak* data_break() const override {
    return registers_.request || writing_ ? &request_ : nullptr;
  }
  // Ignored if no data break is requested. After a word is written, the next data break is requested at once.
  void end_break(core::Instant end, core::Word18 word) override;
  // The instant since when the data break is requested.
  [[nodiscard]] core::Instant requested_at() const { return request_since_; }

  // --- For the host
  // Applies from the last advance on; nullopt removes the pen.
  void point_light_pen(std::optional<LightPen> pen);
  [[nodiscard]] const Counters& counters() const { return counters_; }
  [[nodiscard]] std::vector<core::Count> counts() const override;
  // Where the last pass began; 0 before the first.
  [[nodiscard]] std::uint16_t start_address() const { return start_address_; }
  // Indicator lights, as of the last advance.
  [[nodiscard]] const Registers& registers() const { return registers_; }
  // The next internal pulse, as of the last advance; never: none is pending.
  [[nodiscard]] core::Instant next_pulse() const { return delays_.next().at; }

  // Whether a word is to be executed as a whole is not visited: after restoring, the same pulses are made one by one.
  void visit_state(core::StateVisitor& visit) override;
  void require_time(core::StateVisitor& visit, core::Instant now) override;

 private:
  // Flags and addresses do not change during a word that is to be executed as a whole.
  const Registers& flags_at(core::Instant now) {
    if (!whole_ || now >= whole_until_) advance(now);
    return registers_;
  }

  [[nodiscard]] core::Instant deadline_of_delays() const;
  void start(core::Instant now, std::uint32_t address);
  void deliver(core::Instant at, core::Word18 word);

  static constexpr core::Duration not_whole{-1};
  [[nodiscard]] core::Duration time_of_whole_word();
  void execute_whole_word();
  void draw_vector(VectorWord w);

  void make_pulses(core::Instant now);
  [[nodiscard]] bool counts_for_ever() const;
  void fire(Delay delay, core::Instant t);
  void operate(core::Instant t);
  void operate_parameter(core::Instant t);
  void operate_point(core::Instant t);
  void operate_subroutine(core::Instant t);
  void operate_character(core::Instant t);
  void count(core::Instant t);
  void note_motion(bool moved);
  void end_word(core::Instant t);
  void continue_word(core::Instant t);
  void next_stroke(core::Instant t);
  void start_intensify(core::Instant t);
  void flash(core::Instant t, bool lit);
  void raise_request(core::Instant t);
  void end_pass(core::Instant t);

  Options options_;
  core::StrokeBuffer& strokes_;
  Registers registers_;
  Delays delays_;
  core::Word18 input_;              // the word at the inputs
  std::uint16_t word_address_ = 0;  // its core address
  std::uint16_t start_address_ = 0;
  core::DataBreak request_;
  core::Instant request_since_{};
  bool writing_ = false;  // the request is one of DDS
  bool pass_open_ = false;
  CharacterPath path_;
  std::size_t stroke_ = 0;  // of the path
  std::optional<LightPen> pen_;
  bool whole_ = false;           // the word at the inputs will run undisturbed until whole_until_
  core::Instant whole_until_{};  // its request, or its stop
  Registers::End end_{};         // its end point, if it is a vector
  Counters counters_;
};

}  // namespace sightline::type340
