#include "host/explain/turn_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace sightline::explain {

namespace {

using pl::EventKind;

constexpr double plan_radius = 0.8;  // of the scene's plan; the circle of directions has radius 1

Space space_of(const pl::Vector3& p) { return geometry::real_vector(p); }

void add_part(std::vector<Mark>& marks, Look look, const Point& from, const Point& to, double low, double high) {
  const auto at = [&](double s) { return Point{from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])}; };
  marks.push_back(line(look, {at(low), at(high)}));
}

}  // namespace

double degrees(double angle) {
  return angle * 180 / std::numbers::pi;
}

TurnStage::TurnStage(const pl::RotationModel& model, const scene::PolyCamera& camera) : model_(model), maker_(model) {
  const std::vector<pl::Vector3>& vertices = model.vertices();
  const Space right = space(camera.right);
  const Space up = space(camera.up);
  const Space forward = space(camera.forward);
  const double turn = geometry::dot(right, geometry::cross(up, forward));
  handedness_ = turn > 0 ? -1 : 1;

  std::array<std::int64_t, 3> least{};
  std::array<std::int64_t, 3> most{};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t a = 0; a < 3; ++a) {
      least[a] = i == 0 ? vertices[i][a] : std::min(least[a], vertices[i][a]);
      most[a] = i == 0 ? vertices[i][a] : std::max(most[a], vertices[i][a]);
    }
  }
  for (const std::size_t a : {0U, 2U}) middle_[a] = static_cast<double>(least[a] + most[a]) / 2;
  low_ = static_cast<double>(least[1]);
  high_ = static_cast<double>(most[1]);
  for (const pl::Vector3& p : vertices)
    reach_ = std::max(reach_, std::hypot(static_cast<double>(p[0]) - middle_[0], static_cast<double>(p[2]) - middle_[2]));
}

Sheet TurnStage::image_sheet() const {
  const double margin = 0.04 * std::max(2 * reach_, high_ - low_);
  return {"The image", {-reach_ - margin, low_ - margin}, {reach_ + margin, high_ + margin}};
}

Point TurnStage::in_image(double u, double v, double angle) const {
  return {handedness_ * (u - (middle_[0] * std::cos(angle) - middle_[2] * std::sin(angle))), v};
}

Point TurnStage::in_image(const Space& p, double angle) const {
  return in_image(p[0] * std::cos(angle) - p[2] * std::sin(angle), p[1], angle);
}

Point TurnStage::on_circle(double angle, double radius) const {
  return {radius * std::sin(angle), -handedness_ * radius * std::cos(angle)};
}

Point TurnStage::in_plan(const Space& p) const {
  const double scale = plan_radius / reach_;
  return {(p[0] - middle_[0]) * scale, handedness_ * (middle_[2] - p[2]) * scale};
}

std::vector<Mark> TurnStage::wire(double angle) const {
  std::vector<Mark> marks;
  for (pl::EdgeIndex edge = 0; edge < model_.edges().size(); ++edge) add_edge(marks, Look::faint, edge, angle);
  return marks;
}

std::vector<Mark> TurnStage::plan() const {
  std::vector<Mark> marks;
  for (pl::EdgeIndex edge = 0; edge < model_.edges().size(); ++edge) add_edge_to_plan(marks, Look::faint, edge);
  return marks;
}

std::vector<Mark> TurnStage::radius(double angle) const {
  return {line(Look::plain, {on_circle(angle, plan_radius), on_circle(angle, 1.08)}),
          text(Look::now, {0.6, 1.18}, fmt::format("viewer at {:.1f} degrees", degrees(angle))),
          dot(Look::now, on_circle(angle, 1.08))};
}

void TurnStage::add_cause(std::vector<Mark>& image_marks, std::vector<Mark>& plan_marks, const pl::PotentialEvent& cause, double angle) {
  const auto both = [&](Look look, pl::EdgeIndex edge) {
    add_edge(image_marks, look, edge, angle);
    add_edge_to_plan(plan_marks, look, edge);
  };
  const auto face_of = [&](pl::FaceIndex face) {
    add_face(image_marks, Look::other, face, angle);
    for (const pl::Corner& corner : model_.corners(face)) add_edge_to_plan(plan_marks, Look::other, corner.side);
  };
  Space through = space_of(model_.segment(cause.edge).from);
  switch (cause.kind) {
    case EventKind::own_face:
    case EventKind::face_edge_on:
      face_of(cause.first);
      through = space_of(model_.vertices()[model_.corners(cause.first)[0].vertex]);
      break;
    case EventKind::vertex_in_front:
    case EventKind::vertex_behind: {
      both(Look::other, cause.kind == EventKind::vertex_behind ? cause.second : cause.edge);
      const pl::Vector3& p = model_.vertices()[cause.first];
      through = space_of(p);
      image_marks.push_back(dot(Look::now, at(p, angle)));
      plan_marks.push_back(dot(Look::now, in_plan(through)));
      break;
    }
    case EventKind::three_edges: {
      both(Look::other, cause.first);
      both(Look::other, cause.second);
      maker_.place(angle);
      const double s = parameter(cause.edge, pl::End::of(pl::EndKind::junction, cause.first));
      const pl::Segment segment = model_.segment(cause.edge);
      const Space from = space_of(segment.from);
      const Space to = space_of(segment.to);
      for (std::size_t a = 0; a < 3; ++a) through[a] = from[a] + s * (to[a] - from[a]);
      image_marks.push_back(dot(Look::now, in_image(through, angle)));
      break;
    }
    case EventKind::edge_pair:
      both(Look::other, cause.first);
      both(Look::other, cause.second);
      break;
    case EventKind::own_plane:
    case EventKind::in_line: both(Look::other, cause.first); break;
    case EventKind::passage:
      face_of(cause.first);
      both(Look::other, cause.second);
      break;
  }
  add_edge_to_plan(plan_marks, Look::now, cause.edge);
  add_line_of_sight(plan_marks, through, angle);
}

