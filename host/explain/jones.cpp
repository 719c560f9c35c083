#include "host/explain/jones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/jones/sight_plane.hpp"
#include "host/algorithms/jones/trace.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/explain/cell_shapes.hpp"
#include "host/explain/stage.hpp"
#include "host/scene/cells/decompose.hpp"

namespace sightline::explain {
namespace {

using algorithms::jones::PortalTest;
using Planes = std::vector<std::array<double, 4>>;

constexpr std::size_t plan = 1;
constexpr std::size_t graph = 2;
// In a scene with more cells, the plan numbers only the cells that a caption names.
constexpr std::size_t most_numbered_cells = 40;
// How far from its cell's node an avenue's arrow begins and ends, as a part of the sheet's width.
constexpr double node_radius = 0.022;
// A caption names at most this many of the portals that face away.
constexpr std::size_t most_named_portals = 8;

// "Portal 3", "Portals 3 and 5", "Portals 3, 5 and 7".
std::string portal_names(const std::vector<std::uint32_t>& portals) {
  const std::size_t named = std::min(portals.size(), most_named_portals);
  std::string text = portals.size() == 1 ? "Portal " : "Portals ";
  for (std::size_t i = 0; i < named; ++i)
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 == portals.size() ? " and " : ", ", portals[i]);
  if (named < portals.size()) text += fmt::format(" and {} more", portals.size() - named);
  return text;
}

// Whether the opening joins a cell and the outside, not two cells.
bool leads_outside(const scene::ComplexOpening& opening) {
  return opening.cells[0] == scene::outside || opening.cells[1] == scene::outside;
}

// The graph of the cells (Fig. 3): a node for each cell, where an oblique view of the scene shows its middle, and an arc for
// each pair of cells that portals join.
class CellGraph {
 public:
  CellGraph(const scene::CellComplex& complex, const scene::PolyCamera& camera) {
    const ObliqueView view(camera);
    for (scene::CellNumber cell = 0; cell < complex.cells.size(); ++cell) places_.push_back(view.at(middle_of(edges_of(complex, cell))));
    if (!places_.empty()) low_ = high_ = places_.front();
    for (const Point& place : places_)
      for (std::size_t a = 0; a < 2; ++a) {
        low_[a] = std::min(low_[a], place[a]);
        high_[a] = std::max(high_[a], place[a]);
      }
    size_ = std::max({high_[0] - low_[0], high_[1] - low_[1], 1.0});
    for (std::size_t a = 0; a < 2; ++a) {
      low_[a] -= size_ * 0.12;
      high_[a] += size_ * 0.12;
    }
    for (const scene::ComplexOpening& opening : complex.openings)
      if (!leads_outside(opening)) arcs_.insert(std::minmax(opening.cells[0], opening.cells[1]));
  }

  [[nodiscard]] Sheet sheet(std::string title) const { return {std::move(title), low_, high_}; }
  [[nodiscard]] std::vector<Mark> arcs() const {
    std::vector<Mark> marks;
    for (const auto& [from, to] : arcs_) marks.push_back(explain::line(Look::faint, {places_[from], places_[to]}));
    return marks;
  }
  [[nodiscard]] Mark node(Look look, scene::CellNumber cell) const { return dot(look, places_[cell]); }
  [[nodiscard]] Mark number(Look look, scene::CellNumber cell) const { return text(look, places_[cell], std::to_string(cell)); }
  // An arrow of an avenue of sight (Fig. 5) from node to node; nothing if they are too close together.
  [[nodiscard]] std::vector<Mark> avenue(Look look, scene::CellNumber from, scene::CellNumber to) const {
    const Point& a = places_[from];
    const Point& b = places_[to];
    const Point way{b[0] - a[0], b[1] - a[1]};
    const double length = std::sqrt(way[0] * way[0] + way[1] * way[1]);
    const double radius = size_ * node_radius;
    if (length <= 3 * radius) return {};
    // Beside the arc, so that an avenue back is seen, too.
    const auto at = [&](double along, double left) {
      return Point{a[0] + (way[0] * along - way[1] * left) / length, a[1] + (way[1] * along + way[0] * left) / length};
    };
    const double beside = radius * 0.4;
    const double end = length - radius;
    return {explain::line(look, {at(radius, beside), at(end, beside)}),
            explain::line(look, {at(end - radius, beside + radius * 0.6), at(end, beside), at(end - radius, beside - radius * 0.6)})};
  }

