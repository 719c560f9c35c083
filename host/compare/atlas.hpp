// Maps where in a scene Jones's program on the emulated PDP-7 draws a wrong picture, why, and how long it takes.
//
// A view is wrong if a stretch of it is missing or extra and farther than one point of the screen from the reference
// (wrong_stretches.hpp), the oracle's visible lines. The ends of drawn lines are taken as the program calculated
// them, before it rounds them to points of the display.
//
// The cause of a wrong view is found by experiment: the twin runs again with one thing changed (twin/number.hpp,
// MixedWords). It first gets all fraction bits that the program can have; then masks that rounding made concave are
// made convex again; then one of its roundings is made finer, then two. The first change that makes the view right is
// the cause.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/algorithms/oracle/matter.hpp"
#include "host/base/result.hpp"
#include "host/compare/lines.hpp"
#include "host/compare/wrong_stretches.hpp"
#include "host/programs/jones/jones.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::compare {

struct AtlasLattice {
  int columns = 0;  // along x
  int rows = 0;     // along z
  std::int32_t height = 0;
};
inline constexpr int most_lattice_steps = 1000;
// About 4,000 eyes in squares, no two of them equal.
[[nodiscard]] AtlasLattice default_lattice(const scene::CellScene& scene);
// The centres of equal rectangles over the plan of the scene, row by row from the least z, without repetition.
[[nodiscard]] std::vector<geometry::Point> lattice_eyes(const scene::CellScene& scene,
                                                        const AtlasLattice& lattice);
// The eyes of sweep_camera's views 0 to count - 1.
[[nodiscard]] std::vector<geometry::Point> random_eyes(const scene::CellScene& scene, std::uint64_t count,
                                                       std::uint64_t seed);

// Why a view is wrong.
struct WrongCause {
  programs::jones::Status status =
      programs::jones::Status::complete;  // of the machine: it stopped before the end
  // The program is assembled with fewer fraction bits than it can have, and the view is right with all of them.
  bool fraction_bits = false;
  // Otherwise: the view is right without the corners at which rounding made a mask concave. The line through two
  // corners that are close together then has another direction and cuts off parts far away from them.
  bool concave_mask = false;
  // Otherwise: each entry makes the view right if these roundings of the program, in the order of `Rounding`, become
  // 32 times finer or more. All entries have the same, least number of roundings. Empty if none helps.
  std::vector<std::array<bool, programs::jones::roundings>> finer;
  // The view is right with this number of fraction bits and every greater one up to 8, in words of 36 bits.
  std::optional<int> right_from_bits;
  // For an arithmetic overflow: the shortest word with which the view is complete.
  std::optional<int> word_bits;

  // "mask corner", "fraction bits", "rounding of a portal", "rounding of a line or of a mask" (either is enough),
  // "display file overflow".
  [[nodiscard]] std::string name() const;
};

struct AtlasView {
  geometry::Point eye{};
  bool free = false;  // the program accepts the eye; if not, the members below are unset
  std::int64_t emulated_ns = 0;
  std::string difference;  // the guest's first difference from its twin; empty if there is none
  WrongStretches wrong;
  std::optional<WrongCause> cause;  // if the view is wrong

  [[nodiscard]] bool is_wrong() const { return cause.has_value(); }
};

struct AtlasOptions {
  bool eae = true;
  int fraction_bits = programs::jones::machine_fraction_bits;  // 0..3
};

// A checked scene, the program assembled for it, and the reference.
class ErrorAtlas {
 public:
  // Errors: no eye is in free space; the scene does not fit into core, or is too large for the oracle.
  [[nodiscard]] static base::Result<ErrorAtlas> of(const scene::CellScene& scene,
                                                   std::vector<geometry::Point> eyes,
                                                   const AtlasOptions& options);

  [[nodiscard]] const std::vector<geometry::Point>& eyes() const { return eyes_; }
  // The view from eyes()[number]. Thread-safe.
  [[nodiscard]] AtlasView view(std::size_t number) const;

 private:
  ErrorAtlas(std::vector<geometry::Point> eyes, const AtlasOptions& options, programs::jones::Prepared program,
             algorithms::oracle::Matter matter);
  [[nodiscard]] WrongCause cause_of(programs::jones::Status status, const std::vector<core::Word18>& core,
                                    const std::vector<ImagePiece>& truth, const geometry::Point& eye) const;

  std::vector<geometry::Point> eyes_;
  AtlasOptions options_;
  programs::jones::Prepared program_;
  std::map<std::uint32_t, AxisLine> lines_of_words_;
  algorithms::oracle::Matter matter_;
  std::vector<algorithms::oracle::RealLine> lines_;
};

// A cluster: wrong views of one cause that are connected because they show a stretch of the same line wrongly. Views
// that the machine did not complete are connected by their status.
struct AtlasCluster {
  std::string cause;
  std::optional<AxisLine> line;        // the line that is wrong in most of the views
  std::vector<std::size_t> views;      // view numbers, ascending
  std::size_t worst = 0;               // the view with the greatest wrong length
  double most_wrong = 0;               // points
  std::optional<int> right_from_bits;  // for all its views; empty if there is none for one of them
};

// A quantile is the least value that this share of the values does not exceed; the median is the one for 0.5.
struct AtlasQuantiles {
  double median = 0;
  double of_90 = 0;
  double of_99 = 0;
  double greatest = 0;
};

struct AtlasSummary {
  std::size_t free = 0;
  std::size_t wrong = 0;
  AtlasQuantiles wrong_length;  // points, over the views in free space
  AtlasQuantiles time;          // emulated seconds
  std::size_t worst = 0;        // view with the greatest wrong length; the slowest of equal ones
  std::size_t slowest = 0;
  std::vector<AtlasCluster> clusters;       // by wrong length, descending
  std::optional<std::size_t> differs_from_twin;  // a view where the guest differs from its twin
};
// At least one view is free (precondition).
[[nodiscard]] AtlasSummary summary_of(const std::vector<AtlasView>& views);

}  // namespace sightline::compare
