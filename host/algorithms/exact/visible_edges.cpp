#include "host/algorithms/exact/visible_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "host/algorithms/exact/face_shadow.hpp"
#include "host/algorithms/exact/image_grid.hpp"
#include "host/algorithms/exact/view.hpp"

namespace sightline::algorithms::exact {
namespace {

// What a search without a listener tells: nothing, and the compiler leaves it out.
struct Unwatched {
  void edge(const picture::LineEdge&) {}
  void compared(const picture::LineEdge&, const Occluder&, bool, const EdgeShadow&) {}
  void result(const picture::LineEdge&, bool, std::span<const picture::LinePiece>) {}
};

// Tells a Trace what is seen of an edge after each comparison.
class Watched {
 public:
  Watched(const EdgeMesh& mesh, Trace& trace) : mesh_(mesh), trace_(trace) {}

  void edge(const picture::LineEdge& edge) { trace_.edge(edge); }
  void compared(const picture::LineEdge& edge, const Occluder& occluder, bool hidden, const EdgeShadow& shadow) {
    std::vector<picture::LinePiece> left;
    if (!hidden) shadow.append_visible(left);
    const auto face = std::lower_bound(
        mesh_.faces.begin(), mesh_.faces.end(), occluder.first_corner,
        [](const MeshFace& f, std::uint32_t corner) { return f.first_corner < corner; });
    trace_.compared(edge, static_cast<std::uint32_t>(face - mesh_.faces.begin()), left);
  }
  void result(const picture::LineEdge& edge, bool drawn, std::span<const picture::LinePiece> pieces) {
    trace_.result(edge, drawn, pieces);
  }

 private:
  const EdgeMesh& mesh_;
  Trace& trace_;
};

// Holds one edge after the other against the occluders near it.
template <class Listener>
class Search {
 public:
  Search(const View& view, Listener listener)
      : view_(view), grid_(view), shadow_(view), met_(view.occluders.size()), listener_(listener) {}

  // Faces of the surfaces `beside` do not hide the edge.
  void append_visible(std::uint32_t edge, std::span<const std::uint32_t> beside,
                      std::vector<picture::LinePiece>& pieces) {
    beside_ = beside;
    shadow_.begin(edge);
    listener_.edge(view_.mesh->edges[edge]);
    const picture::LineEdge& ends = view_.mesh->edges[edge];
    const std::int64_t depth = std::max(view_.depths[ends.from], view_.depths[ends.to]);
    const ImageBounds& bounds = view_.bounds[edge];
    const ImageGrid::Cells cells = grid_.cells_of(bounds);
    for (std::uint32_t row = cells.low[1]; row <= cells.high[1]; ++row) {
      for (std::uint32_t column = cells.low[0]; column <= cells.high[0]; ++column) {
        if (hidden_in(column, row, edge, bounds, depth)) return;
      }
    }
    shadow_.append_visible(pieces);
  }

 private:
  bool hidden_in(std::uint32_t column, std::uint32_t row, std::uint32_t edge, const ImageBounds& bounds,
                 std::int64_t depth) {
    for (const std::uint32_t index : grid_.occluders_at(column, row)) {
      const Occluder& occluder = view_.occluders[index];
      if (occluder.depth >= depth) return false;
      if (met_[index] == edge + 1) continue;
      met_[index] = edge + 1;
      if (!occluder.bounds.meets(bounds) || is_beside(occluder)) continue;
      const bool hidden = shadow_.add(occluder);
      listener_.compared(view_.mesh->edges[edge], occluder, hidden, shadow_);
      if (hidden) return true;
    }
    return false;
  }

  [[nodiscard]] bool is_beside(const Occluder& occluder) const {
    for (const std::uint32_t surface : beside_)
      if (surface == occluder.surface) return true;
    return false;
  }

  const View& view_;
  ImageGrid grid_;
  EdgeShadow shadow_;
  std::vector<std::uint32_t> met_;  // the edge, plus one, that an occluder was last compared with
  Listener listener_;
  std::span<const std::uint32_t> beside_;
};

template <class Listener>
picture::LinePicture search_edges(const EdgeMesh& mesh, const scene::PolyCamera& camera, Listener listener,
                                  const picture::ChosenEdges* chosen = nullptr) {
  const View view = make_view(mesh, camera, chosen);
  Search<Listener> search(view, listener);
  picture::LinePicture picture;
  std::size_t next = 0;  // of those chosen
  for (std::uint32_t edge = 0; edge < mesh.edges.size(); ++edge) {
    const std::size_t before = picture.pieces.size();
    if (view.drawn[edge] != 0) {
      std::span<const std::uint32_t> beside;
      if (chosen != nullptr) {
        while (chosen->edges[next] < mesh.edges[edge]) ++next;
        beside = chosen->surfaces_at(next);
      }
      search.append_visible(edge, beside, picture.pieces);
    }
    listener.result(mesh.edges[edge], view.drawn[edge] != 0, std::span(picture.pieces).subspan(before));
  }
  return picture;
}

}  // namespace

picture::LinePicture visible_edges(const EdgeMesh& mesh, const scene::PolyCamera& camera,
                                   const picture::ChosenEdges* chosen) {
  return search_edges(mesh, camera, Unwatched(), chosen);
}

picture::LinePicture visible_edges(const scene::PolyScene& scene, const scene::PolyCamera& camera, Trace& trace) {
  const EdgeMesh mesh = make_edge_mesh(scene);
  return search_edges(mesh, camera, Watched(mesh, trace));
}

picture::LinePicture visible_edges(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  return visible_edges(make_edge_mesh(scene), camera);
}

}  // namespace sightline::algorithms::exact
