// Grid formats that say at their beginning what they are: the ASCII grids of ESRI (.asc) and of Golden Software's Surfer (.grd).
// Their grids have places in the units of the file.
#pragma once

#include <string_view>

#include "host/base/result.hpp"
#include "host/scene/heights/grid.hpp"

namespace sightline::scene {

using GridFormatReader = base::Result<HeightGrid> (*)(std::string_view text, std::string_view source);

// How the format that the text begins as is read; null: it begins as none. A grid has no range yet.
[[nodiscard]] GridFormatReader grid_format_of(std::string_view text);

// "a TIFF image": a known format by its first bytes that no reader of grids takes. Empty: none of them.
[[nodiscard]] std::string_view foreign_format_of(std::string_view text);
// The same, or "binary data" or a list in brackets: anything that is no text of numbers.
[[nodiscard]] std::string_view unread_format_of(std::string_view text);

}  // namespace sightline::scene
