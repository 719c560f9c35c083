// All algorithms compared with each other on the common scenes: one cell for each pair and scene.
//
// Every algorithm of the registries takes part. Exceptions are listed here, with their reasons. Everything
// else is run, and a cell that is not listed but cannot be run is a failure: an algorithm that begins to refuse
// scenes does not go unnoticed. The exact edges and the oracle take part like the algorithms they are to check.
//
// Source: the suite's cross-check of algorithms, sections 2 to 4.
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
  bool screen = false;  // lines as a machine's display shows them, to its points
  bool jones = false;   // builds of Jones's program
  bool ink = false;     // pictures of Skala's program on its devices
};
// In the order of the registries: lines, faces, heights; then the 8080's stripes (stripes.hpp). The oracle has faces, too: nearest_faces().
// Then Willis's priorities from an 8080 (willis_8080.hpp), the solid turning on the PDP-7 (turning.hpp), and Jones's and Skala's programs
// (cross_check_machines.hpp).
[[nodiscard]] std::span<const Participant> participants();

struct NotApplicable {
  enum class Views { all, perspective };

  std::string_view who;
  std::string_view scenes;  // every one whose name begins so
  Views views = Views::all;
  std::string_view reason;
};
[[nodiscard]] std::span<const NotApplicable> not_applicable();
// Why a participant has no picture of a view, as listed.
[[nodiscard]] std::optional<std::string_view> listed_reason(std::string_view who, std::string_view scene,
                                                            bool perspective);

// Why two participants that both have pictures of a scene have nothing in common that can be compared.
[[nodiscard]] std::optional<std::string_view> nothing_in_common(std::string_view a, std::string_view b);

// Where the algorithms are looked for.
struct CrossCheckTables {
  std::span<const registry::LineAlgorithm> lines = registry::line_algorithms();
  std::span<const registry::FaceAlgorithm> faces = registry::face_algorithms();
};

// What one participant made of one view.
struct CrossCheckPicture {
  std::optional<picture::LinePicture> lines;
  bool same_by_image = false;
  std::optional<picture::PixelGrid> faces;  // number + 1, 0 for none
  std::optional<ScreenPicture> screen;
  // Lines again, for the participant with a screen, at the angle of its machine: the picture, and in points of the display.
  std::optional<picture::LinePicture> lines_at_angle;
  std::vector<picture::PixelSegment> lines_on_screen;
  std::optional<std::vector<JonesPicture>> builds;
  std::optional<std::vector<SkalaInk>> ink;
  std::string_view not_applicable;          // the listed reason
  std::string problem;                      // why something listed is not there
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
  std::string how;        // as ViewVerdict has it, each once; no "pieces" where it took "image"
  std::string text;       // what was found; of a failure the view and the first difference
  std::vector<CheckedDistance> distances = {};  // of Jones's and Skala's programs
};

struct SceneCrossCheck {
  std::vector<CrossCheckCell> cells;  // by participants, all pairs
  // By participant, then view.
  std::vector<std::vector<CrossCheckPicture>> pictures;

  // Nothing differs and nothing listed is missing.
  [[nodiscard]] bool agrees() const;
};

[[nodiscard]] SceneCrossCheck cross_check(
    const CommonScene& scene, const CrossCheckTables& tables = {},
    const std::function<void(std::string_view)>& progress = [](std::string_view) {});

// How many cells are listed to run on a scene.
[[nodiscard]] std::size_t listed_cells(const CommonScene& scene);

}  // namespace sightline::compare
