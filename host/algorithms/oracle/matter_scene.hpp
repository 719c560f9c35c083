// A scene of cells in the form that all line-drawing methods receive, so that they draw the same lines: its matter as
// bodies, which hide, and the real lines of that matter (host/algorithms/oracle/matter.hpp) as wires, which hide nothing.
// The outer box has real lines, too. The scene's cells, openings and cell lines are not read.
//
// The outer box is not a body, because an eye inside it sees nothing beyond it. For methods that draw only edges of
// faces, with_box() contains it as a sheet, and on_lines() converts their pieces to pieces of the real lines.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/base/result.hpp"
#include "host/picture/edge_choice.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::algorithms::oracle {

// A line of space parallel to an axis.
struct AxisLine {
  std::size_t axis = 0;
  std::array<std::int32_t, 2> cross{};  // on other_axes(axis)

  friend bool operator==(const AxisLine&, const AxisLine&) = default;
  // Not <=>, which arrays in libc++ 14 do not support.
  friend bool operator<(const AxisLine& a, const AxisLine& b) { return a.axis != b.axis ? a.axis < b.axis : a.cross < b.cross; }
};

class MatterScene {
 public:
  // Precondition: the scene is checked. Error: the scene has too many distinct coordinates for the oracle.
  [[nodiscard]] static base::Result<MatterScene> of(const scene::CellScene& cells);

  // Solids, walls, and all real lines as wires; the camera is the scene's default view.
  [[nodiscard]] const scene::PolyScene& scene() const { return scene_; }
  // The same solids and walls, and the outer box as a sheet of six faces; no wires.
  [[nodiscard]] const scene::PolyScene& with_box() const { return with_box_; }

  // The wires that are lines for this eye (oracle::is_line_for).
  [[nodiscard]] picture::ChosenEdges lines_at(const geometry::Point& eye) const;
  // The visible parts of the wires in a window, from the oracle of cells. Precondition: the eye is inside the outer box
  // and in no solid.
  [[nodiscard]] picture::LinePicture visible(const geometry::Point& eye, const Window& window) const;
  // Converts pieces of edges of with_box() to pieces of the wires that are lines for this eye. Parts on no such wire,
  // such as the joint of two solids, are left out.
  [[nodiscard]] picture::LinePicture on_lines(const picture::LinePicture& drawn, const geometry::Point& eye) const;
  // A wire on a line of space; nullopt if no real line lies on it.
  [[nodiscard]] std::optional<picture::LineEdge> wire_on(const AxisLine& line) const;

 private:
  MatterScene(Matter matter) : matter_(std::move(matter)), lines_(matter_.real_lines()) {}
  [[nodiscard]] picture::LineEdge wire(std::size_t line) const;
  // Collects parts of wires, by line number, into a picture.
  class Parts;

  Matter matter_;
  std::vector<RealLine> lines_;  // in the order of the wires
  std::map<AxisLine, std::vector<std::size_t>> on_;  // numbers of real lines, ascending along the axis
  scene::PolyScene scene_;
  scene::PolyScene with_box_;
};

}  // namespace sightline::algorithms::oracle
