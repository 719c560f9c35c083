// See frame.hpp.
#include "host/algorithms/plantinga/frame.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::algorithms::plantinga {

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

void FrameMaker::place(double angle) {
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    places_[i] = {points_[i].x * cosine - points_[i].z * sine, points_[i].y};
  }
}

double FrameMaker::passage_of(EdgeIndex edge, FaceIndex face) const {
  const auto [n, offset] = planes_[face];
  const auto at = [&n = n, &offset = offset](const Point& p) {
    return n.x * p.x + n.y * p.y + n.z * p.z - offset;
  };
  const double from = at(points_[edges_[edge].from]);
  const double to = at(points_[edges_[edge].to]);
  return from / (from - to);
}

FrameMaker::Place FrameMaker::place_of(EdgeIndex edge, const End& end) const {
  if (end.kind() == EndKind::vertex || end.kind() == EndKind::contact) return places_[end.index()];
  const Place& p = places_[edges_[edge].from];
  const Place& q = places_[edges_[edge].to];
  if (end.kind() == EndKind::passage) {
    const double at = passage_of(edge, end.index());
    return {p.u + at * (q.u - p.u), p.v + at * (q.v - p.v)};
  }
  const Place& r = places_[edges_[end.index()].from];
  const Place& s = places_[edges_[end.index()].to];
  const double du = q.u - p.u;
  const double dv = q.v - p.v;
  const double whole = du * (s.v - r.v) - dv * (s.u - r.u);
  const double part = (r.u - p.u) * (s.v - r.v) - (r.v - p.v) * (s.u - r.u);
  const double at = whole != 0 ? std::clamp(part / whole, 0.0, 1.0) : 0.5;
  return {p.u + at * du, p.v + at * dv};
}

void FrameMaker::visible(const EdgeStructureGraph& graph, double angle, std::vector<ImageLine>& lines) {
  place(angle);
  lines.clear();
  for (const LivePiece& live : graph.pieces()) {
    if (live.edge == no_edge) continue;
    const Place low = place_of(live.edge, live.piece.low);
    const Place high = place_of(live.edge, live.piece.high);
    lines.push_back({low.u, low.v, high.u, high.v});
  }
}

void FrameMaker::wire(double angle, std::vector<ImageLine>& lines) {
  place(angle);
  lines.clear();
  for (const Ends& edge : edges_) {
    const Place& low = places_[edge.from];
    const Place& high = places_[edge.to];
    lines.push_back({low.u, low.v, high.u, high.v});
  }
}

}  // namespace sightline::algorithms::plantinga
