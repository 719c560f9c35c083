// The PDP-7 assembler: DEC's symbolic language (DIGITAL-7-3-S; PDP-4 manual, appendix 4) in ASCII.
//
//   tag,        name=expr     expr/ sets the location    / comment (at the start of a line or after a blank)
//   lac x   dac i 10   jmp .-2   lac (5   dac buf 5   spa cla   tad (-1+1)   ; separates statements on a line
//   space or + adds, - subtracts, ! ors, & ands, from left to right; `.` is the location; `i` sets bit 4
//   DECIMAL OCTAL (each file begins in octal), TEXT /abc/, TITLE ..., VARIABLES, CONSTANTS, PAUSE, START
//   [expr], IFZERO expr <...>, IFNZRO expr <...>, PUNCH, EXTERNAL a b, INTERNAL a b
//   name=jms, is a tag whose value is the expression and the location (Cambridge, 1972)
//
// Case does not matter and the first six characters of a name count (a warning if two names differ only after
// them). A word such as START or TEXT is a pseudo-operation only as the first word of a statement and not
// before `,` or `=`.
//
// Decisions where the manuals are silent or invite errors:
// - Numbers are one's complement: -1 is 777776 (Options::twos_complement for 777777). The difference of two
//   equal terms is +0; -0 is 777777. IFZERO takes both for zero.
// - Microinstructions of one class (EAE, IOT, OPR) side by side are ORed, as the machine reads them; a sum
//   would make 711101 of `spa cla`. Mixing skips of opposite sense warns: bit 1000 inverts all of them.
// - A value that does not fit its field is an error: an address outside the bank, LAW above 17777 (so `law -3`, which
//   a plain sum would turn into an OPR), a step count above 77.
// - An undefined symbol is an error; `#x` or `x#`, or with `$` for `#`, at one of its uses makes it a variable.
//   Options::undefined_are_variables gives DEC's rule, under which a typing error is a variable.
// - Literals are pooled by value. They are placed at CONSTANTS, variables at VARIABLES (in alphabetical
//   order), the rest at the end: literals, then variables.
// - TEXT packs three characters of trimmed ASCII (lower case as upper) into a word, high bits first, and fills the last
//   word with 00: the code of the Type 342. The rest of a file after START is not read; PAUSE begins another tape.
// - -D NAME=VALUE overrides an assignment NAME=... in the source, which thus gives the default.
// - PUNCH has no effect: all words are written. EXTERNAL and INTERNAL must name symbols that a source defines.
// Not supported: LIBFRM of the FORTRAN system, and the rest of the Cambridge dialect. A construct of --dialect bell
// is an error that names the dialect.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "tools/asm/assembly.hpp"
#include "tools/image/core_image.hpp"

namespace sightline::assembler {

// "NAME=VALUE" with VALUE in octal, a leading minus for the one's complement; else a message "found ...,
// expected ...".
[[nodiscard]] base::Result<Define> parse_define(std::string_view text);

enum class Dialect : std::uint8_t {
  dec,   // DIGITAL-7-3-S, as above
  bell,  // `as` of Bell Laboratories, 1970: pdp7/bell.hpp
};

struct Options {
  Dialect dialect = Dialect::dec;  // of the other options `bell` uses only `defines`
  std::vector<Define> defines;
  bool twos_complement = false;
  bool undefined_are_variables = false;
  bool first_line_is_title = false;  // DEC's tapes: the first line of each file is a title, not assembled
};

struct Assembly : AssemblyReport {
  image::CoreImage image;  // empty if there was an error
};

// The sources are read one after the other as the tapes of one program.
[[nodiscard]] Assembly assemble_pdp7(std::span<const SourceFile> sources, const Options& options = {});

// One line `name value` per symbol, the value in six octal digits.
[[nodiscard]] std::string write_symbols(std::span<const ProgramSymbol> symbols);

}  // namespace sightline::assembler
