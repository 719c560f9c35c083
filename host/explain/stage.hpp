// Where a lesson draws a scene of polyhedra: the image as the camera shows it, and the ground seen from above.
//
// Coordinates are those of the image as PolyCamera defines it. What lies behind the eye, or nearer than a thousandth of the
// way to the farthest point, is cut off. Lessons draw pictures for people: doubles are good enough here, and only here.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/explain/lesson.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::explain {

using Space = std::array<double, 3>;
[[nodiscard]] inline Space space(const scene::PolyPoint& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

class ImageStage {
 public:
  ImageStage(const scene::PolyScene& scene, const scene::PolyCamera& camera);

  // All of the image, at most 110 degrees of it.
  [[nodiscard]] Sheet sheet(std::string title) const;
  // Any straight line or plane outline in space, each point joined to the next; empty if all of it is cut off.
  [[nodiscard]] std::vector<Point> line_in_image(const Space& from, const Space& to) const;
  [[nodiscard]] std::vector<Point> outline_in_image(std::span<const Space> corners) const;

  // Appends nothing where nothing is seen of it.
  void add_line(std::vector<Mark>& marks, Look look, const Space& from, const Space& to) const;
  void add_area(std::vector<Mark>& marks, Look look, std::span<const Space> corners) const;
  void add_edge(std::vector<Mark>& marks, Look look, const picture::LineEdge& edge) const;
  void add_piece(std::vector<Mark>& marks, Look look, const picture::LinePiece& piece) const;
  // The outline of a face; holes are left out.
  void add_face(std::vector<Mark>& marks, Look look, const scene::PolyFace& face) const;
  // Every edge.
  [[nodiscard]] std::vector<Mark> wire_frame(Look look = Look::faint) const;

 private:
  [[nodiscard]] Space seen_from_eye(const Space& p) const;  // right, up, forward
  [[nodiscard]] Point projected(const Space& of_eye) const;
  [[nodiscard]] bool cut(Space& from, Space& to) const;

  const scene::PolyScene& scene_;
  const scene::PolyCamera camera_;
  std::array<Space, 3> axes_{};  // right, up, forward of length 1
  double nearest_ = 0;           // depth before which all is cut off
  Point low_{};
  Point high_{};
};

// The steps of a lesson while it is made: fills in the counts and ends at most_steps.
class Steps {
 public:
  explicit Steps(Lesson& lesson) : lesson_(lesson) {}

  // From now on every step has this value under this name, which keeps its place.
  void count(std::string_view name, std::uint64_t value);
  // False once there is no room for more; the last step then says so.
  bool add(std::string caption, std::string section, std::vector<Layer> changes);
  [[nodiscard]] bool full() const { return full_; }

 private:
  Lesson& lesson_;
  std::vector<Count> counts_;
  bool full_ = false;
};

}  // namespace sightline::explain
