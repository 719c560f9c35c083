// See portals.hpp.
#include "host/scene/cells/grid/portals.hpp"

#include <algorithm>

namespace sightline::scene {

using geometry::Rectangle;

template <class Visit>
void GridOpenings::for_each_unit(const Meeting& meeting, Visit visit) const {
  const auto [u, v] = meeting.across;
  GridUnit unit = meeting.low;
  for (unit[v] = meeting.low[v]; unit[v] < meeting.end[v]; ++unit[v])
    for (unit[u] = meeting.low[u]; unit[u] < meeting.end[u]; ++unit[u]) visit(space_.index(unit), unit);
}

Rectangle GridOpenings::meeting_rectangle(const Meeting& meeting) const {
  const GridPlanes& planes = space_.planes();
  Rectangle result;
  result.axis = meeting.axis;
  result.at = planes.at(meeting.axis, meeting.end[meeting.axis]);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t a = meeting.across[k];
    result.sides[k] = {planes.at(a, meeting.low[a]), planes.at(a, meeting.end[a])};
  }
  return result;
}

std::optional<std::span<const Rectangle>> GridOpenings::between(const GridCell& below, const GridCell& above,
                                                                std::size_t axis) {
  Meeting meeting{axis, geometry::other_axes(axis), {}, {}};
  meeting.low[axis] = below.end[axis] - 1;
  meeting.end[axis] = below.end[axis];
  for (const std::size_t a : meeting.across) {
    meeting.low[a] = std::max(below.low[a], above.low[a]);
    meeting.end[a] = std::min(below.end[a], above.end[a]);
  }
  bool obstructed = false;
  bool closed = true;
  for_each_unit(meeting, [&](std::size_t unit, const GridUnit&) {
    obstructed = obstructed || space_.obstructed(unit, axis);
    closed = closed && space_.closed(unit, axis);
  });
  openings_.clear();
  if (!obstructed) {
    openings_.push_back(meeting_rectangle(meeting));
  } else if (!closed) {
    gather_covers(meeting);
    if (!free_.find(meeting_rectangle(meeting), covers_, most_parts_)) return std::nullopt;
    return free_.rectangles();
  }
  return openings_;
}

// Covers are cut at their unit's borders, so that one across many units is not painted whole for each unit.
void GridOpenings::gather_covers(const Meeting& meeting) {
  const GridPlanes& planes = space_.planes();
  covers_.clear();
  for_each_unit(meeting, [&](std::size_t unit, const GridUnit& at) {
    Rectangle face = meeting_rectangle(meeting);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t a = meeting.across[k];
      face.sides[k] = {planes.at(a, at[a]), planes.at(a, at[a] + 1)};
    }
    if (space_.closed(unit, meeting.axis)) {
      covers_.push_back(face);
      return;
    }
    space_.for_each_part(unit, meeting.axis, [&](const auto& sides) {
      Rectangle part = face;
      for (std::size_t k = 0; k < 2; ++k) {
        part.sides[k] = {std::max(sides[k].low, face.sides[k].low),
                         std::min(sides[k].high, face.sides[k].high)};
      }
      covers_.push_back(part);
    });
  });
}

}  // namespace sightline::scene
