// Grids of Golden Software's Surfer 6 (.grd): DSAA as text, DSBB in binary. Rows go from south to north.
//
//   DSAA   columns and rows, the least and the greatest x, y and height, then the heights, all as decimal numbers.
//   DSBB   columns and rows in 2 bytes each; the least and the greatest x, y and height as doubles; the heights as floats. Little-endian,
//          56 bytes before the heights.
//
// Source: Golden Software, Surfer User's Guide, appendix "Grid files". A height of 1.70141e38 or more is blanked: a hole.
#include "host/scene/heights/grid_formats.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "host/base/text.hpp"
#include "host/scene/heights/grid_words.hpp"

namespace sightline::scene {
namespace {

constexpr double blanked = 1.70141e38;
constexpr std::size_t header_size = 56;

template <class Unsigned>
Unsigned little_endian(std::string_view bytes, std::size_t at) {
  Unsigned value = 0;
  for (std::size_t i = sizeof(Unsigned); i-- > 0;)
    value = static_cast<Unsigned>((std::uint64_t{value} << 8U) | static_cast<unsigned char>(bytes[at + i]));
  return value;
}
double double_at(std::string_view bytes, std::size_t at) {
  return std::bit_cast<double>(little_endian<std::uint64_t>(bytes, at));
}
double float_at(std::string_view bytes, std::size_t at) { return std::bit_cast<float>(little_endian<std::uint32_t>(bytes, at)); }

std::string byte_text(std::size_t at) { return "byte " + std::to_string(at); }

}  // namespace

bool is_surfer_text(std::string_view bytes, std::string_view /*source*/) {
  std::string_view rest = base::without_blanks(bytes.substr(0, 1000));
  return base::lower_case(base::take_word(rest)) == "dsaa";
}

bool is_surfer_binary(std::string_view bytes, std::string_view /*source*/) { return bytes.starts_with("DSBB"); }

base::Result<HeightGrid> read_surfer_text(std::string_view bytes, std::string_view source) {
  GridWords words(bytes, source);
  static_cast<void>(words.next());
  const std::size_t points = words.count("a number of columns", smallest_grid.points, largest_file_grid.points);
  const std::size_t slices = words.count("a number of rows", smallest_grid.slices, largest_file_grid.slices);
  const auto interval = [&words](const std::string& of) {
    const double low = words.number("the least " + of);
    return Interval{low, words.number("the greatest " + of)};
  };
  const Interval x = interval("x");
  const Interval y = interval("y");
  static_cast<void>(interval("height"));
  auto heights = words.heights(points * slices, [](double height) { return height >= blanked; });
  if (words.error()) return *words.error();
  return even_grid({x, y}, {points, slices}, std::move(heights), RowOrder::south_first, source);
}

base::Result<HeightGrid> read_surfer_binary(std::string_view bytes, std::string_view source) {
  const auto error = [source](std::string place, std::string found, std::string expected) {
    return base::Error{std::string(source), std::move(place), std::move(found), std::move(expected)};
  };
  if (bytes.size() < header_size)
    return error(byte_text(bytes.size()), "the end of the file", "a header of 56 bytes of a binary Surfer grid");
  std::array<std::size_t, 2> counts{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto count = static_cast<std::int16_t>(little_endian<std::uint16_t>(bytes, 4 + 2 * axis));
    if (count < 2) return error(byte_text(4 + 2 * axis), std::to_string(count) + (axis == 0 ? " columns" : " rows"), "2 or more");
    counts[axis] = static_cast<std::size_t>(count);
  }
  const std::size_t wanted = header_size + 4 * counts[0] * counts[1];
  if (bytes.size() != wanted) {
    return error(byte_text(bytes.size()), "the end of the file",
                 std::to_string(wanted) + " bytes for " + std::to_string(counts[1]) + " rows of " + std::to_string(counts[0]) +
                     " heights");
  }
  std::vector<double> heights;
  heights.reserve(counts[0] * counts[1]);
  for (std::size_t at = header_size; at < wanted; at += 4) {
    const double height = float_at(bytes, at);
    if (std::isinf(height)) return error(byte_text(at), "an infinite height", "a number, or 1.70141e38 for a hole");
    heights.push_back(height >= blanked ? std::numeric_limits<double>::quiet_NaN() : height);
  }
  return even_grid({{double_at(bytes, 8), double_at(bytes, 16)}, {double_at(bytes, 24), double_at(bytes, 32)}},
                   {counts[0], counts[1]}, std::move(heights), RowOrder::south_first, source);
}

}  // namespace sightline::scene
