#include "host/programs/jones/twin/walk.hpp"

#include <utility>

#include "host/programs/jones/twin/elements.hpp"

namespace sightline::programs::jones {

namespace {

constexpr std::uint32_t first_limit = 5;     // word of the header
constexpr std::uint32_t most_planes = 1000;  // passed in one leg: more than any scene in core has

// A coordinate moved to the nearest of low..high. The differences are words, as on the machine.
std::int32_t limited(std::int32_t value, std::int32_t low, std::int32_t high) {
  if (wrapped(std::int64_t{low} - value) >= 0) return low;
  return wrapped(std::int64_t{value} - high) >= 0 ? high : value;
}

}  // namespace

Walk::Walk(std::vector<core::Word18> core, std::uint32_t scene_header, std::uint32_t first_cell)
    : core_(std::move(core)), header_(scene_header), first_cell_(first_cell) {
  core_.resize(core_words);
  put(header_, 0);
  for (std::uint32_t a = 0; a < 3; ++a) eye_[a] = number(header_ + 2 + a);
}

std::uint32_t Walk::cell() const { return word(header_).value(); }

core::Word18 Walk::word(std::uint32_t address) const { return core_[address & address_mask]; }

void Walk::put(std::uint32_t address, std::int32_t number) {
  core_[address & address_mask] = core::Word18(static_cast<std::uint32_t>(number));
}

Status Walk::take(const std::array<std::int32_t, 3>& steps) {
  stops_ = 0;
  cell_ = cell();
  if (cell_ == 0)
    if (const Status status = locate(); status != Status::complete) return status;
  put(header_, 0);
  if (const Status status = move_inside(); status != Status::complete) return status;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (steps[axis] == 0) continue;
    if (const Status status = take_leg(axis, steps[axis]); status != Status::complete) return status;
  }
  put(header_, static_cast<std::int32_t>(cell_));
  return Status::complete;
}

Status Walk::locate() {
  const std::uint32_t cells = word(header_ + 1).value();
  const auto eye = eye_;
  cell_ = first_cell_;
  for (std::uint32_t n = 0; n < cells; ++n) {
    eye_ = eye;
    const Status status = move_inside();
    const bool found = eye_ == eye;
    eye_ = eye;
    if (status != Status::complete || found) return status;
    std::uint32_t last = list_of(cell_);
    for (std::uint32_t words = 0; !word(last).bit(0); ++last)
      if (++words > core_words) return Status::unfinished;
    cell_ = last + 4;
  }
  return Status::eye_in_no_cell;
}

// Sets the box of the eye to the inside of the cell, and moves the eye there.
Status Walk::move_inside() {
  for (std::uint32_t a = 0; a < 3; ++a) {
    std::int32_t low = number(cell_ + a);
    std::int32_t high = number(cell_ - 3 + a);
    if (wrapped(std::int64_t{low} - high) >= 0) std::swap(low, high);
    low = wrapped(std::int64_t{low} + 1);
    high = wrapped(std::int64_t{high} - 1);
    put(header_ + first_limit + 2 * a, low);
    put(header_ + first_limit + 2 * a + 1, high);
    if (wrapped(std::int64_t{low} - high) > 0) return Status::bad_data_element;
    eye_[a] = limited(eye_[a], low, high);
  }
  return Status::complete;
}

std::uint32_t Walk::list_of(std::uint32_t cell) const { return cell + 4 + word(cell + 3).value(); }

Status Walk::take_leg(std::size_t axis, std::int32_t steps) {
  const std::int32_t target = wrapped(std::int64_t{eye_[axis]} + steps);
  std::int32_t passed = 0;  // plane
  for (std::uint32_t planes = 0; planes < most_planes; ++planes) {
    if (is_between_planes(axis, target)) return end_leg(axis, steps, target);
    bool passes = false;
    if (const Status status = pass(axis, steps, passed, passes); status != Status::complete) return status;
    if (!passes) return end_leg(axis, steps, target);
  }
  return Status::unfinished;
}

Status Walk::end_leg(std::size_t axis, std::int32_t steps, std::int32_t target) {
  eye_[axis] = target;
  if (const Status status = move_inside(); status != Status::complete) return status;
  const std::int32_t moved_back = wrapped(std::int64_t{eye_[axis]} - target);
  if (moved_back != 0 && (moved_back < 0) != (steps < 0)) stops_ |= 1U << axis;
  return Status::complete;
}

bool Walk::is_between_planes(std::size_t axis, std::int32_t target) const {
  const std::uint32_t origin = cell_ + static_cast<std::uint32_t>(axis);
  const std::int32_t one = wrapped(std::int64_t{target} - number(origin));
  const std::int32_t other = wrapped(std::int64_t{target} - number(origin - 3));
  return one != 0 && other != 0 && (one < 0) != (other < 0);
}

// Goes through the first opening of the cell whose plane is ahead of `passed` and reached.
Status Walk::pass(std::size_t axis, std::int32_t steps, std::int32_t& passed, bool& passes) {
  for (std::uint32_t entry = list_of(cell_);; ++entry) {
    const std::uint32_t far_word = word(entry).field(5, 17);
    if (far_word == 0) return Status::complete;
    const std::uint32_t element = far_word + (word(far_word).bit(0) ? 2 : 1);
    const std::int32_t plane = wrapped(std::int64_t{number(element + static_cast<std::uint32_t>(axis))} - eye_[axis]);
    const std::int32_t ahead = wrapped(std::int64_t{passed} - plane);
    const std::int32_t left = wrapped(std::int64_t{steps} - plane);
    if (ahead != 0 && (ahead < 0) != (steps < 0) && (left == 0 || (left < 0) == (steps < 0))) {
      Extent extent;
      if (const Status status = extent_of(element, extent); status != Status::complete) return status;
      passes = true;
      for (std::size_t a = 0; a < 3; ++a)
        if (a != axis) passes = passes && wrapped(std::int64_t{extent.sides[a].low} - 1) < 0 && wrapped(std::int64_t{extent.sides[a].high} - 1) >= 0;
      if (passes) {
        passed = extent.sides[axis].low;
        cell_ = word(far_word).field(5, 17);
        return Status::complete;
      }
    }
    if (word(entry).bit(0)) return Status::complete;
  }
}

Status Walk::extent_of(std::uint32_t element, Extent& extent) const {
  const std::uint32_t count = word(element + 3).value();
  const std::uint32_t first = element + 4;
  const std::uint32_t along = Vector(word(first)).axis_code;
  if (count == 0 || along == 0) return Status::bad_data_element;
  std::uint32_t other = 0;
  for (std::uint32_t n = 1; n < count && other == 0; ++n) {
    const std::uint32_t code = Vector(word(first + n)).axis_code;
    if (code == 0) return Status::bad_data_element;
    if (code != along) other = code;
  }
  if (other == 0) return Status::bad_data_element;
  for (std::uint32_t a = 0; a < 3; ++a) {
    const std::int32_t origin = wrapped(std::int64_t{number(element + a)} - eye_[a]);
    extent.sides[a] = {origin, origin};
  }
  std::uint32_t at = first;
  for (const std::uint32_t code : {along, other}) {
    std::int32_t length = 0;
    for (; Vector(word(at)).axis_code == code; ++at) length = wrapped(std::int64_t{length} + Vector(word(at)).magnitude);
    Side& side = extent.sides[code - 1];
    std::int32_t& end = length < 0 ? side.low : side.high;
    end = wrapped(std::int64_t{end} + length);
  }
  return Status::complete;
}

}  // namespace sightline::programs::jones
