#include "host/algorithms/plantinga/frame.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "host/algorithms/plantinga/near_vector.hpp"

namespace sightline::algorithms::plantinga {
namespace {

Near3 unit(Near3 v) {
  const double length = length_of(v);
  for (double& part : v) part /= length;
  return v;
}

}  // namespace

// The image axes are turned with the eye, instead of the scene before it.
CircleImage::CircleImage(const EyeCircle& circle, double angle) : about_(near_of(circle.about)) {
  const Near3 axis = unit(near_of(circle.axis));
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const auto turned = [&](const Near3& v) {
    const double along = dot(axis, v);
    const Near3 across = cross(axis, v);
    Near3 result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = cosine * v[i] + (1 - cosine) * along * axis[i] + sine * across[i];
    return result;
  };
  const Near3 eye = near_of(circle.eye);
  const Near3 towards = unit(eye);
  const Near3 level = unit(cross({0, 1, 0}, towards));
  right_ = turned(level);
  up_ = turned(cross(towards, level));
  if (!circle.perspective) return;
  deeper_ = turned(towards);
  for (double& part : deeper_) part /= -length_of(eye);
}

CircleImage::Place CircleImage::of(const std::array<double, 3>& p) const {
  const Near3 d{p[0] - about_[0], p[1] - about_[1], p[2] - about_[2]};
  const double depth = 1 + dot(d, deeper_);
  return {dot(d, right_) / depth, dot(d, up_) / depth, depth};
}

FrameMaker::FrameMaker(const RotationModel& model) : places_(model.vertices().size()) {
  points_.reserve(places_.size());
  for (const Vector3& v : model.vertices()) {
    points_.push_back({static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])});
  }
  edges_.reserve(model.edges().size());
  for (const picture::LineEdge& edge : model.edges()) edges_.push_back({edge.from, edge.to});
  planes_.reserve(model.faces().size());
  for (FaceIndex face = 0; face < model.faces().size(); ++face) {
    const Vector3& n = model.faces()[face].normal;
    planes_.push_back(
        {{static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])},
         static_cast<double>(geometry::dot(n, model.vertices()[model.corners(face)[0].vertex]))});
  }
}

FrameMaker::FrameMaker(const RotationModel& model, const EyeCircle& circle) : FrameMaker(model) {
  circle_ = circle;
}

void FrameMaker::place(double angle) {
  if (circle_) {
    const CircleImage image(*circle_, angle);
    if (circle_->perspective) depths_.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const CircleImage::Place place = image.of({points_[i].x, points_[i].y, points_[i].z});
      places_[i] = {place.u, place.v};
      if (circle_->perspective) depths_[i] = place.depth;
    }
    return;
  }
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    places_[i] = {points_[i].x * cosine - points_[i].z * sine, points_[i].y};
  }
}

double FrameMaker::image_parameter(EdgeIndex edge, double at) const {
  if (depths_.empty()) return at;
  const double from = (1 - at) * depths_[edges_[edge].from];
  const double to = at * depths_[edges_[edge].to];
  return to / (from + to);
}

double FrameMaker::passage_of(EdgeIndex edge, FaceIndex face) const {
  const auto [n, offset] = planes_[face];
  const auto at = [&n = n, &offset = offset](const Point& p) {
    return n.x * p.x + n.y * p.y + n.z * p.z - offset;
  };
  const double from = at(points_[edges_[edge].from]);
  const double to = at(points_[edges_[edge].to]);
  return image_parameter(edge, from / (from - to));
}

// Equation 5a.
double FrameMaker::junction_of(EdgeIndex edge, EdgeIndex other) const {
  const Place& p = places_[edges_[edge].from];
  const Place& q = places_[edges_[edge].to];
  const Place& r = places_[edges_[other].from];
  const Place& s = places_[edges_[other].to];
  const double along = s.v - r.v;
  const double across = s.u - r.u;
  const double whole = (q.u - p.u) * along - (q.v - p.v) * across;
  const double part = (r.u - p.u) * along - (r.v - p.v) * across;
  const double at = whole != 0 ? part / whole : 0.5;
  return std::min(std::max(at, 0.0), 1.0);
}

double FrameMaker::contact_of(EdgeIndex edge, std::uint32_t vertex) const {
  const Place& from = places_[edges_[edge].from];
  const Place& to = places_[edges_[edge].to];
  // Without a circle, the edge is level in the image.
  const bool steep = circle_ && std::abs(to.v - from.v) > std::abs(to.u - from.u);
  const double along = steep ? to.v - from.v : to.u - from.u;
  const double part = steep ? places_[vertex].v - from.v : places_[vertex].u - from.u;
  return along != 0 ? std::clamp(part / along, 0.0, 1.0) : 0.5;
}

