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
#include "host/geometry/vector.hpp"
#include "host/picture/camera_view.hpp"
#include "host/picture/line_picture.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::explain {

// The first sheet of every lesson.
inline constexpr std::size_t image = 0;

using Space = geometry::RealVector;
[[nodiscard]] inline Space space(const scene::PolyPoint& p) { return geometry::real_vector(p); }

class ImageStage {
 public:
  ImageStage(const scene::PolyScene& scene, const scene::PolyCamera& camera);

  // All of the image, in perspective at most 90 degrees of it: the field of Jones's program on the PDP-7.
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
  // What of the sheet lies within the planes a x + b y + c z >= d, each seen as a line: through the eye, or along the line of sight.
  [[nodiscard]] std::vector<Point> region(std::span<const std::array<double, 4>> planes) const;
  // The number of the edge's two vertices beside them.
  void add_names(std::vector<Mark>& marks, Look look, const picture::LineEdge& edge) const;
  // A label on what the sheet shows of an outline in the image; nothing where it shows nothing.
  void add_label(std::vector<Mark>& marks, Look look, const std::vector<Point>& outline, std::string words, double height = 0.5) const;
  void add_label(std::vector<Mark>& marks, Look look, std::span<const Space> corners, std::string words) const {
    add_label(marks, look, outline_in_image(corners), std::move(words));
  }
  void add_label(std::vector<Mark>& marks, Look look, const scene::PolyFace& face, std::string words) const {
    add_label(marks, look, corners_of(face), std::move(words));
  }
  // Every edge.
  [[nodiscard]] std::vector<Mark> wire_frame(Look look = Look::faint) const;

 private:
  [[nodiscard]] std::vector<Space> corners_of(const scene::PolyFace& face) const;
  [[nodiscard]] Point projected(const Space& of_eye) const;
  [[nodiscard]] bool cut(Space& from, Space& to) const;

  const scene::PolyScene& scene_;
  const scene::PolyCamera camera_;
  picture::CameraView view_;
  double nearest_ = 0;  // depth before which all is cut off
  Point low_{};
  Point high_{};
};

// The ground from above, seen along an axis of the scene: up on the sheet is the axis that is nearest to the camera's forward.
class PlanStage {
 public:
  PlanStage(const scene::PolyScene& scene, const scene::PolyCamera& camera);

  [[nodiscard]] Sheet sheet(std::string title) const;
  [[nodiscard]] Point at(const Space& p) const { return {across_sign_ * p[across_], along_sign_ * p[along_]}; }
  [[nodiscard]] std::size_t vertical() const { return vertical_; }
  // An arrow along the camera's forward: from the eye, or in parallel projection into the sheet from its border.
  [[nodiscard]] std::vector<Mark> arrow() const;
  [[nodiscard]] std::vector<Mark> wire_frame(Look look = Look::faint) const;
  // The part of the sheet where a x + b y + c z <= d for the planes that stand upright; the others are left out.
  [[nodiscard]] std::vector<Point> region(std::span<const std::array<double, 4>> planes) const;

 private:
  const scene::PolyScene& scene_;
  const scene::PolyCamera camera_;
  std::size_t vertical_ = 1;
  std::size_t across_ = 0;
  std::size_t along_ = 2;
  double across_sign_ = 1;
  double along_sign_ = 1;
  Point low_{};
  Point high_{};
};

// What is left of a convex outline where a x + b y >= c.
[[nodiscard]] std::vector<Point> cut_outline(const std::vector<Point>& outline, double a, double b, double c);

// Where a label of an outline stands: at a part of its height, 0.5 halfway up, in the middle of the longest part of that row that is within the outline. So it is
// within an outline that is not convex, too. Of an outline without an area the mean of its points. Not empty (precondition).
[[nodiscard]] Point label_point(const std::vector<Point>& outline, double height = 0.5);

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
