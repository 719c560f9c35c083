// One view of a scene, drawn by every applicable method and compared with the oracle: Jones's program on its
// machine, its native twin, every line algorithm of the table, and every algorithm of faces by points.
//
// Guest and twin draw the lines of a cell scene (the outer box's too) on the screen of the Type 340; their
// truth is the cell oracle's. Exact algorithms draw edges of polyhedra; theirs is the edge oracle's. Both
// truths are cut to the same screen.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/core/time.hpp"
#include "host/base/result.hpp"
#include "host/compare/faces.hpp"
#include "host/compare/lines.hpp"
#include "host/compare/turning.hpp"
#include "host/guests/jones/twin/twin.hpp"
#include "host/picture/line_metrics.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

struct ComparedPicture {
  std::string name;               // "guest", "twin", or the algorithm's
  std::string what;               // what was measured
  std::optional<bool> identical;  // exact algorithms: the oracle's picture, piece for piece
  picture::LineMetrics metrics;
  picture::LineDifference difference;  // without stretches of up to a pixel
};

// How the machine's run ended, beside its twin's.
struct GuestCheck {
  guests::jones::Status status = guests::jones::Status::complete;
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
};

// Of a checked scene. Errors: the eye is where the program or the algorithms cannot have it; the scene does
// not fit into core; the oracle cannot hold it; the guest did not complete a view.
[[nodiscard]] base::Result<SceneComparison> compare_cell_scene(
    const scene::CellScene& scene, const CompareOptions& options,
    const CompareProgress& progress = [](std::string_view) {});
// Of a checked scene, without Jones's program. Error: the eye is inside a solid or on a face.
[[nodiscard]] base::Result<SceneComparison> compare_poly_scene(
    const scene::PolyScene& scene, const scene::PolyCamera& camera,
    const CompareProgress& progress = [](std::string_view) {});

}  // namespace sightline::compare
