#include "host/harness/skala_twin_masks.hpp"

#include <algorithm>

namespace sightline::harness {
namespace {

constexpr std::uint8_t top_flag = 1;
constexpr std::uint8_t bottom_flag = 2;

}  // namespace

void SkalaMasks::reset() {
  columns_.mask_top.fill(0);
  columns_.mask_bottom.fill(255);
  columns_.fold_flags.fill(0);
  pending_.reset();
}

bool SkalaMasks::outside_with_slack(SkalaPoint point) const {
  const int top = columns_.mask_top[point.x];
  const int bottom = columns_.mask_bottom[point.x];
  return point.y >= std::max(top - 1, 0) || point.y <= std::min(bottom + 1, 255);
}

SkalaFoldPoints SkalaMasks::touch(SkalaPoint point) {
  if (pending_ && pending_->x == point.x) {
    pending_->low = std::min(pending_->low, point.y);
    pending_->high = std::max(pending_->high, point.y);
    return {};
  }
  const SkalaFoldPoints folded = fold();
  pending_ = Pending{point.x, point.y, point.y};
  return folded;
}

SkalaFoldPoints SkalaMasks::fold() {
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

std::optional<SkalaPoint> SkalaMasks::fold_top(const Pending& column) {
  std::uint8_t& mask = columns_.mask_top[column.x];
  std::uint8_t& flags = columns_.fold_flags[column.x];
  if (column.high > mask) {
    mask = column.high;
    flags = static_cast<std::uint8_t>(flags | top_flag);
  } else if ((flags & top_flag) != 0 && column.high < mask - 1) {
    flags = static_cast<std::uint8_t>(flags & ~top_flag);
    return SkalaPoint{column.x, mask};
  }
  return std::nullopt;
}

std::optional<SkalaPoint> SkalaMasks::fold_bottom(const Pending& column) {
  std::uint8_t& mask = columns_.mask_bottom[column.x];
  std::uint8_t& flags = columns_.fold_flags[column.x];
  if (column.low < mask) {
    mask = column.low;
    flags = static_cast<std::uint8_t>(flags | bottom_flag);
  } else if ((flags & bottom_flag) != 0 && column.low > mask + 1) {
    flags = static_cast<std::uint8_t>(flags & ~bottom_flag);
    return SkalaPoint{column.x, mask};
  }
  return std::nullopt;
}

}  // namespace sightline::harness
