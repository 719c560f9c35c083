// Draws a scene that turns about its vertical axis: the image, and the circle of directions with the plan of the scene.
//
// The axis is moved to the middle of the scene: in parallel projection this only shifts the image, and it keeps the scene in view.
// Angles are those of host/algorithms/plantinga, in radians.
#pragma once

#include <string>
#include <vector>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/trace.hpp"
#include "host/algorithms/plantinga/frame.hpp"
#include "host/algorithms/plantinga/turning_scene.hpp"
#include "host/explain/stage.hpp"

namespace sightline::explain {

namespace pl = algorithms::plantinga;

[[nodiscard]] double degrees(double angle);

class TurnStage {
 public:
  // The model outlives the stage.
  TurnStage(const pl::RotationModel& model, const scene::PolyCamera& camera);

  // Large enough for the image from every direction.
  [[nodiscard]] Sheet image_sheet() const;
  [[nodiscard]] Point on_circle(double angle, double radius = 1) const;

  // The image from a direction.
  [[nodiscard]] std::vector<Mark> wire(double angle) const;
  void add_edge(std::vector<Mark>& marks, Look look, pl::EdgeIndex edge, double angle) const;
  void add_face(std::vector<Mark>& marks, Look look, pl::FaceIndex face, double angle) const;
  // Requires place() with the same angle before.
  void add_piece(std::vector<Mark>& marks, Look look, pl::EdgeIndex edge, const pl::Piece& piece, double angle) const;
  void place(double angle) { maker_.place(angle); }
  // The visible pieces of the graph or of a picture.
  [[nodiscard]] std::vector<Mark> view(const pl::EdgeStructureGraph& graph, double angle);
  [[nodiscard]] std::vector<Mark> seen(const picture::LinePicture& drawn, double angle) const;

  // Lines of a turn about any axis (plantinga::ImageLine) whose image is within `radius`, made small enough for the sheet.
  [[nodiscard]] std::vector<Mark> fitted(Look look, const std::vector<pl::ImageLine>& lines, double radius) const;

  // The circle.
  [[nodiscard]] std::vector<Mark> plan() const;
  void add_edge_to_plan(std::vector<Mark>& marks, Look look, pl::EdgeIndex edge) const;
  // On both sheets: the number beside a vertex; "face 7" on a face, counted from 1.
  void add_vertex_number(std::vector<Mark>& image_marks, std::vector<Mark>& plan_marks, scene::VertexIndex vertex, double angle) const;
  void add_face_number(std::vector<Mark>& image_marks, std::vector<Mark>& plan_marks, pl::FaceIndex face, double angle) const;
  // The line from the centre to the viewer.
  [[nodiscard]] std::vector<Mark> radius(double angle) const;

  // The vertices, edges and faces of an event, and in the plan the line of sight on which they meet.
  void add_cause(std::vector<Mark>& image_marks, std::vector<Mark>& plan_marks, const pl::PotentialEvent& cause, double angle);

 private:
  // Equations 1 and 2 of the paper. u and v are image coordinates relative to the algorithm's axis.
  [[nodiscard]] Point in_image(double u, double v, double angle) const;
  [[nodiscard]] Point in_image(const Space& p, double angle) const;
  [[nodiscard]] Point at(const pl::Vector3& p, double angle) const;
  [[nodiscard]] Point in_plan(const Space& p) const;
  [[nodiscard]] double parameter(pl::EdgeIndex edge, pl::End end) const;
  void add_line_of_sight(std::vector<Mark>& marks, const Space& through, double angle) const;

  const pl::RotationModel& model_;
  pl::FrameMaker maker_;
  Space middle_{};
  double reach_ = 1;  // largest distance from the axis
  double low_ = 0;    // range of y
  double high_ = 0;
  // -1: the camera's right, up and forward form a system of the opposite handedness to x, y and z, so the image is mirrored.
  double handedness_ = 1;
};

}  // namespace sightline::explain
