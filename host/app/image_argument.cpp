// See image_argument.hpp.
#include "host/app/image_argument.hpp"

#include <string_view>

#include "host/app/command.hpp"
#include "tools/image/tape.hpp"

namespace sightline::app {

ImageArgument image_argument(const std::string& option, const std::string& text) {
  const std::size_t at = text.rfind('@');
  if (at == std::string::npos) return {text, std::nullopt};
  const std::string_view tail = std::string_view(text).substr(at + 1);
  if (tail.empty() || tail.find_first_not_of("0123456789") != std::string_view::npos)
    return {text, std::nullopt};
  return {text.substr(0, at), octal_argument(option, tail, image::last_address, "an address after @")};
}

image::CoreImage load_image(const ImageArgument& argument) {
  const auto bytes = read_input(argument.path);
  const auto read = image::read_image(bytes, shown_name(argument.path), argument.address);
  if (!read) throw Failure(ExitCode::bad_input, read.error().message(base::MessageStyle::compiler));
  return read.value();
}

}  // namespace sightline::app
