// One view of a scene, drawn by every applicable method and compared with one truth: Jones's program on its machine, its native twin,
// every line algorithm of the table, and every algorithm of faces by points.
//
// Of a scene of cells the truth is the oracle's visible real lines of its matter (matter_scene.hpp), for all rows, on the screen of the
// Type 340. Of other scenes it is the visible edges of the oracle of edges. Pictures are sets of points of the image: what lies on
// each other there counts once, so the true length is the same for all rows of a view.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/core/stroke.hpp"
#include "emulators/core/time.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/base/result.hpp"
#include "host/compare/faces.hpp"
#include "host/compare/host_time.hpp"
#include "host/compare/lines.hpp"
#include "host/compare/piece_difference.hpp"
#include "host/compare/stripes.hpp"
#include "host/compare/turning.hpp"
#include "host/programs/jones/specification.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/picture/raster_difference.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

// Names of methods: Jones's program on the PDP-7, and its twin.
inline constexpr std::string_view jones_pdp7_name = "jones-pdp7";
inline constexpr std::string_view jones_twin_name = "jones-twin";

// How the coordinates of a row's picture are rounded, in words for a reader.
inline constexpr std::string_view not_rounded = "none";

struct ComparedPicture {
  std::string name;               // "jones-pdp7", "jones-twin", or the algorithm's
  std::string rounding;           // of what was measured
  std::optional<bool> identical;  // exact algorithms: exactly what the truth has, without rounding
  picture::LineMetrics metrics;
  picture::LineDifference difference;  // without stretches of up to a pixel
  std::optional<core::Duration> emulated{};  // what the view took on the machine
  std::optional<double> host_seconds{};      // what it took here: median of repeated views; not of a machine's program
  std::vector<registry::AlgorithmCount> counts{};  // what was read of the scene, and done
  // Of a native method: the pieces of edges that it sees, in the window and beyond, their length in the image (infinite if one is),
  // and, where an exact method is not exact, what differs.
  std::optional<std::size_t> pieces{};
  double visible_length = 0;
  std::optional<PieceDifference> piece_difference{};
  // Of a machine's program: the points it lit, and those that the exact lines light by the rule of its display, and their difference.
  picture::PixelGrid lit{};
  picture::PixelGrid lit_in_truth{};
  std::optional<picture::RasterDifference> raster{};
};

// How the machine's run ended, beside its twin's.
struct GuestCheck {
  programs::jones::Status status = programs::jones::Status::complete;
  core::Duration time{};
  std::size_t words = 0;   // of the display file
  std::string difference;  // the first word that differs, or the status; empty: identical
};

struct SceneComparison {
  std::string scene;
  scene::PolyCamera camera;
  std::array<double, 3> eye{};  // the camera's, in the unit of the scene's file
  ScreenFrame frame;
  std::vector<ComparedPicture> pictures;
  std::vector<ComparedFaces> faces;  // of the algorithms that say which face is seen at each point
  std::vector<std::pair<std::string, std::string>> not_applicable;  // name, reason
  std::optional<GuestCheck> guest;                                  // of cell scenes
  std::optional<StripesPen> stripes_pen;  // the same view by the 8080 on a plotter
  std::string stripes_difference;  // where the 8080's stripes are not their twin's; empty: nowhere
  std::optional<TurnCheck> turn;  // of polyhedra in parallel projection, along the plane of a turn, that the machine can hold

  // The exact algorithms are exact, and the guests are their twins.
  [[nodiscard]] bool agrees() const;
};

using CompareProgress = std::function<void(std::string_view)>;  // is told what is being done

struct CompareOptions {
  std::optional<geometry::Point> eye;  // the scene's default view if not given
  std::int32_t scale = 512;            // S, 64..4096
  bool eae = true;
  std::uint32_t fraction_bits = 3;     // of Jones's program, 0..3
  std::vector<std::string> methods{};  // of these names alone; empty: all
  bool faces = true;                   // and not lines alone
  bool host_times = false;             // measure them
  double host_seconds = enough_seconds;  // of repeated runs, for each of them; 0: of one run
  bool truth_by_exact = false;  // of polyhedra `exact` is the truth, because the oracle of edges takes long for large scenes
  bool for_table = false;       // leave out what method_views() does not read: stretches to draw, the rate of wrong points
};

// The names that CompareOptions::methods may have, in the order of rows.
[[nodiscard]] std::vector<std::string> method_names();

// Why a method of method_names() draws nothing of that kind; empty if it may. What depends on the scene or the view is in not_applicable.
enum class SceneKind { cells, polyhedra, function };
[[nodiscard]] std::optional<std::string> why_never(std::string_view method, SceneKind kind);

// All methods of a scene; those of lines are prepared once for any number of views. Several threads may ask at once.
class SceneMethods {
 public:
  // Of a checked scene, which outlives this. Errors: the program cannot be assembled for it; the oracle cannot hold it; a method that
  // applies cannot prepare it.
  [[nodiscard]] static base::Result<SceneMethods> of(const scene::CellScene& scene, const CompareOptions& options);
  [[nodiscard]] static base::Result<SceneMethods> of(const scene::PolyScene& scene, const CompareOptions& options);
  SceneMethods(SceneMethods&&) noexcept;
  SceneMethods& operator=(SceneMethods&&) noexcept;
  ~SceneMethods();

  // Of all methods asked for, those that apply to no view of the scene: name, reason.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& not_applicable() const;
  // One view. Cameras of a scene of cells look along z, as Jones's program does (precondition). Errors: the eye is where the program or
  // the algorithms cannot have it; the program did not complete a view.
  [[nodiscard]] base::Result<SceneComparison> view(
      const scene::PolyCamera& camera, const CompareProgress& progress = [](std::string_view) {}) const;

 private:
  class Parts;
  explicit SceneMethods(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

// The view of the options, or the scene's default view.
[[nodiscard]] base::Result<SceneComparison> compare_cell_scene(
    const scene::CellScene& scene, const CompareOptions& options,
    const CompareProgress& progress = [](std::string_view) {});
// Of a checked scene, without Jones's program. Error: the eye is inside a solid or on a face.
[[nodiscard]] base::Result<SceneComparison> compare_poly_scene(
    const scene::PolyScene& scene, const scene::PolyCamera& camera, const CompareOptions& options = {},
    const CompareProgress& progress = [](std::string_view) {});

}  // namespace sightline::compare
