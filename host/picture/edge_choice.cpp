#include "host/picture/edge_choice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "host/base/threads.hpp"
#include "host/geometry/vector.hpp"

namespace sightline::picture {
namespace {

constexpr std::size_t number_of(EdgeKind kind) {
  return static_cast<std::size_t>(kind);
}

double square(const geometry::Vector3& v) {
  double sum = 0;
  for (const std::int64_t c : v) sum += static_cast<double>(c) * static_cast<double>(c);
  return sum;
}

geometry::Vector3 area_of(const std::vector<scene::PolyPoint>& vertices, const scene::PolyFace& face) {
  geometry::Vector3 sum{};
  const auto add = [&](std::span<const scene::VertexIndex> ring) {
    for (std::size_t i = 2; i < ring.size(); ++i) {
      const auto part = geometry::normal_of(vertices[ring[0]], vertices[ring[i - 1]], vertices[ring[i]]);
      for (std::size_t a = 0; a < 3; ++a) sum[a] += part[a];
    }
  };
  add(face.outline);
  for (const auto& hole : face.holes) add(hole);
  return sum;
}

void append(ChosenEdges& chosen, const ChosenEdges& more) {
  chosen.edges.insert(chosen.edges.end(), more.edges.begin(), more.edges.end());
  chosen.kinds.insert(chosen.kinds.end(), more.kinds.begin(), more.kinds.end());
  chosen.turned_away.insert(chosen.turned_away.end(), more.turned_away.begin(), more.turned_away.end());
  const auto before = static_cast<std::uint32_t>(chosen.surfaces.size());
  for (std::size_t e = 1; e < more.first_surface.size(); ++e) chosen.first_surface.push_back(before + more.first_surface[e]);
  chosen.surfaces.insert(chosen.surfaces.end(), more.surfaces.begin(), more.surfaces.end());
}

}  // namespace

std::optional<EdgeChoice> edge_choice_named(std::string_view text) {
  EdgeChoice choice;
  if (text == "feature") return choice;
  if (text == "all") {
    choice.kinds.fill(true);
    return choice;
  }
  choice.kinds.fill(false);
  choice.kinds[number_of(EdgeKind::junction)] = true;
  while (true) {
    const std::size_t comma = text.find(',');
    const auto found = std::find(edge_kind_names.begin(), edge_kind_names.end() - 1, text.substr(0, comma));
    if (found == edge_kind_names.end() - 1) return std::nullopt;
    choice.kinds[static_cast<std::size_t>(found - edge_kind_names.begin())] = true;
    if (comma == std::string_view::npos) return choice;
    text.remove_prefix(comma + 1);
  }
}

std::array<std::size_t, edge_kind_count> ChosenEdges::counts() const {
  std::array<std::size_t, edge_kind_count> result{};
  for (const EdgeKind kind : kinds) ++result[number_of(kind)];
  return result;
}

EdgeChooser::EdgeChooser(const scene::PolyScene& scene, const EdgeChoice& choice, unsigned jobs)
    : scene_(scene), choice_(choice), jobs_(jobs), edges_(scene, jobs), least_cosine_(std::cos(choice.crease * std::numbers::pi / 180)) {
  find_surfaces();
  kinds_.resize(edges_.size());
  base::for_parts(jobs_, edges_.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) kinds_[e] = kind_without_eye(e);
  });
  for (const auto& [from, to] : scene.wires) {
    EdgeKind& kind = kinds_[edges_.find(from, to)];
    if (kind == EdgeKind::flat) kind = EdgeKind::wire;
  }
  for (const auto& [wire, surface] : scene.wires_on)
    wires_on_.push_back({static_cast<std::uint32_t>(edges_.find(scene.wires[wire][0], scene.wires[wire][1])), surface});
  std::sort(wires_on_.begin(), wires_on_.end());
}

void EdgeChooser::find_surfaces() {
  const bool mesh = !scene_.surfaces.empty();
  surfaces_.resize(mesh ? scene_.surfaces.size() : face_count(scene_));
  if (!mesh) directions_.resize(surfaces_.size());
  // Each part has all faces of its surfaces.
  base::for_parts(jobs_, surfaces_.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    std::vector<double> largest(end - begin, -1);  // squared area of a face of each
    std::uint32_t number = 0;
    for (const scene::PolyBody& body : scene_.bodies) {
      for (const scene::PolyFace& face : body.faces) {
        const std::uint32_t of = surface_of(number++);
        if (of < begin || of >= end) continue;
        Surface& surface = surfaces_[of];
        const geometry::Vector3 area = area_of(scene_.vertices, face);
        const double size = square(area);
        for (std::size_t a = 0; a < 3; ++a) surface.normal[a] += area[a];
        surface.solid = !body.sheet;
        if (size <= largest[of - begin]) continue;
        largest[of - begin] = size;
        surface.on = face.outline[0];
      }
    }
    for (std::size_t s = begin; s < end && !mesh; ++s) {
      const Surface& surface = surfaces_[s];
      const double length = std::sqrt(square(surface.normal));
      for (std::size_t a = 0; a < 3; ++a)
        if (length > 0) directions_[s][a] = static_cast<double>(surface.normal[a]) / length;
    }
  });
}

// Whether the angle between two surfaces exceeds that of a crease. `agree`: they pass their edge in opposite directions.
bool EdgeChooser::bends(std::uint32_t a, std::uint32_t b, bool agree) const {
  double cosine = geometry::dot(direction(a), direction(b));
  if (!agree) cosine = -cosine;
  if (choice_.crease > 0) return cosine < least_cosine_;
  if (!scene_.surfaces.empty()) return true;  // they are different surfaces
  const geometry::Vector3& v = surfaces_[a].normal;
  const geometry::Vector3& w = surfaces_[b].normal;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3;
    if (geometry::Int128{v[axis]} * w[next] != geometry::Int128{v[next]} * w[axis]) return true;
  }
  return cosine < 0;
}

