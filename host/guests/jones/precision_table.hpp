// What arithmetic costs Jones's program in truth: the error of every scene's six views (views.hpp)
// against exact visibility, for the builds of the program on the emulated PDP-7 and for arithmetic of any
// other kind.
//
// Two measures of one run: its pieces as they left the clip, with their fraction of a point, which is what
// fraction bits buy; and the same pieces between the whole points of the display, which is what one saw.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/base/result.hpp"
#include "host/guests/jones/line_error.hpp"
#include "host/guests/jones/precision.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::guests::jones {

inline constexpr double named_from_points = 20;  // a wrong piece longer than this is named

struct NamedStretch {
  std::size_t view = 0;  // number of the eye
  WrongStretch stretch;
};

// Sums over the views of one scene.
struct ArithmeticError {
  double visible = 0;  // true visible length, points
  double missing = 0;
  double extra = 0;
  double longest = 0;               // wrong stretch
  std::vector<NamedStretch> named;  // wrong by more than named_from_points
  std::vector<Status> statuses;     // by view
  [[nodiscard]] bool complete() const;
  [[nodiscard]] double share() const { return visible > 0 ? (missing + extra) / visible : 0; }
};

struct Measured {
  Precision precision;
  ArithmeticError clipped;
  std::optional<ArithmeticError> displayed;  // of the program on the machine
  // Sums over the views; without those of a run on the machine, which are in GuestView.
  std::uint64_t muldivs = 0;
  std::uint64_t products = 0;
  double largest_coordinate = 0;  // magnitude, points, before clipping
};

// One scene seen from some places; the exact visibility is worked out once.
class PrecisionStudy {
 public:
  // Error: an eye at which the program cannot stand; or the scene is beyond the limits of the oracle.
  [[nodiscard]] static base::Result<PrecisionStudy> of(const scene::CellScene& scene,
                                                       std::span<const geometry::Point> eyes);

  // precision: possible(). Every view that ends with a status counts with what it drew until then.
  [[nodiscard]] Measured measure(const Precision& precision) const;
  // The program itself, assembled with these fraction bits (0..3), on a PDP-7 with the EAE or without. Error:
  // the program and the scene do not fit into core.
  [[nodiscard]] base::Result<Measured> measure_on_machine(int fraction_bits, bool truncate,
                                                          bool eae = true) const;
  // The first length of a word, 12..36, with which every view is complete; nothing if there is none.
  [[nodiscard]] std::optional<int> shortest_complete_word(int fraction_bits, bool truncate) const;

 private:
  struct View {
    geometry::Point eye{};
    SceneInCore in_core;
    std::vector<algorithms::oracle::VisibleLine> truth;
  };
  [[nodiscard]] PreciseView run(const View& view, const Precision& precision) const;
  void add(ArithmeticError& sum, std::size_t view, Status status, const std::vector<DrawnLine>& drawn) const;

  scene::CellScene scene_;
  std::vector<View> views_;
};

// The table of jones.md section 5, anew.
struct ErrorTableRow {
  std::string scene;
  std::vector<geometry::Point> eyes;
  std::vector<Measured> cells;  // by column
};
struct ErrorTable {
  std::vector<Precision> columns;  // round f = 0..3, cut off f = 0, 2
  std::vector<ErrorTableRow> rows;
};
// Of the four scenes of views.hpp, on the emulated machine.
[[nodiscard]] ErrorTable measure_error_table(bool eae = true);

}  // namespace sightline::guests::jones
