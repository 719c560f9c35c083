// Characters that all dialects of the PDP-7 assembler read alike.
#pragma once

namespace sightline::assembler {

[[nodiscard]] constexpr bool is_pdp7_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f'; }
[[nodiscard]] constexpr bool is_pdp7_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace sightline::assembler
