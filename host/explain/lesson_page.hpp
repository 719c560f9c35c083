// Writes a lesson as one HTML page that plays it, without network access or other files.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "host/explain/lesson.hpp"

namespace sightline::explain {

// The player's sources by file name, for the pages that play lessons.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> player_files();

[[nodiscard]] std::string page_of(const Lesson& lesson);

}  // namespace sightline::explain
