#include "host/live/keys.hpp"

namespace sightline::live {

std::uint8_t code_of_key(KeyCodes codes, char key) {
  const auto code = static_cast<std::uint8_t>(key & 0177);
  constexpr std::uint8_t marked = 0200;
  switch (codes) {
    case KeyCodes::ascii: return code;
    case KeyCodes::parity: return code | marked;
    case KeyCodes::upper: return (code >= 'a' && code <= 'z' ? code - 040 : code) | marked;
    case KeyCodes::unix: break;
  }
  switch (code) {
    case '\r': return 0212;
    case '\n': return 0215;
    case 033: return 0375;
    default: return code | marked;
  }
}

std::string shown_text(std::string_view codes) {
  constexpr char rubout = 0177;
  std::string text;
  for (const char code : codes) {
    const char c = static_cast<char>(code & 0177);
    if (c != 0 && c != rubout) text.push_back(c);
  }
  return text;
}

}  // namespace sightline::live
