// Parallel Connected Stripes on a square lattice: regions bounded by lines of the eight lattice directions,
// cut into horizontal stripes, every stripe a row of trapezoids. Source: Montani and Re (1985), section 2 and
// Table 1.
//
// A side passes through one stripe; it is of type 1 ("/"), 2 ("|") or 3 ("\"). Internally everything is on the doubled lattice
// (unit: half a lattice step): a "/" and a "\" in one square cross in its middle, which is a point only of the doubled lattice.
// All diagonals keep an even x + y where they cross a line of the lattice, so that no two sides cross inside a half stripe. The
// algebra is therefore closed and exact: stripes of a fixed thickness (host/algorithms/montani_re/stripes.hpp) are compared with
// it.
//
// Laws: stripes ascend; the sides in a stripe ascend by the sum of their two abscissas; their number is even and not 0; no two
// are
// equal. Two sets of the same points are therefore equal by ==.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sightline::algorithms::montani_re {

struct LatticePoint {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
  friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

// A closed line as the paper writes it: a starting point and digits, 0 east, 1 north-east, ... 7 south-east.
struct FreemanChain {
  LatticePoint start;
  std::string_view links;
};

enum class SideType : std::uint8_t { rising = 1, vertical = 2, falling = 3 };

struct LatticeSide {
  std::int32_t bottom = 0;  // abscissas; they differ by at most 1
  std::int32_t top = 0;

  [[nodiscard]] constexpr SideType type() const {
    return top > bottom ? SideType::rising : top < bottom ? SideType::falling : SideType::vertical;
  }
  // The value that Table 1 prints: the smaller abscissa.
  [[nodiscard]] constexpr std::int32_t abscissa() const { return top < bottom ? top : bottom; }
  friend bool operator==(const LatticeSide&, const LatticeSide&) = default;
  friend auto operator<=>(const LatticeSide&, const LatticeSide&) = default;
};

// Sides 2k and 2k + 1 are the west and east sides of substripe k.
struct LatticeStripe {
  std::int32_t y = 0;  // of the lower side
  std::vector<LatticeSide> sides;

  friend bool operator==(const LatticeStripe&, const LatticeStripe&) = default;
};

struct LatticePcs {
  std::vector<LatticeStripe> half_stripes;  // in half steps

  friend bool operator==(const LatticePcs&, const LatticePcs&) = default;
};

// The points inside an odd number of the chains, in either orientation. Empty if a chain does not close or has a link that is not
// a
// digit 0..7. Coordinates stay below 2^29.
[[nodiscard]] std::optional<LatticePcs> lattice_pcs(std::span<const FreemanChain> chains);
// The same from closed polygons with corners in half steps and lines in lattice directions (precondition; corners of diagonal
// lines
// have an even x + y).
[[nodiscard]] LatticePcs lattice_pcs_of_half_steps(std::span<const std::vector<LatticePoint>> loops);

// Stripes of a whole step, as in Table 1. Empty if a corner of the set is not a lattice point.
[[nodiscard]] std::optional<std::vector<LatticeStripe>> whole_stripes(const LatticePcs& pcs);

// Linear in the number of sides.
[[nodiscard]] LatticePcs unite(const LatticePcs& a, const LatticePcs& b);
[[nodiscard]] LatticePcs intersect(const LatticePcs& a, const LatticePcs& b);
[[nodiscard]] LatticePcs subtract(const LatticePcs& a, const LatticePcs& b);

// Eight times the area in square steps.
[[nodiscard]] std::int64_t eightfold_area(const LatticePcs& pcs);

// Corners in half steps with the inside to the left: an outline has a positive area, a hole a negative one.
struct LatticeLoop {
  std::vector<LatticePoint> corners;  // collinear lines are joined

  [[nodiscard]] std::int64_t eightfold_area() const;
};

// Loops that only touch are separate. Horizontal pieces are where there is coverage above xor below; the lines between stripes
// are
// never part of a boundary.
[[nodiscard]] std::vector<LatticeLoop> boundary_of(const LatticePcs& pcs);

struct OwnedChain {
  LatticePoint start;
  std::string links;
};
// In whole steps, from the first corner. Empty if a corner is not a lattice point.
[[nodiscard]] std::optional<OwnedChain> chain_of(const LatticeLoop& loop);

}  // namespace sightline::algorithms::montani_re
