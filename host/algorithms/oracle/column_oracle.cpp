#include "host/algorithms/oracle/column_oracle.hpp"

#include <algorithm>
#include <cstdlib>

namespace sightline::algorithms::oracle {
namespace {

struct Dot {
  int y;
  SegmentRole role;
};

// The dots of one chain in one column, in the chain's direction.
struct Piece {
  int rank = 0;
  ColumnExtent extent;  // of its chain
  std::int64_t nearest = 0;
  std::int64_t farthest = 0;
  std::vector<Dot> dots;
};

using Column = std::vector<Piece>;
using Columns = std::array<Column, raster_columns>;

[[nodiscard]] std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
  return a / b - (a % b < 0 ? 1 : 0);
}

// Collects the pieces of one chain by column. Only the column added to last is open.
class PieceCollector {
 public:
  PieceCollector(Columns& columns, int rank, ColumnExtent extent)
      : columns_(columns), rank_(rank), extent_(extent) {}

  // depth_low <= true depth <= depth_high
  void add(const RasterDot& dot, SegmentRole role, std::int64_t depth_low, std::int64_t depth_high) {
    Column& column = columns_[static_cast<std::size_t>(dot.x)];
    if (open_column_ != dot.x) {
      open_column_ = dot.x;
      column.push_back({rank_, extent_, depth_low, depth_high, {}});
    }
    Piece& piece = column.back();
    piece.nearest = std::min(piece.nearest, depth_low);
    piece.farthest = std::max(piece.farthest, depth_high);
    piece.dots.push_back({dot.y, role});
  }

 private:
  Columns& columns_;
  int rank_;
  ColumnExtent extent_;
  int open_column_ = -1;
};

[[nodiscard]] ColumnExtent extent_of(const Chain& chain) {
  if (chain.facet) return *chain.facet;
  ColumnExtent extent{raster_columns, -1};
  for (const ChainVertex& vertex : chain.vertices)
    extent = {std::min(extent.first, vertex.x), std::max(extent.last, vertex.x)};
  return extent;
}

void collect(Columns& columns, const Chain& chain) {
  PieceCollector pieces(columns, chain.rank, extent_of(chain));
  bool start_pending = true;
  for (std::size_t i = 1; i < chain.vertices.size(); ++i) {
    const ChainVertex& a = chain.vertices[i - 1];
    const ChainVertex& b = chain.vertices[i];
    if (b.role == SegmentRole::none) {
      start_pending = true;
      continue;
    }
    const auto dots = segment_dots(a.x, a.y, b.x, b.y);
    const auto length = static_cast<std::int64_t>(dots.size()) - 1;
    for (std::int64_t j = start_pending ? 0 : 1; j <= length; ++j) {
      const std::int64_t span = std::max<std::int64_t>(length, 1);
      const std::int64_t weighted = (b.depth - a.depth) * j;
      pieces.add(dots[static_cast<std::size_t>(j)], b.role, a.depth + floor_divide(weighted, span),
                 a.depth - floor_divide(-weighted, span));
    }
    // A vertex between a segment without ink and a segment with ink is a dot of both.
    start_pending = b.role == SegmentRole::mask;
  }
}

[[nodiscard]] bool hides(const Piece& piece) {
  return std::any_of(piece.dots.begin(), piece.dots.end(),
                     [](const Dot& dot) { return dot.role != SegmentRole::test; });
}

// Whether two chains are side by side and meet in a column. A chain within one column never is.
[[nodiscard]] bool adjoining(ColumnExtent a, ColumnExtent b) {
  const bool wide = a.first != a.last && b.first != b.last;
  return wide && (a.last == b.first || b.last == a.first);
}

// Whether depth alone decides that a is nearer. Two pieces that hide nothing need no order.
[[nodiscard]] bool clearly_nearer(const Piece& a, const Piece& b, std::int64_t tolerance) {
  return a.farthest + tolerance < b.nearest && !adjoining(a.extent, b.extent) && (hides(a) || hides(b));
}

// Nearest first. Among the pieces that no remaining piece is clearly nearer than, the one of the least rank is next.
[[nodiscard]] Column in_order(Column pieces, std::int64_t tolerance) {
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.rank < b.rank; });
  Column ordered;
  while (!pieces.empty()) {
    const auto next = std::find_if(pieces.begin(), pieces.end(), [&](const Piece& piece) {
      return std::none_of(pieces.begin(), pieces.end(),
                          [&](const Piece& other) { return clearly_nearer(other, piece, tolerance); });
    });
    ordered.push_back(std::move(*next));
    pieces.erase(next);
  }
  return ordered;
}

