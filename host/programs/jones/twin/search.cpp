#include "host/programs/jones/twin/search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace sightline::programs::jones {
namespace {

using core::Word18;

constexpr Word18 no_openings{0400000};
constexpr std::uint32_t no_entry = 0777777;

// Only number types with several roundings need the call.
template <class Number>
void enter(Number& number, Rounding rounding) {
  if constexpr (requires { number.enter(rounding); }) number.enter(rounding);
}

}  // namespace

template <class Number>
auto Search<Number>::run() && -> View {
  if (!parameters_.stereo) {
    pass(Pass::mono, parameters_.eye);
  } else if (pass(Pass::left, stereo_eye(-separation))) {
    pass(Pass::right, stereo_eye(separation));
  }
  view_.counts.distinct_cells = cells_.count();
  view_.display_file = std::move(file_).finish();
  return std::move(view_);
}

template <class Number>
SpacePoint Search<Number>::stereo_eye(std::int32_t shift) const {
  SpacePoint eye = parameters_.eye;
  const auto limited = [&](std::int32_t value, std::uint32_t word) {
    return std::min(std::max(value, core_.number(header_ + word)), core_.number(header_ + word + 1));
  };
  if (!parameters_.direction) {
    eye.x = limited(wrapped(std::int64_t{eye.x} + shift), 5);
    return eye;
  }
  const auto [x, z] = TurnedSteps().take(*parameters_.direction, shift, 0);
  eye.x = limited(wrapped(std::int64_t{eye.x} + x), 5);
  eye.z = limited(wrapped(std::int64_t{eye.z} + z), 9);
  return eye;
}

template <class Number>
bool Search<Number>::chain_at(std::uint32_t element, Chain& chain) {
  const auto relative = [&](std::uint32_t at, std::int32_t eye) {
    return number_.sum(std::int64_t{core_.number(element + at)} - eye);
  };
  chain = {element & address_mask,
           {relative(0, eye_.x), relative(1, eye_.y), relative(2, eye_.z)},
           core_[element + 3].value()};
  return sound();
}

template <class Number>
bool Search<Number>::pass(Pass which, SpacePoint eye) {
  pass_ = which;
  eye_ = eye;
  window_ = window_of(which, parameters_.scale, number_.fraction_bits(), number_.word_bits());
  if (!fits(window_, number_.fraction_bits(), number_.word_bits())) return fail(Status::arithmetic_overflow);
  if (parameters_.direction) turned_.emplace(*parameters_.direction, window_, ShortWords(machine_word_bits, parameters_.fraction_bits, parameters_.truncate));
  if (!visit(core_[header_].field(5, 17), window_mask<Coordinate>(window_), no_entry)) return false;
  while (!levels_.empty()) {
    Level& top = levels_.back();
    if (top.exhausted) {
      levels_.pop_back();
      if (!levels_.empty()) stack_words_ -= frame_words(levels_.back().mask);
      continue;
    }
    const Word18 entry = core_[top.next_entry++];
    top.exhausted = entry.bit(0);
    if (entry == no_openings) continue;
    if (!spend() || !opening(entry.field(5, 17))) return false;
  }
  return true;
}

template <class Number>
bool Search<Number>::visit(std::uint32_t cell, const Mask& mask, std::uint32_t entry) {
  Chain chain;
  if (!chain_at(cell, chain)) return false;
  levels_.push_back({mask, entry, chain.first() + chain.count});
  TwinCounts& counts = view_.counts;
  ++counts.visits;
  cells_.set(cell & address_mask);
  counts.depth = std::max(counts.depth, static_cast<int>(levels_.size()));
  counts.mask_vertices = std::max(counts.mask_vertices, mask.count);
  return walk(chain, nullptr);
}

template <class Number>
bool Search<Number>::walk(const Chain& chain, Outline* outline) {
  if (turned_) return walk_turned(chain, outline);
  SpacePoint point = chain.origin;
  projected_last_.reset();
  if (outline && !append_corner(*outline, outline->bound.into_bound(point))) return false;
  for (std::uint32_t i = 0; i < chain.count; ++i) {
    const std::uint32_t address = chain.first() + i;
    const Vector vector(core_[address]);
    SpaceSegment moved;
    if (!move(point, vector, moved)) return false;
    if (vector.actual_line && !draw(moved, axis_of(vector), address)) return false;
    if (outline && !append_side(*outline, moved, axis_of(vector), i + 1 == chain.count)) return false;
  }
  return true;
}

