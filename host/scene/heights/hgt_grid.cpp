// Tiles of the Shuttle Radar Topography Mission (.hgt): a square of one degree, 1201 by 1201 or 3601 by 3601 heights in metres.
//
// Heights are big-endian integers of 16 bits, -32768 for a hole, in rows from north to south, each from west to east. The first and
// the last row and column lie on the border. The file's name has the south-west corner: N47E011.hgt. Without such a name the places
// count from 0 to 1.
// Source: USGS, "SRTM Topography" (SRTM_Topo.pdf), section 2.
#include "host/scene/heights/grid_formats.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/base/number.hpp"
#include "host/base/text.hpp"

namespace sightline::scene {
namespace {

constexpr std::array<std::size_t, 2> sides{1201, 3601};

constexpr std::size_t bytes_of(std::size_t side) { return 2 * side * side; }

// Longitude and latitude of the corner that "N47E011.hgt" names.
std::optional<std::array<double, 2>> corner_in_name(std::string_view source) {
  const std::size_t folder = source.find_last_of("/\\");
  const std::string name = base::lower_case(source.substr(folder == std::string_view::npos ? 0 : folder + 1));
  if (name.size() < 7) return std::nullopt;
  const std::string_view text(name);
  const auto north = base::whole_number<int>(text.substr(1, 2), 10, 0, 90);
  const auto east = base::whole_number<int>(text.substr(4, 3), 10, 0, 180);
  const bool letters = (text[0] == 'n' || text[0] == 's') && (text[3] == 'e' || text[3] == 'w');
  if (!north || !east || !letters) return std::nullopt;
  return std::array<double, 2>{static_cast<double>(text[3] == 'e' ? *east : -*east),
                               static_cast<double>(text[0] == 'n' ? *north : -*north)};
}

}  // namespace

bool is_hgt_grid(std::string_view bytes, std::string_view source) {
  if (base::lower_case(source).ends_with(".hgt")) return true;
  const bool size = bytes.size() == bytes_of(sides[0]) || bytes.size() == bytes_of(sides[1]);
  return size && bytes.find('\0') != std::string_view::npos;
}

base::Result<HeightGrid> read_hgt_grid(std::string_view bytes, std::string_view source) {
  std::size_t side = 0;
  for (const std::size_t each : sides)
    if (bytes.size() == bytes_of(each)) side = each;
  if (side == 0) {
    return base::Error{std::string(source), "", std::to_string(bytes.size()) + " bytes",
                       "an SRTM tile: 2884802 bytes (1201 x 1201 heights) or 25934402 (3601 x 3601)",
                       "if it is compressed, unpack it; other sizes are no HGT files"};
  }
  constexpr int no_height = -32768;
  std::vector<double> heights;
  heights.reserve(side * side);
  for (std::size_t at = 0; at < bytes.size(); at += 2) {
    const auto high = static_cast<unsigned char>(bytes[at]);
    const auto low = static_cast<unsigned char>(bytes[at + 1]);
    const auto height = static_cast<std::int16_t>(static_cast<std::uint16_t>(high * 256U + low));
    heights.push_back(height == no_height ? std::numeric_limits<double>::quiet_NaN() : height);
  }
  const auto corner = corner_in_name(source).value_or(std::array<double, 2>{});
  return even_grid({{corner[0], corner[0] + 1}, {corner[1], corner[1] + 1}}, {side, side}, std::move(heights),
                   RowOrder::north_first, source);
}

}  // namespace sightline::scene
