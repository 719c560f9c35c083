#include "host/picture/svg.hpp"

#include <fmt/core.h>


#include "host/base/text.hpp"

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

SvgWriter::SvgWriter(const std::string& width, const std::string& height, std::string_view title,
                     SvgPositions positions)
    : positions_(positions),
      text_(fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                        "<svg xmlns=\"http://www.w3.org/2000/svg\" "
                        "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
                        "     width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\">\n"
                        "  <title>{2}</title>\n",
                        width, height, xml_text(title))) {}

std::string SvgWriter::millimetres(double length) {
  return fmt::format("{:.3f}", length);
}

void SvgWriter::clip_rectangle(std::string_view id, double x, double y, double width, double height) {
  base::append(text_,
               "  <clipPath id=\"{}\"><rect x=\"{:.3f}\" y=\"{:.3f}\" width=\"{:.3f}\" height=\"{:.3f}\"/>"
               "</clipPath>\n",
               id, x, y, width, height);
}

void SvgWriter::open_lines(std::string_view id, std::string_view label, Colour colour,
                           std::string_view pen_millimetres) {
  base::append(
      text_,
      "  <g id=\"{}\" inkscape:groupmode=\"layer\" inkscape:label=\"{}\"\n"
      "     fill=\"none\" stroke=\"#{:02x}{:02x}{:02x}\" stroke-width=\"{}\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\">\n",
      id, xml_text(label), colour.red, colour.green, colour.blue, pen_millimetres);
}

void SvgWriter::open_areas(std::string_view id, std::string_view label, std::string_view style) {
  base::append(text_, "  <g id=\"{}\" inkscape:groupmode=\"layer\" inkscape:label=\"{}\" {}>\n", id,
               xml_text(label), style);
}

void SvgWriter::begin_path(Colour colour) {
  begin("    <path");
  base::append(text_, " fill=\"#{0:02x}{1:02x}{2:02x}\" stroke=\"#{0:02x}{1:02x}{2:02x}\" d=\"", colour.red,
               colour.green, colour.blue);
}

void SvgWriter::begin_area(Colour colour, bool with_line) {
  begin("    <path");
  begin_distances();
  base::append(text_, " fill=\"#{:02x}{:02x}{:02x}\"", colour.red, colour.green, colour.blue);
  if (with_line) base::append(text_, " stroke=\"#{:02x}{:02x}{:02x}\"", colour.red, colour.green, colour.blue);
  text_ += " d=\"";
}

void SvgWriter::begin_short_area(Colour colour) {
  begin("<path");
  begin_distances();
  base::append(text_, " fill=\"#{:02x}{:02x}{:02x}\" d=\"", colour.red, colour.green, colour.blue);
}

void SvgWriter::whole_point(std::int64_t across, std::int64_t down) {
  const auto number = [this](std::int64_t value, bool apart) {
    if (apart && value >= 0) text_ += ' ';
    char digits[24];
    char* at = digits + sizeof digits;
    std::uint64_t rest = static_cast<std::uint64_t>(value < 0 ? -value : value);
    do *--at = static_cast<char>('0' + rest % 10);
    while ((rest /= 10) > 0);
    if (value < 0) *--at = '-';
    text_.append(at, static_cast<std::size_t>(digits + sizeof digits - at));
  };
  if (command_ == 'M') {
    text_ += 'M';
    number(across, false);
    number(down, true);
    command_ = 'l';
  } else {
    if (across == last_across_ && down == last_down_) return;
    if (command_ == 'l') text_ += 'l';
    number(across - last_across_, command_ != 'l');
    number(down - last_down_, true);
    command_ = ' ';
  }
  last_across_ = across;
  last_down_ = down;
}

void SvgWriter::append_distance(std::int64_t distance, bool first) {
  if (distance >= 0 && !first) text_ += ' ';
  const std::size_t begin = text_.size();
  append(distance);
  if (distance == 0) return;
  const std::size_t zero = begin + (distance < 0 ? 1 : 0);
  if (text_[zero] == '0') text_.erase(zero, 1);
}

void SvgWriter::point(std::int64_t across, std::int64_t down) {
  if (distances_ && command_ != 'M') {
    if (command_ == 'l') text_ += 'l';
    append_distance(across - last_across_, command_ == 'l');
    append_distance(down - last_down_, false);
    last_across_ = across;
    last_down_ = down;
    command_ = ' ';
    return;
  }
  if (distances_) {
    text_ += 'M';
    append(across);
    text_ += ' ';
    append(down);
    last_across_ = across;
    last_down_ = down;
    command_ = 'l';
    return;
  }
  if (command_ != 0) text_ += command_;
  append(across);
  text_ += ',';
  append(down);
  command_ = command_ == 'M' || command_ == 'L' ? 'L' : ' ';
}

void SvgWriter::dot(std::int64_t across, std::int64_t down) {
  std::int64_t half_dash = 1;  // 10^-2 mm
  for (int digit = 2; digit < positions_.decimals; ++digit) half_dash *= 10;
  point(across - half_dash, down);
  point(across + half_dash, down);
}

// Formatted by hand, because a drawing has hundreds of thousands of these.
void SvgWriter::append(std::int64_t position) {
  char digits[24];
  char* const end = digits + sizeof digits;
  char* at = end;
  std::uint64_t rest = static_cast<std::uint64_t>(position < 0 ? -position : position);
  for (int place = 0; place <= positions_.decimals || rest > 0; ++place) {
    if (place == positions_.decimals) *--at = '.';
    *--at = static_cast<char>('0' + rest % 10);
    rest /= 10;
  }
  if (position < 0) *--at = '-';
  std::size_t length = static_cast<std::size_t>(end - at);
  if (!positions_.needless_zeros) {
    while (at[length - 1] == '0') --length;
    if (at[length - 1] == '.') --length;
  }
  text_.append(at, length);
}

}  // namespace sightline::picture
