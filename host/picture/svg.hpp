// SVG for drawing programs and plotter programs: one user unit is a millimetre, y is downwards, every group is an
// Inkscape layer. Plotter programs select layers by the number at the start of their labels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "host/picture/image.hpp"

namespace sightline::picture {

// Escapes text, and values in double quotes. Characters that XML does not allow, or that are not ASCII, become '?'.
[[nodiscard]] std::string xml_text(std::string_view text);

// Positions are integers in units of 10^-decimals mm from the top left corner.
struct SvgPositions {
  int decimals = 3;
  bool needless_zeros = true;  // 1.500 instead of 1.5
};

class SvgWriter {
 public:
  // Width and height are in millimetres; the title is escaped here.
  SvgWriter(double width, double height, std::string_view title, SvgPositions positions = {})
      : SvgWriter(millimetres(width), millimetres(height), title, positions) {}
  SvgWriter(const std::string& width, const std::string& height, std::string_view title,
            SvgPositions positions);

  void reserve(std::size_t bytes) { text_.reserve(bytes); }
  // Layers opened with `clip` are clipped to this rectangle.
  void clip_rectangle(std::string_view id, double x, double y, double width, double height);

  // A layer of lines: not filled, with round ends and corners. The label is escaped here.
  void open_lines(std::string_view id, std::string_view label, Colour colour,
                  std::string_view pen_millimetres);
  // A layer of areas. Each area has a line of its own colour around it; otherwise the paper would shine through between
  // areas. `style` holds SVG attributes, including the width of that line.
  void open_areas(std::string_view id, std::string_view label, std::string_view style);
  void close_layer() { text_ += "  </g>\n"; }

  void begin_polyline() { begin("    <polyline points=\""); }
  // Lines and areas written as distances from point to point, which are half as long as positions. Each is the difference
  // of two rounded positions, so rounding errors do not accumulate. An area has one loop; its inside is filled, whatever
  // its direction.
  void begin_line() {
    begin("    <path d=\"");
    begin_distances();
  }
  // Starts another line in the same path.
  void begin_distances() {
    distances_ = true;
    command_ = 'M';
  }
  void begin_area(Colour colour, bool with_line);
  // The shortest form of an area: positions are integers in the layer's own unit, and a point that equals the previous
  // one is skipped.
  void begin_short_area(Colour colour);
  void whole_point(std::int64_t across, std::int64_t down);
  // Any number of loops, each started by begin_loop and ended by end_loop.
  void begin_path(Colour colour);
  void begin_loop() { command_ = 'M'; }
  void end_loop() { text_ += 'Z'; }
  void point(std::int64_t across, std::int64_t down);
  // A dot is a dash of 0.02 mm, because many programs do not draw a line of length 0.
  void dot(std::int64_t across, std::int64_t down);
  void end_area() { text_ += "z\"/>\n"; }
  void end_shape() { text_ += "\"/>\n"; }

  [[nodiscard]] std::string finish() && {
    text_ += "</svg>\n";
    return std::move(text_);
  }

 private:
  [[nodiscard]] static std::string millimetres(double length);
  void begin(std::string_view element) {
    text_ += element;
    command_ = 0;
    distances_ = false;
  }
  void append(std::int64_t position);
  // Omits the zero before the decimal point; writes a blank first, unless the number has a sign or is the first.
  void append_distance(std::int64_t distance, bool first);

  SvgPositions positions_;
  std::string text_;
  char command_ = 0;  // written before the next point: a path command, or a blank
  bool distances_ = false;
  std::int64_t last_across_ = 0;
  std::int64_t last_down_ = 0;
};

}  // namespace sightline::picture
