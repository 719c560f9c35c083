// The octal core image: a text of six-digit words.
//
// White space separates words. The first word goes to the given address (0 if none), each later one to the next
// address; `NNNNN:` (one to five octal digits) sets the address. A later word for the same address replaces
// the earlier one, so that patches can be appended. There are no comments and no start address.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "host/base/result.hpp"
#include "tools/image/core_image.hpp"

namespace sightline::image {

[[nodiscard]] base::Result<CoreImage> read_octal(std::string_view text, std::string_view file,
                                                 std::uint32_t address = 0);

// Eight words per line; each line and each word after a gap begins with its address.
[[nodiscard]] std::string write_octal(const CoreImage& image);

}  // namespace sightline::image