template <class Number>
bool Search<Number>::move(SpacePoint& point, Vector vector, SpaceSegment& moved) {
  if (!spend()) return false;
  ++view_.counts.vectors;
  if (vector.axis_code == 0) return fail(Status::bad_data_element);
  moved.p = point;
  auto& along = point.*coordinate(vector.axis_code);
  along = number_.sum(std::int64_t{along} + vector.magnitude);
  moved.q = point;
  return sound();
}

template <class Number>
void Search<Number>::count_fresh(const SpacePoint& point) {
  const bool same_depth = projected_last_ && projected_last_->z == point.z;
  if (!same_depth || projected_last_->x != point.x) ++view_.counts.fresh_coordinates;
  if (!same_depth || projected_last_->y != point.y) ++view_.counts.fresh_coordinates;
  projected_last_ = point;
}

template <class Number>
bool Search<Number>::project_point(const SpacePoint& point, Point& projected) {
  count_fresh(point);
  const auto place = project(number_, point, window_.width_scale, view_.counts.operations);
  if (!place) return fail(Status::arithmetic_overflow);
  projected = *place;
  auto& largest = view_.counts.largest_coordinate;
  largest = std::max({largest, std::abs(number_.points(place->x)), std::abs(number_.points(place->y))});
  return true;
}

template <class Number>
bool Search<Number>::draw(const SpaceSegment& moved, Axis axis, std::uint32_t vector_address) {
  const auto part = seg3(moved, axis, window_.bound_factor, number_.largest());
  if (!part) return true;
  BasicScreenSegment<Coordinate> line;
  enter(number_, Rounding::line_ends);
  if (!project_point(part->p, line.a) || !project_point(part->q, line.b)) return false;
  return draw_through_mask(line, vector_address);
}

template <class Number>
bool Search<Number>::draw_through_mask(const BasicScreenSegment<Coordinate>& line, std::uint32_t vector_address) {
  ++view_.counts.lines_clipped;
  const auto left = MaskClip(number_, view_.counts.operations).clip2(levels_.back().mask, line);
  if (!sound()) return false;
  if (!left) return true;
  BasicPiece<Coordinate> piece{static_cast<std::uint16_t>(vector_address & address_mask), pass_, *left};
  return add_to_file(piece);
}

template <class Number>
bool Search<Number>::add_to_file(BasicPiece<Coordinate>& piece) {
  const auto point = [&](const Point& p) {
    return ScreenPoint{number_.point(p.x) + window_.centre_x, number_.point(p.y) + window_.centre_y};
  };
  const auto outcome = file_.add(point(piece.line.a), point(piece.line.b), view_.counts.operations);
  if (outcome == DisplayFile::Outcome::full) return fail(Status::display_file_overflow);
  piece.drawn = outcome == DisplayFile::Outcome::drawn;
  view_.clipped.push_back(piece);
  if (!piece.drawn) return true;
  ++view_.counts.pieces;
  view_.pieces.push_back(piece);
  return true;
}

// The opening: the side of the eye, the part inside the mask, the entrance.

template <class Number>
bool Search<Number>::opening(std::uint32_t far_word_address) {
  const Word18 far_word = core_[far_word_address];
  const bool towards_higher = !far_word.bit(0);  // N = 0: the far cell is on the high side
  const std::uint32_t element = (far_word_address + (towards_higher ? 1 : 2)) & address_mask;
  if (element == levels_.back().entry) return true;
  ++view_.counts.openings_tested;
  Chain chain;
  if (!chain_at(element, chain)) return false;
  RingScan facts;
  if (!scan(chain, towards_higher, facts)) return false;
  if (facts.crossing) ++view_.counts.openings_crossing;
  if (!facts.crossing && !turned_) return !facts.actual_lines || walk(chain, nullptr);
  Outline outline{RingBound(facts.plane, facts.distance, window_.bound_factor, number_.largest()), {}, {}, beyond_none};
  if (!walk(chain, &outline)) return false;
  if (turned_ && facts.actual_lines && !walk(chain, nullptr)) return false;
  if (!facts.crossing) return true;
  outline.polygon.close();
  if (outline.polygon.points().size() < 3) return true;
  return go_through(far_word.field(5, 17), element, outline.polygon, facts.counter_clockwise);
}

template <class Number>
bool Search<Number>::scan(const Chain& ring, bool towards_higher, RingScan& facts) {
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
  if (facts.plane == Axis::z && !turned_) facts.crossing = towards_higher && facts.distance >= near_z;
  facts.counter_clockwise = positive == towards_higher;
  return true;
}

