// The AC switches of the console, and a script that moves them at given times.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "../core/state_visitor.hpp"
#include "../core/time.hpp"
#include "../core/word.hpp"

namespace sightline::pdp7 {

struct SwitchSetting {
  core::Instant time;
  core::Word18 switches;
};

class Console {
 public:
  // Schedules settings, in any order. Of two at one instant the later in the list applies.
  void schedule(std::vector<SwitchSetting> settings) {
    settings_ = std::move(settings);
    std::stable_sort(settings_.begin(), settings_.end(),
                     [](const SwitchSetting& a, const SwitchSetting& b) { return a.time < b.time; });
    next_ = 0;
  }

  void set(core::Word18 switches) { switches_ = switches; }

  [[nodiscard]] core::Word18 switches(core::Instant now) {
    while (next_ < settings_.size() && settings_[next_].time <= now) switches_ = settings_[next_++].switches;
    return switches_;
  }

  // When the script moves them again.
  [[nodiscard]] core::Instant deadline() const { return next_ < settings_.size() ? settings_[next_].time : core::never; }

  // The pending settings and the current one.
  void visit_state(core::StateVisitor& visit) {
    settings_.erase(settings_.begin(), settings_.begin() + static_cast<std::ptrdiff_t>(next_));
    next_ = 0;
    visit("switches", switches_);
    visit.list("settings", settings_, [&visit](SwitchSetting& setting) {
      visit("time", setting.time);
      visit("switches", setting.switches);
    });
  }

 private:
  std::vector<SwitchSetting> settings_;
  std::size_t next_ = 0;
  core::Word18 switches_;
};

}  // namespace sightline::pdp7
