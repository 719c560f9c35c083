// Turns about any axis, in parallel projection and perspective: every picture through the events is compared with the exact
// picture of the same view by independent code (host/algorithms/exact) and with the oracle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/oracle/edge_oracle.hpp"
#include "host/algorithms/plantinga/circle_candidates.hpp"
#include "host/algorithms/plantinga/circle_events.hpp"
#include "host/algorithms/plantinga/circle_structure.hpp"
#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/scene/generate/scene.hpp"
#include "tests/host/algorithms/plantinga/turning_scenes.hpp"

namespace sightline::algorithms::plantinga {
namespace {

// The view of a place as a scene and a camera in integers: the eye is at a multiple of 1 / D, so the scene is enlarged.
struct SameView {
  scene::PolyScene scene;
  scene::PolyCamera camera;
};
std::optional<SameView> same_view(const scene::PolyScene& scene, const EyeCircle& circle, const CirclePlace& place) {
  const ExactEye eye = eye_at(circle, place);
  SameView view{scene, {}};
  geometry::Int128 divisor = 0;
  for (const geometry::Int128 part : eye.turned) divisor = geometry::common_divisor(divisor, part);
  std::array<std::int64_t, 3> towards{};
  for (std::size_t i = 0; i < 3; ++i) towards[i] = static_cast<std::int64_t>(eye.turned[i] / divisor);
  view.camera.perspective = circle.perspective;
  if (circle.perspective) {
    for (std::size_t i = 0; i < 3; ++i) {
      const geometry::Int128 at = eye.turned[i] + geometry::Int128{eye.weight} * circle.about[i];
      if (geometry::magnitude(at) >= scene::poly_coordinate_limit) return std::nullopt;
      view.camera.eye[i] = static_cast<std::int32_t>(at);
    }
    for (scene::PolyPoint& vertex : view.scene.vertices) {
      for (std::int32_t& c : vertex) {
        const std::int64_t large = std::int64_t{c} * eye.weight;
        if (std::abs(large) >= scene::poly_coordinate_limit) return std::nullopt;
        c = static_cast<std::int32_t>(large);
      }
    }
  }
  // Visibility depends on the eye alone; the camera looks along the sight line as nearly as its numbers allow.
  const double scale = std::max({std::abs(static_cast<double>(towards[0])), std::abs(static_cast<double>(towards[1])),
                                 std::abs(static_cast<double>(towards[2]))});
  std::array<std::int32_t, 3> forward{};
  for (std::size_t i = 0; i < 3; ++i) {
    forward[i] = circle.perspective ? static_cast<std::int32_t>(std::lround(-100.0 * static_cast<double>(towards[i]) / scale))
                                    : static_cast<std::int32_t>(-towards[i]);
    if (std::abs(forward[i]) >= 1 << 15) return std::nullopt;
  }
  // Two integer vectors across: of the three across an axis, one that is not zero.
  const geometry::Vector3 f{forward[0], forward[1], forward[2]};
  const geometry::Vector3 axis = f[0] == 0 && f[2] == 0 ? geometry::Vector3{0, 0, 1} : geometry::Vector3{0, 1, 0};
  geometry::Vector3 right = geometry::cross(f, axis);
  geometry::Vector3 up = geometry::cross(right, f);
  for (geometry::Vector3* v : {&right, &up}) {
    std::int64_t common = 0;
    for (const std::int64_t c : *v) common = static_cast<std::int64_t>(geometry::common_divisor(geometry::Int128{common}, geometry::Int128{c}));
    for (std::int64_t& c : *v) c /= common;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::max(std::abs(right[i]), std::abs(up[i])) >= 1 << 15) return std::nullopt;
    view.camera.forward[i] = forward[i];
    view.camera.right[i] = static_cast<std::int32_t>(right[i]);
    view.camera.up[i] = static_cast<std::int32_t>(up[i]);
  }
  return view;
}

// Scenes of small coordinates, about 0.
scene::PolyScene centred(scene::PolyScene scene, std::int32_t largest) {
  const auto box = scene::bounds_of(scene);
  const auto middle = box.middle();
  std::int32_t reach = 1;
  for (scene::PolyPoint& p : scene.vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] -= middle[i];
      reach = std::max(reach, std::abs(p[i]));
    }
  }
  EXPECT_LE(reach, largest) << scene.name;
  return scene;
}

