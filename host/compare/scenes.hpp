// Compares one view of a scene, drawn by every applicable method, with one reference: Jones's program on its machine,
// its twin, every line algorithm of the registry, and every algorithm of faces by points.
//
// For a scene of cells, the reference of all rows is the oracle's visible real lines of its matter
// (matter_scene.hpp), on the screen of the Type 340. For other scenes it is the visible edges of the oracle of edges.
// Pictures are sets of points of the image: coinciding lines count once, so the visible length is the same for all
// rows of a view.
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
  std::string rounding;           // of the measured picture
  std::optional<bool> identical;  // exact algorithms: whether the picture equals the reference, without rounding
  picture::LineMetrics metrics;
  picture::LineDifference difference;  // stretches of up to a pixel are ignored
  std::optional<core::Duration> emulated{};  // the time of the view on the machine
  std::optional<double> host_seconds{};      // the time on this computer: median of repeated runs; not for a machine's program
  std::vector<registry::AlgorithmCount> counts{};  // how much of the scene was read, and work done
  // For a native method: the number of visible pieces of edges, in the window and beyond; their length in the image
  // (infinite if one is); and the difference, where an exact method is not exact.
  std::optional<std::size_t> pieces{};
  double visible_length = 0;
  std::optional<PieceDifference> piece_difference{};
  // For a machine's program: the points it lit, those that the exact lines light by the rule of its display, and
  // their difference.
  picture::PixelGrid lit{};
  picture::PixelGrid lit_in_truth{};
  std::optional<picture::RasterDifference> raster{};
};

// How the machine's run ended, compared with its twin.
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
  std::vector<ComparedFaces> faces;  // of the algorithms that give the visible face at each point
  std::vector<std::pair<std::string, std::string>> not_applicable;  // name, reason
  std::optional<GuestCheck> guest;                                  // of cell scenes
  std::optional<StripesPen> stripes_pen;  // the same view by the 8080 on a plotter
  std::string stripes_difference;  // how the 8080's stripes differ from their twin's; empty: identical
  std::optional<TurnCheck> turn;  // of polyhedra in parallel projection, along the plane of a turn, that fit into the machine

  // Whether the exact algorithms are exact and the guests equal their twins.
  [[nodiscard]] bool agrees() const;
};

using CompareProgress = std::function<void(std::string_view)>;  // called with the current step

struct CompareOptions {
  std::optional<geometry::Point> eye;  // the scene's default view if not given
  std::int32_t scale = 512;            // S, 64..4096
  bool eae = true;
  std::uint32_t fraction_bits = 3;     // of Jones's program, 0..3
  std::vector<std::string> methods{};  // only these; empty: all
  bool faces = true;                   // faces, too, not only lines
  bool host_times = false;             // measure times on this computer
  double host_seconds = enough_seconds;  // of repeated runs, for each method; 0: one run
  bool truth_by_exact = false;  // the reference of polyhedra is `exact`, because the oracle of edges takes long for large scenes
  bool for_table = false;       // leave out what method_views() does not read: stretches to draw, the rate of wrong points
};

// The valid names in CompareOptions::methods, in the order of rows.
[[nodiscard]] std::vector<std::string> method_names();

// Why a method of method_names() never draws scenes of this kind; empty if it may. Reasons of a single scene or view
// are in not_applicable.
enum class SceneKind { cells, polyhedra, function };
[[nodiscard]] std::optional<std::string> why_not_applicable(std::string_view method, SceneKind kind);

// All methods of a scene. Line methods are prepared once for any number of views. Thread-safe.
class SceneMethods {
 public:
  // The scene is a checked one and outlives this object. Errors: the program cannot be assembled for it; the oracle
  // cannot hold it; a method that applies cannot prepare it.
  [[nodiscard]] static base::Result<SceneMethods> of(const scene::CellScene& scene, const CompareOptions& options);
  [[nodiscard]] static base::Result<SceneMethods> of(const scene::PolyScene& scene, const CompareOptions& options);
  SceneMethods(SceneMethods&&) noexcept;
  SceneMethods& operator=(SceneMethods&&) noexcept;
  ~SceneMethods();

  // The requested methods that apply to no view of the scene: name, reason.
  [[nodiscard]] const std::vector<std::pair<std::string, std::string>>& not_applicable() const;
  // Compares one view. Cameras of a scene of cells look along z, as Jones's program does (precondition). Errors: the
  // program or the algorithms cannot use the eye; the program did not complete a view.
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
// For a checked scene, without Jones's program. Error: the eye is inside a solid or on a face.
[[nodiscard]] base::Result<SceneComparison> compare_poly_scene(
    const scene::PolyScene& scene, const scene::PolyCamera& camera, const CompareOptions& options = {},
    const CompareProgress& progress = [](std::string_view) {});

}  // namespace sightline::compare
