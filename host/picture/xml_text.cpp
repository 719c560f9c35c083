#include "host/picture/xml_text.hpp"

namespace sightline::picture {

std::string xml_text(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&': safe += "&amp;"; break;
      case '<': safe += "&lt;"; break;
      case '>': safe += "&gt;"; break;
      case '"': safe += "&quot;"; break;
      default: safe += c >= ' ' && c <= '~' ? c : '?';
    }
  }
  return safe;
}

}  // namespace sightline::picture
