// The list of grid formats that have a header or a known size. All other files of heights are texts of numbers (read_grid.hpp).
#pragma once

#include <span>
#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

struct GridFormat {
  std::string_view name;  // in messages
  // `source`: the file's name.
  bool (*recognises)(std::string_view bytes, std::string_view source);
  // The grid without its range.
  base::Result<HeightGrid> (*read)(std::string_view bytes, std::string_view source);
};

// In the order in which they are tried. `bytes` has no byte order mark.
[[nodiscard]] std::span<const GridFormat> grid_formats();
// Null: none of them.
[[nodiscard]] const GridFormat* grid_format_of(std::string_view bytes, std::string_view source);

// The functions of the formats, each group in the source of its name.

// Does the file begin with a line of a key and its value?
[[nodiscard]] bool is_esri_grid(std::string_view bytes, std::string_view source);
[[nodiscard]] base::Result<HeightGrid> read_esri_grid(std::string_view bytes, std::string_view source);

// Does the file begin with these letters?
[[nodiscard]] bool is_surfer_text(std::string_view bytes, std::string_view source);
[[nodiscard]] bool is_surfer_binary(std::string_view bytes, std::string_view source);
[[nodiscard]] base::Result<HeightGrid> read_surfer_text(std::string_view bytes, std::string_view source);
[[nodiscard]] base::Result<HeightGrid> read_surfer_binary(std::string_view bytes, std::string_view source);

// Does the name end in .hgt, or is it a binary file of one of the two sizes?
[[nodiscard]] bool is_hgt_grid(std::string_view bytes, std::string_view source);
[[nodiscard]] base::Result<HeightGrid> read_hgt_grid(std::string_view bytes, std::string_view source);

// "a TIFF image": the name of a format that is recognised by its first bytes and cannot be read. Empty: none of them.
[[nodiscard]] std::string_view foreign_format_of(std::string_view text);
// The same, or "binary data", or a list in brackets.
[[nodiscard]] std::string_view unread_format_of(std::string_view text);

}  // namespace sightline::scene
