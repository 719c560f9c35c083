// Where a lesson draws a scene that turns about its vertical axis: the image, and the circle of directions with the scene in plan.
//
// The axis is moved to the scene's middle, which changes nothing in parallel projection but keeps it in sight. Angles are those of
// the algorithm (host/algorithms/plantinga), in radians.
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

  // All directions have room on it.
  [[nodiscard]] Sheet image_sheet() const;
  [[nodiscard]] Point on_circle(double angle, double radius = 1) const;

  // The image, seen from a direction.
  [[nodiscard]] std::vector<Mark> wire(double angle) const;
  void add_edge(std::vector<Mark>& marks, Look look, pl::EdgeIndex edge, double angle) const;
  void add_face(std::vector<Mark>& marks, Look look, pl::FaceIndex face, double angle) const;
  // After place() at the same angle.
  void add_piece(std::vector<Mark>& marks, Look look, pl::EdgeIndex edge, const pl::Piece& piece, double angle) const;
  void place(double angle) { maker_.place(angle); }
  // What the graph or a picture shows.
  [[nodiscard]] std::vector<Mark> view(const pl::EdgeStructureGraph& graph, double angle);
  [[nodiscard]] std::vector<Mark> seen(const picture::LinePicture& drawn, double angle) const;

  // The circle.
  [[nodiscard]] std::vector<Mark> plan() const;
  void add_edge_to_plan(std::vector<Mark>& marks, Look look, pl::EdgeIndex edge) const;
  // Beside a vertex its number, on a face "face 7", counted from 1; in both sheets.
  void add_vertex_number(std::vector<Mark>& image_marks, std::vector<Mark>& plan_marks, scene::VertexIndex vertex, double angle) const;
  void add_face_number(std::vector<Mark>& image_marks, std::vector<Mark>& plan_marks, pl::FaceIndex face, double angle) const;
  // Where the viewer is.
  [[nodiscard]] std::vector<Mark> radius(double angle) const;

  // The vertices, edges and faces of an event, and on the plan the line of sight on which they meet.
  void add_cause(std::vector<Mark>& image_marks, std::vector<Mark>& plan_marks, const pl::PotentialEvent& cause, double angle);

 private:
  // Equations 1 and 2. u and v are those of the algorithm, about its own axis.
  [[nodiscard]] Point in_image(double u, double v, double angle) const;
  [[nodiscard]] Point in_image(const Space& p, double angle) const;
  [[nodiscard]] Point at(const pl::Vector3& p, double angle) const;
  [[nodiscard]] Point in_plan(const Space& p) const;
  [[nodiscard]] double parameter(pl::EdgeIndex edge, pl::End end) const;
  void add_line_of_sight(std::vector<Mark>& marks, const Space& through, double angle) const;

  const pl::RotationModel& model_;
  pl::FrameMaker maker_;
  Space middle_{};
  double reach_ = 1;  // from the axis
  double low_ = 0;    // of y
  double high_ = 0;
  // -1: the camera's right is to the left of somebody who looks forward with up above, as x, y and z turn the other way round.
  double hand_ = 1;
};

}  // namespace sightline::explain
