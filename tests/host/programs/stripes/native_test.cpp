// The machine's picture compared with Montani and Re's native stripes, one dot thick: the same corners on the same borders
// between lines,
// the same edges between them. They may differ where a side passes a dot's middle within 1/64 of a dot: the machine counts
// abscissas in
// 1/256 of a dot and adds at most 255 steps, each too short by less than 1/65536. They may differ by a dot along edges that the
// host
// has made, of cuts and at the window's border, because the native algorithm does not have such a corner.
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string>

#include "host/scene/generate/scene.hpp"
#include "tests/host/programs/stripes/views.hpp"
#include "tests/host/scene/generate/generated_set.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::stripes {
namespace {

picture::PixelGrid native_faces(const scene::PolyScene& scene, const View& view, double shift) {
  const auto prepared = registry::find_face_algorithm("montani-re")->prepare(scene, {});
  registry::FaceWindow window = window_of(view);
  window.left += shift;
  return prepared->view(view.camera, window)->faces;
}

// The view with each way to determine the priority.
void expect_native(const scene::PolyScene& scene, const View& view, const std::string& name,
                   std::initializer_list<Computer> priorities) {
  constexpr double margin = 1.0 / 64;
  const picture::PixelGrid native = native_faces(scene, view, 0);
  const picture::PixelGrid west = native_faces(scene, view, -margin);
  const picture::PixelGrid east = native_faces(scene, view, margin);
  for (const Computer priority : priorities) {
    const auto drawn = run({.scene = scene, .view = view, .options = {.priority = priority}, .check = true});
    ASSERT_TRUE(drawn) << name << ": " << drawn.error().message();
    const picture::PixelGrid& faces = *drawn->faces;
    for (int y = 0; y < picture_size; ++y) {
      for (int x = 0; x < picture_size; ++x) {
        const std::uint32_t face = faces.at(x, y);
        if (face == native.at(x, y)) continue;
        const bool beside = drawn->scene.cuts > 0 &&
                            (face == native.at(std::max(x - 1, 0), y) || face == native.at(std::min(x + 1, 254), y) ||
                             face == native.at(x, std::max(y - 1, 0)) || face == native.at(x, std::min(y + 1, 254)));
        EXPECT_TRUE(beside || face == west.at(x, y) || face == east.at(x, y)) << name << ": dot " << x << ", " << y;
      }
    }
  }
}

TEST(StripesNative, CommonScenesEqualTheNativeOnes) {
  for (const std::string_view name : {"C1", "C2", "C3", "C4", "C5", "C6", "C7", "C8", "C9"}) {
    const compare::CommonScene scene = compare::common_scene(name);
    const std::size_t views = tests::effort(scene.views.size(), std::size_t{1});
    for (std::size_t v = 0; v < views; ++v) {
      const std::string title = std::string(name) + ", view " + std::to_string(v);
      if (title == "C9, view 1") continue;  // 65 faces
      // C7 has two faces that hide each other in different places, "unable to solve" in the paper (section 5, Figure 10) and on
      // the 8080; the
      // host cuts them.
      const bool figure_10 = name == "C7";
      figure_10 ? expect_native(scene.scene, common_view(scene.views[v]), title, {Computer::host})
                : expect_native(scene.scene, common_view(scene.views[v]), title, {Computer::host, Computer::i8080});
    }
  }
}

TEST(StripesNative, GeneratedScenesEqualTheNativeOnes) {
  const auto names = scene::generated_set();
  for (std::size_t k = 0; k < names.size(); k += tests::effort(std::size_t{7}, std::size_t{70})) {
    const auto scene = *scene::generate_scene(names[k].family, names[k].size, names[k].seed);
    expect_native(scene, whole_view(scene),
                  std::string(names[k].family) + "-" + std::to_string(names[k].size) + "-" + std::to_string(names[k].seed),
                  {Computer::host, Computer::i8080});
  }
}

}  // namespace
}  // namespace sightline::programs::stripes
