#include "host/programs/stripes/face_stripes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "host/programs/stripes/status.hpp"

namespace sightline::programs::stripes {

Stripes stripes_of(const CornerRings& rings, std::size_t& longest) {
  int low = 0xFFFF;
  int high = 0;
  for (const auto& ring : rings) {
    for (const Corner& corner : ring) {
      low = std::min(low, corner.line());
      high = std::max(high, corner.line());
    }
  }
  Stripes stripes;
  stripes.low = low;
  stripes.lines.resize(static_cast<std::size_t>(high - low));
  for (const auto& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      Corner lower = ring[k];
      Corner upper = ring[k + 1 == ring.size() ? 0 : k + 1];
      if (lower.line() == upper.line()) continue;
      if (lower.line() > upper.line()) std::swap(lower, upper);
      const std::int32_t sign = upper.x < lower.x ? -1 : 1;
      const std::int32_t step = (std::abs(upper.x - lower.x) << 8) / (upper.line() - lower.line());
      std::int32_t x = (lower.x << 8) + sign * (step >> 1) + 0x7FFF;
      for (int line = lower.line(); line < upper.line(); ++line, x += sign * step) {
        const auto toggle = static_cast<std::uint8_t>(x >> 16);
        if (toggle == picture_size) continue;
        Toggles& list = stripes.lines[static_cast<std::size_t>(line - stripes.low)];
        const auto at = std::lower_bound(list.begin(), list.end(), toggle);
        if (at != list.end() && *at == toggle)
          list.erase(at);
        else
          list.insert(at, toggle);
        longest = std::max(longest, list.size());
      }
    }
  }
  return stripes;
}

}  // namespace sightline::programs::stripes
