#include "host/algorithms/montani_re/trapezoid_pcs.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>

#include "host/base/short_list.hpp"

namespace sightline::algorithms::montani_re {

Combiner::Combiner(const Image& image, Operation operation) : image_(image), operation_(operation) {
  for (std::size_t in = 0; in < kept_.size(); ++in)
    kept_[in] = in_result(operation, (in & inside_a) != 0, (in & inside_b) != 0);
}

void Combiner::operator()(TrapezoidPcs& a, const TrapezoidPcs& b) {
  result_.bands.clear();
  result_.sides.clear();
  run(a, b);
  std::swap(a, result_);
}

// Processes the parts between consecutive ends of bands.
void Combiner::run(const TrapezoidPcs& a_pcs, const TrapezoidPcs& b_pcs) {
  const bool keeps_a = operation_ != Operation::intersect;
  const bool keeps_b = operation_ == Operation::unite;
  const std::vector<Band>& a = a_pcs.bands;
  const std::vector<Band>& b = b_pcs.bands;
  std::size_t i = 0;
  std::size_t j = 0;
  if (!b.empty())
    while (i < a.size() && image_.compare(a[i].high, b[0].low) <= 0) ++i;
  if (!a.empty())
    while (j < b.size() && image_.compare(b[j].high, a[0].low) <= 0) ++j;
  if (keeps_a) copy(a_pcs, 0, i);
  if (keeps_b) copy(b_pcs, 0, j);
  const Ordinate* low = nullptr;
  bool in_a = false;
  bool in_b = false;
  while (i < a.size() && j < b.size()) {
    if (!in_a && !in_b) {
      const int order = image_.compare(a[i].low, b[j].low);
      in_a = order <= 0;
      in_b = order >= 0;
      low = in_a ? &a[i].low : &b[j].low;
    }
    const Ordinate* const end_a = in_a ? &a[i].high : &a[i].low;
    const Ordinate* const end_b = in_b ? &b[j].high : &b[j].low;
    const int order = image_.compare(*end_a, *end_b);
    const Ordinate* const high = order <= 0 ? end_a : end_b;
    append(*low, *high, in_a ? a_pcs.sides_of(a[i]) : std::span<const Side>{},
           in_b ? b_pcs.sides_of(b[j]) : std::span<const Side>{});
    if (order <= 0) {
      if (in_a) ++i;
      in_a = i < a.size() && (!in_a || image_.compare(a[i].low, *high) == 0);
    }
    if (order >= 0) {
      if (in_b) ++j;
      in_b = j < b.size() && (!in_b || image_.compare(b[j].low, *high) == 0);
    }
    low = high;
  }
  if (keeps_a && i < a.size()) {
    if (in_a) append_band(image_, result_, *low, a[i].high, a_pcs.sides_of(a[i]));
    copy(a_pcs, in_a ? i + 1 : i, a.size());
  }
  if (keeps_b && j < b.size()) {
    if (in_b) append_band(image_, result_, *low, b[j].high, b_pcs.sides_of(b[j]));
    copy(b_pcs, in_b ? j + 1 : j, b.size());
  }
}

void Combiner::copy(const TrapezoidPcs& pcs, std::size_t begin, std::size_t end) {
  for (std::size_t k = begin; k < end; ++k)
    append_band(image_, result_, pcs.bands[k].low, pcs.bands[k].high, pcs.sides_of(pcs.bands[k]));
}

void Combiner::append(const Ordinate& low, const Ordinate& high, std::span<const Side> a,
                      std::span<const Side> b) {
  if (a.empty() && operation_ != Operation::unite) return;
  if (b.empty() && operation_ == Operation::intersect) return;
  if (a.empty() || b.empty()) {
    append_band(image_, result_, low, high, a.empty() ? b : a);
    return;
  }
  a_count_ = a.size();
  count_ = a.size() + b.size();
  if (apart_.size() < count_) {
    apart_.resize(count_);
    row_.resize(count_);
    out_.resize(count_);
  }
  const Middle at_low(low);
  const Middle at_high(high);
  const auto set_member = [&](Member& member, const Side& side, bool of_a) {
    member = {side, of_a, image_.abscissa_at(side.line, at_low), image_.abscissa_at(side.line, at_high)};
  };
  Member* const of_a = apart_.data();
  Member* const of_b = apart_.data() + a.size();
  set_member(of_a[0], a[0], true);
  set_member(of_a[a.size() - 1], a.back(), true);
  set_member(of_b[0], b[0], false);
  set_member(of_b[b.size() - 1], b.back(), false);
  if (operation_ == Operation::subtract) {
    // The outermost sides show whether all of a is beside b, or in it.
    const auto west_of = [](const Member& one, const Member& other) {
      return one.at_from.high < other.at_from.low && one.at_high.high < other.at_high.low;
    };
    if (west_of(of_a[a.size() - 1], of_b[0]) || west_of(of_b[b.size() - 1], of_a[0])) {
      append_band(image_, result_, low, high, a);
      return;
    }
    if (b.size() == 2 && west_of(of_b[0], of_a[0]) && west_of(of_a[a.size() - 1], of_b[1])) return;
  }
  for (std::size_t k = 1; k + 1 < a.size(); ++k) set_member(of_a[k], a[k], true);
  for (std::size_t k = 1; k + 1 < b.size(); ++k) set_member(of_b[k], b[k], false);
  Ordinate from = low;
  for (;;) {
    merge(from, high);
    Ordinate lowest;
    const bool crossing = find_crossing(high, lowest);
    append_band(image_, result_, from, crossing ? lowest : high, toggle(from, high));
    if (!crossing) return;
    from = lowest;
    const Middle at_from(from);
    for (std::size_t k = 0; k < count_; ++k) apart_[k].at_from = image_.abscissa_at(apart_[k].side.line, at_from);
  }
}

// Merges both rows into the order just above `from`, and marks sides that coincide with the preceding side of the other
// region.
void Combiner::merge(const Ordinate& from, const Ordinate& high) {
  std::size_t i = 0;
  std::size_t j = a_count_;
  std::size_t k = 0;
  std::uint32_t coincides = 0;
  while (i < a_count_ && j < count_) {
    const Member& a = apart_[i];
    const Member& b = apart_[j];
    bool take_a = a.at_from.high < b.at_from.low;
    std::uint32_t next_coincides = 0;
    if (static_cast<int>(take_a) == static_cast<int>(a.at_from.low > b.at_from.high)) {
      int order = order_at_from(a, b, from);
      if (order == 0) order = order_at_high(a, b, high);
      take_a = order <= 0;
      if (order == 0) next_coincides = coincides_bit;
    }
    row_[k++] = static_cast<std::uint32_t>(take_a ? i : j) | coincides;
    i += static_cast<std::size_t>(take_a);
    j += static_cast<std::size_t>(!take_a);
    coincides = next_coincides;
  }
  for (; i < a_count_; ++i, coincides = 0) row_[k++] = static_cast<std::uint32_t>(i) | coincides;
  for (; j < count_; ++j, coincides = 0) row_[k++] = static_cast<std::uint32_t>(j) | coincides;
}

bool Combiner::find_crossing(const Ordinate& high, Ordinate& lowest) const {
  bool found = false;
  const Member* west = &member(0);
  for (std::size_t k = 1; k < count_; ++k) {
    const Member* const east = &member(k);
    const bool ordered = west->at_high.high < east->at_high.low;
    const Member& one = *west;
    west = east;
    if (ordered || one.of_a == east->of_a || order_at_high(one, *east, high) <= 0) continue;
    const Ordinate here = image_.crossing(one.side.line, east->side.line);
    if (!found || image_.compare(here, lowest) < 0) lowest = here;
    found = true;
  }
  return found;
}

// The sides of the result. Sides that coincide are crossed together.
std::span<const Side> Combiner::toggle(const Ordinate& from, const Ordinate& high) {
  std::size_t kept = 0;
  std::size_t in = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    const bool before = kept_[in];
    const Member& first = member(k);
    Side side{first.side.line, first.of_a && first.side.own};
    in ^= first.of_a ? inside_a : inside_b;
    const Member* west = &first;
    for (; k + 1 < count_; ++k) {
      const Member& next = member(k + 1);
      if (west->at_from.high < next.at_from.low || !coincides(k, from, high)) break;
      in ^= next.of_a ? inside_a : inside_b;
      if (next.of_a) side = {next.side.line, side.own || next.side.own};
      west = &next;
    }
    out_[kept] = side;
    kept += static_cast<std::size_t>(kept_[in] != before);
  }
  return {out_.data(), kept};
}

