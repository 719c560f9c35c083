// The search along the avenues of sight, with its explicit stack, which implements twin.hpp. Source:
// firmware/pdp7/jones/SPECIFICATION.md section 4; Jones (1971), "The algorithm".
#pragma once

#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/programs/jones/twin/elements.hpp"
#include "host/programs/jones/twin/mask.hpp"
#include "host/programs/jones/twin/twin.hpp"

namespace sightline::programs::jones {

// Number of stack words needed to return to a cell seen through this mask: place in the list, entry, cell, the link to the
// frame before; count and box of the mask, its sloped edges.
template <class Coordinate>
[[nodiscard]] int frame_words(const BasicMask<Coordinate>& mask) {
  return 9 + 4 * sloped_edges(mask);
}

// One view in one arithmetic; run once.
template <class Number>
class Search {
 public:
  using Coordinate = typename Number::Coordinate;
  using View = BasicView<Coordinate>;

  Search(std::span<const core::Word18> core, std::uint32_t header, const Parameters& parameters,
         const Number& number)
      : core_(core),
        header_(header),
        parameters_(parameters),
        number_(number),
        file_(display_file_words, !parameters.immediate, number.truncate()) {}

  [[nodiscard]] View run() &&;

 private:
  using Point = BasicScreenPoint<Coordinate>;
  using Mask = BasicMask<Coordinate>;
  using PolygonBuilder = BasicPolygonBuilder<Coordinate>;
  // The properties of an opening found before its ring is walked.
  struct RingScan {
    bool crossing = false;  // the eye is strictly on the near side
    bool counter_clockwise = false;
    bool actual_lines = false;
    Axis plane = Axis::z;       // normal to the opening
    std::int32_t distance = 0;  // of the plane from the eye, signed
  };
  // The outline of a ring on the screen.
  struct Outline {
    RingBound bound;
    PolygonBuilder polygon;
    // Only in a turned view: the sides by which the outline came into the view first and left it last.
    std::optional<unsigned> came;
    unsigned left = beyond_none;
  };
  struct Level {
    Mask mask;
    std::uint32_t entry;       // element of the opening through which the search came
    std::uint32_t next_entry;  // list of openings: where to continue
    bool exhausted = false;
  };

  // The functions that return bool return false as soon as the view has ended with a status.
  bool pass(Pass which, SpacePoint eye);
  bool visit(std::uint32_t cell, const Mask& mask, std::uint32_t entry);
  // Draws the lines of a chain or ring, and collects the outline of a ring unless `outline` is null.
  bool walk(const Chain& chain, Outline* outline);
  bool move(SpacePoint& point, Vector vector, SpaceSegment& moved);
  bool draw(const SpaceSegment& moved, Axis axis, std::uint32_t vector_address);
  bool draw_through_mask(const BasicScreenSegment<Coordinate>& line, std::uint32_t vector_address);
  // The same for a view turned about the vertical; draws nothing if it collects the outline.
  bool walk_turned(const Chain& chain, Outline* outline);
  bool draw_turned(const ScreenPoint& a, const ScreenPoint& b, std::uint32_t vector_address);
  bool append_turned(const SeenLevel& seen, std::int32_t y, Outline& outline);
  bool append_round(unsigned side, std::int32_t y, Outline& outline);
  bool append(const ScreenPoint& corner, Outline& outline);
  bool append_corner(Outline& outline, const SpacePoint& corner);
  bool append_side(Outline& outline, const SpaceSegment& moved, Axis axis, bool last);
  bool opening(std::uint32_t far_word_address);
  bool scan(const Chain& ring, bool towards_higher, RingScan& facts);
  bool go_through(std::uint32_t far_cell, std::uint32_t element, PolygonBuilder& polygon,
                  bool counter_clockwise);
  bool project_point(const SpacePoint& point, Point& projected);
  bool add_to_file(BasicPiece<Coordinate>& piece);

  bool fail(Status status) {
    view_.status = status;
    return false;
  }
  bool spend() { return spent_++ < parameters_.limit || fail(Status::unfinished); }
  [[nodiscard]] SpacePoint stereo_eye(std::int32_t shift) const;
  // Whether no number has overflowed its word so far.
  bool sound() { return !number_.overflowed() || fail(Status::arithmetic_overflow); }
  bool chain_at(std::uint32_t element, Chain& chain);
  void count_fresh(const SpacePoint& point);

  CoreImage core_;
  std::uint32_t header_;
  Parameters parameters_;
  Number number_;
  DisplayFile file_;
  View view_;
  std::bitset<core_words> cells_;
  std::vector<Level> levels_;
  int stack_words_ = 0;  // frames of all levels but the last
  Pass pass_ = Pass::mono;
  SpacePoint eye_;
  Window window_;
  std::optional<RotatedView> turned_;
  std::optional<SpacePoint> projected_last_;  // within one chain
  std::uint64_t spent_ = 0;
};

extern template class Search<ShortWords>;
extern template class Search<LongWords>;
extern template class Search<MixedWords>;
extern template class Search<SingleFloat>;
extern template class Search<DoubleFloat>;

}  // namespace sightline::programs::jones
