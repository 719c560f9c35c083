// The differences between the 8080 assemblers of the time. The expected bytes follow from their manuals: Digital Research's of
// ASM
// (CP/M Operating System Manual, chapter 3) and MAC, Microsoft's of MACRO-80 (Utility Software Manual, chapter 2), Intel's of the
// 8080/8085 assembler (9800301). originals_test.cpp has bytes made by MAC and MACRO-80 themselves.
#include "tools/asm/i8080/dialect.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/effort.hpp"
#include "tests/tools/asm/i8080/assemble.hpp"
#include "tools/disasm/i8080.hpp"

namespace sightline::assembler {
namespace {

using enum I8080Dialect;

I8080Assembly assemble_dialect(I8080Dialect dialect, const std::string& text) {
  I8080Options options;
  options.dialect = dialect;
  return assemble8080(text, options);
}
Bytes bytes(I8080Dialect dialect, const std::string& text) {
  const auto assembly = assemble_dialect(dialect, text);
  EXPECT_TRUE(assembly.ok()) << text << (assembly.ok() ? "" : messages(assembly)[0]);
  return bytes_of(assembly);
}
std::string first_message(I8080Dialect dialect, const std::string& text) {
  const auto all = messages(assemble_dialect(dialect, text));
  return all.empty() ? "" : all[0];
}

// --- Constructs whose bytes differ without an error ---

// ASM, section 3.2: a comment lasts to the next real or logical end of line, and `!` is a logical one. MACRO-80, 2.3.1: to the
// carriage return.
TEST(I8080Dialect, ABangEndsACommentOfDigitalResearch) {
  const std::string text = " MVI A,1 ; one ! RET\n";
  EXPECT_EQ(bytes(mac, text), (Bytes{0x3E, 1, 0xC9}));
  EXPECT_EQ(bytes(m80, text), (Bytes{0x3E, 1}));
  EXPECT_EQ(bytes(intel, text), (Bytes{0x3E, 1}));
  EXPECT_EQ(bytes(common, text), (Bytes{0x3E, 1}));
  EXPECT_EQ(first_message(common, text),
            "t.asm:1:16: warning: found '!' in a comment before 'RET', expected --dialect: mac begins a statement there");
  EXPECT_EQ(first_message(common, " NOP ; that is all!\n NOP ; so be it! And no more\n"), "");
  EXPECT_EQ(first_message(common, " NOP ; go! NEXT: is the label\n").substr(0, 26), "t.asm:1:10: warning: found");
}

// In MAC 2.0 and MACRO-80 3.44 (see originals_test.cpp) `$` moves on with each item, whatever 2.11 of the manual of MACRO-80 says.
TEST(I8080Dialect, TheLocationOfLaterItems) {
  const std::string text = " ORG 100H\n DB 0,0,LOW $\n DW $,$\n";
  EXPECT_EQ(bytes(mac, text), (Bytes{0, 0, 2, 3, 1, 5, 1}));
  EXPECT_EQ(bytes(m80, text), (Bytes{0, 0, 2, 3, 1, 5, 1}));
  EXPECT_EQ(bytes(intel, text), (Bytes{0, 0, 0, 3, 1, 3, 1}));
  EXPECT_EQ(bytes(common, text), (Bytes{0, 0, 2, 3, 1, 5, 1}));
  EXPECT_EQ(messages(assemble_dialect(common, text)).size(), 2U);
  EXPECT_EQ(first_message(common, " JMP $+3\n DB $\n"), "");
}

// MACRO-80, 2.7.9: `!` makes the next character of an argument literal, so `!;` and `<;>` are the same; MAC has `^`.
TEST(I8080Dialect, TheSignOfLiteralCharacters) {
  const std::string macro = "P MACRO X\n DB X\n ENDM\n";
  EXPECT_EQ(bytes(m80, macro + " P <1!+2>\n"), Bytes{3});
  EXPECT_EQ(bytes(m80, "P MACRO X\n DB '&X'\n ENDM\n P !;\n P <;>\n"), (Bytes{';', ';'}));
  EXPECT_EQ(bytes(m80, macro + " P <'!>'>\n"), (Bytes{'!', '>'})) << "a string is passed as it is";
  EXPECT_EQ(bytes(intel, macro + " P <'!>'>\n"), Bytes{'>'});
  EXPECT_EQ(bytes(mac, macro + " P <'^>'>\n"), Bytes{'>'});
  EXPECT_EQ(bytes(mac, macro + " P <'!'>\n"), Bytes{'!'});
  EXPECT_EQ(bytes(common, macro + " P <'!'>\n"), Bytes{'!'});
  EXPECT_NE(first_message(common, macro + " P <'!'>\n").find("warning: found '!' in an argument, expected --dialect"),
            std::string::npos);
}

// MACRO-80, 2.3.2: `$` is one of the characters of a name. ASM, section 3.2: it is ignored in names.
TEST(I8080Dialect, DollarsInNames) {
  EXPECT_EQ(bytes(m80, "$abe EQU 5\nA$B: DB $abe\nAB: DB A$B,AB\n"), (Bytes{5, 0, 1}));
  EXPECT_EQ(bytes(m80, "$name: JMP $name\n"), (Bytes{0xC3, 0, 0}));
  EXPECT_EQ(bytes(mac, "A$B: DB 1$2\n DB AB\n"), (Bytes{12, 0}));
  for (const auto dialect : {common, mac, intel}) {
    EXPECT_EQ(first_message(dialect, " DB $abe\n").substr(0, 34), "t.asm:1:5: error: found '$abe', ex");
    EXPECT_EQ(first_message(dialect, " NOP\n$name: JMP 0\n"),
              "t.asm:2:1: error: found label '$name:', expected one that does not begin with `$`, which --dialect m80 has");
  }
  EXPECT_EQ(bytes(common, "$PRINT\n DB $3A\n"), Bytes{0x3A});
}

// --- The other rows ---

TEST(I8080Dialect, StatementsOfALine) {
  EXPECT_EQ(bytes(mac, " NOP ! HLT\n"), (Bytes{0, 0x76}));
  for (const auto dialect : {m80, intel}) {
    EXPECT_EQ(first_message(dialect, " NOP ! HLT\n"),
              "t.asm:1:6: error: found '!', expected the end of the statement; --dialect mac separates statements with `!`");
  }
}

// MAC, 4.5: "if the least significant bit of the expression is 1"; Intel: the low-order bit. MACRO-80, 2.6.26: true if not 0.
TEST(I8080Dialect, BitZeroOfIf) {
  const std::string text = " IF 2\n DB 1\n ELSE\n DB 0\n ENDIF\n";
  EXPECT_EQ(bytes(mac, text), Bytes{0});
  EXPECT_EQ(bytes(common, text), Bytes{1});
  EXPECT_NE(first_message(common, text).find("warning: found value 2 of IF, expected 0, an odd value or --dialect"), std::string::npos);
  EXPECT_NE(first_message(mac, text).find("only bit 0 is tested with --dialect mac"), std::string::npos);
  EXPECT_EQ(first_message(common, " IF 3\n ENDIF\n IF 0\n ENDIF\n"), "");
  EXPECT_EQ(bytes(m80, text), Bytes{1});
  EXPECT_EQ(bytes(intel, text), Bytes{0});
  EXPECT_NE(first_message(intel, text).find("warning: found value 2 of IF"), std::string::npos);
  EXPECT_EQ(first_message(intel, " IF 0FFFFH\n ENDIF\n IF 0\n ENDIF\n"), "");
}

// MAC, 3.6: HIGH and LOW are applied last. MACRO-80, 2.4.1, and Intel, chapter 2: they are applied first.
TEST(I8080Dialect, WhatHighTakes) {
  const std::string text = "T EQU 12FFH\n DB HIGH T+1, LOW T OR 100H AND 0FFH, (HIGH T)+1, 1 OR HIGH T\n";
  EXPECT_EQ(bytes(mac, text), (Bytes{0x13, 0xFF, 0x13, 0x13}));
  for (const I8080Dialect other : {m80, intel, common}) EXPECT_EQ(bytes(other, text), (Bytes{0x13, 0xFF, 0x13, 0x13}));
  const std::string apart = "T EQU 12FFH\n DW HIGH T SHL 4, LOW T+1\n";
  EXPECT_EQ(bytes(mac, apart), (Bytes{0x2F, 0, 0, 0}));  // 12FF SHL 4 is 2FF0; 1300
  for (const I8080Dialect other : {m80, intel, common}) EXPECT_EQ(bytes(other, apart), (Bytes{0x20, 1, 0, 1}));
  EXPECT_EQ(messages(assemble_dialect(common, apart)).size(), 2U);
  EXPECT_EQ(messages(assemble_dialect(m80, apart)).size(), 0U);
  EXPECT_EQ(first_message(common, " DB HIGH 1, LOW (2+3), 1+HIGH 2\n"), "");
}

// --- The listings of MAC 2.0 in its manual ---

// The bytes of DB lines in the form of the listing: strings with `'`, and numbers.
Bytes operator+(Bytes bytes, const std::string& text) {
  bytes.insert(bytes.end(), text.begin(), text.end());
  return bytes;
}
Bytes operator+(Bytes bytes, std::uint8_t byte) {
  bytes.push_back(byte);
  return bytes;
}

// Figure 19; the listing assembles the last line but one at 0086, although the text says otherwise of NUL ''.
TEST(I8080MacManual, TestsOfEmptyParameters) {
  const std::string text =
      " IF NUL\n DB 'true case'\n ELSE\n DB 'false case'\n ENDIF\n"
      " IF NUL XXX\n DB 'xxx is nul'\n ELSE\n DB 'xxx is not nul'\n ENDIF\n"
      "NULMAC MACRO A,B,C\n IF NOT NUL A\n DB 'a = &A is not nul'\n ENDIF\n IF NOT NUL B\n DB 'b = &B is not nul'\n ENDIF\n"
      " IF NOT NUL B&C\n DB 'bc = &B&C is not nul'\n ENDM\n"
      " NULMAC\n NULMAC XXX\n NULMAC ,XXX\n NULMAC XXX,,YYY\n NULMAC ,,YYY\n NULMAC ,,,\n NULMAC ,'',''\n";
  const Bytes expected = Bytes{} + "true case" + "xxx is not nul" + "a = XXX is not nul" + "b = XXX is not nul" +
                         "bc = XXX is not nul" + "a = XXX is not nul" + "bc = YYY is not nul" + "bc = YYY is not nul" +
                         "b = ' is not nul" + "bc = '' is not nul";
  ASSERT_EQ(expected.size(), 0xA8U);
  EXPECT_EQ(bytes(mac, text), expected);
}

// Figure 23: A, the value of C, gives way to the value of A.
TEST(I8080MacManual, EvaluationOfParameters) {
  const std::string text =
      "MAC1 MACRO A,B,C,D,S\n DB '&A &B &C &D'\n DB S\nA: NOP\n MVI B,1\nC&1: NOP\nL&A&D: NOP\n ENDM\n"
      "MAC2 MACRO E,F,G,H,S\n DB '&E &F &G &H'\n DB S\n MVI M,H\n MAC1 E,F&M,A,H,S\n ENDM\n"
      "X EQU 15\n MAC2 I ,, X+L, % X + 1, 'kwote'\n";
  const Bytes expected = Bytes{} + "I  X+L 16" + "kwote" + 0x36 + 0x10 + "I M I 16" + "kwote" + 0x00 + 0x36 + 0x01 + 0x00 + 0x00;
  ASSERT_EQ(expected.size(), 0x22U);
  const auto assembly = assemble_dialect(mac, text);
  EXPECT_EQ(bytes_of(assembly), expected);
  EXPECT_EQ(assembly.value_of("I"), 0x1D);
  EXPECT_EQ(assembly.value_of("I1"), 0x20);
  EXPECT_EQ(assembly.value_of("LI16"), 0x21);
}

// Figure 24.
TEST(I8080MacManual, BracketsAreRemovedOneByOne) {
  const std::string text =
      "IRPM1 MACRO X\n IRP Y,X\nY: NOP\n ENDM\n ENDM\n IRPM1 <<ONE,TWO,THREE>>\n"
      "IRPM2 MACRO X\n IRP Y,<X>\nY: NOP\n ENDM\n ENDM\n IRPM2 <FOUR,FIVE,SIX>\n"
      "IRPM3 MACRO X1,X2,X3\n IRP Y,<X1,X2,X3>\nY: NOP\n ENDM\n ENDM\n IRPM3 SEVEN,EIGHT,NINE\n"
      "IRPM4 MACRO X\n IRPM1 X\n ENDM\n IRPM4 <<<TEN,ELEVEN,TWELVE>>>\n";
  const auto assembly = assemble_dialect(mac, text);
  EXPECT_EQ(bytes_of(assembly), Bytes(12, 0));
  EXPECT_EQ(assembly.value_of("TWELVE"), 11);
}

// Figure 25.
TEST(I8080MacManual, StringsAndEscapesInArguments) {
  const std::string text =
      "MAC1 MACRO X,Y\n DB '&X'\n IF NUL Y\n EXITM\n ENDIF\n DB Y\n ENDM\n"
      " MAC1 <<LEFT SIDE> MIDDLE <RIGHT SIDE>>\n"
      " MAC1 <>,<'string of pearls',34H>\n"
      " MAC1 <A QUOTE IS A '', RIGHT?>\n"
      " MAC1 <>,<'right, but also '''''>\n"
      " MAC1 ,<'is this ','''''confusing''''', 63>\n"
      " MAC1 <HERE IS A ^> AND A ^^>\n"
      "MAC2 MACRO APAR,BPAR\n LOCAL X\nX EQU 10\n DB APAR\n MAC1 ^APAR,BPAR\n ENDM\n"
      " MAC2 (X+5)*4,'what''''''''s qoing on?'\n";
  const Bytes expected = Bytes{} + "<LEFT SIDE> MIDDLE <RIGHT SIDE>" + "string of pearls" + 0x34 + "A QUOTE IS A ', RIGHT?" +
                         "right, but also '" + "is this " + "'confusing'" + 63 + "HERE IS A > AND A ^" + 0x3C + "APAR" +
                         "what's qoing on?";
  ASSERT_EQ(expected.size(), 0x93U);
  EXPECT_EQ(bytes(mac, text), expected);
  // In the other dialects each call needs one more apostrophe.
  EXPECT_EQ(bytes(m80, "Q MACRO Y\n DB Y\n ENDM\n Q 'a''b'\n"), Bytes{} + "a'b");
}

// --- Warnings of the common language where a dialect would make other bytes ---

TEST(I8080Dialect, WordsOfTwoCharacters) {
  EXPECT_EQ(bytes(mac, " DW 'AB'\n LXI H,'AB'\n"), (Bytes{0x41, 0x42, 0x21, 0x41, 0x42}));
  EXPECT_EQ(bytes(m80, " DW 'AB'\n LXI H,'AB'\n"), (Bytes{0x42, 0x41, 0x21, 0x42, 0x41}));
  EXPECT_EQ(bytes(common, " DW 'AB'\n"), (Bytes{0x42, 0x41}));
  EXPECT_EQ(first_message(common, " DW 'AB'\n"),
            "t.asm:1:5: warning: found ''AB'' as a value, expected --dialect: its first character is the high byte here, the low "
            "byte in MAC");
  EXPECT_EQ(first_message(common, " DW 'AA','A'\n DB 'AB'\n"), "");
}

TEST(I8080Dialect, DivisionsWithSign) {
  EXPECT_EQ(bytes(m80, " DW -7/2,7 MOD -4\n"), (Bytes{0xFD, 0xFF, 0xFD, 0xFF}));
  EXPECT_EQ(bytes(mac, " DW 0FFF9H/2\n"), (Bytes{0xFC, 0x7F}));
  EXPECT_EQ(bytes(common, " DW 0FFF9H/2\n"), (Bytes{0xFC, 0x7F}));
  EXPECT_NE(first_message(common, " DW 0FFF9H/2\n").find("warning: found a division of values above 7FFF, expected --dialect"), std::string::npos);
  EXPECT_EQ(first_message(common, " DW 7/2,7 MOD 4,-7/2\n"), "");
}

// MAC 2.0 marks all of these with E; those that it accepts get no warning.
TEST(I8080Dialect, PrefixesAfterOperatorsOfHigherPrecedenceInMac) {
  for (const char* refused : {"5--3", "5-NOT 3", "5*-3", "6/-3", "1 EQ NOT 0FFFEH", "5-HIGH 300H", "5*LOW 3", "- -5", "2*NOT 1", "1 OR HIGH 300H",
                              "1 EQ HIGH 100H", "NOT HIGH 100H", "HIGH LOW 5", "-HIGH 300H", "-NOT 1"}) {
    EXPECT_NE(first_message(mac, std::string(" DW ") + refused + "\n").find("after an operator of higher precedence"), std::string::npos) << refused;
    EXPECT_EQ(first_message(m80, std::string(" DW ") + refused + "\n"), "") << refused;
  }
  for (const char* taken : {"-5*3", "5 AND NOT 4", "5 XOR NOT 4", "5-+3", "5 OR -1", "5 EQ -1", "5 SHL (-1)", "HIGH 300H+1", "HIGH NOT 0", "HIGH -1",
                            "NOT -1", "(5)-(-3)", "1 OR (HIGH 300H)"})
    EXPECT_EQ(first_message(mac, std::string(" DW ") + taken + "\n"), "") << taken;
}

TEST(I8080Dialect, LongNamesDrawAWarning) {
  EXPECT_EQ(first_message(intel, "SEVENCH: NOP\n"),
            "t.asm:1:1: warning: found 'SEVENCH' of 7 characters, expected at most 6, which are all that count with --dialect intel");
  EXPECT_EQ(first_message(m80, "SIXTEENCHARACTER: NOP\n"), "");
  EXPECT_EQ(first_message(m80, "SEVENTEENCHARACTS: NOP\n").substr(0, 20), "t.asm:1:1: warning: ");
  EXPECT_EQ(first_message(mac, "SEVENTEENCHARACTS: NOP\n").substr(0, 20), "t.asm:1:1: warning: ");
  EXPECT_EQ(first_message(common, "SEVENTEENCHARACTS: NOP\n"), "");
}

// --- Common to all dialects ---

TEST(I8080Dialect, RelationsBySign) {
  EXPECT_EQ(bytes(m80, " DB 1=1,1<>1,1<2,2<=1,2>1,1>=2\n"), (Bytes{0xFF, 0, 0xFF, 0, 0xFF, 0}));
  EXPECT_EQ(bytes(common, " DB 1+1=2 AND 3>2\n"), Bytes{0xFF});
}

TEST(I8080Dialect, LabelsThatAreWordsOfTheLanguage) {
  EXPECT_EQ(bytes(common, "daa: JMP daa\nLT: JMP LT\nM: MOV A,M\n JMP M\nlda: LDA lda\n"),
            (Bytes{0xC3, 0, 0, 0xC3, 3, 0, 0x7E, 0xC3, 6, 0, 0x3A, 10, 0}));
  EXPECT_EQ(bytes(common, " JMP ret\n DB (RET)\nret: NOP\n"), (Bytes{0xC3, 4, 0, 4, 0})) << "also before it is defined";
  EXPECT_EQ(bytes(common, "LT: DB 1 LT 2\n"), Bytes{0xFF}) << "between operands it is the operator";
  EXPECT_FALSE(assemble_dialect(common, "NOT: NOP\n").ok());
}

TEST(I8080Dialect, ALabelOnEndm) {
  EXPECT_EQ(bytes(m80, "P MACRO\n JMP DONE\nDONE: ENDM\n P\n NOP\n"), (Bytes{0xC3, 3, 0, 0}));
}

TEST(I8080Dialect, OpenConditionalsAtTheEnd) {
  EXPECT_EQ(bytes(m80, "P MACRO\n IF 1\n DB 1\n ENDM\n P\n DB 2\n"), (Bytes{1, 2}));
  EXPECT_EQ(first_message(m80, " IF 1\n DB 1\n END\n").substr(0, 20), "t.asm:1:2: warning: ");
}

TEST(I8080Dialect, EqualDefinitions) {
  EXPECT_EQ(bytes(common, "A1: EQU 5\nA1 EQU 5\n DB A1\n"), Bytes{5});
  EXPECT_FALSE(assemble_dialect(common, "A1 EQU 5\nA1 EQU 6\n").ok());
  EXPECT_FALSE(assemble_dialect(common, "A1: NOP\nA1: NOP\n").ok());
}

// MACRO-80, 2.6.26 IF1 and IF2, 2.6.22 .RADIX, 2.6.29 .PHASE, 2.6.20 .COMMENT, 2.3.2 NAME##, 2.3.3 X'..', 2.11 controls.
TEST(I8080Dialect, DirectivesOfMacro80) {
  EXPECT_EQ(bytes(m80, " IF1\nONE EQU 7\n ENDIF\n IF2\n DB ONE\n ENDIF\n"), Bytes{7});
  EXPECT_EQ(bytes(m80, " .RADIX 16\n DB 10,0FB,1D,11Q\n .RADIX 10\n DB 10\n .RADIX 2\n DB 101,10D\n"),
            (Bytes{0x10, 0xFB, 0x1D, 9, 10, 5, 10}));
  EXPECT_EQ(bytes(m80, " ORG 100H\n NOP\n .PHASE 200H\nX: JMP X\n DW $\n .DEPHASE\nY: DW Y\n"),
            (Bytes{0, 0xC3, 0, 2, 3, 2, 6, 1}));
  EXPECT_EQ(bytes(m80, " DB 1\n .COMMENT * DB 2\n DB 3\n DB 4 * DB 5\n DB 6\n .COMMENT /one line/\n DB 7\n"), (Bytes{1, 6, 7}));
  EXPECT_FALSE(assemble_dialect(m80, " .COMMENT *\n NOP\n").ok());
  EXPECT_EQ(bytes(m80, " CALL SUB##\n EXTRN TOP\n DW TOP\nSUB:: RET\nTOP: NOP\n"), (Bytes{0xCD, 5, 0, 6, 0, 0xC9, 0}));
  EXPECT_EQ(bytes(m80, " DB X'0F',x'a'\n"), (Bytes{0x0F, 0x0A}));
  EXPECT_FALSE(assemble_dialect(m80, " DB X'0G'\n").ok());
  EXPECT_EQ(bytes(m80, "$EJECT\n$TITLE('x')\n$ EJECT\n DB 1\n"), Bytes{1});
  EXPECT_FALSE(assemble_dialect(m80, "$INCLUDE X\n").ok());
  // 2.7.9: % gives the number in the current radix.
  EXPECT_EQ(bytes(m80, "P MACRO X\n DB X\n ENDM\n .RADIX 16\n P %0FE\n .RADIX 2\n P %101\n"), (Bytes{0xFE, 5}));
}

TEST(I8080Dialect, CommonBlocksOfOneNameOverlap) {
  EXPECT_EQ(bytes(m80, " DB 1\n COMMON /C/\nA1: DS 2\nB1: DB 9\n CSEG\n DB 2\n COMMON /C/\nA2: DS 2\n CSEG\n DB A1,A2\n"),
            (Bytes{1, 0, 0, 9, 2, 1, 1}));
  EXPECT_FALSE(assemble_dialect(m80, " COMMON /C/\n DS 1\n CSEG\n COMMON /C/\n DS 2\n").ok());
  EXPECT_FALSE(assemble_dialect(m80, " COMMON C\n").ok());
}

// Utility Software Manual, 2.6.1, 2.6.3, 2.6.7, 2.6.15: a segment continues where it was left, and ORG sets the current segment.
TEST(I8080Dialect, SegmentsContinueWhereTheyWereLeft) {
  const auto assembly = assemble_dialect(m80,
                                  " ORG 100H\n DB 1\n DSEG\n ORG 200H\nV: DB 2\n CSEG\n DB 3\n DSEG\nW: DB 4\n ASEG\n ORG 8\n DB 5\n CSEG\n"
                                  "X: DW V,W,X\n ASEG\n DB 6\n END\n");
  ASSERT_TRUE(assembly.ok()) << messages(assembly)[0];
  const std::vector<std::pair<unsigned, unsigned>> expected{{8, 5}, {9, 6}, {0x100, 1}, {0x101, 3}, {0x102, 0}, {0x103, 2},
                                                            {0x104, 1}, {0x105, 2}, {0x106, 2}, {0x107, 1}, {0x200, 2}, {0x201, 4}};
  std::vector<std::pair<unsigned, unsigned>> made;
  for (unsigned at = 0; at < 0x10000; ++at)
    if (assembly.image.used(static_cast<std::uint16_t>(at)))
      made.emplace_back(at, assembly.image[static_cast<std::uint16_t>(at)]);
  EXPECT_EQ(made, expected);
  // Without an ORG a segment follows the code before it, and no bytes overlap.
  EXPECT_EQ(bytes(m80, " ORG 100H\n DB 1\n DSEG\nV: DB 2\n CSEG\n DB 3\n DSEG\n DB LOW V\n CSEG\n ORG 110H\n DSEG\nW: DB LOW W\n"),
            (Bytes{1, 2, 3, 1, 4}));
}

TEST(I8080Dialect, NumbersWrapWithAWarning) {
  EXPECT_EQ(bytes(common, " DW 65536,10001H\n"), (Bytes{0, 0, 1, 0}));
  EXPECT_EQ(messages(assemble_dialect(common, " DW 65536,10001H\n")).size(), 2U);
}

TEST(I8080Dialect, ExternalsAreFoundInOtherSourcesOfTheCommand) {
  const std::vector<SourceFile> sources{{"a.asm", " EXTRN PUTC\n CALL PUTC\n"}, {"b.asm", " PUBLIC PUTC\nPUTC: RET\n"}};
  const auto assembly = assemble_i8080(sources);
  EXPECT_TRUE(assembly.ok());
  EXPECT_EQ(bytes_of(assembly), (Bytes{0xCD, 3, 0, 0xC9}));
}

// MACRO-80, 2.6.10 and 2.6.12; RMAC and Intel, chapter 4: a name is local to its module unless PUBLIC declares it.
TEST(I8080Dialect, NamesOfAModuleAreLocal) {
  const std::vector<SourceFile> sources{
      {"a.asm", " PUBLIC START,OUT\n EXTRN PUTC\nSTART: CALL PUTC\nLOOP: JMP LOOP\nN EQU 5\nOUT: DB N\n"},
      {"b.asm", "LOOP: JMP LOOP\nN SET 6\nN SET N+1\nPUTC:: DB N\n LXI H,OUT##\n"},
      {"c.asm", "LOOP: JMP LOOP\n CALL START\n"}};
  for (const I8080Dialect dialect : {common, mac, m80, intel}) {
    I8080Options options;
    options.dialect = dialect;
    const auto assembly = assemble_i8080(sources, options);
    ASSERT_TRUE(assembly.ok()) << messages(assembly)[0];
    EXPECT_EQ(bytes_of(assembly), (Bytes{0xCD, 10, 0, 0xC3, 3, 0, 5, 0xC3, 7, 0, 7, 0x21, 6, 0, 0xC3, 14, 0, 0xCD, 0, 0}));
    EXPECT_EQ(assembly.diagnostics.size(), 0U);
  }
  // A name of -D is common to all modules.
  I8080Options options;
  options.defines.push_back({"N", 9});
  EXPECT_EQ(bytes_of(assemble_i8080(sources, options))[6], 9);
}

TEST(I8080Dialect, UndeclaredNamesBetweenModules) {
  const auto first = [](const std::string& a, const std::string& b) {
    const auto all = messages(assemble_i8080(std::vector<SourceFile>{{"a.asm", a}, {"b.asm", b}}));
    return all.empty() ? std::string() : all[0];
  };
  EXPECT_EQ(first(" EXTRN X\n CALL X\n", " PUBLIC Y\nX: RET\nY: RET\n"),
            "a.asm:2:7: error: found external symbol 'X', expected PUBLIC X in b.asm");
  EXPECT_EQ(first(" PUBLIC Y\nY: CALL X\n", " PUBLIC X\nX: RET\n"),
            "a.asm:2:9: error: found undefined symbol 'X', expected EXTRN X: b.asm defines it");
  EXPECT_EQ(first(" CALL X\n", " PUBLIC Y\nX: RET\nY: RET\n"),
            "a.asm:1:7: error: found undefined symbol 'X', expected PUBLIC X in b.asm");
  EXPECT_EQ(first(" PUBLIC X\nX: RET\n", " PUBLIC X\nX: RET\n"),
            "b.asm:2:1: error: found a second definition of 'X', expected one, at a.asm:2");
  EXPECT_EQ(first(" PUBLIC X\n", " NOP\n"), "a.asm:1:9: warning: found public symbol 'x' without a definition, expected one in this source");
  // Without PUBLIC and EXTRN they are one program.
  EXPECT_EQ(first("X: RET\n", "X: RET\n"), "b.asm:1:1: error: found a second definition of 'X', expected one, at a.asm:1");
  EXPECT_EQ(first("X: RET\n", " JMP X\n"), "");
}

// --- Laws ---

TEST(I8080Dialect, DisassembliesReadTheSameInEachDialect) {
  std::mt19937 random(1974);
  for (int program = 0; program < tests::effort(1000, 100); ++program) {
    image::ByteImage image;
    auto at = static_cast<std::uint16_t>(random() % 0xFF00);
    for (unsigned n = 0; n < 40; ++n) {
      if (random() % 16 == 0) at = static_cast<std::uint16_t>(at + random() % 5);
      image.put(at++, static_cast<std::uint8_t>(random()));
    }
    const std::vector<SourceFile> sources{{"again", disassembler::disassemble_i8080(image)}};
    for (const auto dialect : {common, mac, m80, intel}) {
      I8080Options options;
      options.dialect = dialect;
      options.listing = false;
      const auto assembly = assemble_i8080(sources, options);
      ASSERT_TRUE(assembly.diagnostics.empty()) << to_string(assembly.diagnostics[0]);
      ASSERT_EQ(assembly.image, image) << program;
    }
  }
}

TEST(I8080Dialect, NamesAndRowsAreComplete) {
  for (const std::string_view name : i8080_dialect_names) {
    const auto dialect = i8080_dialect_named(name);
    ASSERT_TRUE(dialect) << name;
    EXPECT_EQ(rules_of(*dialect).dialect, *dialect);
  }
  EXPECT_FALSE(i8080_dialect_named("z80"));
  for (const I8080DialectRow& row : i8080_dialect_rows()) {
    bool differs = false;
    for (const auto dialect : {mac, m80, intel}) differs = differs || row.says(rules_of(dialect)) != row.says(rules_of(common));
    EXPECT_TRUE(differs) << row.what;
  }
}

}  // namespace
}  // namespace sightline::assembler