// Whether the next side of the row coincides with this one.
bool Combiner::coincides(std::size_t k, const Ordinate& from, const Ordinate& high) const {
  const Member& west = member(k);
  const Member& east = member(k + 1);
  if (west.of_a != east.of_a) return (row_[k + 1] & coincides_bit) != 0;
  return order_at_from(west, east, from) == 0 && order_at_high(west, east, high) == 0;
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

// The west and the east border, each from its lowest side to its highest, are walked together.
TrapezoidPcs convex_pcs(const Image& image, std::span<const std::uint32_t> lines,
                        std::span<const std::int8_t> inner_sides) {
  struct Edge {
    std::uint32_t line = 0;
    std::uint32_t low = 0;  // vertices
    std::uint32_t high = 0;
  };
  const auto compare = [&image](std::uint32_t v, std::uint32_t w) {
    return v == w ? 0 : image.compare(image.ordinate_of(v), image.ordinate_of(w));
  };
  std::array<base::ShortList<Edge, 6>, 2> borders;  // west, east
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const ImageLine& line = image.lines()[lines[k]];
    if (line.horizontal()) continue;
    Edge edge{lines[k], line.from, line.to};
    if (compare(edge.low, edge.high) > 0) std::swap(edge.low, edge.high);
    auto& border = borders[inner_sides[k] > 0 ? 0 : 1];
    border.push_back(edge);
    for (std::size_t i = border.size() - 1; i > 0 && compare(border[i].low, border[i - 1].low) < 0; --i)
      std::swap(border[i], border[i - 1]);
  }
  const auto& [west, east] = borders;
  TrapezoidPcs pcs;
  if (west.empty() || east.empty()) return pcs;
  const std::size_t most = west.size() + east.size() - 1;
  pcs.bands.reserve(most);
  pcs.sides.reserve(2 * most);
  Ordinate low = image.ordinate_of(west[0].low);
  for (std::size_t w = 0, e = 0; w < west.size() && e < east.size();) {
    const int order = compare(west[w].high, east[e].high);
    const Ordinate high = image.ordinate_of(order <= 0 ? west[w].high : east[e].high);
    pcs.bands.push_back({low, high, static_cast<std::uint32_t>(pcs.sides.size()), 2});
    pcs.sides.push_back({west[w].line, true});
    pcs.sides.push_back({east[e].line, true});
    low = high;
    if (order <= 0) ++w;
    if (order >= 0) ++e;
  }
  return pcs;
}

TrapezoidPcs combine(const Image& image, const TrapezoidPcs& a, const TrapezoidPcs& b, Operation operation) {
  TrapezoidPcs result = a;
  Combiner{image, operation}(result, b);
  return result;
}

std::vector<TrapezoidPcs> components(const Image& image, const TrapezoidPcs& pcs) {
  const std::size_t count = pcs.sides.size() / 2;  // substripes, numbered consecutively
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
