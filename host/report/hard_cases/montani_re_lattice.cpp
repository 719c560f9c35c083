#include "host/report/hard_cases/montani_re_lattice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "host/algorithms/montani_re/lattice_boundary.hpp"
#include "host/algorithms/montani_re/stripes.hpp"
#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "host/report/hard_cases/hard_cases.hpp"
#include "host/report/hard_cases/montani_re.hpp"
#include "host/report/montani_re_pixels.hpp"
#include "host/scene/read/poly_text.hpp"

namespace sightline::harness::report {

namespace {

namespace native = algorithms::montani_re;
using native::FreemanChain;
using native::LatticePcs;
using native::LatticePoint;
using Combination = LatticeExpected::Combination;

constexpr std::int64_t farthest = 1 << 20;  // of a starting point; and as many links

// Sixths of a step: so far are the middles of the quarters of a square from its corner.
constexpr std::array<LatticePoint, 4> quarters{{{3, 1}, {5, 3}, {3, 5}, {1, 3}}};

bool inside(const std::vector<FreemanChain>& chains, const LatticePoint& place) {
  constexpr std::array<LatticePoint, 8> steps{
      {{6, 0}, {6, 6}, {0, 6}, {-6, 6}, {-6, 0}, {-6, -6}, {0, -6}, {6, -6}}};
  bool odd = false;
  for (const FreemanChain& chain : chains) {
    LatticePoint from{6 * chain.start.x, 6 * chain.start.y};
    for (const char link : chain.links) {
      const LatticePoint& step = steps[static_cast<std::size_t>(link - '0')];
      const LatticePoint to{from.x + step.x, from.y + step.y};
      if ((from.y > place.y) != (to.y > place.y)) {
        // Links rise by 6 or fall by 6: x on the link at the place's y.
        const std::int32_t x = from.x + step.x * (place.y - from.y) / step.y;
        if (x > place.x) odd = !odd;
      }
      from = to;
    }
  }
  return odd;
}

bool kept(Combination combination, bool a, bool b) {
  switch (combination) {
    case Combination::first: return a;
    case Combination::both: return a && b;
    case Combination::either: return a || b;
    case Combination::less: return a && !b;
  }
  return false;
}

struct RegionPair {
  std::vector<FreemanChain> a;
  std::vector<FreemanChain> b;
};

// Eighths of a square step.
std::int64_t counted_area(const RegionPair& regions, Combination combination, std::int32_t size) {
  std::int64_t eighths = 0;
  for (std::int32_t y = 0; y < size; ++y) {
    for (std::int32_t x = 0; x < size; ++x) {
      for (const LatticePoint& quarter : quarters) {
        const LatticePoint place{6 * x + quarter.x, 6 * y + quarter.y};
        if (kept(combination, inside(regions.a, place), inside(regions.b, place))) eighths += 2;
      }
    }
  }
  return eighths;
}

LatticePcs combined(const LatticePcs& a, const LatticePcs& b, Combination combination) {
  switch (combination) {
    case Combination::first: return a;
    case Combination::both: return native::intersect(a, b);
    case Combination::either: return native::unite(a, b);
    case Combination::less: return native::subtract(a, b);
  }
  return {};
}

std::vector<std::vector<LatticePoint>> corners_of(const LatticePcs& pcs) {
  std::vector<std::vector<LatticePoint>> loops;
  for (const native::LatticeLoop& loop : native::boundary_of(pcs)) loops.push_back(loop.corners);
  return loops;
}

native::Operation operation_of(Combination combination) {
  if (combination == Combination::both) return native::Operation::intersect;
  return combination == Combination::either ? native::Operation::unite : native::Operation::subtract;
}

// The regions in stripes of a step, whose sides cross where they will. Half steps are units.
double area_in_stripes(const std::array<LatticePcs, 2>& pcs, Combination combination, std::int32_t size) {
  std::array<native::StripePcs, 2> stripes;
  for (std::size_t r = 0; r < (combination == Combination::first ? 1U : 2U); ++r) {
    native::FaceSetBuilder builder(false);
    native::Rings rings;
    for (const auto& loop : corners_of(pcs[r])) {
      auto& ring = rings.emplace_back();
      for (const LatticePoint& p : loop) ring.push_back(builder.add_vertex({p.x, p.y, 0}));
    }
    builder.add_face(rings, 0, 0);
    const native::FaceSet set = builder.take();
    stripes[r] = native::stripe_pcs(set.image, set.faces[0].pcs, {{0.5, 0.5}, {0, 0}, size, size}, 16);
  }
  if (combination == Combination::first) return square_pixels(stripes[0], 16);
  return square_pixels(native::combine(stripes[0], stripes[1], operation_of(combination)), 16);
}

struct Findings {
  std::string native;
  std::string stripes;
  std::string oracle;
};

void add(std::string& text, const std::string& complaint) {
  text += (text.empty() ? "" : "; ") + complaint;
}

void check(const RegionPair& regions, const std::array<LatticePcs, 2>& pcs, const LatticeExpected& expected,
           std::int32_t size, Findings& wrong) {
  const LatticePcs result = combined(pcs[0], pcs[1], expected.combination);
  const auto loops = corners_of(result);
  if (const auto area = native::eightfold_area(result); area != expected.eighths)
    add(wrong.native, fmt::format("area {}", static_cast<double>(area) / 8));
  if (loops.size() != expected.loops) add(wrong.native, fmt::format("{} loops", loops.size()));
  if (native::lattice_pcs_of_half_steps(loops) != result) add(wrong.native, "its loops are another region");
  if (const double area = area_in_stripes(pcs, expected.combination, size);
      8 * area != static_cast<double>(expected.eighths))
    add(wrong.stripes, fmt::format("area {}", area));
  if (const auto area = counted_area(regions, expected.combination, size); area != expected.eighths)
    add(wrong.oracle, fmt::format("area {}", static_cast<double>(area) / 8));
}

Cell verdict(const std::string& wrong) {
  if (wrong.empty()) return Verdict{true, "right"};
  return Verdict{false, "differs: " + wrong};
}

MontaniReHardResult unusable(const std::string& why) {
  const Cell cell = Verdict{false, "refused: " + why};
  return {cell, cell, cell, cell};
}

// No point of any region has a greater coordinate.
std::int32_t size_of(const std::array<LatticePcs, 2>& pcs) {
  std::int32_t half_steps = 0;
  for (const LatticePcs& region : pcs) {
    for (const auto& loop : corners_of(region)) {
      for (const LatticePoint& corner : loop) half_steps = std::max({half_steps, corner.x, corner.y});
    }
  }
  return (half_steps + 1) / 2;
}

}  // namespace

base::Result<LatticeRegions> read_chains(std::string_view text, std::string_view source) {
  LatticeRegions regions;
  scene::PolyLines lines(text, source);
  while (lines.next()) {
    const auto& fields = lines.fields();
    if (fields.size() != 4)
      return lines.error(fmt::format("found {} fields, expected name, x, y and links", fields.size()));
    std::array<std::int32_t, 2> start{};
    for (std::size_t a = 0; a < 2; ++a) {
      const auto number = base::signed_number(fields[1 + a]);
      if (!number || *number < 0 || *number > farthest)
        return lines.unexpected(fields[1 + a], fmt::format("an integer from 0 to {}", farthest));
      start[a] = static_cast<std::int32_t>(*number);
    }
    const std::string_view links = fields[3];
    if (links.size() > farthest || links.find_first_not_of("01234567") != std::string_view::npos)
      return lines.unexpected(links, fmt::format("up to {} digits from 0 to 7", farthest));
    regions[std::string(fields[0])].push_back({{start[0], start[1]}, links});
  }
  return regions;
}

MontaniReHardResult run_lattice_case(const MontaniReHardCase& hard) {
  const auto read = read_chains(hard_case_text(hard.file), hard.file);
  if (!read) return unusable(read.error().message());
  const auto& regions = *read;
  const auto region = [&regions](std::string_view name) {
    const auto found = regions.find(name);
    return found != regions.end() ? found->second : std::vector<FreemanChain>{};
  };
  const RegionPair pair{region("A"), region("B")};
  const auto a = native::lattice_pcs(pair.a);
  const auto b = native::lattice_pcs(pair.b);
  if (!a || !b) return unusable("a chain does not close");
  Findings wrong;
  const std::array<LatticePcs, 2> pcs{*a, *b};
  for (const LatticeExpected& expected : hard.regions) check(pair, pcs, expected, size_of(pcs), wrong);
  return {verdict(wrong.native), verdict(wrong.stripes),
          std::string("not applicable: regions of a plane hide nothing"), verdict(wrong.oracle)};
}

}  // namespace sightline::harness::report
