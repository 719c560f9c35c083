// The comparison that the paper of 1971 asks for: all methods on a variety of objects from a variety of viewpoints,
// and the openness at which the method for scenes of cells loses its advantage.
//
// 24 scenes of 100 random views each: the built-in ones, ten buildings with the same rooms and an increasing number
// of doors, and scenes of polyhedra. The native line methods draw every view. The programs on machines and the face
// methods, which take longer here, draw fewer. The openness of a scene of cells is its number of portals per wall; a
// wall is a pair of cells that share a piece of a plane.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/compare/answer.hpp"
#include "host/report/experiment.hpp"
#include "host/report/page.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::report {

// The number of pairs of cells that share more than a line, with or without a portal between them.
[[nodiscard]] std::size_t walls_of(const scene::CellScene& scene);

struct ComparisonScene {
  std::string name;
  std::string kind;  // "built-in", "rooms", "polyhedra"
  std::size_t faces = 0;
  std::optional<std::size_t> portals{};  // this and walls: of scenes of cells
  std::optional<std::size_t> walls{};
  // Medians over views, for methods that apply.
  std::optional<double> visits{};  // native Jones: cells entered in a view, counting repetitions
  std::optional<double> pairs{};   // Montani and Re: pairs of faces where one hides the other
  // As in AnswerRow.
  std::optional<double> exact_s{};
  std::optional<double> jones_s{};
  std::optional<double> montani_re_s{};
  std::optional<double> pdp7_s{};
  std::string not_on_pdp7{};  // for a scene of cells that Jones's program cannot take: the reason; else empty

  [[nodiscard]] std::optional<double> openness() const {
    return portals && walls && *walls > 0
               ? std::optional(static_cast<double>(*portals) / static_cast<double>(*walls))
               : std::nullopt;
  }
};

struct Comparison {
  std::vector<ComparisonScene> scenes;
  std::vector<compare::AnswerRow> rows;     // by scene and method
  std::vector<compare::AnswerRow> methods;  // each over all scenes
  std::size_t views = 0;                    // per scene
  std::size_t views_by_programs = 0;        // drawn by the PDP-7
  std::size_t views_of_faces = 0;           // drawn by face methods

  // The buildings of rooms, ascending by openness.
  [[nodiscard]] Chosen<ComparisonScene> rooms() const {
    return where(scenes, equals(&ComparisonScene::kind, "rooms"));
  }
};

// For values ascending by `at`: how long `one` stays less than `other`, if it begins so: the last such place, and the
// next.
struct Crossing {
  std::optional<double> last;   // empty: nowhere
  std::optional<double> first;  // empty: it stays less to the end
};
struct Pair {
  double at = 0;
  double one = 0;
  double other = 0;
};
[[nodiscard]] Crossing crossing_of(const std::vector<Pair>& pairs);

[[nodiscard]] Comparison compare_all(const Context& context);

void comparison_chapter(Page& page, const Comparison& comparison);

}  // namespace sightline::report
