#include "host/programs/skala/twin/masks.hpp"

#include <algorithm>

namespace sightline::programs::skala {

void Masks::reset() {
  columns_.mask_top.fill(0);
  columns_.mask_bottom.fill(255);
  columns_.raised_from.fill(0);
  columns_.lowered_from.fill(255);
  pending_.reset();
}

bool Masks::outside_with_slack(Point point) const {
  const int top = columns_.mask_top[point.x];
  const int bottom = columns_.mask_bottom[point.x];
  if (point.y >= std::max(top - 1, 0) || point.y <= std::min(bottom + 1, 255)) return true;
  const auto shown_beside = [&](int x) {
    if (x < 0 || x > 255 || !visited(static_cast<std::uint8_t>(x))) return false;
    const Point beside{static_cast<std::uint8_t>(x), point.y};
    return outside(beside) || on_border(beside);
  };
  return shown_beside(point.x - 1) || shown_beside(point.x + 1);
}

FoldLines Masks::touch(Point point) {
  if (direct_) {
    pending_ = Pending{point.x, point.y, point.y};
    return fold();
  }
  if (pending_ && pending_->x == point.x) {
    pending_->low = std::min(pending_->low, point.y);
    pending_->high = std::max(pending_->high, point.y);
    return {};
  }
  const FoldLines folded = fold();
  pending_ = Pending{point.x, point.y, point.y};
  return folded;
}

FoldLines Masks::fold() {
  if (!pending_) return {};
  const Pending column = *pending_;
  pending_.reset();
  if (!visited(column.x)) {
    columns_.mask_top[column.x] = column.high;
    columns_.mask_bottom[column.x] = column.low;
    return {};
  }
  const auto top = fold_top(column);
  const auto bottom = fold_bottom(column);
  return {top, bottom};
}

std::optional<FoldLine> Masks::fold_top(const Pending& column) {
  std::uint8_t& mask = columns_.mask_top[column.x];
  std::uint8_t& raised_from = columns_.raised_from[column.x];
  if (column.high > mask) {
    mask = column.high;
    raised_from = column.low;
    return std::nullopt;
  }
  if (column.high + 1 >= raised_from) return std::nullopt;
  raised_from = 0;
  int end = mask;
  for (const std::uint8_t x : visited_neighbours(column.x)) end = std::min(end, columns_.mask_top[x] + 1);
  return FoldLine{column.x, mask, static_cast<std::uint8_t>(end)};
}

std::optional<FoldLine> Masks::fold_bottom(const Pending& column) {
  std::uint8_t& mask = columns_.mask_bottom[column.x];
  std::uint8_t& lowered_from = columns_.lowered_from[column.x];
  if (column.low < mask) {
    mask = column.low;
    lowered_from = column.high;
    return std::nullopt;
  }
  if (column.low <= lowered_from + 1) return std::nullopt;
  lowered_from = 255;
  int end = mask;
  for (const std::uint8_t x : visited_neighbours(column.x)) end = std::max(end, columns_.mask_bottom[x] - 1);
  return FoldLine{column.x, mask, static_cast<std::uint8_t>(end)};
}

std::vector<std::uint8_t> Masks::visited_neighbours(std::uint8_t x) const {
  std::vector<std::uint8_t> neighbours;
  if (x > 0 && visited(static_cast<std::uint8_t>(x - 1)))
    neighbours.push_back(static_cast<std::uint8_t>(x - 1));
  if (x < 255 && visited(static_cast<std::uint8_t>(x + 1)))
    neighbours.push_back(static_cast<std::uint8_t>(x + 1));
  return neighbours;
}

}  // namespace sightline::programs::skala