template <class Number>
bool Search<Number>::append_corner(Outline& outline, const SpacePoint& corner) {
  Point projected;
  enter(number_, Rounding::opening_corners);
  if (!project_point(corner, projected)) return false;
  return outline.polygon.append(projected) || fail(Status::too_many_mask_vertices);
}

template <class Number>
bool Search<Number>::append_side(Outline& outline, const SpaceSegment& moved, Axis axis, bool last) {
  const auto bend = axis == Axis::z ? outline.bound.bend(moved) : std::nullopt;
  if (bend && !append_corner(outline, *bend)) return false;
  return last || append_corner(outline, outline.bound.into_bound(moved.q));
}

// A view turned about the vertical.

template <class Number>
bool Search<Number>::walk_turned(const Chain& chain, Outline* outline) {
  SpacePoint point = chain.origin;
  TurnedPlace place = turned_->moved(turned_->moved({}, Axis::x, point.x), Axis::z, point.z);
  std::optional<SeenCorner> seen;  // the corner at `point`, if anything has asked for it
  for (std::uint32_t i = 0; i < chain.count; ++i) {
    const std::uint32_t address = chain.first() + i;
    const Vector vector(core_[address]);
    const bool needed = outline != nullptr || vector.actual_line;
    if (vector.axis_code != 0 && needed && !seen && !(seen = turned_->corner(place, point.y))) return fail(Status::arithmetic_overflow);
    SpaceSegment moved;
    if (!move(point, vector, moved)) return false;
    const Axis axis = axis_of(vector);
    place = turned_->moved(place, axis, vector.magnitude);
    const std::optional<SeenCorner> before = std::exchange(seen, std::nullopt);
    if (!needed) continue;
    if (!(seen = turned_->corner(place, point.y))) return fail(Status::arithmetic_overflow);
    if (axis == Axis::y) {
      if (seen->beyond == beyond_none && !outline && !draw_turned(before->place, seen->place, address)) return false;
      continue;
    }
    const auto level = turned_->level(axis, point, *before, *seen);
    if (!level) continue;
    const ScreenPoint& from = level->bend && level->a.drawn_back ? *level->bend : level->a.place;
    const ScreenPoint& to = level->bend && level->b.drawn_back ? *level->bend : level->b.place;
    if (!outline && !draw_turned(from, to, address)) return false;
    if (outline && !append_turned(*level, point.y, *outline)) return false;
  }
  return !outline || append_round(outline->came.value_or(beyond_none), point.y, *outline);
}

template <class Number>
bool Search<Number>::draw_turned(const ScreenPoint& a, const ScreenPoint& b, std::uint32_t vector_address) {
  const auto end = [](const ScreenPoint& p) { return Point{static_cast<Coordinate>(p.x), static_cast<Coordinate>(p.y)}; };
  return draw_through_mask({end(a), end(b)}, vector_address);
}

template <class Number>
bool Search<Number>::append(const ScreenPoint& corner, Outline& outline) {
  return outline.polygon.append({static_cast<Coordinate>(corner.x), static_cast<Coordinate>(corner.y)}) || fail(Status::too_many_mask_vertices);
}

template <class Number>
bool Search<Number>::append_turned(const SeenLevel& seen, std::int32_t y, Outline& outline) {
  if (!outline.came) {
    outline.came = seen.a.beyond;
  } else if (!append_round(seen.a.beyond, y, outline)) {
    return false;
  }
  if (!append(seen.a.place, outline)) return false;
  if (seen.bend && !append(*seen.bend, outline)) return false;
  outline.left = seen.b.beyond;
  return append(seen.b.place, outline);
}

// Where the outline has gone round the eye, from one side of the view to another: the corners of the bound between them.
template <class Number>
bool Search<Number>::append_round(unsigned side, std::int32_t y, Outline& outline) {
  if (side == beyond_none || outline.left == beyond_none || side == outline.left) return true;
  for (const unsigned at : {outline.left, side})
    if (at != beyond_eye && !append(turned_->bound_corner(at, y), outline)) return false;
  return true;
}

template <class Number>
bool Search<Number>::go_through(std::uint32_t far_cell, std::uint32_t element, PolygonBuilder& polygon,
                                bool counter_clockwise) {
  if (!counter_clockwise) polygon.reverse();
  enter(number_, Rounding::mask_corners);
  const auto seen =
      MaskClip(number_, view_.counts.operations).intersect(levels_.back().mask, polygon.points());
  if (!sound()) return false;
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

template class Search<ShortWords>;
template class Search<LongWords>;
template class Search<MixedWords>;
template class Search<SingleFloat>;
template class Search<DoubleFloat>;

}  // namespace sightline::programs::jones
