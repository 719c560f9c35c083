// Disassemblers. Their output is source for the PDP-7 assembler, which makes the same words of it; a comment on
// every line gives the address and the word in octal.
#pragma once

#include <string>

#include "emulators/core/word.hpp"
#include "emulators/type340/words.hpp"
#include "host/base/result.hpp"
#include "tools/image/core_image.hpp"

namespace sightline::disassembler {

// One word as an instruction at `address` (15 bits; direct addresses are shown in its bank). A microinstruction word
// is a combination of named ones. A multiply, divide or normalise with a changed step count is its name and the
// difference. A word without a name in the instruction table, or with an undefined action (both rotates), is six
// octal digits.
[[nodiscard]] std::string disassemble_word(core::Word18 word, std::uint32_t address);

[[nodiscard]] std::string disassemble_pdp7(const image::CoreImage& image);

// In the dialect of Bell Laboratories (tools/asm/pdp7/bell.hpp). The dialect has no start address, so that a comment gives it. An
// error if there is a word above 017777, where the dialect ends.
[[nodiscard]] base::Result<std::string> disassemble_pdp7_bell(const image::CoreImage& image);

// One display word in a mode, in the notation of disassemble_type340: "point, x 384, dark, then vector".
[[nodiscard]] std::string disassemble_display_word(core::Word18 word, type340::Mode mode);

// The words as a display file, each an octal word with its meaning in the comment. The first word, and the first after
// every gap, is read in mode 0; later ones in the mode that the word before selects, until a stop; then in mode 0 again.
[[nodiscard]] std::string disassemble_type340(const image::CoreImage& image);

}  // namespace sightline::disassembler
