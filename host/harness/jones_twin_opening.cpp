// The opening's part of the search: which side the eye is on, what of it shows through the mask, the way in.
#include <algorithm>
#include <optional>

#include "host/harness/jones_twin_search.hpp"

namespace sightline::harness::jones {

using core::Word18;

bool Search::opening(std::uint32_t far_word_address) {
  const Word18 far_word = core_[far_word_address];
  const bool towards_higher = !far_word.bit(0);  // N = 0: the far cell is on the high side
  const std::uint32_t element = (far_word_address + (towards_higher ? 1 : 2)) & address_mask;
  if (element == levels_.back().entry) return true;
  ++view_.counts.openings_tested;
  const Chain chain = chain_at(element);
  RingScan facts;
  if (!scan(chain, towards_higher, facts)) return false;
  if (!facts.crossing) return !facts.actual_lines || walk(chain, nullptr);
  ++view_.counts.openings_crossing;
  Outline outline{RingBound(facts.plane, facts.distance, window_.bound_factor), {}};
  if (!walk(chain, &outline)) return false;
  outline.polygon.close();
  if (outline.polygon.points().size() < 3) return true;
  return go_through(far_word.field(5, 17), element, outline.polygon, facts.counter_clockwise);
}

bool Search::scan(const Chain& ring, bool towards_higher, RingScan& facts) {
  const Vector first(core_[ring.first()]);
  if (ring.count == 0 || first.axis_code == 0) return fail(Status::bad_data_element);
  std::optional<Vector> second;
  for (std::uint32_t i = 0; i < ring.count; ++i) {
    if (!spend()) return false;
    const Vector vector(core_[ring.first() + i]);
    facts.actual_lines = facts.actual_lines || vector.actual_line;
    if (!second && vector.axis_code != first.axis_code) second = vector;
  }
  if (!second || second->axis_code == 0) return fail(Status::bad_data_element);
  const bool cyclic = second->axis_code == first.axis_code % 3 + 1;
  const bool positive = (first.negative == second->negative) == cyclic;  // sigma = +1
  const std::uint32_t normal = 6 - first.axis_code - second->axis_code;
  facts.plane = Axis{static_cast<std::uint8_t>(normal)};
  facts.distance = ring.origin.*coordinate(normal);
  facts.crossing = towards_higher ? facts.distance > 0 : facts.distance < 0;
  if (facts.plane == Axis::z) facts.crossing = towards_higher && facts.distance >= near_z;
  facts.counter_clockwise = positive == towards_higher;
  return true;
}

bool Search::append_corner(Outline& outline, const SpacePoint& corner) {
  ScreenPoint projected;
  if (!project_point(corner, projected)) return false;
  return outline.polygon.append(projected) || fail(Status::too_many_mask_vertices);
}

bool Search::append_side(Outline& outline, const SpaceSegment& moved, Axis axis, bool last) {
  const auto bend = axis == Axis::z ? outline.bound.bend(moved) : std::nullopt;
  if (bend && !append_corner(outline, *bend)) return false;
  return last || append_corner(outline, outline.bound.into_bound(moved.q));
}

bool Search::go_through(std::uint32_t far_cell, std::uint32_t element, PolygonBuilder& polygon,
                        bool counter_clockwise) {
  if (!counter_clockwise) polygon.reverse();
  const Intersection seen = intersect(levels_.back().mask, polygon.points(), view_.counts.operations);
  if (seen.outcome == MaskOutcome::too_many_vertices) return fail(Status::too_many_mask_vertices);
  if (seen.outcome == MaskOutcome::empty) return true;
  ++view_.counts.masks_made;
  if (levels_.size() + 1 > core_[header_ + 1].value()) return fail(Status::deeper_than_cells);
  const int frame = frame_words(levels_.back().mask);
  if (stack_words_ + frame > mask_stack_words) return fail(Status::stack_overflow);
  stack_words_ += frame;
  view_.counts.stack_words = std::max(view_.counts.stack_words, stack_words_);
  return visit(far_cell, seen.mask, element);
}

}  // namespace sightline::harness::jones
