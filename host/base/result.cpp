#include "host/base/result.hpp"

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

}  // namespace sightline::base
