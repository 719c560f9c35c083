#include "host/algorithms/montani_re/trapezoid_pcs.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace sightline::algorithms::montani_re {

Combiner::Combiner(const Image& image, Operation operation) : image_(image), operation_(operation) {
  for (std::size_t in = 0; in < kept_.size(); ++in)
    kept_[in] = kept(operation, (in & inside_a) != 0, (in & inside_b) != 0);
}

void Combiner::operator()(TrapezoidPcs& a, const TrapezoidPcs& b) {
  result_.bands.clear();
  result_.sides.clear();
  run(a, b);
  std::swap(a, result_);
}

void Combiner::run(const TrapezoidPcs& a_pcs, const TrapezoidPcs& b_pcs) {
  std::size_t i = 0;
  std::size_t j = 0;
  const Ordinate* reached = nullptr;
  while (i < a_pcs.bands.size() || j < b_pcs.bands.size()) {
    const bool need_a = operation_ != Operation::unite && i == a_pcs.bands.size();
    const bool need_b = operation_ == Operation::intersect && j == b_pcs.bands.size();
    if (need_a || need_b) break;
    const Band* a = i < a_pcs.bands.size() ? &a_pcs.bands[i] : nullptr;
    const Band* b = j < b_pcs.bands.size() ? &b_pcs.bands[j] : nullptr;
    const Ordinate* from_a = a == nullptr ? nullptr : later(a->low, reached);
    const Ordinate* from_b = b == nullptr ? nullptr : later(b->low, reached);
    const int first = from_a == nullptr ? 1 : from_b == nullptr ? -1 : image_.compare(*from_a, *from_b);
    const bool in_a = first <= 0;
    const bool in_b = first >= 0;
    const Ordinate* low = in_a ? from_a : from_b;
    const Ordinate* high = earlier(a == nullptr ? nullptr
                                   : in_a       ? &a->high
                                                : &a->low,
                                   b == nullptr ? nullptr
                                   : in_b       ? &b->high
                                                : &b->low);
    append(*low, *high, in_a ? a_pcs.sides_of(*a) : std::span<const Side>{},
           in_b ? b_pcs.sides_of(*b) : std::span<const Side>{});
    if (in_a && image_.compare(a->high, *high) == 0) ++i;
    if (in_b && image_.compare(b->high, *high) == 0) ++j;
    reached = high;
  }
}

const Ordinate* Combiner::later(const Ordinate& low, const Ordinate* reached) const {
  return reached != nullptr && image_.compare(*reached, low) > 0 ? reached : &low;
}

const Ordinate* Combiner::earlier(const Ordinate* one, const Ordinate* other) const {
  if (one == nullptr || other == nullptr) return one == nullptr ? other : one;
  return image_.compare(*one, *other) <= 0 ? one : other;
}

void Combiner::append(const Ordinate& low, const Ordinate& high, std::span<const Side> a,
                      std::span<const Side> b) {
  if (a.empty() && operation_ != Operation::unite) return;
  if (b.empty() && operation_ == Operation::intersect) return;
  if (a.empty() || b.empty()) {
    append_band(image_, result_, low, high, a.empty() ? b : a);
    return;
  }
  Ordinate from = low;
  for (;;) {
    merge(from, high, a, b);
    const Ordinate* crossing = nullptr;
    Ordinate lowest;
    for (std::size_t k = 0; k + 1 < row_.size(); ++k) {
      const std::uint32_t west = row_[k].side.line;
      const std::uint32_t east = row_[k + 1].side.line;
      if (row_[k].of_a == row_[k + 1].of_a || image_.order_at(west, east, high) <= 0) continue;
      const Ordinate here = image_.crossing(west, east);
      if (crossing == nullptr || image_.compare(here, lowest) < 0) lowest = here;
      crossing = &lowest;
    }
    toggle(from, high);
    append_band(image_, result_, from, crossing != nullptr ? lowest : high, out_);
    if (crossing == nullptr) return;
    from = lowest;
  }
}

// Both rows in the order just above `from`.
void Combiner::merge(const Ordinate& from, const Ordinate& high, std::span<const Side> a,
                     std::span<const Side> b) {
  row_.resize(a.size() + b.size());
  std::size_t i = 0;
  std::size_t j = 0;
  bool coincide = false;
  while (i < a.size() || j < b.size()) {
    bool take_a = j == b.size();
    bool equal = false;
    if (!take_a && i < a.size()) {
      int order = image_.order_at(a[i].line, b[j].line, from);
      if (order == 0) order = image_.order_at(a[i].line, b[j].line, high);
      take_a = order <= 0;
      equal = order == 0;
    }
    row_[i + j] = {take_a ? a[i] : b[j], take_a, coincide};
    ++(take_a ? i : j);
    coincide = equal;
  }
}

// The sides of the result: sides that coincide are passed at once.
void Combiner::toggle(const Ordinate& from, const Ordinate& high) {
  out_.clear();
  std::size_t in = 0;
  for (std::size_t k = 0; k < row_.size(); ++k) {
    const bool before = kept_[in];
    Side side{row_[k].side.line, row_[k].of_a && row_[k].side.own};
    in ^= row_[k].of_a ? inside_a : inside_b;
    for (; k + 1 < row_.size() && coincides(k + 1, from, high); ++k) {
      const Member& next = row_[k + 1];
      in ^= next.of_a ? inside_a : inside_b;
      if (next.of_a) side = {next.side.line, side.own || next.side.own};
    }
    if (kept_[in] != before) out_.push_back(side);
  }
}