// A line across the circle through a point of the plan.
void TurnStage::add_line_of_sight(std::vector<Mark>& marks, const Space& through, double angle) const {
  const Point p = in_plan(through);
  const Point v = on_circle(angle);
  const double along = p[0] * v[0] + p[1] * v[1];
  const double outside = 1 - (p[0] * p[0] + p[1] * p[1] - along * along);
  const double half = outside > 0 ? std::sqrt(outside) : 0;
  marks.push_back(line(Look::waiting, {{p[0] + (half - along) * v[0], p[1] + (half - along) * v[1]},
                                       {p[0] - (half + along) * v[0], p[1] - (half + along) * v[1]}}));
}

Point TurnStage::at(const pl::Vector3& p, double angle) const {
  return in_image(space_of(p), angle);
}

void TurnStage::add_edge(std::vector<Mark>& marks, Look look, pl::EdgeIndex edge, double angle) const {
  const pl::Segment segment = model_.segment(edge);
  marks.push_back(line(look, {at(segment.from, angle), at(segment.to, angle)}));
}

void TurnStage::add_vertex_number(std::vector<Mark>& image_marks, std::vector<Mark>& plan_marks, scene::VertexIndex vertex, double angle) const {
  const pl::Vector3& p = model_.vertices()[vertex];
  image_marks.push_back(text(Look::now, at(p, angle), std::to_string(vertex)));
  plan_marks.push_back(text(Look::now, in_plan(space_of(p)), std::to_string(vertex)));
}

void TurnStage::add_face_number(std::vector<Mark>& image_marks, std::vector<Mark>& plan_marks, pl::FaceIndex face, double angle) const {
  std::vector<Point> outline;
  std::vector<Point> from_above;
  for (const pl::Corner& corner : model_.corners(face)) {
    outline.push_back(at(model_.vertices()[corner.vertex], angle));
    from_above.push_back(in_plan(space_of(model_.vertices()[corner.vertex])));
  }
  const std::string name = fmt::format("face {}", face + 1);
  image_marks.push_back(label(Look::other, label_point(outline), name));
  plan_marks.push_back(label(Look::other, label_point(from_above), name));
}

void TurnStage::add_edge_to_plan(std::vector<Mark>& marks, Look look, pl::EdgeIndex edge) const {
  const pl::Segment segment = model_.segment(edge);
  marks.push_back(line(look, {in_plan(space_of(segment.from)), in_plan(space_of(segment.to))}));
}

void TurnStage::add_face(std::vector<Mark>& marks, Look look, pl::FaceIndex face, double angle) const {
  std::vector<Point> outline;
  for (const pl::Corner& corner : model_.corners(face)) outline.push_back(at(model_.vertices()[corner.vertex], angle));
  marks.push_back(area(look, std::move(outline)));
}

// At an event the edges may be parallel in the image; the parameter may then be any number or none.
double TurnStage::parameter(pl::EdgeIndex edge, pl::End end) const {
  const double s = maker_.parameter_of(edge, end);
  return s > 0 ? std::min(s, 1.0) : 0;
}

void TurnStage::add_piece(std::vector<Mark>& marks, Look look, pl::EdgeIndex edge, const pl::Piece& piece, double angle) const {
  const pl::Segment segment = model_.segment(edge);
  add_part(marks, look, at(segment.from, angle), at(segment.to, angle), parameter(edge, piece.low),
           parameter(edge, piece.high));
}

std::vector<Mark> TurnStage::view(const pl::EdgeStructureGraph& graph, double angle) {
  std::vector<pl::ImageLine> lines;
  maker_.visible(graph, angle, lines);
  std::vector<Mark> marks;
  for (const pl::ImageLine& each : lines)
    marks.push_back(line(Look::seen, {in_image(each.u0, each.v0, angle), in_image(each.u1, each.v1, angle)}));
  return marks;
}

std::vector<Mark> TurnStage::fitted(Look look, const std::vector<pl::ImageLine>& lines, double radius) const {
  const double scale = std::min(1.0, std::min(reach_, (high_ - low_) / 2) / radius);
  const auto at = [&](double u, double v) { return Point{handedness_ * scale * u, (low_ + high_) / 2 + scale * v}; };
  std::vector<Mark> marks;
  for (const pl::ImageLine& each : lines) marks.push_back(line(look, {at(each.u0, each.v0), at(each.u1, each.v1)}));
  return marks;
}

std::vector<Mark> TurnStage::seen(const picture::LinePicture& drawn, double angle) const {
  std::vector<Mark> marks;
  for (const picture::LinePiece& piece : drawn.pieces)
    add_part(marks, Look::seen, at(model_.vertices()[piece.edge.from], angle),
             at(model_.vertices()[piece.edge.to], angle), piece.low.to_double(), piece.high.to_double());
  return marks;
}

}  // namespace sightline::explain
