// See compartment_grid_openings.hpp.
#include "host/scene/compartment_grid_openings.hpp"

#include <algorithm>

namespace sightline::scene {

using geometry::Rectangle;
using geometry::Span;

template <class Visit>
void GridOpenings::for_each_unit(const Meeting& meeting, Visit visit) const {
  const auto [u, v] = meeting.across;
  GridUnit unit = meeting.low;
  for (unit[v] = meeting.low[v]; unit[v] < meeting.end[v]; ++unit[v])
    for (unit[u] = meeting.low[u]; unit[u] < meeting.end[u]; ++unit[u]) visit(space_.index(unit), unit);
}

Rectangle GridOpenings::whole(const Meeting& meeting) const {
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
    openings_.push_back(whole(meeting));
  } else if (!closed) {
    if (!lay_out(meeting)) return std::nullopt;
    cover_sheets(meeting);
    take_rectangles(meeting);
  }
  return openings_;
}

bool GridOpenings::lay_out(const Meeting& meeting) {
  const Rectangle all = whole(meeting);
  for (std::size_t k = 0; k < 2; ++k) {
    const std::size_t a = meeting.across[k];
    borders_[k].clear();
    for (std::uint32_t n = meeting.low[a]; n <= meeting.end[a]; ++n)
      borders_[k].push_back(space_.planes().at(a, n));
  }
  for_each_unit(meeting, [&](std::size_t unit, const GridUnit&) {
    if (space_.closed(unit, meeting.axis)) return;
    space_.for_each_part(unit, meeting.axis, [&](const Rectangle& part) {
      for (std::size_t k = 0; k < 2; ++k) {
        for (const std::int32_t c : {part.sides[k].low, part.sides[k].high})
          if (all.sides[k].contains(c)) borders_[k].push_back(c);
      }
    });
  });
  for (auto& borders : borders_) {
    std::sort(borders.begin(), borders.end());
    borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  }
  const std::size_t columns = borders_[0].size() - 1;
  const std::size_t rows = borders_[1].size() - 1;
  if (columns > most_parts_ / rows) return false;
  covered_.assign(columns * rows, 0);
  return true;
}

// Clipped to the meeting; its sides, where they lie within, are borders.
void GridOpenings::cover(const Rectangle& rectangle) {
  std::array<std::size_t, 2> low{};
  std::array<std::size_t, 2> end{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto number_of = [&](std::int32_t c) {
      const std::int32_t within = std::clamp(c, borders_[k].front(), borders_[k].back());
      return static_cast<std::size_t>(std::lower_bound(borders_[k].begin(), borders_[k].end(), within) -
                                      borders_[k].begin());
    };
    low[k] = number_of(rectangle.sides[k].low);
    end[k] = number_of(rectangle.sides[k].high);
  }
  for (std::size_t row = low[1]; row < end[1]; ++row) {
    const auto begin = covered_.begin() + static_cast<std::ptrdiff_t>(row * (borders_[0].size() - 1));
    std::fill(begin + static_cast<std::ptrdiff_t>(low[0]), begin + static_cast<std::ptrdiff_t>(end[0]),
              char{1});
  }
}

// A part is covered unit by unit, so that one that crosses many units is not painted whole in each.
void GridOpenings::cover_sheets(const Meeting& meeting) {
  const GridPlanes& planes = space_.planes();
  for_each_unit(meeting, [&](std::size_t unit, const GridUnit& at) {
    Rectangle face = whole(meeting);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::size_t a = meeting.across[k];
      face.sides[k] = {planes.at(a, at[a]), planes.at(a, at[a] + 1)};
    }
    if (space_.closed(unit, meeting.axis)) {
      cover(face);
      return;
    }
    space_.for_each_part(unit, meeting.axis, [&](Rectangle part) {
      for (std::size_t k = 0; k < 2; ++k) {
        part.sides[k] = {std::max(part.sides[k].low, face.sides[k].low),
                         std::min(part.sides[k].high, face.sides[k].high)};
      }
      cover(part);
    });
  });
}

// From the first free part on, as wide as it goes, then as high.
void GridOpenings::take_rectangles(const Meeting& meeting) {
  const std::size_t columns = borders_[0].size() - 1;
  const std::size_t rows = borders_[1].size() - 1;
  const auto covered = [&](std::size_t column, std::size_t row) -> char& {
    return covered_[row * columns + column];
  };
  const auto row_is_free = [&](std::size_t row, std::size_t from, std::size_t end) {
    for (std::size_t column = from; column < end; ++column)
      if (covered(column, row) != 0) return false;
    return true;
  };
  Rectangle opening = whole(meeting);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      if (covered(column, row) != 0) continue;
      std::size_t right = column + 1;
      while (right < columns && covered(right, row) == 0) ++right;
      std::size_t top = row + 1;
      while (top < rows && row_is_free(top, column, right)) ++top;
      opening.sides = {Span{borders_[0][column], borders_[0][right]},
                       Span{borders_[1][row], borders_[1][top]}};
      cover(opening);
      openings_.push_back(opening);
    }
  }
}

}  // namespace sightline::scene
