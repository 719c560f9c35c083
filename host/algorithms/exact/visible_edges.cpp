#include "host/algorithms/exact/visible_edges.hpp"

#include <algorithm>
#include <cstddef>

#include "host/algorithms/exact/face_shadow.hpp"
#include "host/algorithms/exact/image_grid.hpp"
#include "host/algorithms/exact/view.hpp"

namespace sightline::algorithms::exact {
namespace {

// Holds one edge after the other against the occluders near it.
class Search {
 public:
  explicit Search(const View& view) : view_(view), grid_(view), shadow_(view), met_(view.occluders.size()) {}

  void append_visible(std::uint32_t edge, std::vector<picture::LinePiece>& pieces) {
    shadow_.begin(edge);
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
      if (occluder.bounds.meets(bounds) && shadow_.add(occluder)) return true;
    }
    return false;
  }

  const View& view_;
  ImageGrid grid_;
  EdgeShadow shadow_;
  std::vector<std::uint32_t> met_;  // the edge, plus one, that an occluder was last compared with
};

}  // namespace

picture::LinePicture visible_edges(const EdgeMesh& mesh, const scene::PolyCamera& camera) {
  const View view = make_view(mesh, camera);
  Search search(view);
  picture::LinePicture picture;
  for (std::uint32_t edge = 0; edge < mesh.edges.size(); ++edge) {
    if (view.drawn[edge] != 0) search.append_visible(edge, picture.pieces);
  }
  return picture;
}

picture::LinePicture visible_edges(const scene::PolyScene& scene, const scene::PolyCamera& camera) {
  return visible_edges(make_edge_mesh(scene), camera);
}

}  // namespace sightline::algorithms::exact
