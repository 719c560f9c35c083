// Computes the lit dots of a picture of slices, column by column, from depths: the reference for programs in the manner
// of Skala (1985), which rely on receiving slices from the foreground to the background.
//
// The picture consists of chains of straight segments between raster points, each vertex with a depth. In every column of
// the raster, all chains that pass through it are sorted by depth, and the dots of each are compared with the hull of
// everything nearer. Slow and simple: no mask is kept, and no line is drawn with an error term.
//
// - A segment's dots: with greater extent L and lesser extent l, dot j (0..L) counted from the left end (from
//   the given end when the segment is vertical) lies at floor((2 j l + L) / (2 L)) on the lesser axis. So a tie
//   is rounded away from the left end, and a segment has the same dots in both directions.
// - The part of a chain in one column is one piece of the picture. Its dots do not hide each other; for everything
//   behind it, it is one interval from its lowest to its highest dot.
//   lies behind they are one interval, from the lowest to the highest.
// - Depth along a segment is linear in j. Two pieces are not ordered by depth if their depths in the column touch,
//   overlap or differ by no more than `depth_tolerance` (shared vertices, slices seen end-on, vertices rounded to
//   columns), nor if their chains are side by side and meet in this column, because their true ends are somewhere in it.
//   Then the piece of lesser rank is nearer, unless a third piece forces the opposite. Ranks must therefore be right
//   only where depth does not decide.
// - Which pieces are nearer than a test-only piece in a column beside it is decided in the same way, as if the piece
//   were there.
//
// Not modelled: colours and levels, gaps, lines beyond the raster.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <vector>

namespace sightline::algorithms::oracle {

inline constexpr int raster_columns = 256;

// What a segment does. Each segment has its own role, so a chain may be inked in parts.
enum class SegmentRole : std::uint8_t {
  none,   // no segment: the chain starts or is interrupted
  draw,   // lit where strictly outside the hull of everything nearer; hides
  test,   // lit there and in the outermost two rows of the hull, and where it is outside or in the outermost
          // row of the hull of what is nearer in a column beside it; hides nothing
  mask,   // never lit; hides
  shade,  // like draw; also fills the surface down or up to the preceding piece where it is outside the hull
  rim,    // like draw; the surface of a later piece may be filled up to it
};

struct ChainVertex {
  int x = 0;                             // 0..255
  int y = 0;                             // 0..255
  std::int64_t depth = 0;                // greater is farther; magnitude below 2^40
  SegmentRole role = SegmentRole::none;  // of the segment from the vertex before
};

struct ColumnExtent {
  int first = 0;
  int last = 0;
};

// Monotone in x, in either direction. A vertex between two interruptions has no dot; a segment of length 0 has one.
struct Chain {
  int rank = 0;
  std::vector<ChainVertex> vertices;
  // The columns of the flat facet on which a chain of test-only segments lies; if absent, the chain's own columns.
  std::optional<ColumnExtent> facet{};
};

struct ColumnHull {
  int low = 0;
  int high = 0;
};

struct ColumnPicture {
  std::array<std::bitset<raster_columns>, raster_columns> lit;  // lit[x][y]
  std::array<std::optional<ColumnHull>, raster_columns> hull;   // of everything that hides
  // Dots where the surface turns away from the eye: the top (bottom) of a piece that reached above (below) all nearer
  // pieces, if a later piece, before the next one that reaches farther, is wholly below (above) it with at least one row
  // between.
  std::array<std::bitset<raster_columns>, raster_columns> silhouette;
  std::array<std::bitset<raster_columns>, raster_columns> outline;  // the polygon around all hulls
};

[[nodiscard]] ColumnPicture column_picture(const std::vector<Chain>& chains, std::int64_t depth_tolerance);

struct RasterDot {
  int x = 0;
  int y = 0;
  friend bool operator==(const RasterDot&, const RasterDot&) = default;
};
// The dots of the segment from (x0, y0) to (x1, y1), both ends included, in this direction.
[[nodiscard]] std::vector<RasterDot> segment_dots(int x0, int y0, int x1, int y1);

}  // namespace sightline::algorithms::oracle
