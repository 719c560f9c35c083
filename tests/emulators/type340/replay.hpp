// Plays an event file to a Display and records what it does, as events of the same form.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "emulators/type340/display.hpp"
#include "tests/emulators/type340/golden_events.hpp"

namespace sightline::type340::testing {

struct FlashEvents final : core::StrokeTaker {
  std::vector<Event> events;
  void strokes(std::span<const core::Stroke> strokes) override {
    for (const core::Stroke& s : strokes) {
      events.push_back({core::nanoseconds_of(s.time),
                        "I " + std::to_string(s.x) + ' ' + std::to_string(s.y) + ' ' + std::to_string(s.intensity)});
    }
  }
};

enum class Stepping {
  ticks,      // every 50 ns, of which all times in the files are multiples
  deadlines,  // as a machine does: to the deadlines of the display and of the replay
};

class Replay {
 public:
  // `taker` has all flashes when run() returns; null: there is no taker.
  Replay(const EventFile& file, core::StrokeTaker* taker, Options options = {}) : file_(file), display_(options, strokes_) {
    strokes_.hand_to(taker);
    display_.point_light_pen(file.pen);
  }

  // Events in order, without flashes.
  [[nodiscard]] std::vector<Event> run(Stepping stepping) {
    const std::int64_t end = file_.events.back().time + 100'000;
    std::int64_t now = 0;
    std::size_t input = 0;
    while (now <= end) {
      display_.advance(core::at_nanoseconds(now));
      note_changes(now);
      serve(now);
      for (; input < file_.events.size() && file_.events[input].time <= now; ++input) give(file_.events[input]);
      serve(now);
      now = stepping == Stepping::ticks ? now + 50 : next_stop(now, input);
    }
    strokes_.flush();
    return std::move(events_);
  }

  [[nodiscard]] std::string final_state() const {
    const Registers& r = display_.registers();
    std::string text;
    for (const unsigned value : {unsigned{r.x}, unsigned{r.y}, static_cast<unsigned>(r.mode), unsigned{r.scale},
                                 unsigned{r.intensity}, unsigned{r.pen_enable}, unsigned{r.stop}}) {
      text += (text.empty() ? "" : " ") + std::to_string(value);
    }
    return text;
  }

  [[nodiscard]] const Display& display() const { return display_; }

 private:
  [[nodiscard]] static std::string octal(core::Word18 word) {
    std::string text(6, '0');
    for (unsigned i = 0; i < 6; ++i) text[i] = static_cast<char>('0' + word.field(3 * i, 3 * i + 2));
    return text;
  }

  // Starts and resumes are inputs of the file; all else is expected output.
  void give(const Event& event) {
    const core::Instant t = core::at_nanoseconds(event.time);
    if (event.text[0] == 'G') {
      segment_ = static_cast<std::size_t>(std::stoi(event.text.substr(2)));
      asked_ = false;
      display_.load_address_and_start(t, core::Word18(0760000));
    } else if (event.text == "R") {
      display_.resume(t);
    } else {
      return;
    }
    events_.push_back(event);
    note_changes(event.time);
  }

  void serve(std::int64_t now) {
    const core::DataBreak* request = display_.data_break();
    if (request != nullptr && !asked_) {
      asked_ = true;
      const auto& words = file_.segments[segment_];
      word_ = request->address < words.size() ? words[request->address] : core::Word18{};
      const std::int64_t since = core::nanoseconds_of(display_.requested_at());
      due_ = since + file_.latency;
      events_.push_back({since, "Q " + std::to_string(request->address) + ' ' + octal(word_)});
    }
    if (asked_ && due_ <= now) {
      asked_ = false;
      display_.end_break(core::at_nanoseconds(due_), word_);
      note_changes(due_);
    }
  }

  void note_changes(std::int64_t now) {
    const Registers& r = display_.registers();
    const bool state[] = {r.stop,     r.stop_interrupt(), r.horizontal_edge,
                          r.vertical_edge, r.pen_find, r.pen_flag};
    for (std::size_t i = 0; i < std::size(state); ++i) {
      if (state[i] == state_[i]) continue;
      state_[i] = state[i];
      events_.push_back({now, std::string(1, "STHVFL"[i]) + (state[i] ? '1' : '0')});
    }
  }

  [[nodiscard]] std::int64_t next_stop(std::int64_t now, std::size_t input) const {
    std::int64_t next = core::nanoseconds_of(display_.deadline());
    if (asked_) next = std::min(next, due_);
    for (std::size_t i = input; i < file_.events.size(); ++i) {
      if (file_.events[i].text[0] != 'G' && file_.events[i].text != "R") continue;
      next = std::min(next, file_.events[i].time);
      break;
    }
    return std::max(now + 1, next);
  }

  const EventFile& file_;
  core::StrokeBuffer strokes_;
  Display display_;
  std::vector<Event> events_;
  std::size_t segment_ = 0;
  bool asked_ = false;
  core::Word18 word_;
  std::int64_t due_ = 0;
  bool state_[6] = {};
};

}  // namespace sightline::type340::testing
