// Pieces of Jones's program as pieces of the scene's lines: which line a vector word of core is on, and where
// on the screen a piece lies. See lines.hpp.
#include <cstddef>

#include "host/compare/lines.hpp"

namespace sightline::compare {
namespace {

using picture::DrawnPiece;

constexpr double screen_centre = 512;  // of the one window of a mono view

// Two's complement of 18 bits.
std::int32_t number_in(std::uint32_t word) {
  return word & 0400000 ? static_cast<std::int32_t>(word) - (1 << 18) : static_cast<std::int32_t>(word);
}

class VectorWalk {
 public:
  explicit VectorWalk(const guests::jones::EncodedScene& scene) : scene_(scene) {}

  // `at`: the address of X, which Y Z n and the vectors follow.
  void walk(std::uint32_t at) {
    geometry::Point pen{number(at), number(at + 1), number(at + 2)};
    const std::int32_t vectors = number(at + 3);
    for (std::int32_t i = 0; i < vectors; ++i) {
      const std::uint32_t address = at + 4 + static_cast<std::uint32_t>(i);
      const std::uint32_t word = scene_.words[address - scene_.base].value;
      const std::size_t axis = (word >> 15 & 3U) - 1;
      const auto [u, v] = geometry::other_axes(axis);
      lines_[address] = AxisLine{axis, {pen[u], pen[v]}};
      const auto magnitude = static_cast<std::int32_t>(word & 0077777);
      pen[axis] += magnitude >= 1 << 14 ? magnitude - (1 << 15) : magnitude;
    }
  }
  [[nodiscard]] std::map<std::uint32_t, AxisLine> take() && { return std::move(lines_); }

 private:
  [[nodiscard]] std::int32_t number(std::uint32_t address) const {
    return number_in(scene_.words[address - scene_.base].value);
  }

  const guests::jones::EncodedScene& scene_;
  std::map<std::uint32_t, AxisLine> lines_;
};

template <class ToPixel>
std::vector<DrawnPiece> pieces_of(const guests::jones::View& view,
                                  const std::map<std::uint32_t, AxisLine>& vectors,
                                  const CellReference& reference, ToPixel&& pixel) {
  std::vector<DrawnPiece> pieces;
  for (const auto& piece : view.pieces) {
    const picture::PixelSegment image{{pixel(piece.line.a.x), pixel(piece.line.a.y)},
                                      {pixel(piece.line.b.x), pixel(piece.line.b.y)}};
    if (image.a.x == image.b.x && image.a.y == image.b.y) continue;
    pieces.push_back({reference.number_of(vectors.at(piece.vector_address)), image});
  }
  return pieces;
}

}  // namespace

std::map<std::uint32_t, AxisLine> lines_of_vectors(const guests::jones::EncodedScene& scene) {
  VectorWalk walk(scene);
  for (const std::uint32_t cell : scene.cell_addresses) walk.walk(cell);
  for (const std::uint32_t opening : scene.opening_addresses) walk.walk(opening + 2);
  return std::move(walk).take();
}

std::vector<DrawnPiece> twin_pieces(const guests::jones::View& view,
                                    const std::map<std::uint32_t, AxisLine>& vectors,
                                    const CellReference& reference) {
  return pieces_of(view, vectors, reference, [](std::int32_t half) { return 0.5 * half + screen_centre; });
}

std::vector<DrawnPiece> display_pieces(const guests::jones::View& view,
                                       const std::map<std::uint32_t, AxisLine>& vectors,
                                       const CellReference& reference) {
  return pieces_of(view, vectors, reference,
                   [](std::int32_t half) { return static_cast<double>((half + 1) >> 1) + screen_centre; });
}

}  // namespace sightline::compare
