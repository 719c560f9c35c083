#include "tools/image/error.hpp"

namespace sightline::image {

std::string to_string(const Error& error) {
  std::string text = error.file;
  if (!error.place.empty()) text += ":" + error.place;
  return text + ": error: found " + error.found + ", expected " + error.expected;
}

std::string octal(std::uint32_t value, unsigned digits) {
  std::string text(digits, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, value >>= 3) {
    *digit = static_cast<char>('0' + (value & 07U));
  }
  return text;
}

}  // namespace sightline::image
