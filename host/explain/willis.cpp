#include "host/explain/willis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/algorithms/willis/frame.hpp"
#include "host/algorithms/willis/model.hpp"
#include "host/algorithms/willis/trace.hpp"
#include "host/explain/stage.hpp"

namespace sightline::explain {
namespace {

namespace wl = algorithms::willis;

constexpr std::size_t ground = 1;
// Further clusters in a round, and further surfaces in flight, are summarised in one step.
constexpr std::size_t most_shown = 25;
constexpr std::size_t most_painted = 120;
// Larger scenes are rejected, because nobody could follow the lesson.
constexpr std::size_t most_pieces = 3000;

Space place_of(const wl::Point& p) {
  return {static_cast<double>(p[0]) / wl::lattice_unit, static_cast<double>(p[1]) / wl::lattice_unit, static_cast<double>(p[2]) / wl::lattice_unit};
}

std::vector<Space> corners_of(const wl::Surface& surface) {
  std::vector<Space> corners;
  for (const wl::Point& point : surface.points) corners.push_back(place_of(point));
  return corners;
}

double distance(const Space& a, const Space& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

class WillisRecorder final : public wl::Trace {
 public:
  // `unit`: one unit of the scene's coordinates, in units of its file.
  WillisRecorder(const ImageStage& stage, const PlanStage& plan, double unit, Steps& steps) : stage_(stage), plan_(plan), unit_(unit), steps_(steps) { count(); }

  void surfaces(std::span<const wl::Surface> pieces, const wl::OrderCells& cells) override {
    pieces_ = pieces.size();
    order_cells_ = cells.cells;
    count();
    steps_.add(fmt::format("The scene as {} convex surfaces. If distance from the eye alone were their order, no sorting tree would be needed, only one distance for each surface "
                           "and frame.{}",
                           pieces.size(),
                           cells.cells > 1 ? fmt::format(" Surfaces that touch are kept apart by planes: {} cells, which are ordered by the side the eye is on.", cells.cells) : std::string()),
               "Use of distance as a measure of priority", {{image, "surfaces", outlines(pieces)}, {ground, "surfaces", in_plan(pieces)}});
  }

  void clusters(std::span<const wl::Surface> pieces, std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) override {
    pieces_ = pieces.size();
    clusters_ = pairs.size();
    count();
    if (pairs.empty()) {
      steps_.add("No two surfaces are a cluster any more: whichever is farther from the eye is behind, from wherever one looks.", "The cluster algorithm",
                 {{image, "pair", {}}, {ground, "pair", {}}, {image, "surfaces", outlines(pieces)}, {ground, "surfaces", in_plan(pieces)},
                  {image, "numbers", {}}, {ground, "numbers", {}}});
      return;
    }
    std::size_t shown = 0;
    for (const auto& [a, b] : pairs) {
      if (++shown > most_shown) break;
      std::vector<Mark> in_image;
      stage_.add_area(in_image, Look::now, corners_of(pieces[a]));
      stage_.add_area(in_image, Look::other, corners_of(pieces[b]));
      std::vector<Mark> in_ground = boundary(pieces[a], Look::mask);
      add_plan(in_ground, Look::now, pieces[a]);
      add_plan(in_ground, Look::other, pieces[b]);
      NumberMarks numbers;
      add_number(numbers, Look::now, pieces[a], a);
      add_number(numbers, Look::other, pieces[b], b);
      steps_.add(fmt::format("Surfaces {} and {} are a cluster: one can hide the other, and one has a point within the boundary of the other, where distance may give the wrong "
                             "order. On the ground the boundary of surface {}: about each corner a ball that reaches its farthest corner.",
                             a + 1, b + 1, a + 1),
                 "Determining the boundary; Clustering",
                 {{image, "pair", std::move(in_image)}, {ground, "pair", std::move(in_ground)}, {image, "surfaces", outlines(pieces)}, {ground, "surfaces", in_plan(pieces)},
                  {image, "numbers", std::move(numbers.image)}, {ground, "numbers", std::move(numbers.ground)}});
    }
    if (pairs.size() > most_shown) steps_.add(fmt::format("{} more clusters are found in this round.", pairs.size() - most_shown), "Clustering",
                 {{image, "pair", {}}, {ground, "pair", {}}, {image, "numbers", {}}, {ground, "numbers", {}}});
  }

  void cut(std::uint32_t piece, const std::array<wl::Surface, 2>& halves, std::uint32_t second) override {
    ++cuts_;
    count();
    if (cuts_ > 200) return;
    std::vector<Mark> in_image;
    stage_.add_area(in_image, Look::now, corners_of(halves[0]));
    stage_.add_area(in_image, Look::waiting, corners_of(halves[1]));
    std::vector<Mark> in_ground = boundary(halves[0], Look::mask);
    add_plan(in_ground, Look::now, halves[0]);
    add_plan(in_ground, Look::waiting, halves[1]);
    NumberMarks numbers;
    add_number(numbers, Look::now, halves[0], piece);
    add_number(numbers, Look::waiting, halves[1], second);
    steps_.add(fmt::format("Surface {} is the larger of its cluster. It is cut in two; its other half is surface {}. The boundaries of the halves are smaller than that of the whole.",
                           piece + 1, second + 1),
               "Properties of the boundary oval", {{image, "pair", std::move(in_image)}, {ground, "pair", std::move(in_ground)},
                {image, "numbers", std::move(numbers.image)}, {ground, "numbers", std::move(numbers.ground)}});
  }

  void in_flight(const wl::Model& model, const scene::PolyCamera& camera) {
    wl::Frames frames(model);
    const auto order = frames.order(camera);
    facing_ = order.size();
    count();
    const Space eye = space(camera.eye);
    std::vector<Mark> here;
    if (camera.perspective) here.push_back(dot(Look::now, plan_.at(eye)));
    steps_.add(fmt::format("In flight. {} of {} surfaces are turned to the eye. Each gets one distance, from the eye to its first corner; within a cell the nearer one has the "
                           "higher priority.",
                           order.size(), model.pieces.size()),
               "The cluster algorithm", {{image, "pair", {}}, {ground, "pair", std::move(here)}, {image, "numbers", {}}, {ground, "numbers", {}}});
    std::vector<Mark> painted;
    const std::size_t at_once = std::max<std::size_t>(1, (order.size() + most_painted - 1) / most_painted);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const wl::Surface& surface = model.pieces[order[i]];
      // The area hides what was painted before; its outline is drawn on it.
      stage_.add_area(painted, Look::seen, corners_of(surface));
      ++shown_;
      if ((i + 1) % at_once != 0 && i + 1 != order.size()) continue;
      count();
      std::vector<Mark> now;
      stage_.add_area(now, Look::now, corners_of(surface));
      std::vector<Mark> in_ground;
      add_plan(in_ground, Look::now, surface);
      NumberMarks numbers;
      const bool in_cells = model.cells.cells > 1;
      add_number(numbers, Look::now, surface, order[i], in_cells ? fmt::format(", cell {}", surface.cell) : std::string());
      const std::string where = in_cells ? fmt::format(", in cell {}", surface.cell) : std::string();
      if (camera.perspective) in_ground.push_back(line(Look::now, {plan_.at(eye), plan_.at(place_of(surface.points[0]))}));
      steps_.add(camera.perspective ? fmt::format("Priority {}: surface {}, {:.5g} from the eye{}. It covers what has a lower priority.", i + 1, order[i] + 1,
                                                  unit_ * distance(eye, place_of(surface.points[0])), where)
                                    : fmt::format("Priority {}: surface {}{}. It covers what has a lower priority.", i + 1, order[i] + 1, where),
                 "The Sussex approach", {{image, "pair", std::move(now)}, {image, "painted", painted}, {ground, "pair", std::move(in_ground)},
                  {image, "numbers", std::move(numbers.image)}, {ground, "numbers", std::move(numbers.ground)}});
    }
    steps_.add(fmt::format("The frame is complete: in the priority display the highest priority at each point of a line is shown. {} pairs could not be separated.", model.residual.size()),
               "Concluding remarks", {{image, "pair", {}}, {ground, "pair", {}}, {image, "numbers", {}}, {ground, "numbers", {}}});
  }

 private:
  struct NumberMarks {
    std::vector<Mark> image;
    std::vector<Mark> ground;
  };
  // Labels a surface as the captions name it.
  void add_number(NumberMarks& numbers, Look look, const wl::Surface& surface, std::uint32_t number, std::string_view more = {}) const {
    const std::string words = fmt::format("surface {}{}", number + 1, more);
    stage_.add_label(numbers.image, look, corners_of(surface), words);
    std::vector<Point> outline;
    for (const Space& corner : corners_of(surface)) outline.push_back(plan_.at(corner));
    numbers.ground.push_back(label(look, label_point(outline), words));
  }
  std::vector<Mark> outlines(std::span<const wl::Surface> pieces) const {
    std::vector<Mark> marks;
    for (const wl::Surface& surface : pieces) {
      auto outline = stage_.outline_in_image(corners_of(surface));
      if (outline.size() < 2) continue;
      outline.push_back(outline.front());
      marks.push_back(line(Look::faint, std::move(outline)));
    }
    return marks;
  }
  void add_plan(std::vector<Mark>& marks, Look look, const wl::Surface& surface) const {
    std::vector<Point> points;
    for (const Space& corner : corners_of(surface)) points.push_back(plan_.at(corner));
    points.push_back(points.front());
    marks.push_back(line(look, std::move(points)));
  }
  std::vector<Mark> in_plan(std::span<const wl::Surface> pieces) const {
    std::vector<Mark> marks;
    for (const wl::Surface& surface : pieces) add_plan(marks, Look::faint, surface);
    return marks;
  }
  std::vector<Mark> boundary(const wl::Surface& surface, Look look) const {
    std::vector<Mark> marks;
    const auto corners = corners_of(surface);
    for (const Space& corner : corners) {
      double radius = 0;
      for (const Space& other : corners) radius = std::max(radius, distance(corner, other));
      const Point middle = plan_.at(corner);
      std::vector<Point> circle;
      for (int i = 0; i <= 48; ++i) circle.push_back({middle[0] + radius * std::cos(i * 0.1308996938995747), middle[1] + radius * std::sin(i * 0.1308996938995747)});
      marks.push_back(line(look, std::move(circle)));
    }
    return marks;
  }
  void count() {
    steps_.count("surfaces", pieces_);
    steps_.count("order cells", order_cells_);
    steps_.count("clusters left", clusters_);
    steps_.count("cuts", cuts_);
    steps_.count("turned to the eye", facing_);
    steps_.count("shown", shown_);
  }

  const ImageStage& stage_;
  const PlanStage& plan_;
  double unit_;
  Steps& steps_;
  std::uint64_t pieces_ = 0, order_cells_ = 0, clusters_ = 0, cuts_ = 0, facing_ = 0, shown_ = 0;
};

}  // namespace

base::Result<Lesson> explain_willis(const scene::PolyScene& scene, const scene::PolyCamera& camera, const scene::CellComplex*) {
  if (scene::face_count(scene) > 300) return base::Error{"", "willis", "the scene has more than 300 faces, too many to follow", "a smaller scene"};
  Lesson lesson{"willis", "Willis 1977: distance as priority", scene.name, {}, {}};
  const ImageStage stage(scene, camera);
  const PlanStage plan(scene, camera);
  lesson.sheets = {stage.sheet("The image"), plan.sheet("The ground from above")};
  Steps steps(lesson);
  WillisRecorder recorder(stage, plan, scene.step, steps);
  wl::ModelOptions options;
  options.limits.pieces = most_pieces;
  options.limits.depth = 6;
  auto model = wl::make_model(scene, options, &recorder);
  if (!model) return std::move(model.error());
  recorder.in_flight(*model, camera);
  return lesson;
}

}  // namespace sightline::explain
