// The 8080 assembler: the language of Intel's ASM80, CP/M's ASM and MAC and Microsoft's MACRO-80, for one absolute program.
// i8080/dialect.hpp states how each reads a source where they differ.
//
// clang-format off
//   label:  OP args ; comment      the colon may be left out when the label begins in column 1
//   MVI A,'A' ! RET                `!` separates statements; `*` in column 1 begins a comment line
//   $PRINT                         other lines with `$` in column 1, controls of the listing, are skipped;
//                                  $INCLUDE(file) is an error: the directive is INCLUDE
//   10 10D 0FFH 17O 17Q 1010B 0x3A $3A X'3A'
//   $                              the address of the statement; also `*`, where a value is expected
//   ( )  HIGH LOW  * / MOD SHL SHR  + -  EQ NE LT LE GT GE  NOT  AND  OR XOR
//                                  also = <> < <= > >=;
//                                  16 bits, unsigned; true is 0FFFFH
//   ORG EQU SET DB DW DS DC END
//   IF IFE IFDEF IFNDEF IFB IFNB IFIDN IFDIF IF1 IF2 ELSE ENDIF
//   .RADIX .PHASE .DEPHASE .COMMENT COMMON
//   INCLUDE MACLIB
//   name MACRO p,q ... LOCAL x ... EXITM ... ENDM
//   REPT n, IRP p,<a,b>, IRPC p,text
//   & <...> %expr ^c ;; NUL        in macros and their arguments
//
// Decisions where the assemblers differ or invite errors:
// - Every character of a name counts. Names of registers are their values: MOV 7,0 is MOV A,B. A mnemonic in
//   an expression is its opcode: MVI A,(RET). LXI HL and LXI DE are read as LXI H and LXI D, PUSH A as PUSH PSW.
// - A byte is -128 to 255. The result of NOT may also have FF in its high byte, in parentheses or through an
//   EQU, too (ANI NOT 80H).
// - A string alone, of any length, is data in DB and DC; elsewhere one or two characters are a number, 'AB' is
//   4142H. DC adds 80H to the last character.
// - EQU, IF and instructions may refer forward; ORG, DS, REPT and %expr must not. In the first pass IF takes an unknown name as
//   0; later passes use its value.
// - DS may run past FFFF: values begin again at 0, but a byte there needs an ORG.
// - A second byte for one address draws a warning and replaces the first.
// - END ends the file it is in. Segments (ASEG CSEG DSEG) share one location counter. There is no linker: if a source
//   with PUBLIC or EXTRN is assembled with other sources, its undeclared names are local to it.
// - A label with a colon may have the name of an instruction, a register or an infix operator; in an operand that must be
//   a register, the name means the register.
// - A second, equal definition of a label or EQU, and an IF open at ENDM or END, draw a warning.
// - A label with a colon may have the name of a directive. A directive without effect (NAME, TITLE,
//   PAGE, ENTRY, GLOBAL) is also a label in column 1 before an instruction, DB, DW, DS or DC, as in CP/M's
//   ASM. An indented TITLE or SUBTTL is always the directive.
// - -D NAME=VALUE overrides an EQU or SET of the source, which thus gives the default.
// - A line has at most 16384 characters, also after expansion.
// Not supported: Z80 mnemonics, relocation.
// clang-format on
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"
#include "tools/asm/assembly.hpp"
#include "tools/asm/i8080/dialect.hpp"
#include "tools/image/binary.hpp"

namespace sightline::assembler {

// "NAME=VALUE", VALUE a number as in a source, optionally with a minus sign; else "found ..., expected ...".
[[nodiscard]] base::Result<Define> parse_i8080_define(std::string_view text);

struct I8080Options {
  std::vector<Define> defines;  // 16 bits each
  // If empty, every INCLUDE is an error. For INCLUDE the assembler tries the name as written, then in lower case, in the folder of
  // the including file; for MACLIB also with .LIB and .lib appended.
  IncludeReader include;
  bool listing = true;
  I8080Dialect dialect = I8080Dialect::common;
  // Limit of lines in one pass, including expansions and the rows of DS n,x: stops endless repeats and macros.
  std::size_t most_lines = 2'000'000;
};

// The listing has address, bytes and source as in a .PRN file; `+` marks expansions. The diagnostics are in the order of assembly.
struct I8080Assembly : AssemblyReport {
  image::ByteImage image;  // empty if there was an error
};

// The sources are read one after the other as one program.
[[nodiscard]] I8080Assembly assemble_i8080(std::span<const SourceFile> sources,
                                           const I8080Options& options = {});

// One line `name value` per symbol, the value in four hexadecimal digits.
[[nodiscard]] std::string write_i8080_symbols(std::span<const ProgramSymbol> symbols);

}  // namespace sightline::assembler