 private:
  std::vector<Point> places_;  // by cell
  std::set<std::pair<scene::CellNumber, scene::CellNumber>> arcs_;
  double size_ = 1;
  Point low_{};
  Point high_{};
};

class JonesRecorder final : public algorithms::jones::Trace {
 public:
  JonesRecorder(const scene::CellComplex& complex, const ImageStage& stage, const PlanStage& ground, const CellGraph& nodes, const scene::PolyCamera& camera, Steps& steps)
      : complex_(complex), stage_(stage), ground_(ground), nodes_(nodes), steps_(steps), sight_(camera), eye_(space(camera.eye)), perspective_(camera.perspective) {
    count();
  }

  [[nodiscard]] bool enough() const override { return steps_.full(); }

  void start(std::span<const scene::CellNumber> cells, bool outside) override {
    outside_ = outside;
    waiting_.assign(cells.begin(), cells.end());
    std::vector<Mark> eye = ground_.arrow();
    if (perspective_) eye.push_back(dot(Look::now, ground_.at(eye_)));
    std::string where;
    if (outside) {
      where = fmt::format("{}: the search begins with the portals in the outer walls that face the eye, and its mask is the whole image.",
                          perspective_ ? "The eye is outside all cells" : "In parallel projection the eye is outside, infinitely far away");
    } else {
      where = fmt::format("The eye is in cell {}. The search begins there, and sees all of it.", cells.front());
    }
    std::vector<Mark> whole;
    if (outside) whole.push_back(area(Look::mask, stage_.region({})));
    steps_.add(std::move(where), "Fig. 4 and 5, avenues of sight", {{image, "mask", std::move(whole)},
                                  {plan, "eye", std::move(eye)},
                                  {plan, "numbers", outside ? std::vector<Mark>() : numbers({cells.front()})},
                                  {graph, "now", outside ? std::vector<Mark>() : std::vector<Mark>{nodes_.node(Look::waiting, cells.front())}}});
  }

  void entered(scene::CellNumber cell, std::uint32_t depth, std::span<const Plane> mask) override {
    flush();
    const bool chosen = waiting_.size() > 1;
    // A cell may be in the queue more than once, each time with another mask.
    if (const auto last = std::find(waiting_.rbegin(), waiting_.rend(), cell); last != waiting_.rend()) waiting_.erase(std::next(last).base());
    const scene::CellNumber left = std::exchange(cell_, cell);
    in_cell_ = true;
    visited_.insert(cell);
    ++visits_;
    count();
    std::vector<Mark> here;
    label_in_image_.clear();
    if (auto outline = stage_.region(mask); outline.size() > 2) {
      stage_.add_label(label_in_image_, Look::now, outline, name_of(cell), 0.92);  // above its portals
      here.push_back(area(Look::mask, std::move(outline)));
    }
    const auto openings = complex_.openings_of(complex_.cells[cell]);
    const auto portals = std::count_if(openings.begin(), openings.end(), [&](std::uint32_t n) { return !leads_outside(complex_.openings[n]); });
    const std::uint32_t passed = outside_ ? depth : depth - 1;
    const std::string seen = passed == 0 ? "It is seen as a whole"
                                         : fmt::format("It is {} portal{} from the eye and is seen through the mask only", passed, passed == 1 ? "" : "s");
    const std::size_t lines = complex_.lines_of(complex_.cells[cell]).size();
    std::vector<Layer> changes{{image, "mask", std::move(here)}, {image, "portal", {}}, {image, "line", {}}, {image, "numbers", label_in_image_},
                               {plan, "portal", {}}, cell_in_plan(cell), {plan, "numbers", numbers({cell})},
                               {graph, "now", {}}, cell_in_graph(cell)};
    if (left != cell) {
      changes.push_back(cell_in_plan(left));
      changes.push_back(cell_in_graph(left));
    }
    steps_.add(fmt::format("Cell {} is entered. {}{}. It has {} line{} and {} portal{} to other cells.", cell,
                           chosen ? "Of the cells that wait the last one comes first. " : "", seen, lines, lines == 1 ? "" : "s", portals,
                           portals == 1 ? "" : "s"),
               "Fig. 4 and 5, avenues of sight", std::move(changes));
  }

