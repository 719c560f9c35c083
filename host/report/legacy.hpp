// Chapters that are not data files and experiments yet.
#pragma once

#include <string_view>
#include <vector>

#include "host/report/document.hpp"
#include "host/report/experiment.hpp"

namespace sightline::report {

struct LegacyChapter {
  std::string_view name;  // as report.json has it
  Outcome<std::vector<Block>> (*make)(const Context& context) = nullptr;
};

// nullptr: there is none.
[[nodiscard]] const LegacyChapter* legacy_chapter(std::string_view name);

// Without host times, the columns and figures marked so are gone.
[[nodiscard]] Outcome<std::vector<Block>> make_legacy(const LegacyChapter& chapter, const Context& context);

}  // namespace sightline::report
