// Draws a polyhedral scene on the sheets of a lesson: the image that the camera sees, and the ground seen from above.
//
// Image coordinates are those of PolyCamera. Everything behind the eye, or nearer than a thousandth of the distance to the
// farthest point, is clipped. Doubles suffice: nothing in a lesson is decided by them.
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

  // The whole image; in perspective at most 90 degrees of it, the field of view of Jones's program on the PDP-7.
  [[nodiscard]] Sheet sheet(std::string title) const;
  // The image of a straight line or plane outline in space, as connected points; empty if all of it is clipped.
  [[nodiscard]] std::vector<Point> line_in_image(const Space& from, const Space& to) const;
  [[nodiscard]] std::vector<Point> outline_in_image(std::span<const Space> corners) const;

  // Append nothing if nothing of it is in the image.
  void add_line(std::vector<Mark>& marks, Look look, const Space& from, const Space& to) const;
  void add_area(std::vector<Mark>& marks, Look look, std::span<const Space> corners) const;
  void add_edge(std::vector<Mark>& marks, Look look, const picture::LineEdge& edge) const;
  void add_piece(std::vector<Mark>& marks, Look look, const picture::LinePiece& piece) const;
  // The outline of a face without its holes.
  void add_face(std::vector<Mark>& marks, Look look, const scene::PolyFace& face) const;
  // The part of the sheet within the planes a x + b y + c z >= d, each of which contains the eye or the direction of view.
  [[nodiscard]] std::vector<Point> region(std::span<const std::array<double, 4>> planes) const;
  // The numbers of the edge's two vertices.
  void add_names(std::vector<Mark>& marks, Look look, const picture::LineEdge& edge) const;
  // A label on the visible part of an outline in the image; none if no part is on the sheet.
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
  [[nodiscard]] Point project(const Space& of_eye) const;
  [[nodiscard]] bool cut(Space& from, Space& to) const;

  const scene::PolyScene& scene_;
  const scene::PolyCamera camera_;
  picture::CameraView view_;
  double nearest_ = 0;  // depth of the near clipping plane
  Point low_{};
  Point high_{};
};

// The ground seen from above, along an axis of the scene. The axis nearest to the camera's forward direction points up.
class PlanStage {
 public:
  PlanStage(const scene::PolyScene& scene, const scene::PolyCamera& camera);

  [[nodiscard]] Sheet sheet(std::string title) const;
  [[nodiscard]] Point at(const Space& p) const { return {across_sign_ * p[across_], along_sign_ * p[along_]}; }
  [[nodiscard]] std::size_t vertical() const { return vertical_; }
  // An arrow in the camera's forward direction: from the eye, or in parallel projection from the sheet's border.
  [[nodiscard]] std::vector<Mark> arrow() const;
  [[nodiscard]] std::vector<Mark> wire_frame(Look look = Look::faint) const;
  // The part of the sheet where a x + b y + c z <= d for all vertical planes; other planes are ignored.
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

// The part of a convex outline where a x + b y >= c.
[[nodiscard]] std::vector<Point> cut_outline(const std::vector<Point>& outline, double a, double b, double c);

// The position of an outline's label: at the fraction `height` of its height, the middle of the longest part of that row
// inside the outline, which may be concave. For an outline without area, the mean of its points. The outline is not empty
// (precondition).
[[nodiscard]] Point label_point(const std::vector<Point>& outline, double height = 0.5);

// Appends steps to a lesson, with the current counts, up to most_steps.
class Steps {
 public:
  explicit Steps(Lesson& lesson) : lesson_(lesson) {}

  // Sets a count for all further steps. Counts keep the order in which they were first set.
  void count(std::string_view name, std::uint64_t value);
  // False once the lesson is full; its last step says so.
  bool add(std::string caption, std::string section, std::vector<Layer> changes);
  [[nodiscard]] bool full() const { return full_; }

 private:
  Lesson& lesson_;
  std::vector<Count> counts_;
  bool full_ = false;
};

}  // namespace sightline::explain
