// Converts an image to a picture of the page.
#pragma once

#include "host/picture/image.hpp"
#include "host/report/document.hpp"

namespace sightline::report {

// Throws base::Error (file) if it cannot be encoded.
[[nodiscard]] Picture png_picture(const picture::Image& image, bool pixelated = false);

}  // namespace sightline::report
