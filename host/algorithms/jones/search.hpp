// The search along avenues of sight: from cell to cell through openings, with the mask clipped to each.
//
// Pending cells and their masks are on a stack. A mask is popped when its cell is entered, so a passage through any
// number of cells keeps only one. Openings are pushed last to first, which gives the order of the paper: the lines of a
// cell, then everything seen through its first opening, and so on.
//
// Planes of sight are computed when an opening is first reached, once per view.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "host/algorithms/jones/arithmetic.hpp"
#include "host/algorithms/jones/fragments.hpp"
#include "host/algorithms/jones/mask.hpp"
#include "host/algorithms/jones/prepared_complex.hpp"
#include "host/algorithms/jones/sight_plane.hpp"
#include "host/algorithms/jones/start_cells.hpp"
#include "host/algorithms/jones/stretch.hpp"
#include "host/algorithms/jones/trace.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/base/result.hpp"
#include "host/geometry/box.hpp"
#include "host/geometry/integer.hpp"

namespace sightline::algorithms::jones {

// The openings and cells that a view has reached. An entry is valid if it holds the number of the current view; therefore
// nothing is cleared between views, which would take time proportional to the complex.
struct Reached {
  struct Opening {
    std::uint32_t view = 0;
    std::uint32_t first_plane = 0;  // 0: its planes of sight are not computed yet
    std::int16_t eye_side = 0;      // side of the opening's plane that the eye is on
    std::uint16_t excluding_side = 0;  // the side (modulo 2^16) beyond which the last mask lay that missed the opening
  };

  explicit Reached(const scene::CellComplex& complex)
      : openings(complex.openings.size()), cells(complex.cells.size()) {}

  void begin_view() {
    if (view == std::numeric_limits<std::uint32_t>::max()) {
      std::fill(openings.begin(), openings.end(), Opening{});
      std::fill(cells.begin(), cells.end(), 0U);
      view = 0;
    }
    ++view;
  }

  std::uint32_t view = 0;
  std::vector<Opening> openings;
  std::vector<std::uint32_t> cells;
};

template <class Arithmetic, class Listener = NoListener>
class Search {
 public:
  explicit Search(Listener listener = {}) : listener_(listener) {}

  [[nodiscard]] base::Result<View> run(const PreparedComplex& prepared, Reached& reached,
                                       const scene::PolyCamera& camera, const Start& start);

 private:
  using Number = typename Arithmetic::Number;
  using Side = MaskSide<Arithmetic>;

  // A pending cell. Without sides, all of it is seen.
  struct Waiting {
    scene::CellNumber cell = 0;
    std::uint32_t depth = 0;
    std::size_t first_side = 0;
    std::size_t side_count = 0;
  };

  // The state of one view.
  struct Pass {
    const PreparedComplex& prepared;
    Reached& reached;
    const Sight sight;
    Search& search;
    Counts counts;

    [[nodiscard]] typename Arithmetic::Line image(std::uint32_t plane) const {
      return sight.template image<Arithmetic>(search.planes_[plane]);
    }
    void draw_outer_faces();
    [[nodiscard]] bool walk();
    void visit(const Waiting& waiting);
    void take_mask(const Waiting& waiting);
    [[nodiscard]] bool may_see(const geometry::Box& box) const;
    void set_whole_view();
    template <class Part>
    void draw_line(std::uint32_t edge, const Part& part);
    void draw_rest(std::uint32_t edge, Stretch<Number> left);
    [[nodiscard]] bool hidden(const geometry::Vector3& from, const geometry::Vector3& to);
    void test_opening(const Waiting& waiting, std::uint32_t opening);
    void queue_cell_beyond(std::uint32_t number, bool from_negative_side, std::uint32_t depth);
    [[nodiscard]] bool faces_eye(std::uint32_t number, bool from_negative_side);
    void make_planes(const scene::ComplexOpening& opening, Reached::Opening& state);
    [[nodiscard]] std::span<const Side> first_mask(std::uint32_t first_plane, std::uint32_t count);
    [[nodiscard]] std::span<const Side> clipped(std::span<const Side> mask, std::uint32_t plane);
    [[nodiscard]] std::span<const Side> clipped_by_sides(std::span<const Side> mask, Reached::Opening& opening,
                                                         std::uint32_t count);
  };