// A side with the one before it.
bool Combiner::coincides(std::size_t k, const Ordinate& from, const Ordinate& high) const {
  const Member& west = row_[k - 1];
  const Member& east = row_[k];
  if (west.of_a != east.of_a) return east.coincides;
  return image_.order_at(west.side.line, east.side.line, from) == 0 &&
         image_.order_at(west.side.line, east.side.line, high) == 0;
}

void append_band(const Image& image, TrapezoidPcs& pcs, const Ordinate& low, const Ordinate& high,
                 std::span<const Side> sides) {
  if (sides.empty()) return;
  if (!pcs.bands.empty()) {
    Band& last = pcs.bands.back();
    const auto before = pcs.sides_of(last);
    if (std::equal(before.begin(), before.end(), sides.begin(), sides.end()) &&
        image.compare(last.high, low) == 0) {
      last.high = high;
      return;
    }
  }
  pcs.bands.push_back(
      {low, high, static_cast<std::uint32_t>(pcs.sides.size()), static_cast<std::uint32_t>(sides.size())});
  pcs.sides.insert(pcs.sides.end(), sides.begin(), sides.end());
}

TrapezoidPcs trapezoid_pcs(const Image& image, std::span<const std::uint32_t> lines) {
  struct Span {
    std::uint32_t line = 0;
    Ordinate low;
    Ordinate high;
  };
  std::vector<Span> spans;
  std::vector<Ordinate> levels;
  spans.reserve(lines.size());
  levels.reserve(2 * lines.size());
  for (const std::uint32_t line : lines) {
    if (image.lines()[line].horizontal()) continue;
    Span span{line, image.ordinate_of(image.lines()[line].from), image.ordinate_of(image.lines()[line].to)};
    if (image.compare(span.low, span.high) > 0) std::swap(span.low, span.high);
    spans.push_back(span);
    levels.push_back(span.low);
    levels.push_back(span.high);
  }
  std::sort(levels.begin(), levels.end(),
            [&image](const Ordinate& a, const Ordinate& b) { return image.compare(a, b) < 0; });
  levels.erase(
      std::unique(levels.begin(), levels.end(),
                  [&image](const Ordinate& a, const Ordinate& b) { return image.compare(a, b) == 0; }),
      levels.end());
  TrapezoidPcs pcs;
  pcs.bands.reserve(levels.size());
  pcs.sides.reserve(2 * levels.size());
  std::vector<Side> sides;
  sides.reserve(spans.size());
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    sides.clear();
    for (const Span& span : spans) {
      if (image.compare(span.low, levels[k]) <= 0 && image.compare(span.high, levels[k + 1]) >= 0) {
        sides.push_back({span.line, true});
      }
    }
    std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
      const int order = image.order_at(a.line, b.line, levels[k]);
      return order != 0 ? order < 0 : image.order_at(a.line, b.line, levels[k + 1]) < 0;
    });
    append_band(image, pcs, levels[k], levels[k + 1], sides);
  }
  return pcs;
}

TrapezoidPcs combine(const Image& image, const TrapezoidPcs& a, const TrapezoidPcs& b, Operation operation) {
  TrapezoidPcs result = a;
  Combiner{image, operation}(result, b);
  return result;
}

std::vector<TrapezoidPcs> components(const Image& image, const TrapezoidPcs& pcs) {
  const std::size_t count = pcs.sides.size() / 2;  // substripes, numbered through
  std::vector<std::size_t> parent(count);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&parent](std::size_t k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  const auto wide = [&](std::size_t west, std::size_t east, const Ordinate& y) {
    return image.order_at(pcs.sides[west].line, pcs.sides[east].line, y) < 0;
  };
  for (std::size_t i = 0; i + 1 < pcs.bands.size(); ++i) {
    const Band& below = pcs.bands[i];
    const Band& above = pcs.bands[i + 1];
    if (image.compare(below.high, above.low) != 0) continue;
    const Ordinate& y = above.low;
    for (std::size_t p = below.first; p < below.first + below.count; p += 2) {
      for (std::size_t q = above.first; q < above.first + above.count; q += 2) {
        if (wide(p, p + 1, y) && wide(q, q + 1, y) && wide(p, q + 1, y) && wide(q, p + 1, y)) {
          parent[root(p / 2)] = root(q / 2);
        }
      }
    }
  }
  std::vector<TrapezoidPcs> parts;
  std::vector<std::uint32_t> number(count, none);
  std::vector<Side> pair(2);
  for (const Band& band : pcs.bands) {
    std::vector<std::vector<Side>> rows(parts.size());
    for (std::size_t p = band.first; p < band.first + band.count; p += 2) {
      std::uint32_t& part = number[root(p / 2)];
      if (part == none) {
        part = static_cast<std::uint32_t>(parts.size());
        parts.emplace_back();
        rows.emplace_back();
      }
      rows[part].push_back(pcs.sides[p]);
      rows[part].push_back(pcs.sides[p + 1]);
    }
    for (std::size_t part = 0; part < rows.size(); ++part) {
      append_band(image, parts[part], band.low, band.high, rows[part]);
    }
  }
  return parts;
}

double area(const Image& image, const TrapezoidPcs& pcs) {
  double sum = 0;
  for (const Band& band : pcs.bands) {
    const double low = band.low.middle();
    const double high = band.high.middle();
    const auto sides = pcs.sides_of(band);
    for (std::size_t k = 0; k + 1 < sides.size(); k += 2) {
      const double width = image.abscissa(sides[k + 1].line, low) - image.abscissa(sides[k].line, low) +
                           image.abscissa(sides[k + 1].line, high) - image.abscissa(sides[k].line, high);
      sum += width / 2 * (high - low);
    }
  }
  return sum;
}

}  // namespace sightline::algorithms::montani_re
