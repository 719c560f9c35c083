// Words put into XML: titles and names of layers.
#pragma once

#include <string>
#include <string_view>

namespace sightline::picture {

// For text and for values in double quotes. What XML does not allow at all, or is not ASCII, becomes '?'.
[[nodiscard]] std::string xml_text(std::string_view text);

}  // namespace sightline::picture
