// What was changed in the faces and lines of a mesh while it was read, in words: for the command and for the page.
#pragma once

#include <string>

#include "host/scene/read/poly_import.hpp"

namespace sightline::scene {

// "mended: 1 unused vertex left out; 3 faces turned the right side out", or without "mended: " for what rounding alone did and what
// was passed over; empty if nothing was.
[[nodiscard]] std::string changes_text(const PolyImportReport& report);

}  // namespace sightline::scene
