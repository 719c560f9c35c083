#include "host/programs/jones/walk_path.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "host/base/number.hpp"
#include "host/base/text.hpp"

namespace sightline::programs::jones {

namespace {

struct Way {
  std::string_view name;
  std::size_t axis;  // `about_vertical`: a turn
  std::int32_t sign;
};
constexpr std::size_t about_vertical = 3;
constexpr std::array<Way, 8> ways{
    {{"left", 0, -1}, {"right", 0, 1}, {"up", 1, 1}, {"down", 1, -1}, {"in", 2, 1}, {"out", 2, -1}, {"turn-left", about_vertical, -1}, {"turn-right", about_vertical, 1}}};

constexpr std::string_view path_expected = "expected left, right, up, down, in or out, each with a number of units from 0 to 65535, turn-left or turn-right with degrees from 0 to 360, and a comma between views: \"in 100, right 50 up 20\"";

base::Error unexpected(std::size_t view, std::string_view found) {
  return base::bad_input(fmt::format("view {} of the walk: found {}; {}", view, found.empty() ? std::string("no direction") : fmt::format("\"{}\"", found), path_expected));
}

}  // namespace

base::Result<std::vector<Move>> read_walk(std::string_view text) {
  std::vector<Move> walk;
  for (bool last = false; !last;) {
    const std::size_t comma = text.find(',');
    last = comma == std::string_view::npos;
    std::string_view part = base::without_blanks(text.substr(0, comma));
    if (!last) text.remove_prefix(comma + 1);
    const std::size_t view = walk.size() + 1;
    if (view > most_walk_views) return base::bad_input(fmt::format("the walk has more than {} views", most_walk_views));
    Move move;
    std::array<bool, 4> moved{};
    do {
      const std::string_view name = base::take_word(part);
      const auto found = std::find_if(ways.begin(), ways.end(), [&](const Way& way) { return way.name == name; });
      if (found == ways.end()) return unexpected(view, name);
      const std::string_view number = base::take_word(part);
      const auto units = base::whole_number<std::int32_t>(number, 10, 0, found->axis == about_vertical ? most_degrees : most_steps);
      if (!units) return unexpected(view, fmt::format("{}{}{}", name, number.empty() ? "" : " ", number));
      const bool again = std::exchange(moved[found->axis], true);
      if (again && found->axis == about_vertical) return base::bad_input(fmt::format("view {} of the walk: \"{}\" is a second turn; put a comma before it", view, name));
      if (again)
        return base::bad_input(fmt::format("view {} of the walk: \"{}\" is a second direction along {}; put a comma before it", view, name, "xyz"[found->axis]));
      (found->axis == about_vertical ? move.turn : move.steps[found->axis]) = found->sign * *units;
    } while (!part.empty());
    walk.push_back(move);
  }
  return walk;
}

bool has_turn(std::span<const Move> walk) {
  return std::any_of(walk.begin(), walk.end(), [](const Move& move) { return move.turn != 0; });
}

std::string axes_of(std::uint32_t stops) {
  std::string text;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((stops >> axis & 1U) == 0) continue;
    if (!text.empty()) text += stops >> (axis + 1) == 0 ? " and " : ", ";
    text += "xyz"[axis];
  }
  return text;
}

}  // namespace sightline::programs::jones
