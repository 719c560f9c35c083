// The search along avenues of sight: from cell to cell through openings, each with the mask that is left.
//
// Cells that wait, with their masks, are on a stack; a cell's mask leaves it when the cell's turn comes, so a
// passage through any number of rooms keeps one. Openings are put there last to first, which gives the
// order of the paper: a cell's lines, then what is seen through its first opening, and so on.
//
// Planes of sight are worked out when an opening is first looked at, once for a view.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "host/algorithms/jones/arithmetic.hpp"
#include "host/algorithms/jones/fragments.hpp"
#include "host/algorithms/jones/mask.hpp"
#include "host/algorithms/jones/met.hpp"
#include "host/algorithms/jones/prepared_complex.hpp"
#include "host/algorithms/jones/sight_plane.hpp"
#include "host/algorithms/jones/start_cells.hpp"
#include "host/algorithms/jones/stretch.hpp"
#include "host/algorithms/jones/visible_edges.hpp"
#include "host/geometry/box.hpp"
#include "host/geometry/integer.hpp"

namespace sightline::algorithms::jones {

template <class Arithmetic>
class Search {
 public:
  [[nodiscard]] std::variant<View, Error> run(const PreparedComplex& prepared, Met& met,
                                              const scene::PolyCamera& camera, const Start& start);

 private:
  using Number = typename Arithmetic::Number;
  using Side = MaskSide<Arithmetic>;

  // A cell that waits; without sides it is seen whole.
  struct Waiting {
    scene::CellNumber cell = 0;
    std::uint32_t depth = 0;
    std::size_t first_side = 0;
    std::size_t side_count = 0;
  };

  // One view: the search with what it looks at.
  struct Pass {
    const PreparedComplex& prepared;
    Met& met;
    const Sight sight;
    Search& search;
    Counts counts;

    [[nodiscard]] typename Arithmetic::Line image(std::uint32_t plane) const {
      return sight.template image<Arithmetic>(search.planes_[plane]);
    }
    void draw_outer_faces();
    [[nodiscard]] bool walk();
    void visit(const Waiting& waiting);
    [[nodiscard]] bool may_see(const geometry::Box& box) const;
    void draw_line(const scene::ComplexLine& line, std::span<const Side> mask);
    void look_out(const Waiting& waiting, std::uint32_t opening);
    void look_through(std::uint32_t opening, scene::CellNumber beyond, std::uint32_t depth);
    [[nodiscard]] bool faces_eye(std::uint32_t opening, bool from_negative_side);
    void make_planes(const scene::ComplexOpening& opening, Met::Opening& state);
    [[nodiscard]] std::span<const Side> first_mask(std::uint32_t first_plane, std::uint32_t count);
    [[nodiscard]] std::span<const Side> clipped(std::span<const Side> mask, std::uint32_t plane);
  };

