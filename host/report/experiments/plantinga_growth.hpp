// How the events of a turn grow with the scene, and what they take beside the frames of the turn: Plantinga, Seales and Dyer
// (1990) give orders of growth and no numbers.
//
// Families, from about 10 to about 3,000 faces: a torus, of which little is hidden; boxes apart, which hide each other; a cloud of
// triangles, each before and behind many others, up to 1,000 without Context::full; and three fences of bars, one behind the other
// in three directions, up to 96 faces (192 with Context::full), where every three bars meet in the image: the worst case.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"

namespace sightline::report {

struct TurnGrowth {
  std::string family;  // "model": one of Table 1
  std::string scene;
  std::size_t faces = 0;
  std::size_t edges = 0;
  std::size_t groups = 0;   // directions at which something changes
  std::size_t changes = 0;  // the paper's events: changes of edges
  double events_kb = 0;     // of 1024 bytes: the event file, and the structures of the first frame
  double lines = 0;         // mean number of visible lines
  std::optional<double> prepare_s = {};  // on all cores; empty without Context::host_times

  // 360 frames of lines as four 16-bit coordinates.
  [[nodiscard]] double frames_kb() const { return 360 * lines * 8 / 1024; }
  [[nodiscard]] double storage_ratio() const { return frames_kb() / events_kb; }
  // The number of frames that take as many bytes as the events.
  [[nodiscard]] double equal_frames() const { return 360 * events_kb / frames_kb(); }
};

// Growth with the number of faces, by least squares of logarithms over a family without its smallest scene or two.
struct TurnExponents {
  std::string family;
  std::size_t from_faces = 0;
  std::size_t to_faces = 0;
  std::optional<double> changes = {};
  std::optional<double> groups = {};
  std::optional<double> prepare = {};
};

// A model drawn polygon by polygon, the farthest first, in the order of a BSP tree (face_tree.hpp). Means of 360 views of a turn.
struct TreeDrawing {
  std::string model;
  std::size_t faces = 0;
  std::size_t polygons = 0;  // of the tree, by which some faces are cut
  double turned = 0;         // polygons turned to the eye
  double sides = 0;          // sides of these: the lines that are drawn
  double lines = 0;          // visible lines, which are drawn with events

  [[nodiscard]] double ratio() const { return sides / lines; }
};

struct PlantingaGrowth {
  std::vector<TurnGrowth> scenes;
  std::vector<TurnExponents> exponents;  // one per family
  std::vector<TreeDrawing> trees;        // one per model
};

[[nodiscard]] PlantingaGrowth plantinga_growth(const Context& context);

class Page;
void plantinga_growth_chapter(Page& page, const PlantingaGrowth& growth);

}  // namespace sightline::report
