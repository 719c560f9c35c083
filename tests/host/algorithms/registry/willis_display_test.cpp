// Willis's method on the display for which it was designed, compared point by point with the native result; and the table through
// which the command draws.
#include "host/algorithms/registry/willis_display.hpp"

#include <gtest/gtest.h>

#include "host/algorithms/registry/faces.hpp"
#include "host/algorithms/willis/frame.hpp"
#include "host/scene/generate/scene.hpp"

namespace sightline::registry {
namespace {

namespace willis = algorithms::willis;

TEST(WillisDisplay, EqualsTheNativeResult) {
  WillisDisplay display;
  for (const scene::PolyScene& scene : {scene::generate_boxes(8), scene::generate_touch(3),
                                        scene::generate_rooms(2), scene::generate_town(9)}) {
    const auto made = willis::make_model(scene);
    const auto& model = *made;
    willis::Frames frames(model);
    willis::FrameSpans spans;
    const willis::ImageWindow window = willis::window_around(scene, scene.camera, 512, 512);
    willis::make_spans(model, frames.order(scene.camera), scene.camera, window, spans);
    ASSERT_TRUE(fits_display(spans, window));
    EXPECT_EQ(show_on_display(spans, display), willis::resolve_priorities(spans, window)) << scene.name;
  }
  EXPECT_EQ(display.device.counts().exchanges, 4U);
  EXPECT_EQ(display.device.counts().writes_lost, 0U);
  EXPECT_EQ(display.device.counts().writes_off_screen, 0U);
  EXPECT_EQ(display.device.counts().writes_no_room, 0U);
}

TEST(FaceAlgorithms, WillisDrawsAndNamesInseparableFaces) {
  const FaceAlgorithm* const algorithm = find_face_algorithm("willis");
  ASSERT_NE(algorithm, nullptr);
  EXPECT_EQ(find_face_algorithm("nobody"), nullptr);
  const scene::PolyScene scene = scene::generate_boxes(4);
  const FaceWindow window = face_window(scene, scene.camera, 100, 80, std::nullopt);
  for (const int depth : {0, 30}) {
    FaceOptions options;
    options.depth = depth;
    auto made = algorithm->prepare(scene, options);
    ASSERT_TRUE(made);
    const auto& prepared = *made;
    EXPECT_EQ(prepared.not_solved.empty(), depth == 30);
    const auto view = prepared.view(scene.camera, window);
    ASSERT_TRUE(view);
    const auto& faces = view->faces;
    EXPECT_EQ(faces.width, 100);
    EXPECT_EQ(faces.height, 80);
    EXPECT_NE(faces, picture::PixelGrid(100, 80));
  }
  FaceOptions plan;
  plan.plan = true;
  auto made = algorithm->prepare(scene, plan);
  ASSERT_TRUE(made);
  // From above the roofs.
  EXPECT_FALSE(made->view(scene.camera, window));
}

}  // namespace
}  // namespace sightline::registry
