#include "host/explain/exact.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "host/algorithms/exact/visible_edges.hpp"
#include "host/explain/stage.hpp"

namespace sightline::explain {
namespace {

using picture::LineEdge;
using picture::LinePiece;

class ExactRecorder final : public algorithms::exact::Trace {
 public:
  ExactRecorder(const scene::PolyScene& scene, const ImageStage& stage, Steps& steps) : stage_(stage), steps_(steps) {
    for (const scene::PolyBody& body : scene.bodies)
      for (const scene::PolyFace& face : body.faces) faces_.push_back(&face);
    count();
  }

  void edge(const LineEdge& edge) override {
    ++edges_;
    count();
    std::vector<Mark> marks;
    stage_.add_edge(marks, Look::now, edge);
    std::vector<Mark> names;
    stage_.add_names(names, Look::now, edge);
    steps_.add(fmt::format("The next edge runs from vertex {} to vertex {}. It is compared with the faces that meet it in the image, "
                           "the nearest first.",
                           edge.from, edge.to),
               {}, {{0, "edge", std::move(marks)}, {0, "face", {}}, {0, "numbers", std::move(names)}});
  }

  void compared(const LineEdge& edge, std::uint32_t face, std::span<const LinePiece> left) override {
    ++compared_;
    count();
    std::vector<Mark> outline;
    stage_.add_face(outline, Look::other, *faces_[face]);
    std::vector<Mark> names;
    stage_.add_names(names, Look::now, edge);
    stage_.add_label(names, Look::other, *faces_[face], fmt::format("face {}", face + 1));
    std::vector<Mark> marks;
    stage_.add_edge(marks, Look::hidden, edge);
    for (const LinePiece& piece : left) stage_.add_piece(marks, Look::now, piece);
    std::string what;
    if (left.empty()) {
      what = "The whole edge is now hidden, so no other face is compared with it.";
    } else if (left.size() == 1 && left[0].low == geometry::Rational(0) && left[0].high == geometry::Rational(1)) {
      what = "It hides no part of the edge.";
    } else {
      what = fmt::format("{} {} of the edge may still be visible.", left.size(), left.size() == 1 ? "piece" : "pieces");
    }
    steps_.add(fmt::format("Face {} is compared with the edge. {}", face + 1, what), {},
               {{0, "edge", std::move(marks)}, {0, "face", std::move(outline)}, {0, "numbers", std::move(names)}});
  }

  void result(const LineEdge& edge, bool searched, std::span<const LinePiece> seen) override {
    if (!searched) {
      ++own_;
      count();
      return;
    }
    for (const LinePiece& piece : seen) stage_.add_piece(seen_, Look::seen, piece);
    pieces_ += seen.size();
    count();
    std::vector<Mark> names;
    stage_.add_names(names, Look::now, edge);
    steps_.add(seen.empty() ? fmt::format("The edge from {} to {} is hidden.", edge.from, edge.to)
                            : fmt::format("No other face can hide it. {} visible {} of the edge from {} to {}: drawn.", seen.size(),
                                          seen.size() == 1 ? "piece" : "pieces", edge.from, edge.to),
               {}, {{0, "edge", {}}, {0, "face", {}}, {0, "numbers", std::move(names)}, {0, "seen", seen_}});
  }

 private:
  void count() {
    steps_.count("edges taken", edges_);
    steps_.count("edges left out", own_);
    steps_.count("comparisons", compared_);
    steps_.count("pieces seen", pieces_);
  }

  const ImageStage& stage_;
  Steps& steps_;
  std::vector<const scene::PolyFace*> faces_;
  std::vector<Mark> seen_;
  std::uint64_t edges_ = 0;
  std::uint64_t own_ = 0;
  std::uint64_t compared_ = 0;
  std::uint64_t pieces_ = 0;
};

}  // namespace

base::Result<Lesson> explain_exact(const scene::PolyScene& scene, const scene::PolyCamera& camera, const scene::CellComplex*) {
  Lesson lesson{"exact", "Every edge against the faces that may hide it", scene.name, {}, {}};
  const ImageStage stage(scene, camera);
  lesson.sheets.push_back(stage.sheet("The image"));
  Steps steps(lesson);
  ExactRecorder recorder(scene, stage, steps);
  steps.add("The wire frame: all edges of the scene. An edge whose faces all look away from the eye is hidden by its own solid "
            "and is left out.",
            {}, {{0, "wire", stage.wire_frame()}});
  const picture::LinePicture picture = algorithms::exact::visible_edges(scene, camera, recorder);
  std::vector<Mark> seen;
  for (const LinePiece& piece : picture.pieces) stage.add_piece(seen, Look::seen, piece);
  steps.add("Every edge has been compared with the faces before it. What is drawn is exactly what is visible.", {}, {{0, "edge", {}}, {0, "face", {}}, {0, "numbers", {}}, {0, "seen", std::move(seen)}});
  return lesson;
}

}  // namespace sightline::explain
