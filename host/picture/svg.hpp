// SVG as drawing programs and plotter programs take it: in millimetres, one user unit each, y downwards,
// every group an Inkscape layer. Plotter programs pick layers by the number that their labels begin with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "host/picture/image.hpp"

namespace sightline::picture {

// For text and for values in double quotes. What XML does not allow at all, or is not ASCII, becomes '?'.
[[nodiscard]] std::string xml_text(std::string_view text);

// Positions are whole numbers of 10^-decimals mm from the top left corner.
struct SvgPositions {
  int decimals = 3;
  bool needless_zeros = true;  // 1.500 rather than 1.5
};

class SvgWriter {
 public:
  // Width and height in millimetres; the title is escaped here.
  SvgWriter(double width, double height, std::string_view title, SvgPositions positions = {})
      : SvgWriter(millimetres(width), millimetres(height), title, positions) {}
  SvgWriter(const std::string& width, const std::string& height, std::string_view title,
            SvgPositions positions);

  void reserve(std::size_t bytes) { text_.reserve(bytes); }
  // What is drawn in layers opened with `clip` ends at this rectangle.
  void clip_rectangle(std::string_view id, double x, double y, double width, double height);

  // A layer of lines: not filled, with round ends and corners. The label is escaped here.
  void open_lines(std::string_view id, std::string_view label, Colour colour,
                  std::string_view pen_millimetres);
  // A layer of areas. Each has a line of its own colour around it, or the paper would shine through where two
  // meet; `style` is SVG's attributes, with the width of that line.
  void open_areas(std::string_view id, std::string_view label, std::string_view style);
  void close_layer() { text_ += "  </g>\n"; }

  void begin_polyline() { begin("    <polyline points=\""); }
  // Lines and areas from point to point, in distances: half as long as positions. Each is the difference of two rounded positions, so
  // that roundings do not add up. An area of one loop; what lies within it counts, whichever way it runs around.
  void begin_line() {
    begin("    <path d=\"");
    begin_distances();
  }
  // Another line in the same path.
  void begin_distances() {
    distances_ = true;
    command_ = 'M';
  }
  void begin_area(Colour colour, bool with_line);
  // The shortest that an area can be: positions are whole numbers of the layer's own unit, and one that does not move is left out.
  void begin_short_area(Colour colour);
  void whole_point(std::int64_t across, std::int64_t down);
  // Any number of loops, each begun by begin_loop and ended by end_loop.
  void begin_path(Colour colour);
  void begin_loop() { command_ = 'M'; }
  void end_loop() { text_ += 'Z'; }
  void point(std::int64_t across, std::int64_t down);
  // A dot as a dash of 0.02 mm: many programs do not draw a line of no length.
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
  // Without the zero before its point; a blank before it unless it has a sign or is the first.
  void append_distance(std::int64_t distance, bool first);

  SvgPositions positions_;
  std::string text_;
  char command_ = 0;  // before the next point: of a path, or a blank
  bool distances_ = false;
  std::int64_t last_across_ = 0;
  std::int64_t last_down_ = 0;
};

}  // namespace sightline::picture