  void line(scene::VertexIndex from, scene::VertexIndex to, bool seen, double low, double high) override {
    ++lines_here_;
    if (!seen) return;
    const Space a = space(complex_.vertices[from]);
    const Space b = space(complex_.vertices[to]);
    const auto at = [&](double t) { return Space{a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t}; };
    stage_.add_line(now_, Look::now, at(low), at(high));
    stage_.add_line(seen_, Look::seen, at(low), at(high));
    ++pieces_here_;
  }

  void portal(std::uint32_t number, scene::CellNumber beyond, PortalTest result, std::span<const Plane> mask) override {
    flush_lines();
    if (result == PortalTest::faces_away) {
      (sight_.eye_value(complex_.planes[complex_.openings[number].plane]) == 0 ? edge_on_ : turned_away_).push_back(number);
      return;
    }
    count();
    PortalMarks marks{{}, label_in_image_, {}, in_cell_ ? numbers({cell_, beyond}) : numbers({beyond})};
    add_portal(marks, number);
    auto& [in_image, image_numbers, in_plan, plan_numbers] = marks;
    std::string what;
    switch (result) {
      case PortalTest::faces_away: break;
      case PortalTest::nothing_left:
        what = "Clipped to the mask nothing is left of it: the cell beyond is not entered through it.";
        ++portals_outside_;
        count();
        break;
      case PortalTest::waits: {
        what = fmt::format("Clipped to the mask a part with {} sides is left: cell {} waits with it as its mask.", mask.size(), beyond);
        waiting_.push_back(beyond);
        ++masks_;
        count();
        if (auto left = stage_.region(mask); left.size() > 2) {
          stage_.add_label(image_numbers, Look::waiting, left, name_of(beyond));
          in_image.push_back(area(Look::waiting, std::move(left)));
        }
        break;
      }
    }
    const std::string from = in_cell_ ? name_of(cell_) : "outside";
    std::vector<Layer> changes{{image, "portal", std::move(in_image)},
                               {image, "numbers", std::move(image_numbers)},
                               {plan, "portal", std::move(in_plan)},
                               cell_in_plan(beyond),
                               {plan, "numbers", std::move(plan_numbers)},
                               cell_in_graph(beyond)};
    if (result == PortalTest::waits && in_cell_)
      changes.push_back({graph, fmt::format("avenue {} {}", cell_, beyond), nodes_.avenue(Look::seen, cell_, beyond)});
    steps_.add(fmt::format("Portal {} leads from {} to cell {}. {}", number, from, beyond, what), "Fig. 4 and 5, avenues of sight",
               std::move(changes));
  }