EyeCircle circle_for(const scene::PolyScene& scene, std::mt19937& random, bool perspective) {
  const auto number = [&random](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  EyeCircle circle;
  circle.perspective = perspective;
  do {
    circle.axis = {number(-2, 2), number(-2, 2), number(-2, 2)};
  } while (circle.axis == Vector3{});
  double reach = 1;
  for (const scene::PolyPoint& p : scene.vertices) reach = std::max(reach, std::hypot(double(p[0]), double(p[1]), double(p[2])));
  do {
    const int far = perspective ? static_cast<int>(reach * 2) + 2 : 9;
    circle.eye = {number(-far, far), number(-far, far), number(-far, far)};
  } while (circle.eye == Vector3{} ||
           (perspective && std::sqrt(static_cast<double>(geometry::dot(circle.eye, circle.eye))) <= 1.1 * reach));
  return circle;
}

// Draws the views of a turn from scratch and through the events, and compares with independent code.
void expect_exact_turn(const scene::PolyScene& scene, const EyeCircle& circle, std::mt19937& random, int views, bool with_oracle) {
  const RotationModel model(scene);
  ASSERT_FALSE(why_not(model, circle)) << *why_not(model, circle);
  const auto events = build_circle_events(model, circle);
  ASSERT_TRUE(events) << events.error().message();
  EdgeStructureGraph graph(events->list);
  int compared = 0;
  int through_events = 0;
  for (int i = 0; i < 40 * views && compared < views; ++i) {
    const auto part = [&random](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
    const int most = circle.perspective ? 6 : 40;
    const CirclePlace place{part(-most, most), part(0, most)};
    if (place.p == 0 && place.q == 0) continue;
    const auto same = same_view(scene, circle, place);
    if (!same) continue;
    ++compared;
    const picture::LinePicture expected = exact::visible_edges(same->scene, same->camera);
    const std::string where = scene.name + " axis " + std::to_string(circle.axis[0]) + ' ' + std::to_string(circle.axis[1]) + ' ' +
                              std::to_string(circle.axis[2]) + " eye " + std::to_string(circle.eye[0]) + ' ' +
                              std::to_string(circle.eye[1]) + ' ' + std::to_string(circle.eye[2]) +
                              (circle.perspective ? " perspective" : " parallel") + " at " + std::to_string(place.p) + " : " +
                              std::to_string(place.q);
    if (with_oracle) {
      EXPECT_TRUE(oracle::visible_edges(same->scene, same->camera) == expected) << where;
    }
    EXPECT_TRUE(visible_edges(model, circle, place) == expected) << where << ", from scratch";
    const auto passed = events->passed_at(angle_of(circle, place));
    if (!passed) continue;
    ++through_events;
    ASSERT_TRUE(graph.turn_to_place(*passed)) << where;
    picture::LinePicture picture;
    for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge)
      append_pieces(model, circle, edge, graph.structure_of(edge), place, picture.pieces);
    EXPECT_TRUE(picture == expected) << where << ", through the events";
  }
  EXPECT_GT(compared, 0);
  EXPECT_GT(through_events, 0);
  // The turn ends with the structures that it starts with.
  ASSERT_TRUE(graph.turn_to_place(0));
  for (std::size_t i = 0; i < events->list.events.size(); ++i) ASSERT_TRUE(graph.step_forward()) << i;
  for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) EXPECT_EQ(graph.structure_of(edge), events->list.first[edge]);
}

TEST(Circle, EveryPictureEqualsTheOracle) {
  std::mt19937 random(1);
  for (int round = 0; round < 6; ++round) {
    for (const bool perspective : {false, true}) {
      for (const scene::PolyScene& each : {two_boxes(), three_boxes(), boxes_on_the_ground()}) {
        const scene::PolyScene scene = centred(each, 200);
        expect_exact_turn(scene, circle_for(scene, random, perspective), random, 12, true);
      }
    }
  }
}

// Bricks touch each other, in small coordinates: contacts, passages and events that coincide.
TEST(Circle, DegenerateScenesEqualTheOracle) {
  std::mt19937 random(2);
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const scene::PolyScene scene = centred(scene::generate_bricks(6, seed), 40);
    for (const bool perspective : {false, true}) {
      EyeCircle circle = circle_for(scene, random, perspective);
      expect_exact_turn(scene, circle, random, 10, true);
      circle.axis = {0, 1, 0};
      expect_exact_turn(scene, circle, random, 10, false);
    }
  }
}