[[nodiscard]] std::optional<ColumnHull> hull_of(const Piece& piece) {
  std::optional<ColumnHull> hull;
  for (const Dot& dot : piece.dots) {
    if (dot.role == SegmentRole::test) continue;
    if (!hull) hull = ColumnHull{dot.y, dot.y};
    hull->low = std::min(hull->low, dot.y);
    hull->high = std::max(hull->high, dot.y);
  }
  return hull;
}

[[nodiscard]] bool shaded(SegmentRole role) {
  return role == SegmentRole::shade || role == SegmentRole::rim;
}

// The y of the last shaded dot of the first `count` pieces.
[[nodiscard]] std::optional<int> surface_before(const Column& pieces, std::size_t count) {
  for (std::size_t i = count; i-- > 0;)
    for (auto dot = pieces[i].dots.rbegin(); dot != pieces[i].dots.rend(); ++dot)
      if (shaded(dot->role)) return dot->y;
  return std::nullopt;
}

// Lights the dots strictly between the two, which lie on the surface. The dot at `from` belongs to the slice itself.
void light_surface(std::bitset<raster_columns>& lit, int from, int to,
                   const std::optional<ColumnHull>& nearer) {
  for (int y = std::min(from, to) + 1; y < std::max(from, to); ++y)
    if (!nearer || y > nearer->high || y < nearer->low) lit.set(static_cast<std::size_t>(y));
}

[[nodiscard]] std::optional<ColumnHull> joined(const std::optional<ColumnHull>& a,
                                               const std::optional<ColumnHull>& b) {
  if (!a || !b) return a ? a : b;
  return ColumnHull{std::min(a->low, b->low), std::max(a->high, b->high)};
}

// The hull of the pieces in another column, which are in order, that would be nearer than this piece if it were there.
[[nodiscard]] std::optional<ColumnHull> hull_nearer_than(const Piece& piece, const Column& others,
                                                         std::int64_t tolerance) {
  const auto last_nearer = std::find_if(others.rbegin(), others.rend(), [&](const Piece& other) {
    return clearly_nearer(other, piece, tolerance);
  });
  const auto end = std::find_if(last_nearer.base(), others.end(), [&](const Piece& other) {
    return other.rank >= piece.rank || clearly_nearer(piece, other, tolerance);
  });
  std::optional<ColumnHull> hull;
  for (auto other = others.begin(); other != end; ++other) hull = joined(hull, hull_of(*other));
  return hull;
}

[[nodiscard]] bool test_only(const Piece& piece) {
  return std::all_of(piece.dots.begin(), piece.dots.end(),
                     [](const Dot& dot) { return dot.role == SegmentRole::test; });
}

// The hulls of the pieces nearer than a test-only piece in the columns beside it, if there are any.
[[nodiscard]] std::vector<ColumnHull> hulls_beside(const Columns& columns, int x, const Piece& piece,
                                                   std::int64_t tolerance) {
  std::vector<ColumnHull> hulls;
  if (!test_only(piece)) return hulls;
  for (const int beside : {x - 1, x + 1}) {
    if (beside < 0 || beside >= raster_columns) continue;
    const auto hull = hull_nearer_than(piece, columns[static_cast<std::size_t>(beside)], tolerance);
    if (hull) hulls.push_back(*hull);
  }
  return hulls;
}

void light_piece(std::bitset<raster_columns>& lit, const Column& pieces, std::size_t number,
                 const std::optional<ColumnHull>& nearer, const std::vector<ColumnHull>& beside) {
  const Piece& piece = pieces[number];
  for (const Dot& dot : piece.dots) {
    const int slack = dot.role == SegmentRole::test ? 2 : 0;
    const bool outside = !nearer || dot.y > nearer->high - slack || dot.y < nearer->low + slack;
    const bool outside_beside = std::any_of(beside.begin(), beside.end(), [&](const ColumnHull& hull) {
      return dot.y >= hull.high || dot.y <= hull.low;
    });
    if ((outside || outside_beside) && dot.role != SegmentRole::mask)
      lit.set(static_cast<std::size_t>(dot.y));
  }
  const auto entry =
      std::find_if(piece.dots.begin(), piece.dots.end(), [](const Dot& dot) { return shaded(dot.role); });
  if (entry == piece.dots.end() || entry->role != SegmentRole::shade) return;
  const bool entry_outside = !nearer || entry->y > nearer->high || entry->y < nearer->low;
  const auto before = surface_before(pieces, number);
  if (entry_outside && before) light_surface(lit, entry->y, *before, nearer);
}