  // The portals of a cell that are not passed form one step, after those that are passed.
  void flush() {
    flush_lines();
    if (turned_away_.empty() && edge_on_.empty()) return;
    portals_turned_away_ += turned_away_.size() + edge_on_.size();
    count();
    PortalMarks marks{{}, label_in_image_, {}, numbers({cell_})};
    std::string caption;
    const auto add_portals = [&](std::vector<std::uint32_t>& portals, std::string_view one, std::string_view many) {
      if (portals.empty()) return;
      std::sort(portals.begin(), portals.end());
      for (std::size_t i = 0; i < std::min(portals.size(), most_named_portals); ++i) add_portal(marks, portals[i]);
      caption += fmt::format("{}{} {}.", caption.empty() ? "" : " ", portal_names(portals), portals.size() == 1 ? one : many);
      portals.clear();
    };
    add_portals(turned_away_, "leads back towards the eye: turned away", "lead back towards the eye: turned away");
    add_portals(edge_on_, "is seen edge-on, so nothing is seen through it", "are seen edge-on, so nothing is seen through them");
    steps_.add(std::move(caption), "Fig. 4 and 5, avenues of sight", {{image, "portal", std::move(marks.in_image)},
                                                     {image, "numbers", std::move(marks.image_numbers)},
                                                     {plan, "portal", std::move(marks.in_plan)},
                                                     {plan, "numbers", std::move(marks.plan_numbers)}});
  }

  // The lines of a cell form one step; if the eye is outside, so do the lines in the outer walls.
  void flush_lines() {
    if (lines_here_ == 0) return;
    // The count includes lines outside the mask, which the search skips without a call of the trace.
    const std::uint64_t all = in_cell_ ? complex_.lines_of(complex_.cells[cell_]).size() : lines_here_;
    const std::uint64_t outside = all - pieces_here_;
    lines_outside_ += outside;
    fragments_ += pieces_here_;
    count();
    const std::string drawn = pieces_here_ == 0 ? "none is seen"
                                                : fmt::format("{} {} drawn, in part or whole", pieces_here_, pieces_here_ == 1 ? "is" : "are");
    const std::string rest = outside == 0 || pieces_here_ == 0 ? "" : fmt::format(", {} {} outside", outside, outside == 1 ? "is" : "are");
    std::vector<Layer> changes{{image, "line", std::exchange(now_, {})}};
    // Each step adds a layer. If each step repeated all lines seen so far, the size of a lesson would grow quadratically.
    if (!seen_.empty()) changes.push_back({image, seen_layer(seen_layers_++), std::exchange(seen_, {})});
    steps_.add(in_cell_ ? fmt::format("The lines of cell {} are clipped to the mask: {}{}.", cell_, drawn, rest)
                        : fmt::format("The lines in the outer walls that face the eye need no portal: {}{}.", drawn, rest),
               "Fig. 4 and 5, avenues of sight", std::move(changes));
    pieces_here_ = lines_here_ = 0;
  }

  // The last step: no cell is current, and the picture is one layer.
  void finish(std::vector<Mark> seen) {
    flush();
    in_cell_ = false;
    std::vector<Layer> changes{{image, "mask", {}}, {image, "portal", {}}, {image, "line", {}}, {image, "numbers", {}}, {image, "seen", std::move(seen)},
                               {plan, "portal", {}}, cell_in_plan(cell_), {plan, "numbers", {}}, cell_in_graph(cell_)};
    for (std::size_t n = 0; n < seen_layers_; ++n) changes.push_back({image, seen_layer(n), {}});
    steps_.add("No cell waits: the picture is complete. Cells that cannot be seen were never entered, so their number costs nothing.",
               "Fig. 5, avenues of sight", std::move(changes));
  }

  // The plan of all cells with their numbers, shown from the first step on; empty for a scene of many cells.
  [[nodiscard]] std::vector<Mark> all_cells() const {
    std::vector<Mark> marks;
    if (complex_.cells.size() > most_numbered_cells) return marks;
    for (scene::CellNumber cell = 0; cell < complex_.cells.size(); ++cell) {
      auto outline = outline_in_plan(cell);
      if (outline.empty()) continue;
      outline.push_back(outline.front());
      marks.push_back(explain::line(Look::faint, std::move(outline)));
      add_label_in_plan(marks, Look::plain, cell, std::to_string(cell));
    }
    return marks;
  }

