#include "host/explain/other_turns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/plantinga/circle_events.hpp"
#include "host/algorithms/plantinga/eye_circle.hpp"

namespace sightline::explain {

namespace {

constexpr std::size_t most_edges = 100;

struct OtherTurn {
  pl::EyeCircle circle;
  std::string caption;
};

struct Ball {
  pl::Vector3 middle{};
  double radius = 1;
};

Ball ball_around(const pl::RotationModel& model) {
  Ball ball;
  const std::vector<pl::Vector3>& vertices = model.vertices();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax_element(vertices.begin(), vertices.end(), [axis](const pl::Vector3& p, const pl::Vector3& q) { return p[axis] < q[axis]; });
    ball.middle[axis] = ((*low)[axis] + (*high)[axis]) / 2;
  }
  for (const pl::Vector3& p : vertices) {
    std::array<double, 3> d{};
    for (std::size_t axis = 0; axis < 3; ++axis) d[axis] = static_cast<double>(p[axis] - ball.middle[axis]);
    ball.radius = std::max(ball.radius, std::hypot(d[0], d[1], d[2]));
  }
  return ball;
}

std::vector<OtherTurn> other_turns(const Ball& ball) {
  constexpr std::int64_t far = 1 << 20;
  const std::int64_t near = std::llround(2 * ball.radius);
  return {{{ball.middle, {1, 3, 0}, {0, 0, far}, false},
           "\"Other rotations are handled by a coordinate transformation\". Here the scene turns about a slanted axis, the direction 1, 3, 0."},
          {{ball.middle, {0, 1, 0}, {0, far / 2, far}, false},
           "Here the axis is vertical again, and the viewer looks down on the scene, by 27 degrees: the line of sight goes round a cone."},
          {{ball.middle, {0, 1, 0}, {0, near / 2, near}, true},
           "\"Perspective projection can be handled with relatively minor modifications\". Here the eye goes round the scene on a circle, and near "
           "parts are larger."}};
}

}  // namespace

void add_other_turns(const pl::RotationModel& model, const TurnStage& stage, std::size_t circle, Steps& steps) {
  if (model.edges().size() > most_edges) return;
  const Ball ball = ball_around(model);
  for (const OtherTurn& turn : other_turns(ball)) {
    if (pl::why_not(model, turn.circle)) continue;
    const auto events = pl::build_circle_events(model, turn.circle);
    if (!events) continue;
    // From the middle of the widest part of the turn in which nothing changes.
    double from = 0;
    double widest = 0;
    std::vector<Mark> dots;
    for (std::size_t i = 0; i < events->enclosures.size(); ++i) {
      const pl::Enclosure& event = events->enclosures[i];
      const double next = i + 1 < events->enclosures.size() ? events->enclosures[i + 1].low : events->enclosures.front().low + 2 * pl::half_turn;
      if (next - event.high > widest) {
        widest = next - event.high;
        from = std::remainder(event.high + widest / 2, 2 * pl::half_turn);
      }
      dots.push_back(dot(Look::plain, stage.on_circle(event.middle())));
    }
    pl::EdgeStructureGraph graph(events->list);
    static_cast<void>(graph.turn_to(from));
    pl::FrameMaker frames(model, turn.circle);
    std::vector<pl::ImageLine> whole;
    std::vector<pl::ImageLine> visible;
    frames.wire(from, whole);
    frames.visible(graph, from, visible);
    const double reach = turn.circle.perspective ? ball.radius / std::sqrt(1 - 1 / 5.0) : ball.radius;
    steps.count("pieces seen", visible.size());
    steps.add(fmt::format("{} There are {} events. Each is where the eye crosses a plane through a vertex and an edge, at an angle t with "
                          "a + b cos t + c sin t = 0, or where three edges meet.",
                          turn.caption, events->enclosures.size()),
              "section 2",
              {{image, "wire", stage.fitted(Look::faint, whole, reach)},
               {image, "face", {}},
               {image, "cause", {}},
               {image, "edge", {}},
               {image, "numbers", {}},
               {image, "seen", stage.fitted(Look::seen, visible, reach)},
               {circle, "numbers", {}},
               {circle, "cause", {}},
               {circle, "candidates", {}},
               {circle, "found", {}},
               {circle, "legend", {}},
               {circle, "events", std::move(dots)},
               {circle, "sight", stage.radius(from)}});
  }
}

}  // namespace sightline::explain
