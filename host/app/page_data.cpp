#include "host/app/page_data.hpp"

#if defined(SIGHTLINE_PAGE)
// Included by the assembler, because a compiler needs longer for an array of a million numbers than for the rest of this folder.
asm(R"(
  .section .rodata
  .global sightline_page_begin
  .global sightline_page_end
sightline_page_begin:
  .incbin ")" SIGHTLINE_PAGE R"("
sightline_page_end:
  .previous
)");
extern "C" const std::uint8_t sightline_page_begin[];
extern "C" const std::uint8_t sightline_page_end[];
#endif

namespace sightline::app {

std::span<const std::uint8_t> packed_page() {
#if defined(SIGHTLINE_PAGE)
  return {sightline_page_begin, sightline_page_end};
#else
  return {};
#endif
}

}  // namespace sightline::app