  // The nodes of the graph with their numbers; no numbers for a scene of many cells.
  [[nodiscard]] std::vector<Mark> all_nodes() const {
    std::vector<Mark> marks = nodes_.arcs();
    for (scene::CellNumber cell = 0; cell < complex_.cells.size(); ++cell) {
      marks.push_back(nodes_.node(Look::faint, cell));
      if (complex_.cells.size() <= most_numbered_cells) marks.push_back(nodes_.number(Look::plain, cell));
    }
    return marks;
  }

 private:
  struct PortalMarks {
    std::vector<Mark> in_image, image_numbers, in_plan, plan_numbers;
  };
  void add_portal(PortalMarks& marks, std::uint32_t number) const {
    const std::vector<Space> corners = corners_of(complex_, number);
    const std::string name = fmt::format("portal {}", number);
    stage_.add_area(marks.in_image, Look::other, corners);
    stage_.add_label(marks.image_numbers, Look::other, corners, name);
    std::vector<Point> outline;
    for (const Space& corner : corners) outline.push_back(ground_.at(corner));
    if (outline.empty()) return;
    marks.plan_numbers.push_back(label(Look::other, label_point(outline), name));
    outline.push_back(outline.front());
    marks.in_plan.push_back(explain::line(Look::other, std::move(outline)));
  }
  static std::string seen_layer(std::size_t number) { return fmt::format("seen {}", number + 1); }
  [[nodiscard]] std::array<double, 4> plane_of(std::uint32_t number, bool turned = false) const {
    const geometry::Plane& plane = complex_.planes[number];
    const double sign = turned ? -1 : 1;
    return {sign * static_cast<double>(plane.normal[0]), sign * static_cast<double>(plane.normal[1]), sign * static_cast<double>(plane.normal[2]),
            sign * static_cast<double>(plane.offset)};
  }
  static std::string name_of(scene::CellNumber cell) { return fmt::format("cell {}", cell); }
  [[nodiscard]] std::vector<Point> outline_in_plan(scene::CellNumber cell) const {
    Planes planes;
    for (const scene::HalfSpace& bound : complex_.bounds_of(complex_.cells[cell])) planes.push_back(plane_of(bound.plane, bound.turned));
    return ground_.region(planes);
  }
  // A cell in plan, marked as entered, waiting or current. Each cell is a layer, so that a step contains only the cells that change.
  [[nodiscard]] Layer cell_in_plan(scene::CellNumber cell) const {
    Layer layer{plan, name_of(cell), {}};
    const auto add = [&](Look look) {
      if (auto outline = outline_in_plan(cell); outline.size() > 2) layer.marks.push_back(area(look, std::move(outline)));
    };
    const bool here = in_cell_ && cell == cell_;
    if (!here && visited_.count(cell) != 0) add(Look::seen);
    if (std::find(waiting_.begin(), waiting_.end(), cell) != waiting_.end()) add(Look::waiting);
    if (here) add(Look::now);
    return layer;
  }
  // The same in the graph.
  [[nodiscard]] Layer cell_in_graph(scene::CellNumber cell) const {
    Layer layer{graph, name_of(cell), {}};
    if (in_cell_ && cell == cell_) {
      layer.marks.push_back(nodes_.node(Look::now, cell));
    } else if (std::find(waiting_.begin(), waiting_.end(), cell) != waiting_.end()) {
      layer.marks.push_back(nodes_.node(Look::waiting, cell));
    } else if (visited_.count(cell) != 0) {
      layer.marks.push_back(nodes_.node(Look::seen, cell));
    }
    return layer;
  }
  void add_label_in_plan(std::vector<Mark>& marks, Look look, scene::CellNumber cell, std::string words) const {
    if (const auto outline = outline_in_plan(cell); !outline.empty()) marks.push_back(label(look, label_point(outline), std::move(words)));
  }
  // The numbers of the cells that the caption names, in plan. They are drawn again because the marked cells cover them.
  [[nodiscard]] std::vector<Mark> numbers(const std::vector<scene::CellNumber>& cells) const {
    std::vector<Mark> marks;
    for (const scene::CellNumber cell : cells) add_label_in_plan(marks, in_cell_ && cell == cell_ ? Look::now : Look::waiting, cell, name_of(cell));
    return marks;
  }
  void count() {
    steps_.count("cells of the scene", complex_.cells.size());
    steps_.count("cells entered", visited_.size());
    steps_.count("visits", visits_);
    steps_.count("portals with a part in the mask", masks_);
    steps_.count("portals outside the mask", portals_outside_);
    steps_.count("portals turned away", portals_turned_away_);
    steps_.count("lines drawn in part or whole", fragments_);
    steps_.count("lines outside the mask", lines_outside_);
  }

