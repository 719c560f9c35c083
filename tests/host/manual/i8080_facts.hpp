// Sections on the 8080, its boards, plotters and links.
#pragma once

#include <string>

namespace sightline::manual {

[[nodiscard]] std::string i8080_effects();
[[nodiscard]] std::string i8080_instructions();
[[nodiscard]] std::string i8080_ports();
[[nodiscard]] std::string ef9365_status();
[[nodiscard]] std::string board_times();
[[nodiscard]] std::string calcomp_status();
[[nodiscard]] std::string i8251_status();

}  // namespace sightline::manual
