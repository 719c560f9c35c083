// Reader of the Type 340 event files (tests/data/type340/events/FORMAT.md).
#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "emulators/core/word.hpp"
#include "emulators/type340/display.hpp"

namespace sightline::type340::testing {

// One line of a record list. `text` contains neither time nor the note k; a run of flashes becomes one event per flash.
struct Event {
  std::int64_t time = 0;  // ns
  std::string text;

  friend auto operator<=>(const Event&, const Event&) = default;
};

struct EventFile {
  std::string id;
  std::int64_t latency = 0;  // ns from request to word
  std::optional<LightPen> pen;
  std::vector<std::vector<core::Word18>> segments;
  std::vector<Event> events;   // sorted
  std::string final_state;     // "x y mode scale intensity pen-enable stop"
};

struct EventFiles {
  std::vector<EventFile> files;
  std::string error;  // empty, or file:line, what was found and what was expected
};

[[nodiscard]] EventFiles read_event_files(const std::filesystem::path& path);

}  // namespace sightline::type340::testing
