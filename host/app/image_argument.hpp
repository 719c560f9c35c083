// The FILE[@ADDRESS] argument: a tape or an octal core image, and where it goes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tools/image/core_image.hpp"

namespace sightline::app {

struct ImageArgument {
  std::string path;
  std::optional<std::uint32_t> address;
};

// Splits at the last @ if only digits follow it. Failure usage if these are no address.
[[nodiscard]] ImageArgument image_argument(const std::string& option, const std::string& text);

// Recognised by content. Failure io or bad_input.
[[nodiscard]] image::CoreImage load_image(const ImageArgument& argument);

}  // namespace sightline::app
