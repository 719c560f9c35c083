// Sections on the PDP-7 and the Type 340.
#pragma once

#include <string>

namespace sightline::manual {

[[nodiscard]] std::string pdp7_instructions();
[[nodiscard]] std::string pdp7_operate();
[[nodiscard]] std::string pdp7_eae();
[[nodiscard]] std::string pdp7_iots();
[[nodiscard]] std::string pdp7_status();
[[nodiscard]] std::string pdp7_timing();
[[nodiscard]] std::string type340_modes();
[[nodiscard]] std::string type340_words(std::size_t mode);
[[nodiscard]] std::string type340_times();
[[nodiscard]] std::string type340_codes();

}  // namespace sightline::manual
