// Measures the errors that arithmetic causes in Jones's program: the error of every scene's six views, compared with
// exact visibility, for the builds of the program on the emulated PDP-7 and for any other arithmetic.
//
// Each run has two measures: its pieces after clipping, with the fraction of a point that fraction bits improve; and
// the same pieces between the points of the display, as a user saw them.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/base/result.hpp"
#include "host/geometry/box.hpp"
#include "host/compare/jones_precision/precision.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::compare::jones_precision {

// The length of a scene's lines that a drawing shows wrongly, line by line: the symmetric difference of drawn and
// visible length. Unlike an error of point sets (oracle/drawn_error.hpp), it counts a piece of a hidden line as wrong
// even where it coincides with another, visible line.
//
// All pieces on one straight line of space are combined, so that pieces drawn twice and pieces that continue each
// other count once. A piece is measured along the exact image of its line, its ends projected on it at right angles.
// Lengths are points of the screen.

// A line of the scene as drawn.
struct DrawnLine {
  SceneLine line;
  algorithms::oracle::ScreenSegment piece;  // points of the screen
};

// A stretch that is drawn and not visible (extra), or visible and not drawn.
struct WrongStretch {
  SceneLine line;  // the straight line, from end to end of all that was drawn or visible on it
  bool extra = false;
  double length = 0;
  algorithms::oracle::ScreenSegment where;  // on the exact image of the line
};

struct LineError {
  double visible = 0;  // exact visible length
  double missing = 0;
  double extra = 0;
  double longest = 0;               // wrong stretch
  std::vector<WrongStretch> wrong;  // stretches longer than named_from, by line
  [[nodiscard]] double share() const { return visible > 0 ? (missing + extra) / visible : 0; }
};

// truth: the exact visible lines from the eye in this window (mono, centre of the window as in `window`). named_from:
// wrong stretches longer than this are listed.
[[nodiscard]] LineError line_error(const std::vector<algorithms::oracle::VisibleLine>& truth,
                                   const std::vector<DrawnLine>& drawn, const geometry::Point& eye,
                                   const algorithms::oracle::Window& window, double named_from);

// The six views per scene with which Jones's program is measured: the scene's own view, and five near it.
//
// The five were chosen once at random for the first measurements of 18-bit arithmetic: x and y up to 30 units from
// the scene's own eye, z unchanged. The scale is 512.

struct SixViews {
  std::string_view scene;  // a built-in scene
  std::array<geometry::Point, 6> eyes;
};

inline constexpr std::array<SixViews, 4> six_views{{
    {"house",
     {{{480, 160, 20}, {470, 190, 20}, {475, 171, 20}, {454, 182, 20}, {456, 153, 20}, {453, 188, 20}}}},
    {"roberts", {{{30, 150, 40}, {13, 122, 40}, {27, 146, 40}, {15, 125, 40}, {27, 123, 40}, {36, 127, 40}}}},
    {"street4", {{{37, 160, 20}, {21, 170, 20}, {44, 190, 20}, {43, 167, 20}, {10, 144, 20}, {42, 184, 20}}}},
    {"corridor8",
     {{{140, 150, 30}, {128, 146, 30}, {144, 127, 30}, {129, 155, 30}, {153, 131, 30}, {147, 156, 30}}}},
}};

inline constexpr double named_from_points = 20;  // longer wrong pieces are named

struct NamedStretch {
  std::size_t view = 0;  // number of the eye
  WrongStretch stretch;
};

// Sums over the views of one scene.
struct ArithmeticError {
  double visible = 0;  // exact visible length, points
  double missing = 0;
  double extra = 0;
  double longest = 0;               // wrong stretch
  std::vector<NamedStretch> named;  // wrong for more than named_from_points
  std::vector<programs::jones::Status> statuses;     // by view
  [[nodiscard]] bool complete() const;
  [[nodiscard]] double share() const { return visible > 0 ? (missing + extra) / visible : 0; }
};

struct Measured {
  Precision precision;
  ArithmeticError clipped;
  std::optional<ArithmeticError> displayed;  // of the program on the machine
  // Sums over the views; zero for a run on the machine, whose counts are in GuestView.
  std::uint64_t muldivs = 0;
  std::uint64_t products = 0;
  double largest_coordinate = 0;  // magnitude, points, before clipping
};

// One scene seen from several positions; the exact visibility is computed once.
class PrecisionStudy {
 public:
  // Errors: the program does not accept an eye; the scene is beyond the limits of the oracle.
  [[nodiscard]] static base::Result<PrecisionStudy> of(const scene::CellScene& scene,
                                                       std::span<const geometry::Point> eyes);

  // precision: is_possible(). A view that ends with another status counts with the lines drawn until then.
  [[nodiscard]] Measured measure(const Precision& precision) const;
  // The program itself, assembled with these fraction bits (0..3), on a PDP-7 with or without the EAE. Error: the
  // program and the scene do not fit into core.
  [[nodiscard]] base::Result<Measured> measure_on_machine(int fraction_bits, bool truncate,
                                                          bool eae = true) const;
  // The shortest word, 12..36 bits, with which every view is complete; empty if there is none.
  [[nodiscard]] std::optional<int> shortest_complete_word(int fraction_bits, bool truncate) const;

 private:
  struct View {
    geometry::Point eye{};
    SceneInCore in_core;
    std::vector<algorithms::oracle::VisibleLine> truth;
  };
  [[nodiscard]] PreciseView run(const View& view, const Precision& precision) const;
  void add(ArithmeticError& sum, std::size_t view, programs::jones::Status status, const std::vector<DrawnLine>& drawn) const;

  scene::CellScene scene_;
  std::vector<View> views_;
};

// The table of errors by arithmetic.
struct ErrorTableRow {
  std::string scene;
  std::vector<geometry::Point> eyes;
  std::vector<Measured> cells;  // by column
};
struct ErrorTable {
  std::vector<Precision> columns;  // rounded, f = 0..3; truncated, f = 0, 2
  std::vector<ErrorTableRow> rows;
};
// For the four scenes of six_views, on the emulated machine.
[[nodiscard]] ErrorTable measure_error_table(bool eae = true);

}  // namespace sightline::compare::jones_precision