  std::vector<SightPlane<Number>> planes_;  // [0]: the plane of the eye, in perspective
  std::vector<Waiting> waiting_;
  std::vector<Side> waiting_sides_;
  std::vector<Side> mask_;                       // of the current cell
  std::vector<SightPlane<Number>> mask_planes_;  // of the mask's sides; without sides, the plane of the eye
  std::vector<std::size_t> cutting_sides_;       // sides of the mask that cut the current line, sized for all sides
  std::size_t cutting_ = 0;                      // number of valid entries of cutting_sides_
  std::vector<Side> cut_;
  std::vector<Side> cut_again_;
  std::vector<std::int8_t> signs_;
  std::vector<std::uint8_t> cutting_planes_;  // 1 for the sides of an opening that cut something off the mask
  std::size_t hiding_side_ = 0;              // the side of the mask beyond which the last hidden line lay
  std::vector<std::uint32_t> openings_met_;  // of a crowded cell, those the mask may meet
  Fragments<Number> fragments_;
  [[no_unique_address]] Listener listener_;
};

template <class Arithmetic, class Listener>
base::Result<View> Search<Arithmetic, Listener>::run(const PreparedComplex& prepared, Reached& reached,
                                           const scene::PolyCamera& camera, const Start& start) {
  reached.begin_view();
  planes_.clear();
  waiting_.clear();
  waiting_sides_.clear();
  fragments_.clear();
  Pass pass{prepared, reached, Sight(camera), *this, {}};
  planes_.push_back(pass.sight.template before_eye<Number>());
  if (start.outside) {
    pass.set_whole_view();
    pass.draw_outer_faces();
    for (const std::uint32_t number : prepared.entrances()) {
      const bool from_negative_side = prepared.complex().openings[number].cells[0] == scene::outside;
      if (pass.faces_eye(number, from_negative_side)) pass.queue_cell_beyond(number, from_negative_side, 0);
    }
  }
  for (const scene::CellNumber cell : start.cells) waiting_.push_back({cell, 1, waiting_sides_.size(), 0});
  if (!pass.walk()) return base::bad_input(no_complex);
  auto picture = fragments_.picture(prepared.complex(), pass.sight);
  if (!picture) return base::bad_input(no_complex);
  pass.counts.number_bits = 8 * sizeof(Number);
  return View{std::move(*picture), pass.counts};
}

// Returns false if a sight line passes more cells than the complex has.
template <class Arithmetic, class Listener>
bool Search<Arithmetic, Listener>::Pass::walk() {
  while (!search.waiting_.empty() && !search.listener_.enough()) {
    const Waiting next = search.waiting_.back();
    search.waiting_.pop_back();
    if (next.depth > prepared.complex().cells.size()) return false;
    visit(next);
  }
  return true;
}

template <class Arithmetic, class Listener>
void Search<Arithmetic, Listener>::Pass::visit(const Waiting& waiting) {
  take_mask(waiting);
  search.listener_.entered(waiting.cell, waiting.depth, search.mask_planes_);
  ++counts.visits;
  counts.depth = std::max<std::uint64_t>(counts.depth, waiting.depth);
  if (reached.cells[waiting.cell] != reached.view) {
    reached.cells[waiting.cell] = reached.view;
    ++counts.cells;
  }
  const scene::CellComplex& complex = prepared.complex();
  const scene::ComplexCell& cell = complex.cells[waiting.cell];
  const auto lines = complex.lines_of(cell);
  const auto openings = complex.openings_of(cell);
  const CrowdedCell* const crowded = prepared.find_crowded(waiting.cell);
  const auto draw = [&](std::size_t i) {
    draw_line(lines.edge(i), [&] {
      const scene::ComplexLine line = lines[i];
      return Stretch<Number>{{line.low.numerator(), line.low.denominator()},
                             {line.high.numerator(), line.high.denominator()}};
    });
  };
  if (crowded == nullptr) {
    for (std::size_t i = 0; i < lines.size(); ++i) draw(i);
    for (std::size_t i = openings.size(); i-- > 0;) test_opening(waiting, openings[i]);
    return;
  }
  const auto meets = [this](const geometry::Box& box) { return may_see(box); };
  crowded->lines.for_each_that(meets, draw);
  search.openings_met_.clear();
  crowded->openings.for_each_that(meets, [&](std::uint32_t i) { search.openings_met_.push_back(i); });
  std::sort(search.openings_met_.begin(), search.openings_met_.end(), std::greater<>());
  for (const std::uint32_t i : search.openings_met_) test_opening(waiting, openings[i]);
}

template <class Arithmetic, class Listener>
void Search<Arithmetic, Listener>::Pass::test_opening(const Waiting& waiting, std::uint32_t opening) {
  const auto& cells = prepared.complex().openings[opening].cells;
  const bool from_negative_side = cells[0] == waiting.cell;
  if (cells[from_negative_side ? 1 : 0] == scene::outside) return;
  if (faces_eye(opening, from_negative_side)) {
    queue_cell_beyond(opening, from_negative_side, waiting.depth);
  } else {
    search.listener_.portal(opening, cells[from_negative_side ? 1 : 0], PortalTest::faces_away);
  }
}

// Pushes the cell beyond an opening that faces the eye, if any of it is seen through the opening and the current mask.
template <class Arithmetic, class Listener>
void Search<Arithmetic, Listener>::Pass::queue_cell_beyond(std::uint32_t number, bool from_negative_side,
                                            std::uint32_t depth) {
  const scene::ComplexOpening& opening = prepared.complex().openings[number];
  ++counts.openings_tested;
  Reached::Opening& state = reached.openings[number];
  if (state.first_plane == 0) make_planes(opening, state);
  const std::uint32_t first = state.first_plane;
  std::span<const Side> left = search.mask_;
  if (left.empty()) {
    left = first_mask(first, opening.side_count);
    if (sight.perspective() && !left.empty()) left = clipped(left, 0);
  } else {
    left = clipped_by_sides(left, state, opening.side_count);
  }
  if (left.empty()) {
    search.listener_.portal(number, opening.cells[from_negative_side ? 1 : 0], PortalTest::nothing_left);
    return;
  }
  ++counts.masks;
  counts.mask_sides = std::max<std::uint64_t>(counts.mask_sides, left.size());
  const scene::CellNumber beyond = opening.cells[from_negative_side ? 1 : 0];
  search.waiting_.push_back({beyond, depth + 1, search.waiting_sides_.size(), left.size()});
  search.waiting_sides_.insert(search.waiting_sides_.end(), left.begin(), left.end());
  search.listener_.waits(number, beyond, left, search.planes_);
}

// The eye is off the opening's plane, on its negative side if so requested, else on its positive side.
template <class Arithmetic, class Listener>
inline bool Search<Arithmetic, Listener>::Pass::faces_eye(std::uint32_t number, bool from_negative_side) {
  Reached::Opening& state = reached.openings[number];
  if (state.view != reached.view) {
    const std::uint32_t plane = prepared.complex().openings[number].plane;
    state = {reached.view, 0, static_cast<std::int16_t>(geometry::sign(sight.eye_value(prepared.planes()[plane]))), 0};
  }
  return state.eye_side == (from_negative_side ? -1 : 1);
}

// Computes the planes in the order of the sides of a mask.
template <class Arithmetic, class Listener>
void Search<Arithmetic, Listener>::Pass::make_planes(const scene::ComplexOpening& opening, Reached::Opening& state) {
  const std::size_t first = search.planes_.size();
  state.first_plane = static_cast<std::uint32_t>(first);
  const geometry::Plane& plane = prepared.planes()[opening.plane];
  const std::int64_t eye = sight.eye_value(plane);
  const auto sides = prepared.complex().sides_of(opening);
  search.planes_.resize(first + sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const scene::HalfSpace& side = sides[eye < 0 ? i : sides.size() - 1 - i];
    search.planes_[first + i] =
        sight.template through<Number>(plane, eye, prepared.planes()[side.plane], side.turned);
  }
}

// A mask of the whole opening. A side collinear with the next one is left out.
template <class Arithmetic, class Listener>
auto Search<Arithmetic, Listener>::Pass::first_mask(std::uint32_t first_plane, std::uint32_t count)
    -> std::span<const Side> {
  std::vector<Side>& mask = search.cut_;
  mask.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t plane = first_plane + i;
    if (!mask.empty()) {
      mask.back().corner = Arithmetic::meet(image(mask.back().plane), image(plane));
      if (Arithmetic::is_zero(mask.back().corner)) continue;
    }
    mask.push_back({plane, {}});
  }
  while (mask.size() > 2) {
    mask.back().corner = Arithmetic::meet(image(mask.back().plane), image(mask.front().plane));
    if (!Arithmetic::is_zero(mask.back().corner)) return mask;
    mask.pop_back();
  }
  return {};
}