// Large coordinates and arbitrary angles: the structures of the events are those from scratch.
TEST(Circle, TurnsOfModelsAreAsFromScratch) {
  std::mt19937 random(3);
  for (const char* name : {"squares", "grid", "objects"}) {
    const scene::PolyScene scene = model_scene(name);
    const RotationModel model(scene);
    for (const bool perspective : {false, true}) {
      EyeCircle circle;
      circle.perspective = perspective;
      circle.axis = {3, 7, -2};
      circle.eye = {100000, 200000, 1000000};
      ASSERT_FALSE(why_not(model, circle)) << *why_not(model, circle);
      const auto events = build_circle_events(model, circle);
      ASSERT_TRUE(events);
      EdgeStructureGraph graph(events->list);
      int outside = 0;
      for (int i = 0; i < 6; ++i) {
        const CirclePlace place = place_at(circle, std::uniform_real_distribution<double>(-half_turn, half_turn)(random));
        const auto passed = events->passed_at(angle_of(circle, place));
        if (!passed) continue;
        ++outside;
        ASSERT_TRUE(graph.turn_to_place(*passed));
        for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
          ASSERT_EQ(graph.structure_of(edge), structure_at(model, circle, edge, model.occluders_from_anywhere(edge), place))
              << name << " edge " << edge << " at " << place.p << " : " << place.q;
        }
      }
      EXPECT_GT(outside, 3) << name;
    }
  }
}

// A turn about y in parallel projection has two lists of events, by different code: the exact directions of event_list.hpp, and
// enclosures. They have as many events, at the same angles.
TEST(Circle, FindsTheEventsOfTheTurnAboutTheVerticalAxis) {
  for (const scene::PolyScene& scene : {two_boxes(), three_boxes(), model_scene("grid")}) {
    const RotationModel model(scene);
    const auto exact = build_event_list(model);
    const auto enclosed = build_circle_events(model, {});
    ASSERT_TRUE(exact);
    ASSERT_TRUE(enclosed);
    ASSERT_EQ(exact->events.size(), enclosed->list.events.size());
    EXPECT_EQ(exact->changes.size(), enclosed->list.changes.size());
    for (std::size_t i = 0; i < exact->events.size(); ++i) {
      const double angle = exact->events[i].direction.angle;
      EXPECT_GE(angle, enclosed->enclosures[i].low - place_error) << i;
      EXPECT_LE(angle, enclosed->enclosures[i].high + place_error) << i;
    }
  }
}

TEST(Circle, SaysWhyAnEyeCannotGoRound) {
  const RotationModel model(two_boxes());
  EXPECT_TRUE(why_not(model, {.axis = {0, 0, 0}}));
  EXPECT_TRUE(why_not(model, {.axis = {0, 1001, 0}}));
  EXPECT_TRUE(why_not(model, {.eye = {0, 0, 0}}));
  EXPECT_TRUE(why_not(model, {.eye = {0, 0, 60}, .perspective = true}));
  EXPECT_FALSE(why_not(model, {.eye = {0, 0, 200}, .perspective = true}));
}

// Every root of a form, and of the meeting of two ratios, is in an enclosure; known ones are narrow.
TEST(Circle, EnclosesRoots) {
  std::mt19937 random(4);
  std::uniform_int_distribution<int> number(-9, 9);
  const auto inside = [](const std::vector<Enclosure>& found, double angle) {
    return std::any_of(found.begin(), found.end(), [angle](const Enclosure& e) {
      return (angle >= e.low && angle <= e.high) || (angle + 2 * half_turn >= e.low && angle + 2 * half_turn <= e.high);
    });
  };
  const auto form = [&] { return CircleForm{double(number(random)), double(number(random)), double(number(random))}; };
  int roots = 0;
  for (int i = 0; i < 3000; ++i) {
    const CircleRatio first{form(), form()};
    const CircleRatio second{form(), form()};
    const std::vector<Enclosure> alone = roots_of(first.n);
    std::vector<Enclosure> meetings;
    const bool sure = append_meetings(first, second, -half_turn, half_turn, meetings);
    constexpr int steps = 720;
    const auto wave = [&](double t) {
      const double c = std::cos(t);
      const double s = std::sin(t);
      return first.n.at(c, s) * second.d.at(c, s) - second.n.at(c, s) * first.d.at(c, s);
    };
    const auto check = [&](const auto& value, const std::vector<Enclosure>& found) {
      for (int k = 0; k < steps; ++k) {
        double low = -half_turn + k * 2 * half_turn / steps;
        double high = -half_turn + (k + 1) * 2 * half_turn / steps;
        if (std::abs(value(low)) < 1e-9 || std::abs(value(high)) < 1e-9 || (value(low) < 0) == (value(high) < 0)) continue;
        for (int j = 0; j < 60; ++j) {
          const double middle = (low + high) / 2;
          ((value(middle) < 0) == (value(low) < 0) ? low : high) = middle;
        }
        ++roots;
        EXPECT_TRUE(inside(found, low) || inside(found, high)) << i << " at " << low;
      }
    };
    check([&](double t) { return first.n.at(std::cos(t), std::sin(t)); }, alone);
    if (sure) check(wave, meetings);
  }
  EXPECT_GT(roots, 3000);
}

}  // namespace
}  // namespace sightline::algorithms::plantinga
