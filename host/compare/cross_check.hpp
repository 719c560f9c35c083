// Cross-check: compares all algorithms with each other on the common scenes; one cell for each pair and scene.
//
// Every algorithm of the registries takes part. The exceptions are listed here, with their reasons. A pair that is
// not listed but cannot be run is a failure, so an algorithm that begins to reject scenes is noticed. The exact edges
// and the oracle take part like the algorithms that they check.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/registry/faces.hpp"
#include "host/algorithms/registry/lines.hpp"
#include "host/compare/cross_check_compare.hpp"
#include "host/compare/cross_check_machines.hpp"
#include "host/compare/cross_check_scenes.hpp"
#include "host/picture/line_picture.hpp"
#include "host/picture/pixel_metrics.hpp"

namespace sightline::compare {

struct Participant {
  std::string_view name;  // of the algorithm in the registries
  bool lines = false;
  bool faces = false;
  bool screen = false;  // lines on a machine's display, in its points
  bool jones = false;   // several builds of Jones's program
  bool ink = false;     // pictures of Skala's program on its devices
};
// In the order of the registries: lines, faces, heights. Then the 8080's stripes (stripes.hpp), Willis's priorities
// from an 8080 (willis_8080.hpp), the solid turning on the PDP-7 (turning.hpp), and Jones's and Skala's programs
// (cross_check_machines.hpp). The oracle has faces, too: nearest_faces().
[[nodiscard]] std::span<const Participant> participants();

struct NotApplicable {
  enum class Views { all, perspective };

  std::string_view who;
  std::string_view scenes;  // all scenes whose names begin with this
  Views views = Views::all;
  std::string_view reason;
};
[[nodiscard]] std::span<const NotApplicable> not_applicable();
// The listed reason why a participant has no picture of a view.
[[nodiscard]] std::optional<std::string_view> listed_reason(std::string_view who, std::string_view scene,
                                                            bool perspective);

// Why the pictures of two participants cannot be compared, although both draw the scene.
[[nodiscard]] std::optional<std::string_view> why_incomparable(std::string_view a, std::string_view b);

// The registries that are cross-checked.
struct CrossCheckTables {
  std::span<const registry::LineAlgorithm> lines = registry::line_algorithms();
  std::span<const registry::FaceAlgorithm> faces = registry::face_algorithms();
};

// The picture that one participant made of one view.
struct CrossCheckPicture {
  std::optional<picture::LinePicture> lines;
  bool same_by_image = false;
  std::optional<picture::PixelGrid> faces;  // face number + 1, 0 for none
  std::optional<ScreenPicture> screen;
  // For the participant with a screen: the lines at the angle of its machine, as a picture and in points of the
  // display.
  std::optional<picture::LinePicture> lines_at_angle;
  std::vector<picture::PixelSegment> lines_on_screen;
  std::optional<std::vector<JonesPicture>> builds;
  std::optional<std::vector<SkalaInk>> ink;
  std::string_view not_applicable;          // the listed reason
  std::string problem;                      // why a listed picture is missing
};

// A distance that was compared with its bound.
struct CheckedDistance : MachineDistance {
  std::size_t view = 0;
};

enum class CrossCheckState { agrees, differs, not_run, not_applicable };

struct CrossCheckCell {
  std::string_view first;
  std::string_view second;
  CrossCheckState state = CrossCheckState::not_applicable;
  std::size_t views = 0;  // compared
  std::string how;        // each ViewVerdict::how once; no "pieces" where "image" was used
  std::string text;       // the result; of a failure, the view and the first difference
  std::vector<CheckedDistance> distances = {};  // for Jones's and Skala's programs
};

struct SceneCrossCheck {
  std::vector<CrossCheckCell> cells;  // of all pairs, in the order of participants
  // By participant, then view.
  std::vector<std::vector<CrossCheckPicture>> pictures;

  // Whether nothing differs and nothing listed is missing.
  [[nodiscard]] bool agrees() const;
};

[[nodiscard]] SceneCrossCheck cross_check(
    const CommonScene& scene, const CrossCheckTables& tables = {},
    const std::function<void(std::string_view)>& progress = [](std::string_view) {});

// The number of cells that are listed to run on a scene.
[[nodiscard]] std::size_t listed_cells(const CommonScene& scene);

}  // namespace sightline::compare