// The records (new maxima, except the first value) after which, before the next record, a value is less than its guard by
// more than one.
[[nodiscard]] std::vector<int> records_left(const std::vector<int>& values, const std::vector<int>& guards) {
  std::vector<int> left;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(i);
    if (values[i] <= *std::max_element(values.begin(), at)) continue;
    const auto next = std::find_if(at, values.end(), [&](int value) { return value > values[i]; });
    if (std::any_of(at, next, [&](int value) { return value + 1 < guards[i]; })) left.push_back(values[i]);
  }
  return left;
}

[[nodiscard]] std::vector<int> negated(std::vector<int> values) {
  for (int& value : values) value = -value;
  return values;
}

void take_column(ColumnPicture& picture, std::size_t x, const Columns& columns, std::int64_t tolerance) {
  const Column& pieces = columns[x];
  std::vector<int> highs;
  std::vector<int> lows;
  std::optional<ColumnHull>& nearer = picture.hull[x];
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    light_piece(picture.lit[x], pieces, i, nearer,
                hulls_beside(columns, static_cast<int>(x), pieces[i], tolerance));
    const auto own = hull_of(pieces[i]);
    if (!own) continue;
    highs.push_back(own->high);
    lows.push_back(own->low);
    nearer = joined(nearer, own);
  }
  for (const int y : records_left(highs, lows)) picture.silhouette[x].set(static_cast<std::size_t>(y));
  for (const int y : records_left(negated(lows), negated(highs)))
    picture.silhouette[x].set(static_cast<std::size_t>(-y));
}

void outline_segment(ColumnPicture& picture, int x0, int y0, int x1, int y1) {
  for (const RasterDot& dot : segment_dots(x0, y0, x1, y1))
    picture.outline[static_cast<std::size_t>(dot.x)].set(static_cast<std::size_t>(dot.y));
}

void take_outline(ColumnPicture& picture) {
  for (int x = 0; x < raster_columns; ++x) {
    const auto& here = picture.hull[static_cast<std::size_t>(x)];
    if (!here) continue;
    const auto& before = picture.hull[static_cast<std::size_t>(std::max(x - 1, 0))];
    const bool next_exists =
        x + 1 < raster_columns && picture.hull[static_cast<std::size_t>(x) + 1].has_value();
    if (x > 0 && before) {
      outline_segment(picture, x - 1, before->high, x, here->high);
      outline_segment(picture, x - 1, before->low, x, here->low);
    } else {
      outline_segment(picture, x, here->high, x, here->low);
    }
    if (!next_exists) outline_segment(picture, x, here->high, x, here->low);
  }
}

}  // namespace

std::vector<RasterDot> segment_dots(int x0, int y0, int x1, int y1) {
  if (x1 < x0) {
    auto dots = segment_dots(x1, y1, x0, y0);
    std::reverse(dots.begin(), dots.end());
    return dots;
  }
  const int width = x1 - x0;
  const int height = std::abs(y1 - y0);
  const int up = y1 < y0 ? -1 : 1;
  const int length = std::max(width, height);
  const auto on_lesser_axis = [&](int j, int extent) {
    return length == 0 ? 0 : (2 * j * extent + length) / (2 * length);
  };
  std::vector<RasterDot> dots;
  for (int j = 0; j <= length; ++j)
    dots.push_back({x0 + (width == length ? j : on_lesser_axis(j, width)),
                    y0 + up * (height == length ? j : on_lesser_axis(j, height))});
  return dots;
}

ColumnPicture column_picture(const std::vector<Chain>& chains, std::int64_t depth_tolerance) {
  Columns columns;
  for (const Chain& chain : chains) collect(columns, chain);
  for (Column& column : columns) column = in_order(std::move(column), depth_tolerance);
  ColumnPicture picture;
  for (std::size_t x = 0; x < columns.size(); ++x) take_column(picture, x, columns, depth_tolerance);
  take_outline(picture);
  return picture;
}

}  // namespace sightline::algorithms::oracle
