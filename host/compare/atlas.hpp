// Where in a scene Jones's program on the emulated PDP-7 draws a wrong picture, and why; and how long it
// takes from where.
//
// A view is wrong if a stretch of it is missing, or extra, and farther than one point of the screen from the
// truth (wrong_stretches.hpp); the truth is the oracle's visible lines. The ends of what is drawn are taken
// as the program calculated them, before they are rounded to whole points for the display.
//
// The cause of a wrong view is found by experiment: its twin runs again with one thing changed
// (twin/number.hpp, MixedWords). First it gets all the fraction bits that the program can have; then masks
// that rounding has made hollow are made convex again; then one of its roundings is made finer, then two of
// them. The first change that makes the view right is the cause.
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
// Of about 4,000 eyes in squares, no two of which are at one place.
[[nodiscard]] AtlasLattice usual_lattice(const scene::CellScene& scene);
// The middles of equal rectangles over the plan of the scene, row by row from the least z; those at one place
// once.
[[nodiscard]] std::vector<geometry::Point> lattice_eyes(const scene::CellScene& scene,
                                                        const AtlasLattice& lattice);
// The eyes of sweep_camera's views 0 to count - 1.
[[nodiscard]] std::vector<geometry::Point> random_eyes(const scene::CellScene& scene, std::uint64_t count,
                                                       std::uint64_t seed);

// Why a view is wrong.
struct WrongCause {
  programs::jones::Status status =
      programs::jones::Status::complete;  // of the machine: it stopped before the end
  // The program is assembled with fewer fraction bits than it can have, and is right with all of them.
  bool fraction_bits = false;
  // If not: the view is right if corners at which rounding has made a mask hollow are left out: the line
  // through two corners that lie near each other has another direction then, and cuts off what is far from
  // them.
  bool hollow_mask = false;
  // If not: each makes the view right if these of the program's roundings, by the order of `Rounding`, become
  // 32 times finer or more; all have the same, least number of roundings. Empty: none does.
  std::vector<std::array<bool, programs::jones::roundings>> finer;
  // The view is right with this number of fraction bits and with every greater one up to 8, in words of 36
  // bits.
  std::optional<int> right_from_bits;
  // Of an arithmetic overflow: the shortest word that completes the view.
  std::optional<int> word_bits;

  // "mask corner", "fraction bits", "rounding of a portal", "rounding of a line or of a mask" (either is
  // enough), "display file overflow".
  [[nodiscard]] std::string name() const;
};

struct AtlasView {
  geometry::Point eye{};
  bool free = false;  // the program accepts the eye; if not, nothing below counts
  std::int64_t emulated_ns = 0;
  std::string difference;  // where the guest is not its twin; empty: nowhere
  WrongStretches wrong;
  std::optional<WrongCause> cause;  // of a wrong view

  [[nodiscard]] bool is_wrong() const { return cause.has_value(); }
};

struct AtlasOptions {
  bool eae = true;
  int fraction_bits = programs::jones::machine_fraction_bits;  // 0..3
};

// A checked scene, the program assembled for it, and its truth.
class ErrorAtlas {
 public:
  // Errors: no eye is in free space; the scene does not fit into core, or is too
  // large for the oracle.
  [[nodiscard]] static base::Result<ErrorAtlas> of(const scene::CellScene& scene,
                                                   std::vector<geometry::Point> eyes,
                                                   const AtlasOptions& options);

  [[nodiscard]] const std::vector<geometry::Point>& eyes() const { return eyes_; }
  // Of eyes()[number]; several threads may ask at once.
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

// Wrong views of one cause that are connected by lines of the scene of which they show a stretch wrongly;
// those that the machine did not complete are connected by their status.
struct AtlasCluster {
  std::string cause;
  std::optional<AxisLine> line;        // the one that is wrong in most of the views
  std::vector<std::size_t> views;      // numbers, ascending
  std::size_t worst = 0;               // of the greatest wrong length
  double most_wrong = 0;               // points
  std::optional<int> right_from_bits;  // of all its views; none if one of them never is
};

// 0.5 is the median: the least value that this share of the values does not exceed.
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
  std::size_t worst = 0;        // number of the view of the greatest wrong length; the slowest of equal ones
  std::size_t slowest = 0;
  std::vector<AtlasCluster> clusters;       // the most wrong first
  std::optional<std::size_t> not_its_twin;  // a view where the guest is not its twin
};
// At least one view is free.
[[nodiscard]] AtlasSummary summary_of(const std::vector<AtlasView>& views);

}  // namespace sightline::compare
