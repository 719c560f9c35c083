#include "host/algorithms/plantinga/visible_edges.hpp"

#include <array>

namespace sightline::algorithms::plantinga {
namespace {

using geometry::Rational;

std::int64_t u_of(const Vector3& p, const Sight& sight) {
  return p[0] * sight.z - p[2] * sight.x;
}

// The parameter at which an edge passes through the plane of a face.
Rational passage_of(const RotationModel& model, const Segment& edge, FaceIndex face) {
  const Vector3& about = model.vertices()[model.corners(face)[0].vertex];
  const Vector3& normal = model.faces()[face].normal;
  const std::int64_t from = geometry::dot(normal, minus(edge.from, about));
  return {from, from - geometry::dot(normal, minus(edge.to, about))};
}

// The parameter on the first edge at which the images of two edges cross (equation 5a).
Rational parameter_of(const RotationModel& model, EdgeIndex edge, const End& end, const Sight& sight) {
  const Segment e = model.segment(edge);
  const std::int64_t u = u_of(e.from, sight);
  const std::int64_t du = u_of(e.to, sight) - u;
  const std::int64_t dy = e.to[1] - e.from[1];
  switch (end.kind()) {
    case EndKind::vertex: return end.index() == model.edges()[edge].from ? 0 : 1;
    case EndKind::contact: return {u_of(model.vertices()[end.index()], sight) - u, du};
    case EndKind::passage: return passage_of(model, e, end.index());
    case EndKind::junction: break;
  }
  const Segment g = model.segment(end.index());
  const std::int64_t gu = u_of(g.from, sight);
  const std::int64_t gdu = u_of(g.to, sight) - gu;
  const std::int64_t gdy = g.to[1] - g.from[1];
  const std::int64_t n = (gu - u) * gdy - (g.from[1] - e.from[1]) * gdu;
  return {n, du * gdy - dy * gdu};
}

template <class Find>
picture::LinePicture picture_of(const RotationModel& model, Find find) {
  picture::LinePicture picture;
  std::vector<PieceRange> ranges;
  for (EdgeIndex edge = 0; edge < model.edges().size(); ++edge) {
    ranges.clear();
    find(edge, &ranges);
    for (const PieceRange& range : ranges) {
      picture.pieces.push_back({model.edges()[edge], {range.low, range.low_of}, {range.high, range.high_of}});
    }
  }
  return picture;
}

}  // namespace

std::optional<Sight> sight_of(const scene::PolyCamera& camera) {
  if (camera.perspective || camera.forward[1] != 0) return std::nullopt;
  return Sight{-camera.forward[0], -camera.forward[2]};
}

scene::PolyCamera camera_of(const Sight& sight) {
  const auto x = static_cast<std::int32_t>(sight.x);
  const auto z = static_cast<std::int32_t>(sight.z);
  scene::PolyCamera camera;
  camera.perspective = false;
  camera.forward = {-x, 0, -z};
  camera.right = {z, 0, -x};
  camera.up = {0, 1, 0};
  return camera;
}

picture::LinePicture visible_edges(const RotationModel& model, const Sight& sight) {
  return picture_of(model, [&](EdgeIndex edge, std::vector<PieceRange>* ranges) {
    static_cast<void>(structure_at(model, edge, model.occluders_of(edge), sight, ranges));
  });
}

picture::LinePicture visible_edges(const RotationModel& model, const Sight& sight, Trace& trace) {
  return picture_of(model, [&](EdgeIndex edge, std::vector<PieceRange>* ranges) {
    static_cast<void>(structure_at(model, edge, model.occluders_of(edge), sight, ranges, trace));
  });
}

void append_pieces(const RotationModel& model, EdgeIndex edge, const EdgeStructure& structure,
                   const Sight& sight, std::vector<picture::LinePiece>& pieces) {
  for (const Piece& piece : structure) {
    pieces.push_back({model.edges()[edge], parameter_of(model, edge, piece.low, sight),
                      parameter_of(model, edge, piece.high, sight)});
  }
}

}  // namespace sightline::algorithms::plantinga
