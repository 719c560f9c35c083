// The drawing part of the search: clips lines to the current mask. Only search.hpp includes it.
//
// When a cell is entered, the planes of the mask's sides are copied to one array, because each line is tested with all of
// them. Most lines are hidden, so that is tested first.
#pragma once

#include "host/algorithms/jones/search.hpp"

namespace sightline::algorithms::jones {

template <class Arithmetic, class Listener>
void Search<Arithmetic, Listener>::Pass::take_mask(const Waiting& waiting) {
  set_whole_view();
  if (waiting.side_count == 0) return;
  const auto first = search.waiting_sides_.begin() + static_cast<std::ptrdiff_t>(waiting.first_side);
  search.mask_.assign(first, first + static_cast<std::ptrdiff_t>(waiting.side_count));
  search.waiting_sides_.resize(waiting.first_side);
  search.mask_planes_.clear();
  for (const Side& side : search.mask_) search.mask_planes_.push_back(search.planes_[side.plane]);
  if (search.cutting_sides_.size() < waiting.side_count) search.cutting_sides_.resize(waiting.side_count);
}

// The current mask is everything in front of the eye.
template <class Arithmetic, class Listener>
void Search<Arithmetic, Listener>::Pass::set_whole_view() {
  search.mask_.clear();
  search.mask_planes_.clear();
  if (search.cutting_sides_.empty()) search.cutting_sides_.resize(1);
  if (sight.perspective()) search.mask_planes_.push_back(search.planes_[0]);
}

// part() returns the line as a stretch of its edge. It is called only if the line is not hidden, and most are.
template <class Arithmetic, class Listener>
template <class Part>
inline void Search<Arithmetic, Listener>::Pass::draw_line(std::uint32_t number, const Part& part) {
  ++counts.lines_clipped;
  const scene::CellComplex& complex = prepared.complex();
  const scene::ComplexEdge& edge = complex.edges[number];
  const geometry::Vector3 from = geometry::vector_of(complex.vertices[edge.from]);
  const geometry::Vector3 to = geometry::vector_of(complex.vertices[edge.to]);
  if (!hidden(from, to)) {
    draw_rest(number, part());
  } else {
    search.listener_.hidden(edge.from, edge.to);
  }
}

// Draws what the cutting sides leave of a stretch.
template <class Arithmetic, class Listener>
void Search<Arithmetic, Listener>::Pass::draw_rest(std::uint32_t number, Stretch<Number> left) {
  const scene::CellComplex& complex = prepared.complex();
  const geometry::Vector3 from = geometry::vector_of(complex.vertices[complex.edges[number].from]);
  const geometry::Vector3 to = geometry::vector_of(complex.vertices[complex.edges[number].to]);
  for (const std::size_t side : std::span(search.cutting_sides_).first(search.cutting_)) {
    const SightPlane<Number>& plane = search.mask_planes_[side];
    left.keep_not_negative(plane.at(from), plane.at(to));
  }
  if (!less(left.low, left.high)) {
    search.listener_.hidden(complex.edges[number].from, complex.edges[number].to);
    return;
  }
  ++counts.fragments;
  search.listener_.seen(complex.edges[number].from, complex.edges[number].to, left);
  search.fragments_.add(number, left);
}

// Returns true if one side of the mask hides the edge. Otherwise the first cutting_ entries of cutting_sides_ are the
// sides that hide part of it.
template <class Arithmetic, class Listener>
inline bool Search<Arithmetic, Listener>::Pass::hidden(const geometry::Vector3& from, const geometry::Vector3& to) {
  const SightPlane<Number>* const planes = search.mask_planes_.data();
  const std::size_t count = search.mask_planes_.size();
  std::size_t* const sides = search.cutting_sides_.data();
  std::size_t cutting = 0;
  // The side that hid the last line is likely to hide this one.
  std::size_t side = search.hiding_side_ < count ? search.hiding_side_ : 0;
  for (std::size_t left = count; left > 0; --left) {
    const Number a = planes[side].at(from);
    const Number b = planes[side].at(to);
    if (hides(a, b)) {
      search.hiding_side_ = side;
      return true;
    }
    sides[cutting] = side;
    cutting += cuts(a, b) ? 1 : 0;
    if (++side == count) side = 0;
  }
  search.cutting_ = cutting;
  return false;
}

// Returns false if the box lies beyond one side of the current mask.
template <class Arithmetic, class Listener>
bool Search<Arithmetic, Listener>::Pass::may_see(const geometry::Box& box) const {
  const auto beyond = [&](const SightPlane<Number>& plane) {
    scene::PolyPoint corner{};
    for (std::size_t a = 0; a < 3; ++a) corner[a] = plane.normal[a] < 0 ? box.low[a] : box.high[a];
    return plane.at(geometry::vector_of(corner)) < 0;
  };
  return std::none_of(search.mask_planes_.begin(), search.mask_planes_.end(), beyond);
}

// From outside, edges in a face of the outer box that is turned to the eye are visible without passing an opening.
template <class Arithmetic, class Listener>
void Search<Arithmetic, Listener>::Pass::draw_outer_faces() {
  for (const OuterFace& face : prepared.outer_faces()) {
    if (sight.eye_value(face.plane) < 0) continue;
    for (const std::uint32_t edge : face.edges)
      draw_line(edge, [] { return Stretch<Number>{{0, 1}, {1, 1}}; });
  }
}

}  // namespace sightline::algorithms::jones
