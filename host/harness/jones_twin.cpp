#include "host/harness/jones_twin.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstdlib>
#include <optional>

#include "host/harness/jones_twin_display_file.hpp"
#include "host/harness/jones_twin_elements.hpp"
#include "host/harness/jones_twin_ring.hpp"

namespace sightline::harness::jones {
namespace {

using core::Word18;

constexpr Word18 no_openings{0400000};
constexpr int words_of(const Mask& mask) {
  return 2 * mask.count + 4;
}

// What is known of an opening before its ring is walked.
struct RingScan {
  bool crossing = false;  // the eye is strictly on the near side
  bool counter_clockwise = false;
  bool actual_lines = false;
  Axis plane = Axis::z;  // normal to the opening
};

struct Level {
  Mask mask;
  std::uint32_t entry;       // element of the opening come through
  std::uint32_t next_entry;  // list of openings: where to go on
  bool exhausted = false;
};
constexpr std::uint32_t no_entry = 0777777;

class Search {
 public:
  Search(std::span<const Word18> core, std::uint32_t header, const Parameters& parameters)
      : core_(core),
        header_(header),
        parameters_(parameters),
        file_(display_file_words, !parameters.immediate) {}

  View run() &&;

 private:
  // The functions that give bool give false as soon as the view has ended with a status.
  bool pass(Pass which, SpacePoint eye);
  bool enter(std::uint32_t cell, const Mask& mask, std::uint32_t entry);
  bool draw_lines(const Chain& chain);
  bool opening(std::uint32_t far_word_address);
  bool scan(const Chain& ring, bool towards_higher, RingScan& facts);
  bool outline(const Chain& ring, Axis plane, PolygonBuilder& polygon);
  bool go_through(std::uint32_t far_cell, std::uint32_t element, PolygonBuilder& polygon,
                  bool counter_clockwise);
  bool move(SpacePoint& point, Vector vector, SpaceSegment& moved);
  bool project_point(const SpacePoint& point, ScreenPoint& projected);
  bool draw(const ScreenSegment& line, std::uint32_t vector_address);

  bool fail(Status status) {
    view_.status = status;
    return false;
  }
  bool spend() { return spent_++ < parameters_.limit || fail(Status::unfinished); }
  SpacePoint stereo_eye(std::int32_t shift) const;
  Chain chain_at(std::uint32_t element) const;
  void count_fresh(const SpacePoint& point);

