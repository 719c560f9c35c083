#include "host/base/result.hpp"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace sightline::base {

std::string Error::message(MessageStyle style) const {
  const bool plain = style == MessageStyle::plain;
  std::string text = file;
  if (!place.empty()) {
    if (!text.empty()) text += plain ? ": " : ":";
    text += place;
  }
  if (!text.empty()) text += ": ";
  if (style == MessageStyle::compiler) text += "error: ";
  if (!plain) text += "found ";
  text += found;
  if (!expected.empty()) text += ", expected " + expected;
  if (!remedy.empty()) text += "; " + remedy;
  if (!excerpt.empty()) text += "\n" + excerpt;
  return text;
}

void give_up(const std::string& fault) {
#if defined(__cpp_exceptions)
  throw std::logic_error(fault);
#else
  std::fputs((fault + "\n").c_str(), stderr);
  std::abort();
#endif
}

}  // namespace sightline::base