  const scene::CellComplex& complex_;
  const ImageStage& stage_;
  const PlanStage& ground_;
  const CellGraph& nodes_;
  Steps& steps_;
  algorithms::jones::Sight sight_;
  Space eye_;
  bool perspective_;
  bool outside_ = false;  // the search began with the portals in the outer walls
  bool in_cell_ = false;   // the search is in cell_; else it has not entered any yet
  scene::CellNumber cell_ = 0;
  std::vector<Mark> label_in_image_;  // of cell_
  std::set<scene::CellNumber> visited_;
  std::vector<scene::CellNumber> waiting_;
  std::vector<std::uint32_t> turned_away_;  // portals of cell_ not yet in a step
  std::vector<std::uint32_t> edge_on_;
  std::vector<Mark> now_;
  std::vector<Mark> seen_;
  std::size_t seen_layers_ = 0;
  std::uint64_t visits_ = 0, portals_turned_away_ = 0, portals_outside_ = 0, masks_ = 0, lines_outside_ = 0, fragments_ = 0;
  std::uint64_t lines_here_ = 0, pieces_here_ = 0;
};

}  // namespace

base::Result<Lesson> explain_jones(const scene::PolyScene& scene, const scene::PolyCamera& camera, const scene::CellComplex* given) {
  scene::CellComplex made;
  if (given == nullptr) {
    auto complex = scene::decompose(scene);
    if (!complex) return std::move(complex.error());
    made = std::move(*complex);
    given = &made;
  }
  Lesson lesson{"jones", "Jones 1971: from cell to cell through portals", scene.name, {}, {}};
  const ImageStage stage(scene, camera);
  const PlanStage ground(scene, camera);
  const CellGraph nodes(*given, camera);
  lesson.sheets = {stage.sheet("The image"), ground.sheet("The cells from above; the arrow is the direction of view"),
                   nodes.sheet("The graph: a node for each cell, a line for each portal; arrows are avenues of sight")};
  Steps steps(lesson);
  JonesRecorder recorder(*given, stage, ground, nodes, camera, steps);
  const auto& openings = given->openings;
  const auto portals = openings.size() - static_cast<std::size_t>(std::count_if(openings.begin(), openings.end(), leads_outside));
  steps.add(fmt::format("Space is cut into {} convex cells without matter, joined by {} portals. What is seen from the eye is found by walking along "
                        "its lines of sight, from cell to cell.",
                        given->cells.size(), portals),
            "Fig. 3, 4 and 5, avenues of sight", {{image, "wire", stage.wire_frame()},
                                               {plan, "wire", ground.wire_frame()},
                                               {plan, "all cells", recorder.all_cells()},
                                               {graph, "all cells", recorder.all_nodes()}});
  auto view = algorithms::jones::visible_edges(*given, camera, recorder);
  if (!view) return std::move(view.error());
  std::vector<Mark> seen;
  for (const auto& piece : view->picture.pieces) stage.add_piece(seen, Look::seen, piece);
  recorder.finish(std::move(seen));
  return lesson;
}

}  // namespace sightline::explain