  CoreImage core_;
  std::uint32_t header_;
  Parameters parameters_;
  DisplayFile file_;
  View view_;
  std::bitset<core_words> cells_;
  std::vector<Level> levels_;
  int stack_words_ = 0;
  Pass pass_ = Pass::mono;
  SpacePoint eye_;
  Window window_;
  std::optional<SpacePoint> projected_last_;  // within one chain
  std::uint64_t spent_ = 0;
};

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
  if (!enter(core_[header_].field(5, 17), window_.mask(), no_entry)) return false;
  while (!levels_.empty()) {
    Level& top = levels_.back();
    if (top.exhausted) {
      stack_words_ -= words_of(top.mask);
      levels_.pop_back();
      continue;
    }
    const Word18 entry = core_[top.next_entry++];
    top.exhausted = entry.bit(0);
    if (entry == no_openings) continue;
    if (!spend() || !opening(entry.field(5, 17))) return false;
  }
  return true;
}

bool Search::enter(std::uint32_t cell, const Mask& mask, std::uint32_t entry) {
  if (stack_words_ + words_of(mask) > mask_stack_words) return fail(Status::stack_overflow);
  stack_words_ += words_of(mask);
  const Chain chain = chain_at(cell);
  levels_.push_back({mask, entry, chain.first() + chain.count});
  Counts& counts = view_.counts;
  ++counts.visits;
  cells_.set(cell & address_mask);
  counts.depth = std::max(counts.depth, static_cast<int>(levels_.size()));
  counts.stack_words = std::max(counts.stack_words, stack_words_);
  counts.mask_vertices = std::max(counts.mask_vertices, mask.count);
  return draw_lines(chain);
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

bool Search::draw_lines(const Chain& chain) {
  SpacePoint point = chain.origin;
  projected_last_.reset();
  for (std::uint32_t i = 0; i < chain.count; ++i) {
    const std::uint32_t address = chain.first() + i;
    const Vector vector(core_[address]);
    SpaceSegment moved;
    if (!move(point, vector, moved)) return false;
    if (!vector.actual_line) continue;
    const auto part = seg3(moved, axis_of(vector), window_.bound_factor);
    ScreenSegment line;
    if (!part) continue;
    if (!project_point(part->p, line.a) || !project_point(part->q, line.b) || !draw(line, address))
      return false;
  }
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

bool Search::draw(const ScreenSegment& line, std::uint32_t vector_address) {
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

bool Search::opening(std::uint32_t far_word_address) {
  const Word18 far_word = core_[far_word_address];
  const bool towards_higher = !far_word.bit(0);  // N = 0: the far cell is on the high side
  const std::uint32_t element = (far_word_address + (towards_higher ? 1 : 2)) & address_mask;
  if (element == levels_.back().entry) return true;
  ++view_.counts.openings_tested;
  const Chain chain = chain_at(element);
  RingScan facts;
  if (!scan(chain, towards_higher, facts)) return false;
  if (!facts.crossing && !facts.actual_lines) return true;
  if (facts.actual_lines && !draw_lines(chain)) return false;
  if (!facts.crossing) return true;
  ++view_.counts.openings_crossing;
  PolygonBuilder polygon;
  if (!outline(chain, facts.plane, polygon)) return false;
  if (polygon.points().size() < 3) return true;
  return go_through(far_word.field(5, 17), element, polygon, facts.counter_clockwise);
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
  const std::int32_t plane = ring.origin.*coordinate(normal);
  facts.plane = Axis{static_cast<std::uint8_t>(normal)};
  facts.crossing = towards_higher ? plane > 0 : plane < 0;
  if (facts.plane == Axis::z) facts.crossing = towards_higher && plane >= near_z;
  facts.counter_clockwise = positive == towards_higher;
  return true;
}

bool Search::outline(const Chain& ring, Axis plane, PolygonBuilder& polygon) {
  const RingBound into(plane, ring.origin.*coordinate(static_cast<std::uint32_t>(plane)),
                       window_.bound_factor);
  const auto append = [&](const SpacePoint& corner) {
    ScreenPoint projected;
    if (!project_point(corner, projected)) return false;
    return polygon.append(projected) || fail(Status::too_many_mask_vertices);
  };
  SpacePoint point = ring.origin;
  projected_last_.reset();
  if (!append(into.into_bound(point))) return false;
  for (std::uint32_t i = 0; i < ring.count; ++i) {
    const Vector vector(core_[ring.first() + i]);
    SpaceSegment moved;
    if (!move(point, vector, moved)) return false;
    const auto bend = axis_of(vector) == Axis::z ? into.bend(moved) : std::nullopt;
    if (bend && !append(*bend)) return false;
    if (!append(into.into_bound(moved.q))) return false;
  }
  return polygon.close() || fail(Status::too_many_mask_vertices);
}

bool Search::go_through(std::uint32_t far_cell, std::uint32_t element, PolygonBuilder& polygon,
                        bool counter_clockwise) {
  if (!counter_clockwise) polygon.reverse();
  const Intersection seen = intersect(levels_.back().mask, polygon.points(), view_.counts.operations);
  if (seen.outcome == MaskOutcome::too_many_vertices) return fail(Status::too_many_mask_vertices);
  if (seen.outcome == MaskOutcome::empty) return true;
  ++view_.counts.masks_made;
  if (levels_.size() + 1 > core_[header_ + 1].value()) return fail(Status::deeper_than_cells);
  return enter(far_cell, seen.mask, element);
}

}  // namespace

std::string_view name(Status status) {
  switch (status) {
    case Status::complete: return "complete";
    case Status::stack_overflow: return "stack overflow";
    case Status::display_file_overflow: return "display file overflow";
    case Status::arithmetic_overflow: return "arithmetic overflow";
    case Status::too_many_mask_vertices: return "too many mask vertices";
    case Status::deeper_than_cells: return "deeper than the number of cells";
    case Status::bad_data_element: return "bad data element";
    case Status::unfinished: return "unfinished: the search goes on";
  }
  return "unknown status";
}

Parameters default_parameters(std::span<const Word18> core, std::uint32_t scene_header) {
  const CoreImage words(core);
  Parameters parameters;
  parameters.eye = {words.number(scene_header + 2), words.number(scene_header + 3),
                    words.number(scene_header + 4)};
  return parameters;
}

View run(std::span<const Word18> core, std::uint32_t scene_header, const Parameters& parameters) {
  return Search(core, scene_header, parameters).run();
}

}  // namespace sightline::harness::jones
