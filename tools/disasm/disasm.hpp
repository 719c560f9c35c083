// Disassemblers. Their output is source of the PDP-7 assembler that assembles to the same words again; a comment on
// every line gives the address and the word in octal.
#pragma once

#include <string>

#include "emulators/core/word.hpp"
#include "emulators/type340/words.hpp"
#include "host/base/result.hpp"
#include "tools/image/core_image.hpp"

namespace sightline::disassembler {

// One word as an instruction at `address` (15 bits; direct addresses are shown in its bank). A microinstruction word
// is a combination of named ones, a multiply, divide or normalise with a changed step count its name and the
// difference; a word for which the instruction table has no name, or whose action is undefined (both rotates), is six
// octal digits.
[[nodiscard]] std::string disassemble_word(core::Word18 word, std::uint32_t address);

[[nodiscard]] std::string disassemble_pdp7(const image::CoreImage& image);

// In the dialect of Bell Laboratories (tools/asm/pdp7/bell.hpp). It has no start address, which stands in a comment; an
// error if there is a word above 017777, where the dialect ends.
[[nodiscard]] base::Result<std::string> disassemble_pdp7_bell(const image::CoreImage& image);

// One display word in a mode, as disassemble_type340 says it: "point, x 384, dark, then vector".
[[nodiscard]] std::string disassemble_display_word(core::Word18 word, type340::Mode mode);

// The words as a display file, each an octal word with its meaning in the comment. Mode 0 at the first word and after
// every gap; then as each word says, until a stop; then mode 0 again.
[[nodiscard]] std::string disassemble_type340(const image::CoreImage& image);

}  // namespace sightline::disassembler
