// The comparison that the paper of 1971 asks for: all methods on a variety of objects from a variety of
// viewpoints, and how open a scene of cells may be before its method loses its advantage.
//
// 24 scenes of 100 random views each: the built-in ones, ten buildings of the same rooms with ever more
// doors, and scenes of polyhedra. Every view is drawn by the native methods of lines; fewer by the programs
// on machines and by the methods of faces, which take longer here. The openness of a scene of cells is its
// portals for each wall: for each pair of cells that share a piece of a plane.
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

// Pairs of cells with more than a line in common, a portal between them or not.
[[nodiscard]] std::size_t walls_of(const scene::CellScene& scene);

struct ComparisonScene {
  std::string name;
  std::string kind;  // "built-in", "rooms", "polyhedra"
  std::size_t faces = 0;
  std::optional<std::size_t> portals{};  // these two of scenes of cells
  std::optional<std::size_t> walls{};
  // Medians over views; of methods that apply.
  std::optional<double> visits{};  // native Jones: cells entered in a view, a cell as often as it is entered
  std::optional<double> pairs{};   // Montani and Re: pairs of faces of which one hides the other
  // As AnswerRow has them.
  std::optional<double> exact_s{};
  std::optional<double> jones_s{};
  std::optional<double> montani_re_s{};
  std::optional<double> pdp7_s{};
  std::string not_on_pdp7{};  // of scenes of cells that Jones's program cannot take: why; else empty

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
  std::size_t views = 0;                    // of a scene
  std::size_t views_by_programs = 0;        // of these, by the PDP-7
  std::size_t views_of_faces = 0;           // by methods of faces

  // The rooms, ascending by openness.
  [[nodiscard]] Chosen<ComparisonScene> rooms() const {
    return where(scenes, is(&ComparisonScene::kind, "rooms"));
  }
};

// Of values ascending by `at`, where the first is less than the second as long as it began so: the last such
// place, and the next.
struct Crossing {
  std::optional<double> last;   // nothing: nowhere
  std::optional<double> first;  // nothing: to the end
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
