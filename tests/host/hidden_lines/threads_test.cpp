// ViewOptions::jobs and LoadOptions::jobs: the same drawing for every number of threads.
#include <gtest/gtest.h>

#include "host/hidden_lines/hidden_lines.hpp"
#include "host/scene/check/apart_bodies.hpp"
#include "host/scene/check/crossings.hpp"
#include "host/scene/read/poly_file.hpp"

namespace sightline::hidden_lines {
namespace {

// As OFF: a mesh whose surfaces are found.
scene::SceneFile boxes_file(const std::string& name) {
  const auto boxes = find(name);
  return {.name = "boxes.off", .text = scene::write_poly(*boxes->generated, scene::PolyFormat::off).value()};
}

// All that a drawing says.
std::string outcome(const scene::SceneFile& file, unsigned jobs, ViewOptions options) {
  LoadOptions loading = mending;
  loading.jobs = jobs;
  const auto scene = load(file, loading);
  if (!scene) return scene.error().message();
  options.jobs = jobs;
  const auto drawing = view(*scene, scene->scene.camera, options);
  if (!drawing) return drawing.error().message();
  std::string result = write(drawing->picture)->bytes + json_lines(*drawing);
  for (const std::string& note : drawing->notes) result += note + "\n";
  return result;
}

void expect_equal_for_all_jobs(const scene::SceneFile& file, const ViewOptions& options) {
  const std::string one = outcome(file, 1, options);
  EXPECT_NE(one.find("<svg"), std::string::npos) << one.substr(0, 200);
  for (const unsigned jobs : {2U, 3U, 7U}) EXPECT_EQ(outcome(file, jobs, options), one) << jobs << " threads";
}

TEST(DrawingWithThreads, AMeshAndAGeneratedSceneHaveEqualBytes) {
  ViewOptions options;
  expect_equal_for_all_jobs(boxes_file("boxes-400"), options);
  expect_equal_for_all_jobs(*find("boxes-400"), options);
  options.strokes = true;
  options.hidden = true;
  options.edges.kinds = "all";
  expect_equal_for_all_jobs(boxes_file("boxes-100"), options);
  expect_equal_for_all_jobs(*find("rooms-30"), options);
}

// Boxes of a mesh and the same ones moved by a fraction of their size.
scene::SceneFile crossing_boxes() {
  scene::PolyScene boxes = *find("boxes-100")->generated;
  scene::PolyScene both = boxes;
  const auto count = static_cast<scene::VertexIndex>(boxes.vertices.size());
  for (const scene::PolyPoint& p : boxes.vertices) both.vertices.push_back({p[0] + 3, p[1] + 5, p[2] + 7});
  for (scene::PolyBody& body : boxes.bodies) {
    for (scene::PolyFace& face : body.faces)
      for (scene::VertexIndex& v : face.outline) v += count;
    both.bodies.push_back(body);
  }
  return {.name = "crossing.off", .text = scene::write_poly(both, scene::PolyFormat::off).value()};
}

TEST(DrawingWithThreads, LinesInWhichBodiesCrossAreTheSame) {
  ViewOptions options;
  options.strokes = true;
  const scene::SceneFile file = crossing_boxes();
  expect_equal_for_all_jobs(file, options);
  const auto scene = load(file);
  ASSERT_TRUE(scene);
  const std::vector<scene::Crossing> all = scene::crossings_of(scene->scene);
  ASSERT_GT(all.size(), 100U);
  for (const unsigned jobs : {2U, 3U, 7U}) {
    EXPECT_EQ(scene::crossings_of(scene->scene, all.size() + 1, jobs), all);
    for (const std::size_t most : {1U, 2U, 50U}) EXPECT_EQ(scene::crossings_of(scene->scene, most, jobs), scene::crossings_of(scene->scene, most, 1));
  }
  for (const unsigned jobs : {1U, 2U, 7U}) {
    EXPECT_FALSE(scene::are_plainly_apart(scene->scene, jobs));
    EXPECT_TRUE(scene::are_plainly_apart(*find("boxes-400")->generated, jobs));
  }
}

TEST(DrawingWithThreads, ALateFaultIsTheSameError) {
  scene::SceneFile file = boxes_file("boxes-400");
  const std::size_t line = file.text.rfind("\n4 ", file.text.size() * 3 / 4);
  file.text.insert(line + 3, "?");
  const std::string one = outcome(file, 1, {});
  EXPECT_NE(one.find("found \"?"), std::string::npos) << one;
  for (const unsigned jobs : {2U, 3U, 7U}) EXPECT_EQ(outcome(file, jobs, {}), one);
}

}  // namespace
}  // namespace sightline::hidden_lines
