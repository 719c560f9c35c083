#include "host/algorithms/montani_re/boundary_trace.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>

namespace sightline::algorithms::montani_re {
namespace {

// Pieces sorted by start point, then by heading.
class Departures {
 public:
  explicit Departures(std::span<const BoundaryPiece> pieces)
      : pieces_(pieces), order_(pieces.size()), walked_(pieces.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    std::sort(order_.begin(), order_.end(), [pieces](std::uint32_t a, std::uint32_t b) {
      return std::tie(pieces[a].from, pieces[a].leaving, a) < std::tie(pieces[b].from, pieces[b].leaving, b);
    });
  }

  [[nodiscard]] bool walked(std::uint32_t piece) const { return walked_[piece] != 0; }
  void walk(std::uint32_t piece) { walked_[piece] = 1; }

  // The first unused piece clockwise from the way back.
  [[nodiscard]] std::uint32_t sharpest_left(const BoundaryPiece& arrived) const {
    const auto [low, high] = leaving(arrived.to);
    auto it = std::lower_bound(low, high, arrived.back, [this](std::uint32_t piece, std::int64_t heading) {
      return pieces_[piece].leaving < heading;
    });
    for (auto left = high - low; left > 0; --left) {
      if (it == low) it = high;
      --it;
      if (!walked(*it)) return *it;
    }
    return *low;
  }

 private:
  using Iterator = std::vector<std::uint32_t>::const_iterator;

  [[nodiscard]] std::pair<Iterator, Iterator> leaving(std::uint32_t point) const {
    const auto low =
        std::lower_bound(order_.begin(), order_.end(), point,
                         [this](std::uint32_t a, std::uint32_t p) { return pieces_[a].from < p; });
    const auto high = std::upper_bound(
        low, order_.end(), point, [this](std::uint32_t p, std::uint32_t a) { return p < pieces_[a].from; });
    return {low, high};
  }

  std::span<const BoundaryPiece> pieces_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint8_t> walked_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> trace_boundary(std::span<const BoundaryPiece> pieces) {
  std::vector<std::vector<std::uint32_t>> loops;
  Departures departures(pieces);
  for (std::uint32_t start = 0; start < pieces.size(); ++start) {
    if (departures.walked(start)) continue;
    // A loop is closed when the next piece would be its first one. Reaching its first point is not enough: the loop may
    // touch itself there.
    std::vector<std::uint32_t> loop{start};
    for (;;) {
      const std::uint32_t next = departures.sharpest_left(pieces[loop.back()]);
      if (next == start || departures.walked(next)) break;
      departures.walk(next);
      loop.push_back(next);
    }
    departures.walk(start);
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace sightline::algorithms::montani_re
