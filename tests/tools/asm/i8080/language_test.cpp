// The language of the 8080 assembler without macros: instructions, numbers, expressions, data, symbols, files.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/tools/asm/i8080/assemble.hpp"

namespace sightline::assembler {
namespace {

// Every documented opcode, by the mnemonics of a table independent of the assembler.
TEST(I8080Language, EveryInstruction) {
  std::ifstream table(SIGHTLINE_TEST_DATA "/i8080/opcode-timing.csv");
  std::string line;
  std::getline(table, line);
  int tried = 0;
  while (std::getline(table, line)) {
    const std::size_t quote = line.find('"');
    std::string text = line.substr(quote + 1, line.find('"', quote + 1) - quote - 1);
    if (text[0] == '*') continue;
    Bytes expected{static_cast<std::uint8_t>(std::stoi(line.substr(0, 2), nullptr, 16))};
    for (const auto& [operand, bytes] : std::vector<std::pair<std::string, Bytes>>{
             {"d8", {0x5A}}, {"d16", {0x34, 0x12}}, {"a16", {0x34, 0x12}}}) {
      const std::size_t at = text.find(operand);
      if (at == std::string::npos) continue;
      text.replace(at, operand.size(), operand == "d8" ? "5AH" : "1234H");
      expected.insert(expected.end(), bytes.begin(), bytes.end());
    }
    EXPECT_EQ(bytes8080("\t" + text), expected) << text;
    ++tried;
  }
  EXPECT_EQ(tried, 244);
}

TEST(I8080Language, RegistersAreValues) {
  EXPECT_EQ(bytes8080(" MOV 7,0\n MOV A,6\n INR 1\n PUSH 6\n LXI 4,0\n"),
            (Bytes{0x78, 0x7E, 0x0C, 0xF5, 0x21, 0, 0}));
  EXPECT_EQ(bytes8080("ACC EQU 7\n MOV ACC,M\n DB B,C,D,E,H,L,M,A,SP,PSW"),
            (Bytes{0x7E, 0, 1, 2, 3, 4, 5, 6, 7, 6, 6}));
  EXPECT_EQ(bytes8080(" LXI HL,1\n PUSH BC\n DAD DE\n"), (Bytes{0x21, 1, 0, 0xC5, 0x19}));
  EXPECT_EQ(bytes8080("HL: LXI H,HL\n"), (Bytes{0x21, 0, 0}));
}

// CP/M's ASM and MAC: A is 7, PSW is 6, and both give F5.
TEST(I8080Language, PushAIsPushPsw) {
  EXPECT_EQ(bytes8080(" PUSH A\n POP A\n PUSH 7\nACC EQU A\n POP ACC\n RET\n"), (Bytes{0xF5, 0xF1, 0xF5, 0xF1, 0xC9}));
  for (const char* other : {" LXI A,1", " DAD A", " INX A", " DCX 7", " STAX A", " LDAX A", " PUSH C", " POP 1", " PUSH 5"})
    EXPECT_FALSE(assemble8080(other).ok()) << other;
}

// ASM and MAC: RAM begins again at 0.
TEST(I8080Language, SpaceMayRunPastTheEndOfMemory) {
  const auto assembly = assemble8080(
      "\tORG 0FFF8H\n\tDB 1,2,3\nBUF:\tDS 16\nEND1:\tEQU $\nNEXT:\tDS 0FFFFH\nLAST:\tDS 1\n\tORG 0F000H\n\tLXI H,END1\n");
  EXPECT_EQ(messages(assembly), Texts{});
  EXPECT_EQ(write_i8080_symbols(assembly.symbols), "BUF FFFB\nEND1 000B\nLAST 000A\nNEXT 000B\n");
  EXPECT_EQ(assembly.image.count(), 6U);
  EXPECT_EQ(assembly.image[0xFFFA], 3);
  EXPECT_EQ(assembly.image[0xF000], 0x21);
  EXPECT_EQ(assembly.image[0xF001], 0x0B);
  EXPECT_EQ(assembly.image[0xF002], 0);
  const std::string listing = write_listing(assembly.listing);
  EXPECT_NE(listing.find("FFFB         BUF:\tDS 16\n"), std::string::npos) << listing;
  EXPECT_NE(listing.find("000B         NEXT:\tDS 0FFFFH\n"), std::string::npos) << listing;
  EXPECT_EQ(messages8080(" ORG 0FFFFH\n DS 2,5\n"), (Texts{"t.asm:2:1: error: found a byte past FFFF, expected a program within 64K"}));
}

TEST(I8080Language, Numbers) {
  EXPECT_EQ(bytes8080(" DB 10,10D,0AH,0ffh,17O,17Q,1010B,1010$0000b,0x3A,$3A,1$0"),
            (Bytes{10, 10, 10, 255, 15, 15, 10, 0xA0, 0x3A, 0x3A, 10}));
  EXPECT_EQ(bytes8080(" DW 65535,0FFFFH,0BH,0DH,1BH"), (Bytes{255, 255, 255, 255, 11, 0, 13, 0, 27, 0}));
}

// Values computed by Intel's precedence: HIGH LOW; * / MOD SHL SHR; + -; relations; NOT; AND; OR XOR.
TEST(I8080Language, Precedence) {
  const std::vector<std::pair<std::string, int>> cases{
      {"2+3*4", 14},          {"(2+3)*4", 20},
      {"-4/2", 0xFFFE},       {"2*-3", 0xFFFA},
      {"HIGH 1234H+1", 0x13}, {"LOW 1234H SHL 4", 0x340},
      {"1 SHL 4+1", 17},      {"7 MOD 4*2", 6},
      {"1+1 EQ 2", 0xFFFF},   {"NOT 1 EQ 2", 0xFFFF},
      {"NOT 0 AND 0FH", 15},  {"1 OR 2 AND 4", 1},
      {"5 XOR 1 OR 8", 12},   {"0FFFFH GT 1", 0xFFFF},
      {"-1 LT 1", 0},         {"3 GE 3", 0xFFFF},
      {"2 LE 1", 0},          {"1 NE 1", 0},
      {"1 SHL 16", 0},        {"8000H SHR 15", 1},
      {"200H*200H", 0},       {"'AB'", 0x4142},
      {"'A'+1", 0x42},        {"''", 0},
      {"''''", 0x27},         {"\"'\"", 0x27},
      {"65535+2", 1},         {"0-1", 0xFFFF},
      {"((((1))))", 1},       {"+5 - -5", 10},
      {"$", 0x100},           {"*+1", 0x101},
      {"(RET)", 0xC9},        {"(MOV A,B)", 0x78},
      {"(INX H)", 0x23},      {"JMP", 0xC3},
      {"NUL", 0xFFFF},        {"NUL X", 0},
  };
  for (const auto& [text, value] : cases) {
    EXPECT_EQ(bytes8080(" ORG 100H\n DW " + text),
              (Bytes{static_cast<std::uint8_t>(value & 255), static_cast<std::uint8_t>(value >> 8)}))
        << text;
  }
}

TEST(I8080Language, Data) {
  EXPECT_EQ(bytes8080(" DB 'it''s',0DH,\"a \"\"b\"\"\",-128,-1,255,''"),
            (Bytes{'i', 't', '\'', 's', 13, 'a', ' ', '"', 'b', '"', 0x80, 0xFF, 0xFF}));
  EXPECT_EQ(bytes8080(" DW 'AB',1,-2"), (Bytes{0x42, 0x41, 1, 0, 0xFE, 0xFF}));
  EXPECT_EQ(bytes8080(" DC 'abc'\n DC 'x','yz'"), (Bytes{'a', 'b', 'c' | 0x80, 'x' | 0x80, 'y', 'z' | 0x80}));
  EXPECT_EQ(bytes8080(" DB 1\n DS 2\n DB 2\n DS 2,0AAH\n DEFB 3\n DEFW 4\n DEFS 1\n DB 5"),
            (Bytes{1, 0, 0, 2, 0xAA, 0xAA, 3, 4, 0, 0, 5}));
  EXPECT_EQ(bytes8080(" ANI NOT 80H\n ORI NOT 0F0H AND 0FFH\n MVI A,-128"),
            (Bytes{0xE6, 0x7F, 0xF6, 0x0F, 0x3E, 0x80}));
  EXPECT_EQ(bytes8080("MASK EQU NOT 80H\n ANI (NOT 80H)\n ANI MASK\n ANI ((MASK))\n DB HIGH MASK\n"),
            (Bytes{0xE6, 0x7F, 0xE6, 0x7F, 0xE6, 0x7F, 0xFF}));
}

TEST(I8080Language, SpaceStaysUndefined) {
  const auto assembly = assemble8080(" ORG 10H\n DB 1\n DS 3\n DB 2\n DS 9\n");
  EXPECT_EQ(assembly.image.count(), 2U);
  EXPECT_TRUE(assembly.image.used(0x14));
  EXPECT_FALSE(assembly.image.used(0x12));
  EXPECT_EQ(assembly.image.highest(), 0x14);
}

TEST(I8080Language, LocationIsThatOfTheStatementOrItem) {
  EXPECT_EQ(bytes8080(" ORG 100H\n DB 0,LOW $,LOW $\n JMP $\n DW $,$"),
            (Bytes{0, 1, 2, 0xC3, 3, 1, 6, 1, 8, 1}));
}

TEST(I8080Language, LabelsAndStatements) {
  const Bytes expected{0xC3, 3, 0, 0, 0x76};
  for (const char* text : {" JMP LL\nLL: NOP\n HLT", " jmp ll\nLL NOP\n hlt", " JMP LL ! LL: NOP ! HLT",
                           " JMP LL\n\tLL:\n NOP\n HLT", " JMP LL\nLL:: NOP ; it's ! not done\n HLT",
                           "10 JMP LL\n20 LL: NOP\n30 HLT\n", " JMP LL\r\nLL : NOP\r\n HLT\r\n\x1A",
                           "* JMP 5\n$title('x')\n JMP LL\nl$l NOP\n HLT"}) {
    EXPECT_EQ(bytes8080(text), expected) << text;
  }
  EXPECT_EQ(bytes8080(" MVI A,'!' ! MVI B,';' ! RET"), (Bytes{0x3E, '!', 0x06, ';', 0xC9}));
  EXPECT_EQ(bytes8080("NOP\nRET"), (Bytes{0, 0xC9}));
  EXPECT_EQ(bytes8080("READ$BYTE: DB 1\n?X@._1: DB LOW READBYTE+1"), (Bytes{1, 1}));
}

TEST(I8080Language, LabelsMayHaveNamesOfDirectives) {
  EXPECT_EQ(bytes8080("PAGE EQU 100H\nWORD EQU 2\nENTRY: LXI H,PAGE\n DS WORD\n JMP ENTRY\n"),
            (Bytes{0x21, 0, 1, 0, 0, 0xC3, 0, 0}));
}

TEST(I8080Language, Symbols) {
  const auto assembly =
      assemble8080("A1 EQU B1+1\nB1 EQU C1+1\nC1 EQU LL\nS SET 1\n DB A1,S\nS SET S+1\n DB S\nLL: END LL");
  EXPECT_EQ(messages(assembly), Texts{});
  EXPECT_EQ(bytes_of(assembly), (Bytes{5, 1, 2}));
  EXPECT_EQ(assembly.value_of("a1"), 5);
  EXPECT_EQ(assembly.value_of("s"), 2);
  EXPECT_EQ(assembly.value_of("nobody"), std::nullopt);
  EXPECT_EQ(assembly.image.start, 3);
  EXPECT_EQ(write_i8080_symbols(assembly.symbols), "A1 0005\nB1 0004\nC1 0003\nLL 0003\nS 0002\n");
}

TEST(I8080Language, DefinesOverrideTheSource) {
  I8080Options options;
  options.defines = {{"Size", 3}};
  EXPECT_EQ(bytes_of(assemble8080("SIZE EQU 7\n DB SIZE\n IF SIZE EQ 3\n DB 1\n ENDIF", options)),
            (Bytes{3, 1}));
  for (const auto& [text, value] : std::vector<std::pair<std::string, int>>{
           {"A1=10", 10}, {"X=0FFH", 255}, {"X=0x10", 16}, {"X=-1", 0xFFFF}, {"X=101B", 5}}) {
    const auto define = parse_i8080_define(text);
    ASSERT_TRUE(define) << text;
    EXPECT_EQ(define->value, value) << text;
  }
  for (const char* wrong : {"", "=1", "X", "X=", "X=Y", "X=1 2", "X=70000", "X=12AB", "1X=2", "MOV=1", "A=1"})
    EXPECT_FALSE(parse_i8080_define(wrong)) << wrong;
}

TEST(I8080Language, Conditionals) {
  const std::string text =
      " IF X\n DB 1\n IF Y\n DB 2\n ELSE\n DB 3\n ENDIF\n ELSE\n DB 4\n IF Y\n DB 5\n ENDIF\n ENDIF\n DB 6\n";
  const auto with = [&](int x, int y) {
    return bytes8080("X EQU " + std::to_string(x) + "\nY EQU " + std::to_string(y) + "\n" + text);
  };
  EXPECT_EQ(with(1, 1), (Bytes{1, 2, 6}));
  EXPECT_EQ(with(1, 0), (Bytes{1, 3, 6}));
  EXPECT_EQ(with(0, 1), (Bytes{4, 5, 6}));
  EXPECT_EQ(with(0, 0), (Bytes{4, 6}));
  EXPECT_EQ(bytes8080("Z EQU 0\n IFE Z\n DB 1\n ENDIF\n IFDEF Z\n DB 2\n ENDIF\n IFNDEF Q\n DB 3\n ENDC\n "
                      "COND Z\n DB 4\n ENDC"),
            (Bytes{1, 2, 3}));
  EXPECT_EQ(bytes8080(" IF 0 ! what is this ' ( ! ENDIF ! DB 7"), Bytes{7});
}

// ASM and MAC: a name that is defined further down is 0 in the first pass and has its value in the second.
TEST(I8080Language, ConditionsMayReferForward) {
  EXPECT_EQ(bytes8080(" IF LATER\n DB 1\n ELSE\n DB 2\n ENDIF\nLATER EQU 1\n"), Bytes{1});
  EXPECT_EQ(bytes8080(" IF LATER\n DB 1\n ELSE\n DB 2\n ENDIF\nLATER EQU 0\n"), Bytes{2});
  EXPECT_EQ(bytes8080("X EQU Y\n IF X EQ 5\n DB 1\n ENDIF\nY EQU 5\n"), Bytes{1});
  EXPECT_EQ(bytes8080(" IF NOT X\nX EQU 0\n ENDIF\n DB X\n"), Bytes{0}) << "it is 0 where nothing else defines it";
  EXPECT_EQ(bytes8080(" JMP L\n IF SIZE EQ 2\n DS 2\n ENDIF\nL: NOP\nSIZE EQU 2\n"), (Bytes{0xC3, 5, 0, 0, 0, 0}))
      << "labels after it move";
  EXPECT_EQ(bytes8080(" IF $ - L\n NOP\n ENDIF\nL: RET\n"), (Bytes{0, 0xC9}));
  // What only the first pass defines is not defined.
  EXPECT_EQ(messages8080(" IF X\n ELSE\nY EQU 1\n ENDIF\nX EQU 1\n DB Y\n"),
            (Texts{"t.asm:6:5: error: found undefined symbol 'Y', expected one that is defined"}));
  EXPECT_EQ(bytes8080(" IF X\n ELSE\nY EQU 1\n ENDIF\n IFDEF Y\n DB 1\n ELSE\n DB 2\n ENDIF\nX EQU 1\n"), Bytes{2});
  // A condition that its own lines make untrue.
  EXPECT_FALSE(assemble8080(" IF X EQ 0\nX EQU 1\n ENDIF\n").ok());
  EXPECT_FALSE(assemble8080(" IF L EQ 1\n NOP\n ENDIF\n NOP\nL: RET\n").ok());
}

TEST(I8080Language, IncludedFiles) {
  I8080Options options;
  const Files files{{"sub/a.asm", " DB 2\n INCLUDE b.inc\n DB 4\n"},
                    {"sub/b.inc", " DB 3\n END\n garbage here\n"},
                    {"disk.lib", "TWICE MACRO X\n DB X,X\n ENDM\n"}};
  const std::string text = " MACLIB DISK\n DB 1\n INCLUDE 'sub/a.asm' ; here\n TWICE 5\n";
  const auto assembly = assemble8080(text, options, files);
  EXPECT_EQ(messages(assembly), Texts{});
  EXPECT_EQ(bytes_of(assembly), (Bytes{1, 2, 3, 4, 5, 5}));
}

TEST(I8080Language, SeveralSourcesAreOneProgram) {
  const std::vector<SourceFile> sources{{"a", " JMP FAR\n END\n rubbish"}, {"b", "FAR: RET\n END FAR"}};
  const auto assembly = assemble_i8080(sources);
  EXPECT_EQ(bytes_of(assembly), (Bytes{0xC3, 3, 0, 0xC9}));
  EXPECT_EQ(assembly.image.start, 3);
}

TEST(I8080Language, DirectivesWithoutEffect) {
  EXPECT_EQ(bytes8080(" NAME ('x')\n TITLE 'don''t!'\n PAGE 60\n ASEG\n CSEG\n DSEG\n PUBLIC X,Y\n .8080\n "
                      "CPU 8080\n .XLIST\n"
                      " EXTRN ELSEWHERE\nX: NOP"),
            Bytes{0});
}

// They are not reserved words in CP/M's ASM.
TEST(I8080Language, DirectivesWithoutEffectAreLabelsInColumn1) {
  const auto assembly = assemble8080(
      "ENTRY LXI H,1234H\nNAME DB 'FOO'\nPAGE DS 1\nTITLE DB 1\nglobal dw 2\n JMP NAME\n LDA TITLE");
  EXPECT_EQ(messages(assembly), Texts{});
  EXPECT_EQ(bytes_of(assembly), (Bytes{0x21, 0x34, 0x12, 'F', 'O', 'O', 0, 1, 2, 0, 0xC3, 3, 0, 0x3A, 7, 0}));
  EXPECT_EQ(assembly.value_of("page"), 6);
  EXPECT_EQ(bytes8080("PAGE\nTITLE 'x'\nNAME ('x')\nENTRY X\nX NOP"), Bytes{0});
}

TEST(I8080Language, AnIndentedTitleIsText) {
  for (const char* text :
       {" TITLE SET UP THE DISK", " SUBTTL MACRO LIBRARY", " TITLE EQU ATIONS", " TITLE DB 1"}) {
    const auto assembly = assemble8080(std::string(text) + "\n NOP");
    EXPECT_EQ(messages(assembly), Texts{}) << text;
    EXPECT_EQ(bytes_of(assembly), Bytes{0}) << text;
    EXPECT_TRUE(assembly.symbols.empty()) << text;
  }
}

TEST(I8080Language, ControlLinesOfTheListingAreSkipped) {
  EXPECT_EQ(bytes8080("$PRINT XREF TITLE('include')\n$ NOLIST ; include\n$-MACRO\n NOP"), Bytes{0});
  EXPECT_EQ(bytes8080(" IF 0\n$INCLUDE(x)\n ENDIF\n NOP"), Bytes{0});
}

TEST(I8080Language, EachStatementOfALineHasItsPlaceInTheListing) {
  const auto assembly = assemble8080("\n MVI A,1 ! MVI B,2\n DB 1,2,3,4,5\n");
  std::vector<std::pair<std::string, std::size_t>> places;
  for (const ListingLine& line : assembly.listing) places.emplace_back(line.code, line.line_number);
  EXPECT_EQ(places, (std::vector<std::pair<std::string, std::size_t>>{{"", 0}, {"3E01", 2}, {"0602", 2}, {"01020304", 3}, {"05", 0}}));
}

TEST(I8080Language, Listing) {
  const auto assembly =
      assemble8080("TEN EQU 10\n\tORG 100H\nLL:\tDB 1,2,3,4,5,TEN ; six\nM2\tMACRO\n\tNOP\n\tENDM\n\tM2\n");
  EXPECT_EQ(write_listing(assembly.listing),
            "000A =         TEN EQU 10\n"
            "0100           \tORG 100H\n"
            "0100 01020304  LL:\tDB 1,2,3,4,5,TEN ; six\n"
            "0104 050A\n"
            "               M2\tMACRO\n"
            "               \tNOP\n"
            "               \tENDM\n"
            "               \tM2\n"
            "0106 00        +\tNOP\n"
            "\n"
            "               0100 LL             000A TEN\n");
}

}  // namespace
}  // namespace sightline::assembler