  std::vector<SightPlane<Number>> planes_;  // [0]: before the eye, in perspective
  std::vector<Waiting> waiting_;
  std::vector<Side> waiting_sides_;
  std::vector<Side> mask_;  // of the cell visited
  std::vector<Side> cut_;
  std::vector<Side> cut_again_;
  std::vector<std::int8_t> signs_;
  std::size_t hiding_side_ = 0;              // of a mask: beyond which the last hidden line lay
  std::vector<std::uint32_t> met_openings_;  // of a crowded cell
  Fragments<Number> fragments_;
};

template <class Arithmetic>
std::variant<View, Error> Search<Arithmetic>::run(const PreparedComplex& prepared, Met& met,
                                                  const scene::PolyCamera& camera, const Start& start) {
  met.begin_view();
  planes_.clear();
  waiting_.clear();
  waiting_sides_.clear();
  fragments_.clear();
  Pass pass{prepared, met, Sight(camera), *this, {}};
  SightPlane<Number>& before_eye = planes_.emplace_back();
  for (std::size_t a = 0; a < 3; ++a) before_eye.normal[a] = camera.forward[a];
  if (start.outside) {
    pass.draw_outer_faces();
    mask_.clear();
    for (const std::uint32_t number : prepared.entrances()) {
      const auto& cells = prepared.complex().openings[number].cells;
      pass.look_through(number, cells[0] == scene::outside ? cells[1] : cells[0], 0);
    }
  }
  for (const scene::CellNumber cell : start.cells) waiting_.push_back({cell, 1, waiting_sides_.size(), 0});
  if (!pass.walk()) return Error::no_complex;
  auto picture = fragments_.picture(prepared.complex(), pass.sight);
  if (!picture) return Error::no_complex;
  pass.counts.number_bits = 8 * sizeof(Number);
  return View{std::move(*picture), pass.counts};
}

// From outside, what lies in a face of the outer box that is not turned away is seen without an opening.
template <class Arithmetic>
void Search<Arithmetic>::Pass::draw_outer_faces() {
  for (const OuterFace& face : prepared.outer_faces()) {
    if (sight.eye_value(face.plane) < 0) continue;
    for (const std::uint32_t edge : face.edges) draw_line({edge, 0, 1}, {});
  }
}

// False if a sight line passes more cells than there are.
template <class Arithmetic>
bool Search<Arithmetic>::Pass::walk() {
  while (!search.waiting_.empty()) {
    const Waiting next = search.waiting_.back();
    search.waiting_.pop_back();
    if (next.depth > prepared.complex().cells.size()) return false;
    visit(next);
  }
  return true;
}

template <class Arithmetic>
void Search<Arithmetic>::Pass::visit(const Waiting& waiting) {
  const auto first = search.waiting_sides_.begin() + static_cast<std::ptrdiff_t>(waiting.first_side);
  search.mask_.assign(first, first + static_cast<std::ptrdiff_t>(waiting.side_count));
  search.waiting_sides_.resize(waiting.first_side);
  ++counts.visits;
  counts.depth = std::max<std::uint64_t>(counts.depth, waiting.depth);
  if (met.cells[waiting.cell] != met.view) {
    met.cells[waiting.cell] = met.view;
    ++counts.cells;
  }
  const scene::CellComplex& complex = prepared.complex();
  const scene::ComplexCell& cell = complex.cells[waiting.cell];
  const auto lines = complex.lines_of(cell);
  const auto openings = complex.openings_of(cell);
  const CrowdedCell* const crowded = prepared.crowded(waiting.cell);
  if (crowded == nullptr) {
    for (const scene::ComplexLine line : lines) draw_line(line, search.mask_);
    for (std::size_t i = openings.size(); i-- > 0;) look_out(waiting, openings[i]);
    return;
  }
  const auto meets = [this](const geometry::Box& box) { return may_see(box); };
  crowded->lines.for_each_that(meets, [&](std::uint32_t i) { draw_line(lines[i], search.mask_); });
  search.met_openings_.clear();
  crowded->openings.for_each_that(meets, [&](std::uint32_t i) { search.met_openings_.push_back(i); });
  std::sort(search.met_openings_.begin(), search.met_openings_.end(), std::greater<>());
  for (const std::uint32_t i : search.met_openings_) look_out(waiting, openings[i]);
}

template <class Arithmetic>
void Search<Arithmetic>::Pass::look_out(const Waiting& waiting, std::uint32_t opening) {
  const auto& cells = prepared.complex().openings[opening].cells;
  const scene::CellNumber beyond = cells[0] == waiting.cell ? cells[1] : cells[0];
  if (beyond != scene::outside) look_through(opening, beyond, waiting.depth);
}

// False if the box lies beyond one side of the mask at hand.
template <class Arithmetic>
bool Search<Arithmetic>::Pass::may_see(const geometry::Box& box) const {
  const auto beyond = [&](const SightPlane<Number>& plane) {
    scene::PolyPoint corner{};
    for (std::size_t a = 0; a < 3; ++a) corner[a] = plane.normal[a] < 0 ? box.low[a] : box.high[a];
    return plane.at(sight.from_eye(corner)) < 0;
  };
  if (search.mask_.empty()) return !sight.perspective() || !beyond(search.planes_[0]);
  return std::none_of(search.mask_.begin(), search.mask_.end(),
                      [&](const Side& side) { return beyond(search.planes_[side.plane]); });
}

template <class Arithmetic>
void Search<Arithmetic>::Pass::draw_line(const scene::ComplexLine& line, std::span<const Side> mask) {
  ++counts.lines_clipped;
  const scene::CellComplex& complex = prepared.complex();
  const scene::ComplexEdge& edge = complex.edges[line.edge];
  const geometry::Vector3 from = sight.from_eye(complex.vertices[edge.from]);
  const geometry::Vector3 to = sight.from_eye(complex.vertices[edge.to]);
  Stretch<Number> stretch{{line.low.numerator(), line.low.denominator()},
                          {line.high.numerator(), line.high.denominator()}};
  if (mask.empty() && sight.perspective()) {
    const SightPlane<Number>& before_eye = search.planes_[0];
    if (!stretch.keep_not_negative(before_eye.at(from), before_eye.at(to))) return;
  }
  // What hid the last line is likely to hide this one.
  std::size_t side = search.hiding_side_ < mask.size() ? search.hiding_side_ : 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    const SightPlane<Number>& plane = search.planes_[mask[side].plane];
    if (!stretch.keep_not_negative(plane.at(from), plane.at(to))) {
      search.hiding_side_ = side;
      return;
    }
    if (++side == mask.size()) side = 0;
  }
  if (!less(stretch.low, stretch.high)) return;
  ++counts.fragments;
  search.fragments_.add(line.edge, stretch);
}