double FrameMaker::parameter_of(EdgeIndex edge, const End& end) const {
  switch (end.kind()) {
    case EndKind::vertex: return end.index() == edges_[edge].from ? 0 : 1;
    case EndKind::junction: return junction_of(edge, end.index());
    case EndKind::contact: return contact_of(edge, end.index());
    case EndKind::passage: break;
  }
  return passage_of(edge, end.index());
}

// Whether an end is a vertex is unpredictable, so the loop has no branches: an end that is not a vertex is first set to
// vertex 0, and is recorded by advancing a counter by 0 or 1.
template <class Lines, class Put>
void FrameMaker::put_vertices(const EdgeStructureGraph& graph, Lines& lines, Put put) {
  const std::span<const LivePiece> pieces = graph.pieces();
  lines.resize(pieces.size() + 1);
  inner_.resize(std::max(inner_.size(), 2 * pieces.size() + 2));
  std::uint32_t line = 0;
  std::size_t inner = 0;
  for (const LivePiece& live : pieces) {
    const std::uint32_t there = live.edge != no_edge ? 1U : 0U;
    const std::uint32_t low_inner = live.piece.low.kind() != EndKind::vertex ? 1U : 0U;
    const std::uint32_t high_inner = live.piece.high.kind() != EndKind::vertex ? 1U : 0U;
    // the index, or 0 if the end is not a vertex
    put(lines[line], live.piece.low.index() & (0U - (there & (low_inner ^ 1U))),
        live.piece.high.index() & (0U - (there & (high_inner ^ 1U))));
    inner_[inner] = {2 * line, live.edge, live.piece.low};
    inner += there & low_inner;
    inner_[inner] = {2 * line + 1, live.edge, live.piece.high};
    inner += there & high_inner;
    line += there;
  }
  lines.resize(line);
  inner_count_ = inner;
}

void FrameMaker::visible(const EdgeStructureGraph& graph, double angle, std::vector<ImageLine>& lines) {
  place(angle);
  put_vertices(graph, lines, [this](ImageLine& line, std::uint32_t from, std::uint32_t to) {
    const Place& low = places_[from];
    const Place& high = places_[to];
    line = {low.u, low.v, high.u, high.v};
  });
  for (std::size_t i = 0; i < inner_count_; ++i) {
    const Inner& inner = inner_[i];
    const double at = inner.end.kind() == EndKind::junction ? junction_of(inner.edge, inner.end.index())
                                                            : parameter_of(inner.edge, inner.end);
    const Place& p = places_[edges_[inner.edge].from];
    const Place& q = places_[edges_[inner.edge].to];
    ImageLine& line = lines[inner.end_of_line / 2];
    (inner.end_of_line % 2 == 0 ? line.u0 : line.u1) = p.u + at * (q.u - p.u);
    (inner.end_of_line % 2 == 0 ? line.v0 : line.v1) = p.v + at * (q.v - p.v);
  }
}

void FrameMaker::visible_in_space(const EdgeStructureGraph& graph, double angle,
                                  std::vector<SpaceLine>& lines) {
  place(angle);
  put_vertices(graph, lines, [this](SpaceLine& line, std::uint32_t from, std::uint32_t to) {
    const Point& low = points_[from];
    const Point& high = points_[to];
    line = {{low.x, low.y, low.z}, {high.x, high.y, high.z}};
  });
  for (std::size_t i = 0; i < inner_count_; ++i) {
    const Inner& inner = inner_[i];
    const double at = parameter_of(inner.edge, inner.end);  // in parallel projection, as on the edge
    const Point& p = points_[edges_[inner.edge].from];
    const Point& q = points_[edges_[inner.edge].to];
    SpaceLine& line = lines[inner.end_of_line / 2];
    auto& end = inner.end_of_line % 2 == 0 ? line.from : line.to;
    end = {p.x + at * (q.x - p.x), p.y + at * (q.y - p.y), p.z + at * (q.z - p.z)};
  }
}

void FrameMaker::wire(double angle, std::vector<ImageLine>& lines) {
  place(angle);
  lines.resize(edges_.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Place& low = places_[edges_[i].from];
    const Place& high = places_[edges_[i].to];
    lines[i] = {low.u, low.v, high.u, high.v};
  }
}

}  // namespace sightline::algorithms::plantinga
