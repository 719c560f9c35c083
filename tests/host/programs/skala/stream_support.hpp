// Decodes command streams, and makes grids for them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "host/programs/skala/commands.hpp"
#include "host/programs/skala/stream.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::programs::skala::stream_test {

struct SentCommand {
  Command what = Command::end;
  std::vector<int> arguments;
};

// Fails the test if the bytes are not complete commands, or do not end with the first END.
inline std::vector<SentCommand> decode(const std::vector<std::uint8_t>& bytes) {
  std::vector<SentCommand> commands;
  for (std::size_t i = 0; i < bytes.size();) {
    const auto row = find_command(bytes[i]);
    if (!row) {
      ADD_FAILURE() << "byte " << i << " is no command: " << int{bytes[i]};
      return commands;
    }
    std::size_t arguments = static_cast<std::size_t>(row->leading_arguments);
    if (row->bytes_per_item != 0 && i + arguments < bytes.size())
      arguments += static_cast<std::size_t>(count_of(bytes[i + arguments]) * row->bytes_per_item);
    if (i + arguments >= bytes.size()) {
      ADD_FAILURE() << row->name << " at byte " << i << " is not complete";
      return commands;
    }
    SentCommand command{row->command, {}};
    for (std::size_t a = 1; a <= arguments; ++a) command.arguments.push_back(bytes[i + a]);
    commands.push_back(command);
    i += arguments + 1;
    EXPECT_EQ(command.what == Command::end, i == bytes.size());
  }
  return commands;
}

struct Place {
  int x = 0;
  int y = 0;

  friend bool operator==(const Place&, const Place&) = default;
  friend auto operator<=>(const Place&, const Place&) = default;
};

struct Line {
  Command by = Command::draw;
  Place from;
  Place to;
  int colour = 0;
  std::size_t chain = 0;  // number of COMMITs before it
};

// Every line of the stream in order; a dot is a line to the same point.
inline std::vector<Line> lines_of(const std::vector<std::uint8_t>& bytes) {
  std::vector<Line> lines;
  Place pen;
  int colour = 0;
  std::size_t chain = 0;
  bool fresh = true;
  const auto go = [&](Command by, int x, int y) {
    lines.push_back({by, pen, {x, y}, colour, chain});
    pen = {x, y};
    fresh = false;
  };
  const auto move = [&](int x, int y) {
    fresh = fresh || pen != Place{x, y};
    pen = {x, y};
  };
  for (const auto& [what, a] : decode(bytes)) {
    switch (what) {
      case Command::move: move(a[0], a[1]); break;
      case Command::draw:
      case Command::test_draw:
      case Command::mask: go(what, a[0], a[1]); break;
      case Command::rim:
        fresh ? move(a[0], a[1]) : go(what, a[0], a[1]);
        fresh = false;
        break;
      case Command::colour: colour = a[0]; break;
      case Command::commit: ++chain; break;
      case Command::curve:
        EXPECT_LE(a[0] + count_of(static_cast<std::uint8_t>(a[1])), 256);
        move(a[0], a[2]);
        for (std::size_t i = 2; i < a.size(); ++i) go(what, a[0] + static_cast<int>(i) - 2, a[i]);
        break;
      case Command::surface:
        move(a[1], a[2]);
        for (std::size_t i = 4; i < a.size(); i += 3) go(what, a[i], a[i + 1]);
        break;
      case Command::gap: EXPECT_LE(a[0] + count_of(static_cast<std::uint8_t>(a[1])), 256); break;
      default: break;
    }
  }
  return lines;
}

inline scene::HeightGrid named(std::string_view name, scene::GridSize size) {
  return scene::sample(*scene::height_function(name), size);
}

// Rows of heights, the near one first; with their own range.
inline scene::HeightGrid grid_of(const std::vector<std::vector<double>>& rows) {
  scene::HeightGrid grid;
  grid.x = scene::even_positions(rows.front().size());
  grid.z = scene::even_positions(rows.size());
  for (const auto& row : rows) grid.heights.insert(grid.heights.end(), row.begin(), row.end());
  grid.range = scene::finite_range(grid.heights);
  return grid;
}

// The same surface turned: x of the new one is z of the old one, z is -x.
inline scene::HeightGrid rotate_grid(const scene::HeightGrid& grid) {
  scene::HeightGrid result = grid;
  result.x = grid.z;
  result.z.clear();
  for (std::size_t i = grid.points(); i-- > 0;) result.z.push_back(-grid.x[i]);
  result.heights.clear();
  for (std::size_t slice = 0; slice < result.slices(); ++slice) {
    for (std::size_t point = 0; point < result.points(); ++point)
      result.heights.push_back(grid.height(grid.points() - 1 - slice, point));
  }
  return result;
}

}  // namespace sightline::programs::skala::stream_test
