// The errors of the 8080 assembler and their messages.
#include <gtest/gtest.h>

#include "tests/tools/asm/i8080/assemble.hpp"

namespace sightline::assembler {
namespace {

Texts one(const std::string& text) {
  return {"t.asm:" + text};
}

TEST(I8080Errors, AllOfOneRunWithPlaceFoundAndExpected) {
  const auto assembly =
      assemble8080(" ORG 100H\n\tMVI A,NOWHERE\n\tMOVE A,B\n\tMVI Q,1\nLL:\tDB 256\nLL:\tNOP\n");
  EXPECT_EQ(messages(assembly),
            (Texts{"t.asm:2:8: error: found undefined symbol 'NOWHERE', expected one that is defined",
                   "t.asm:3:2: error: found 'MOVE', expected an instruction, a directive or a macro",
                   "t.asm:4:6: error: found undefined symbol 'Q', expected one that is defined",
                   "t.asm:5:8: error: found value 256 (0100), expected a byte, -128 to 255",
                   "t.asm:6:1: error: found a second definition of 'LL', expected one, at t.asm:5"}));
  EXPECT_TRUE(assembly.image.empty());
}

TEST(I8080Errors, OneErrorGivesOneMessage) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {" MVI A\n", "1:7: error: found the end of the statement, expected ','"},
      {" MVI A,\n", "1:8: error: found the end of the statement, expected a value"},
      {" MVI A,1,2", "1:9: error: found ',', expected the end of the statement"},
      {" MOV SP,A", "1:6: error: found 'SP', expected a register B C D E H L M A"},
      {" MOV 8,A", "1:6: error: found '8', expected a register B C D E H L M A"},
      {" MOV M,M", "1:1: error: found both operands M, expected a register for one of them"},
      {" LXI PSW,1", "1:6: error: found 'PSW', expected a register pair B D H SP"},
      {" LXI C,1", "1:6: error: found 'C', expected a register pair B D H SP"},
      {" INX M", "1:6: error: found 'M', expected a register pair B D H SP"},
      {" PUSH SP", "1:7: error: found 'SP', expected a register pair B D H PSW"},
      {" STAX H", "1:7: error: found 'H', expected register pair B or D"},
      {" RST 8", "1:6: error: found '8', expected a restart number 0 to 7"},
      {" DB -129", "1:5: error: found value 65407 (FF7F), expected a byte, -128 to 255"},
      {" MVI A,300", "1:8: error: found value 300 (012C), expected a byte, -128 to 255"},
      {" OUT 100H", "1:6: error: found value 256 (0100), expected a byte, -128 to 255"},
      {" DB 12A", "1:5: error: found '12A', expected a decimal number or a suffix H O Q B"},
      {" DB 19O", "1:5: error: found '19O', expected an octal number"},
      {" DW 65536", "1:5: warning: found '65536', expected at most 65535 (0FFFFH): it is taken modulo 65536"},
      {" DB 'abc", "1:5: error: found ''abc', expected a closing quote"},
      {" MVI A,'abc'", "1:8: error: found ''abc'', expected one or two characters"},
      {" DB (1", "1:7: error: found the end of the statement, expected ')'"},
      {" DB 1+", "1:7: error: found the end of the statement, expected a value"},
      {" DW 1/0", "1:6: error: found a division by 0, expected another divisor"},
      {" DW 1 MOD 0", "1:7: error: found a division by 0, expected another divisor"},
      {" DB #5", "1:5: error: found '#', expected a value"},
      {"MOV EQU 5", "1:1: error: found 'MOV', expected a name that is no register, operator or instruction"},
      {" EQU 5", "1:2: error: found 'EQU' without a name, expected NAME before it"},
      {" ORG LL\nLL: NOP", "1:6: error: found a forward reference, expected an address known at this line"},
      {" DS LL\nLL: NOP", "1:5: error: found a forward reference, expected a size known at this line"},
      {" IF NOBODY\n ENDIF", "1:5: error: found undefined symbol 'NOBODY', expected one that is defined"},
      {"X EQU Y\n ORG X\nY EQU 5",
       "2:6: error: found a forward reference, expected an address known at this line"},
      {"X EQU X+1",
       "1:7: error: found 'X', whose value is not known, expected an EQU that does not depend on itself"},
      {" .Z80", "1:2: error: found '.Z80', expected 8080 source with Intel's mnemonics"},
      {" CPU Z80", "1:6: error: found 'Z80', expected 8080"},
      {" EXTRN PUTC\n CALL PUTC",
       "2:7: error: found external symbol 'PUTC', expected one that a source of this program defines: there is no linker"},
      {" ORG 0FFFFH\n DW 1", "2:1: error: found a byte past FFFF, expected a program within 64K"},
      {" ORG 0FFFFH\n DS 2\n NOP", "3:1: error: found a byte past FFFF, expected a program within 64K"},
      {" ELSE", "1:2: error: found 'ELSE', expected an IF before it, in the same file or macro"},
      {" ENDIF", "1:2: error: found 'ENDIF', expected an IF before it, in the same file or macro"},
      {" IF 1\n ELSE\n ELSE\n ENDIF", "3:2: error: found a second ELSE, expected ENDIF"},
      {"\n IF 0\n NOP", "2:2: warning: found the end of t.asm inside this IF, expected ENDIF; it ends here"},
      {" NOP\nP MACRO\n NOP", "2:1: error: found the end of t.asm inside this definition, expected ENDM"},
      {" ENDM", "1:2: error: found ENDM, expected a MACRO, REPT, IRP or IRPC before it"},
      {" EXITM", "1:1: error: found EXITM, expected it inside a macro or repeat"},
      {" LOCAL X", "1:2: error: found LOCAL, expected it inside a macro"},
      {" MACRO X\n ENDM", "1:2: error: found MACRO without a name, expected NAME before it"},
      {"ADD MACRO X\n ENDM", "1:1: error: found 'ADD', expected a name that is not reserved"},
      {"P MACRO X\n ENDM\n P <1", "3:4: error: found '<' without '>', expected '>'"},
      {" IRP 5,<1>\n ENDM", "1:6: error: found '5', expected the name of a parameter"},
      {" INCLUDE gone.asm",
       "1:10: error: found 'gone.asm', which cannot be read, expected a file beside t.asm"},
      {" INCLUDE", "1:9: error: found no name, expected the name of a file"},
      {"$INCLUDE(a.inc)", "1:2: error: found the control 'INCLUDE', expected the directive INCLUDE"},
      {"$ NOLIST ic (a.inc)", "1:10: error: found the control 'ic', expected the directive INCLUDE"},
      {" ?", "1:2: error: found '?', expected an instruction, a directive or a macro"},
      {" +", "1:2: error: found '+', expected a label, an instruction, a directive or a comment"},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(messages8080(text), one(message)) << text;
}

TEST(I8080Errors, AMacroNamesBothPlaces) {
  EXPECT_EQ(messages8080("PUT MACRO C\n\tMVI E,C\n ENDM\nTWICE MACRO C\n PUT C\n ENDM\n NOP\n TWICE 300\n"),
            one("2:8: error: found value 300 (012C), expected a byte, -128 to 255 (in PUT at t.asm:5, in "
                "TWICE at t.asm:8)"));
  EXPECT_EQ(messages8080(" REPT 1\n\tDB Q ; later text keeps its column\n ENDM"),
            one("2:5: error: found undefined symbol 'Q', expected one that is defined (in REPT at t.asm:1)"));
  EXPECT_EQ(messages8080("P MACRO LONGNAME\n DB LONGNAME,Q\n ENDM\n P 1\n"),
            one("2:14: error: found undefined symbol 'Q', expected one that is defined (in P at t.asm:4)"));
}

TEST(I8080Errors, IncludedFilesAreNamed) {
  const Files files{{"a.inc", "\n FOO\n"}, {"loop.inc", " INCLUDE loop.inc\n"}};
  EXPECT_EQ(messages(assemble8080(" INCLUDE a.inc\n INCLUDE loop.inc\n", {}, files)),
            (Texts{"a.inc:2:2: error: found 'FOO', expected an instruction, a directive or a macro",
                   "loop.inc:1:10: error: found 'loop.inc', which is being read, expected a file that "
                   "does not include itself"}));
}

TEST(I8080Errors, EndlessRecursionAndRepeats) {
  I8080Options options;
  options.most_lines = 5000;
  const auto last = [&](const std::string& text) { return messages(assemble8080(text, options)); };
  EXPECT_EQ(last("P MACRO\n P\n ENDM\n P\n").size(), 1U);
  EXPECT_NE(last("P MACRO\n P\n ENDM\n P\n")[0].find("a recursion that ends"), std::string::npos);
  EXPECT_NE(last(" REPT 65535\n NOP\n ENDM\n")[0].find("more than 5000 lines"), std::string::npos);
  EXPECT_EQ(last(" REPT 2000\n DB Q\n ENDM\n").size(), 1001U);
  EXPECT_FALSE(assemble8080("P MACRO X\n P <X&X>\n ENDM\n P 1234567890\n").ok());
  EXPECT_FALSE(assemble8080(" DB " + std::string(5000, '(')).ok());
  EXPECT_FALSE(assemble8080(" DB " + std::string(5000, '-') + "1").ok());
  std::string chain = " DB ";
  for (int i = 0; i < 5000; ++i) chain += "MOV ";
  EXPECT_FALSE(assemble8080(chain).ok());
}

TEST(I8080Errors, WarningsDoNotPreventOutput) {
  const auto twice = assemble8080(" DB 1,2\n ORG 1\n DB 3\n");
  EXPECT_EQ(messages(twice), one("3:1: warning: found a second byte for address 0001, expected one"));
  EXPECT_EQ(bytes_of(twice), (Bytes{1, 3}));
  EXPECT_EQ(messages8080("P MACRO X\n DB X\n ENDM\n P 1,2\n"),
            one("4:6: warning: found 2 arguments, expected at most 1 for P"));
}

TEST(I8080Errors, ManyWarningsDoNotPreventOutput) {
  const std::string warned = " REPT 1500\n ORG 0\n DB 1\n ENDM\n";
  const auto assembly = assemble8080(warned);
  EXPECT_TRUE(assembly.ok());
  EXPECT_EQ(bytes_of(assembly), Bytes{1});
  ASSERT_EQ(assembly.diagnostics.size(), 1001U);
  EXPECT_EQ(assembly.diagnostics.back().found, "more than 1000 warnings");
  const auto with_error = assemble8080(warned + " FOO\n");
  EXPECT_EQ(with_error.diagnostics.back().found, "'FOO'");
}

TEST(I8080Errors, AByteBeyondTheMemoryIsReportedOnceUntilOrg) {
  EXPECT_EQ(messages8080(" ORG 0FFFEH\n DS 3\n NOP\n DS 5\n DS 5,1\n ORG 0FFFFH\n NOP\n NOP\n DB 1,2\n"),
            (Texts{"t.asm:3:1: error: found a byte past FFFF, expected a program within 64K",
                   "t.asm:8:1: error: found a byte past FFFF, expected a program within 64K"}));
}

TEST(I8080Errors, LongLines) {
  const std::string most(16384, ';');
  EXPECT_EQ(messages8080(most), Texts{});
  EXPECT_EQ(messages8080(most + ";\n NOP\n"),
            one("1:1: error: found a longer line, expected at most 16384 characters"));
  const std::string argument(8000, 'X');
  std::string body = " DB '";
  for (int i = 0; i < 4000; ++i) body += "&A&";
  EXPECT_EQ(messages8080("P MACRO A\n" + body + "\n ENDM\n P " + argument + "\n"),
            one("2:1: error: found a longer line after expansion, expected at most 16384 characters (in P at "
                "t.asm:4)"));
}

TEST(I8080Errors, FilledSpaceCountsAsLines) {
  I8080Options options;
  options.most_lines = 20000;
  const auto assembly = assemble8080(" REPT 3\n ORG 0\n DS 40000,1\n ENDM\n", options);
  EXPECT_NE(messages(assembly).back().find("more than 20000 lines"), std::string::npos);
  EXPECT_LE(assembly.listing.size(), 20010U);
  EXPECT_TRUE(assemble8080(" DS 40000,1\n", options).ok());
}

TEST(I8080Errors, ADefineIsNotALabel) {
  I8080Options options;
  options.defines = {{"L1", 1}};
  EXPECT_EQ(messages(assemble8080("L1: NOP", options)),
            one("1:1: error: found label 'L1', expected another name: -D defines this one"));
}

}  // namespace
}  // namespace sightline::assembler