// Lets the cell beyond wait if anything of it is seen through the opening and the mask at hand.
template <class Arithmetic>
void Search<Arithmetic>::Pass::look_through(std::uint32_t number, scene::CellNumber beyond,
                                            std::uint32_t depth) {
  const scene::ComplexOpening& opening = prepared.complex().openings[number];
  if (!faces_eye(number, opening.cells[1] == beyond)) return;
  ++counts.openings_tested;
  const std::uint32_t first = met.openings[number].first_plane;
  std::span<const Side> left = search.mask_;
  if (left.empty()) {
    left = first_mask(first, opening.side_count);
    if (sight.perspective() && !left.empty()) left = clipped(left, 0);
  } else {
    for (std::uint32_t i = 0; i < opening.side_count && !left.empty(); ++i) left = clipped(left, first + i);
  }
  if (left.empty()) return;
  ++counts.masks;
  counts.mask_sides = std::max<std::uint64_t>(counts.mask_sides, left.size());
  search.waiting_.push_back({beyond, depth + 1, search.waiting_sides_.size(), left.size()});
  search.waiting_sides_.insert(search.waiting_sides_.end(), left.begin(), left.end());
}

// The eye is off the opening's plane, on its negative side or on the other.
template <class Arithmetic>
bool Search<Arithmetic>::Pass::faces_eye(std::uint32_t number, bool from_negative_side) {
  const scene::ComplexOpening& opening = prepared.complex().openings[number];
  Met::Opening& state = met.openings[number];
  if (state.view != met.view) {
    state = {met.view, 0, geometry::sign(sight.eye_value(prepared.planes()[opening.plane]))};
  }
  if (state.eye_side != (from_negative_side ? -1 : 1)) return false;
  if (state.first_plane == 0) make_planes(opening, state);
  return true;
}

// In the order in which they go round as a mask does.
template <class Arithmetic>
void Search<Arithmetic>::Pass::make_planes(const scene::ComplexOpening& opening, Met::Opening& state) {
  state.first_plane = static_cast<std::uint32_t>(search.planes_.size());
  const geometry::Plane& plane = prepared.planes()[opening.plane];
  const std::int64_t eye = sight.eye_value(plane);
  const auto sides = prepared.complex().sides_of(opening);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const scene::HalfSpace& side = sides[eye < 0 ? i : sides.size() - 1 - i];
    search.planes_.push_back(
        sight.template through<Number>(plane, eye, prepared.planes()[side.plane], side.turned));
  }
}

// The whole opening; a side in one line with the next adds nothing.
template <class Arithmetic>
auto Search<Arithmetic>::Pass::first_mask(std::uint32_t first_plane, std::uint32_t count)
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

// Empty if nothing is left. The result is the given mask or lies in one of the two buffers.
template <class Arithmetic>
auto Search<Arithmetic>::Pass::clipped(std::span<const Side> mask, std::uint32_t plane)
    -> std::span<const Side> {
  std::vector<Side>& left = mask.data() == search.cut_.data() ? search.cut_again_ : search.cut_;
  const auto image_of = [this](std::uint32_t number) { return image(number); };
  return clip_mask<Arithmetic>(mask, plane, image(plane), image_of, search.signs_, left);
}

extern template class Search<NarrowArithmetic>;
extern template class Search<MediumArithmetic>;
extern template class Search<WideArithmetic>;

}  // namespace sightline::algorithms::jones