EdgeKind EdgeChooser::kind_without_eye(std::size_t edge) const {
  const auto uses = edges_.uses(edge);
  if (uses.empty()) return EdgeKind::wire;
  if (uses.size() > 2) return EdgeKind::junction;
  if (uses.size() == 1) return EdgeKind::boundary;
  const std::uint32_t a = surface_of(uses[0].face);
  const std::uint32_t b = surface_of(uses[1].face);
  const bool agree = uses[0].upwards != uses[1].upwards;
  if (a != b && bends(a, b, agree)) return EdgeKind::crease;
  const auto& materials = scene_.material_of;
  if (!materials.empty() && materials[uses[0].face] != materials[uses[1].face]) return EdgeKind::border;
  return EdgeKind::flat;
}

std::vector<EdgeChooser::Facing> EdgeChooser::facing_of(const scene::PolyCamera& camera) const {
  const geometry::Vector3 forward = geometry::vector_of(camera.forward);
  std::vector<Facing> facing(surfaces_.size());
  base::for_parts(jobs_, surfaces_.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      const Surface& surface = surfaces_[s];
      const geometry::Vector3 sight =
          camera.perspective ? geometry::difference(scene_.vertices[surface.on], camera.eye) : forward;
      facing[s].sign = static_cast<std::int8_t>(-geometry::sign(geometry::wide_dot(surface.normal, sight)));
      facing[s].away = surface.solid && facing[s].sign <= 0;
    }
  });
  return facing;
}

ChosenEdges EdgeChooser::chosen_of(const std::vector<Facing>& facing, std::size_t begin, std::size_t end) const {
  const bool mesh = !scene_.surfaces.empty();
  ChosenEdges chosen;
  // Room for all of them: what is not used takes no memory, and what grows is copied.
  chosen.edges.reserve(end - begin);
  chosen.kinds.reserve(end - begin);
  chosen.turned_away.reserve(end - begin);
  chosen.first_surface.reserve(end - begin + 1);
  if (mesh) chosen.surfaces.reserve(2 * (end - begin));
  auto on = wires_on_.begin();
  for (std::size_t e = begin; e < end; ++e) {
    while (on != wires_on_.end() && (*on)[0] < e) ++on;
    const auto uses = edges_.uses(e);
    EdgeKind kind = kinds_[e];
    bool away = !uses.empty();
    for (const scene::EdgeTable::Use& use : uses) away = away && facing[surface_of(use.face)].away;
    if (uses.size() == 2) {
      const std::uint32_t a = surface_of(uses[0].face);
      const std::uint32_t b = surface_of(uses[1].face);
      // If both pass the edge in the same direction, one of them must be reversed.
      const int facing_b = uses[0].upwards != uses[1].upwards ? facing[b].sign : -facing[b].sign;
      if (a != b && (facing[a].sign > 0) != (facing_b > 0)) kind = EdgeKind::silhouette;
    }
    if (!choice_.kinds[number_of(kind)]) {
      // If silhouettes are not chosen, the edge may still be a chosen crease.
      kind = kinds_[e];
      if (!choice_.kinds[number_of(kind)]) continue;
    }
    chosen.edges.push_back({edges_[e].low, edges_[e].high});
    chosen.kinds.push_back(kind);
    chosen.turned_away.push_back(away ? 1 : 0);
    if (mesh)
      for (const scene::EdgeTable::Use& use : uses) chosen.surfaces.push_back(surface_of(use.face));
    for (; on != wires_on_.end() && (*on)[0] == e; ++on) chosen.surfaces.push_back((*on)[1]);
    chosen.first_surface.push_back(static_cast<std::uint32_t>(chosen.surfaces.size()));
  }
  return chosen;
}

ChosenEdges EdgeChooser::at(const scene::PolyCamera& camera) const {
  const std::vector<Facing> facing = facing_of(camera);
  std::vector<ChosenEdges> parts(jobs_);
  base::for_parts(jobs_, edges_.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    parts[part] = chosen_of(facing, begin, end);
  });
  ChosenEdges chosen = std::move(parts[0]);
  for (std::size_t part = 1; part < parts.size(); ++part) append(chosen, parts[part]);
  if (!choice_.kinds[number_of(EdgeKind::intersection)]) return chosen;
  // Their vertices come after all others.
  for (const scene::PolyCrossing& crossing : scene_.crossings) {
    bool away = false;
    for (const std::uint32_t face : {crossing.face_a, crossing.face_b}) {
      away = away || facing[surface_of(face)].away;
      if (!scene_.surface_of.empty()) chosen.surfaces.push_back(scene_.surface_of[face]);
    }
    chosen.edges.push_back({crossing.from, crossing.to});
    chosen.kinds.push_back(EdgeKind::intersection);
    chosen.turned_away.push_back(away ? 1 : 0);
    chosen.first_surface.push_back(static_cast<std::uint32_t>(chosen.surfaces.size()));
  }
  return chosen;
}

LinePicture only(const LinePicture& picture, const ChosenEdges& chosen) {
  LinePicture result;
  auto edge = chosen.edges.begin();
  for (const LinePiece& piece : picture.pieces) {
    while (edge != chosen.edges.end() && *edge < piece.edge) ++edge;
    if (edge != chosen.edges.end() && *edge == piece.edge) result.pieces.push_back(piece);
  }
  return result;
}

}  // namespace sightline::picture