// Returns an empty mask if nothing is left. The result is the given mask or one of the two buffers.
template <class Arithmetic, class Listener>
auto Search<Arithmetic, Listener>::Pass::clipped(std::span<const Side> mask, std::uint32_t plane)
    -> std::span<const Side> {
  std::vector<Side>& left = mask.data() == search.cut_.data() ? search.cut_again_ : search.cut_;
  const auto image_of = [this](std::uint32_t number) { return image(number); };
  return clip_mask<Arithmetic>(mask, plane, image(plane), image_of, search.signs_, left);
}

// Most openings miss the mask, so first every side is tested for leaving nothing, starting with the one that excluded the
// last mask. A side that cuts nothing off the mask cuts nothing off what the other sides leave, either.
template <class Arithmetic, class Listener>
auto Search<Arithmetic, Listener>::Pass::clipped_by_sides(std::span<const Side> mask, Reached::Opening& opening,
                                                          std::uint32_t count) -> std::span<const Side> {
  if (search.cutting_planes_.size() < count) search.cutting_planes_.resize(count);
  std::uint32_t side = opening.excluding_side;
  for (std::uint32_t i = 0; i < count; ++i) {
    const typename Arithmetic::Line line = image(opening.first_plane + side);
    unsigned inside = 0;
    unsigned outside = 0;
    for (const Side& of_mask : mask) {
      const int sign = Arithmetic::side(line, of_mask.corner);
      inside |= static_cast<unsigned>(sign > 0);
      outside |= static_cast<unsigned>(sign < 0);
    }
    if (inside == 0) {
      opening.excluding_side = static_cast<std::uint16_t>(side);
      return {};
    }
    search.cutting_planes_[side] = static_cast<std::uint8_t>(outside);
    if (++side == count) side = 0;
  }
  for (std::uint32_t i = 0; i < count && !mask.empty(); ++i)
    if (search.cutting_planes_[i] != 0) mask = clipped(mask, opening.first_plane + i);
  return mask;
}

extern template class Search<NarrowArithmetic>;
extern template class Search<MediumArithmetic>;
extern template class Search<WideArithmetic>;
extern template class Search<WideArithmetic, TraceListener>;

}  // namespace sightline::algorithms::jones

#include "host/algorithms/jones/search_lines.hpp"  // IWYU pragma: export
