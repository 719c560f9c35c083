// The codes that the keys of a teletype send, and the text that a program's codes print.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sightline::live {

enum class KeyCodes : std::uint8_t {
  ascii,   // seven bits
  parity,  // bit 200 set, as the KSR 33 sends it
  unix,    // the same, but RETURN is 212, LINE FEED 215 and ESCAPE 375
  upper,   // as parity, small letters as capitals
};

[[nodiscard]] std::uint8_t code_of_key(KeyCodes codes, char key);

// The text of the codes that a program prints: their low seven bits, without NUL and DEL.
[[nodiscard]] std::string shown_text(std::string_view codes);

}  // namespace sightline::live
