#include "host/scene/heights/grid_formats.hpp"

#include <algorithm>
#include <array>

#include "host/base/text.hpp"

namespace sightline::scene {
namespace {

constexpr std::array<GridFormat, 4> formats{{{"an ESRI ASCII grid", is_esri_grid, read_esri_grid},
                                             {"a Surfer ASCII grid", is_surfer_text, read_surfer_text},
                                             {"a binary Surfer grid", is_surfer_binary, read_surfer_binary},
                                             {"an SRTM tile (HGT)", is_hgt_grid, read_hgt_grid}}};

}  // namespace

std::span<const GridFormat> grid_formats() { return formats; }

const GridFormat* grid_format_of(std::string_view bytes, std::string_view source) {
  const auto found =
      std::find_if(formats.begin(), formats.end(), [&](const GridFormat& format) { return format.recognises(bytes, source); });
  return found == formats.end() ? nullptr : &*found;
}

std::string_view foreign_format_of(std::string_view text) {
  using namespace std::string_view_literals;
  struct Format {
    std::string_view beginning;
    std::string_view name;
  };
  constexpr std::array<Format, 15> others{{{"DSRB"sv, "a grid of Surfer 7"sv},
                                           {"CDF\x01"sv, "a NetCDF file"sv},
                                           {"CDF\x02"sv, "a NetCDF file"sv},
                                           {"\x89HDF"sv, "an HDF5 or NetCDF file"sv},
                                           {"II*\0"sv, "a TIFF image"sv},
                                           {"MM\0*"sv, "a TIFF image"sv},
                                           {"\x89PNG"sv, "a PNG image"sv},
                                           {"\xFF\xD8\xFF"sv, "a JPEG image"sv},
                                           {"GIF8"sv, "a GIF image"sv},
                                           {"%PDF"sv, "a PDF document"sv},
                                           {"\x1F\x8B"sv, "a file compressed by gzip"sv},
                                           {"PK\x03\x04"sv, "a zip archive, such as a spreadsheet"sv},
                                           {"\xFF\xFE"sv, "text in UTF-16"sv},
                                           {"\xFE\xFF"sv, "text in UTF-16"sv},
                                           {"north:"sv, "a GRASS ASCII grid"sv}}};
  for (const Format& format : others)
    if (text.substr(0, format.beginning.size()) == format.beginning) return format.name;
  return {};
}

std::string_view unread_format_of(std::string_view text) {
  if (const std::string_view format = foreign_format_of(text); !format.empty()) return format;
  const std::string_view first = base::without_blanks(text).substr(0, 1);
  if (first == "{" || first == "[") return "a list in brackets, such as JSON";
  if (text.find('\0') != std::string_view::npos) return "binary data";
  return {};
}

}  // namespace sightline::scene
