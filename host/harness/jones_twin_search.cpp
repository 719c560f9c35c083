#include "host/harness/jones_twin_search.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace sightline::harness::jones {
namespace {

using core::Word18;

constexpr Word18 no_openings{0400000};
constexpr std::uint32_t no_entry = 0777777;

}  // namespace

View Search::run() && {
  if (!parameters_.stereo) {
    pass(Pass::mono, parameters_.eye);
  } else if (pass(Pass::left, stereo_eye(-separation))) {
    pass(Pass::right, stereo_eye(separation));
  }
  view_.counts.distinct_cells = cells_.count();
  view_.display_file = std::move(file_).finish();
  return std::move(view_);
}

SpacePoint Search::stereo_eye(std::int32_t shift) const {
  const std::int32_t low = core_.number(header_ + 5);
  const std::int32_t high = core_.number(header_ + 6);
  SpacePoint eye = parameters_.eye;
  eye.x = std::min(std::max(wrapped(std::int64_t{eye.x} + shift), low), high);
  return eye;
}

Chain Search::chain_at(std::uint32_t element) const {
  const auto relative = [&](std::uint32_t at, std::int32_t eye) {
    return wrapped(std::int64_t{core_.number(element + at)} - eye);
  };
  return {element & address_mask,
          {relative(0, eye_.x), relative(1, eye_.y), relative(2, eye_.z)},
          core_[element + 3].value()};
}

bool Search::pass(Pass which, SpacePoint eye) {
  pass_ = which;
  eye_ = eye;
  window_ = window_of(which, parameters_.scale);
  if (!visit(core_[header_].field(5, 17), mask_of(window_), no_entry)) return false;
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

bool Search::visit(std::uint32_t cell, const Mask& mask, std::uint32_t entry) {
  const Chain chain = chain_at(cell);
  levels_.push_back({mask, entry, chain.first() + chain.count});
  Counts& counts = view_.counts;
  ++counts.visits;
  cells_.set(cell & address_mask);
  counts.depth = std::max(counts.depth, static_cast<int>(levels_.size()));
  counts.mask_vertices = std::max(counts.mask_vertices, mask.count);
  return walk(chain, nullptr);
}

bool Search::walk(const Chain& chain, Outline* outline) {
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

bool Search::move(SpacePoint& point, Vector vector, SpaceSegment& moved) {
  if (!spend()) return false;
  ++view_.counts.vectors;
  if (vector.axis_code == 0) return fail(Status::bad_data_element);
  moved.p = point;
  auto& along = point.*coordinate(vector.axis_code);
  along = wrapped(std::int64_t{along} + vector.magnitude);
  moved.q = point;
  return true;
}

void Search::count_fresh(const SpacePoint& point) {
  const bool same_depth = projected_last_ && projected_last_->z == point.z;
  if (!same_depth || projected_last_->x != point.x) ++view_.counts.fresh_coordinates;
  if (!same_depth || projected_last_->y != point.y) ++view_.counts.fresh_coordinates;
  projected_last_ = point;
}

bool Search::project_point(const SpacePoint& point, ScreenPoint& projected) {
  count_fresh(point);
  const auto place = project(point, window_.width_scale, view_.counts.operations);
  if (!place) return fail(Status::arithmetic_overflow);
  projected = *place;
  auto& largest = view_.counts.largest_coordinate;
  largest = std::max({largest, std::abs(place->x), std::abs(place->y)});
  return true;
}

bool Search::draw(const SpaceSegment& moved, Axis axis, std::uint32_t vector_address) {
  const auto part = seg3(moved, axis, window_.bound_factor);
  if (!part) return true;
  ScreenSegment line;
  if (!project_point(part->p, line.a) || !project_point(part->q, line.b)) return false;
  ++view_.counts.lines_clipped;
  const auto piece = clip2(levels_.back().mask, line, view_.counts.operations);
  if (!piece) return true;
  switch (file_.add(*piece, window_, view_.counts.operations)) {
    case DisplayFile::Outcome::full: return fail(Status::display_file_overflow);
    case DisplayFile::Outcome::no_length: return true;
    case DisplayFile::Outcome::drawn: break;
  }
  ++view_.counts.pieces;
  view_.pieces.push_back({static_cast<std::uint16_t>(vector_address & address_mask), pass_, *piece});
  return true;
}

}  // namespace sightline::harness::jones
