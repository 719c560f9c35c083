// The output of the assemblers of the time: MAC 2.0 of Digital Research ("CP/M MACRO ASSEM 2.0") and MACRO-80 3.44 of Microsoft
// (09-Dec-81), run as CP/M programs by this repository's 8080. Each row assembled there without an error; the bytes are those of
// its HEX or REL file (for MACRO-80 with a preceding ASEG). The programs themselves are not in the repository.
#include <gtest/gtest.h>

#include "tests/tools/asm/i8080/assemble.hpp"
#include "tools/asm/i8080/dialect.hpp"

namespace sightline::assembler {
namespace {

using enum I8080Dialect;

struct Made {
  const char* text;
  Bytes bytes;  // without gaps
};
struct Worth {
  const char* expression;
  std::uint16_t word;
};

void expect(I8080Dialect dialect, const std::string& text, const Bytes& expected) {
  I8080Options options;
  options.dialect = dialect;
  const auto assembly = assemble8080(" ORG 100H\n" + text, options);
  ASSERT_TRUE(assembly.ok()) << text << messages(assembly)[0];
  Bytes made;
  for (unsigned at = 0x100; at < 0x400; ++at)
    if (assembly.image.used(static_cast<std::uint16_t>(at))) made.push_back(assembly.image[static_cast<std::uint16_t>(at)]);
  EXPECT_EQ(made, expected) << i8080_dialect_names[static_cast<std::size_t>(dialect)] << "\n" << text;
}
void expect(I8080Dialect dialect, const Worth& row) {
  const std::string text = std::string("SYA EQU 5\nSYB EQU 0FFF0H\nSYC EQU 1234H\n DW ") + row.expression + "\n";
  expect(dialect, text, {static_cast<std::uint8_t>(row.word), static_cast<std::uint8_t>(row.word >> 8U)});
}

// clang-format off
const std::vector<Made> both{
    {" DW $,$,$+1\n", {0x00, 0x01, 0x02, 0x01, 0x05, 0x01}},
    {" DB 1,LOW $,LOW ($)\n", {0x01, 0x01, 0x02}},
    {" DB 1,$-100H,$-100H\n", {0x01, 0x01, 0x02}},
    {" DB 'AB',$-100H\n", {0x41, 0x42, 0x02}},
    {" DS 3\n DB $-100H\n", {0x03}},
    {" IF 3\n DB 1\n ELSE\n DB 2\n ENDIF\n", {0x01}},
    {" IF -1\n DB 1\n ENDIF\n", {0x01}},
    {" DB HIGH 0FFH+1\n", {0x01}},
    {" DB NOT 0FEH AND 0FFH\n", {0x01}},
    {" DW NOT 1 EQ 1\n", {0x00, 0x00}},
    {" DW 1 SHL 3+1, 100H SHR 2\n", {0x09, 0x00, 0x40, 0x00}},
    {" DB 17 MOD 5*2\n", {0x04}},
    {" DW -1*2, -5/2, 5-(-3)\n", {0xFE, 0xFF, 0xFE, 0xFF, 0x08, 0x00}},
    {" DW -4/2\n", {0xFE, 0xFF}},
    {" DW 1 LT 2, 2 LT 1, 1 EQ 1, -1 GT 1, -1 LT 1, 1 LE 1, 1 GE 2, 1 NE 1\n", {0xFF, 0xFF, 0x00, 0x00, 0xFF, 0xFF, 0xFF, 0xFF, 0x00, 0x00, 0xFF, 0xFF, 0x00, 0x00, 0x00, 0x00}},
    {" DW 1 OR 2 AND 4, 5 XOR 1 OR 2, NOT 0 XOR 0FH\n", {0x01, 0x00, 0x06, 0x00, 0xF0, 0xFF}},
    {" DB ''\n", {}},
    {" DB 10,10D,0AH,12Q,12O,1010B\n", {0x0A, 0x0A, 0x0A, 0x0A, 0x0A, 0x0A}},
    {"ABCDEFG: NOP\nABCDEFH: NOP\n JMP ABCDEFH\n", {0x00, 0x00, 0xC3, 0x01, 0x01}},
    {"M1 MACRO X\n DB '&X'\nL&X: NOP\n ENDM\n M1 AB\n", {0x41, 0x42, 0x00}},
    {"M1 MACRO X\n DB X\n ENDM\nV SET 3\n M1 %V+1\n", {0x04}},
    {"M1 MACRO X\n IF NUL X\n DB 1\n ELSE\n DB 2\n ENDIF\n ENDM\n M1\n M1 A\n M1 ''\n M1 <>\n", {0x01, 0x02, 0x02, 0x01}},
    {" IF NUL ''\n DB 1\n ELSE\n DB 2\n ENDIF\n", {0x02}},
    {" IRP X,<1,2,3>\n DB X\n ENDM\n", {0x01, 0x02, 0x03}},
    {" IRPC X,ABC\n DB '&X'\n ENDM\n", {0x41, 0x42, 0x43}},
    {" IRPC X,123\n DB X\n ENDM\n", {0x01, 0x02, 0x03}},
    {"N SET 0\n REPT 3\n DB N\nN SET N+1\n ENDM\n", {0x00, 0x01, 0x02}},
    {" REPT 3\n DB 1\n EXITM\n DB 2\n ENDM\n", {0x01}},
    {"M1 MACRO\n LOCAL L\nL: JMP L\n ENDM\n M1\n M1\n", {0xC3, 0x00, 0x01, 0xC3, 0x03, 0x01}},
    {"M1 MACRO X\nM2 MACRO Y\n DB X,Y\n ENDM\n ENDM\n M1 3\n M2 4\n", {0x03, 0x04}},
    {"M2 MACRO Y\n DB Y\n ENDM\nM1 MACRO X\n M2 X\n M2 <X,X>\n ENDM\n M1 5\n", {0x05, 0x05, 0x05}},
    {"M1 MACRO\n NOP ;; X\n ENDM\n M1\n", {0x00}},
    {" MVI A,(RET)\n DB NOP\n", {0x3E, 0xC9, 0x00}},
    {" MOV 7,0\n DB B,C,D,E,H,L,M,A,SP,PSW\n", {0x78, 0x00, 0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07, 0x06, 0x06}},
    {" PUSH B\n PUSH PSW\n LXI SP,1\n PUSH H\n", {0xC5, 0xF5, 0x31, 0x01, 0x00, 0xE5}},
    {"A1: NOP\n END A1\n", {0x00}},
    {"X SET 1\n DB X\nX SET 2\n DB X\n", {0x01, 0x02}},
    {"X EQU 1\nX EQU 1\n DB X\n", {0x01}},
    {" DW 65535,65536\n", {0xFF, 0xFF, 0x00, 0x00}},
    {" DS 0\n NOP\n", {0x00}},
    {" DW X\nX EQU 5\n", {0x05, 0x00}},
    {" IF 1\n IF 0\n DB 1\n ELSE\n DB 2\n ENDIF\n ELSE\n DB 3\n ENDIF\n", {0x02}},
    {" DB 1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20\n", {0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07, 0x08, 0x09, 0x0A, 0x0B, 0x0C, 0x0D, 0x0E, 0x0F, 0x10, 0x11, 0x12, 0x13, 0x14}},
    {"lab: mvi a,0ffh\n jmp LAB\n", {0x3E, 0xFF, 0xC3, 0x00, 0x01}},
    {"?AB: NOP\n@C: JMP ?AB\n", {0x00, 0xC3, 0x00, 0x01}},
    {" DB (1+2)*3,10-2-3,100/5/2\n", {0x09, 0x05, 0x0A}},
    {" DB HIGH (1234H),LOW(1234H)\n", {0x12, 0x34}},
    {" DB 1, 2 ,3\n", {0x01, 0x02, 0x03}},
    {" ORG 200H\n DB 1\n ORG 100H\n DB 2\n", {0x02, 0x01}},
    {"X EQU 1\n IF X EQ 1\n DB 1\n ENDIF\n", {0x01}},
    {" RST 7\n RST 0\n", {0xFF, 0xC7}},
    {" IN 5\n OUT 0FFH\n", {0xDB, 0x05, 0xD3, 0xFF}},
    {" DB 'A'+1,'B' OR 80H\n", {0x42, 0xC2}},
    {" DB ('A')\n", {0x41}},
    {" IF 'A' EQ 'A'\n DB 1\n ENDIF\n", {0x01}},
    {"M1 MACRO X\n DB 'X','&X'\n ENDM\n M1 Q\n", {0x58, 0x51}},
    {"M1 MACRO X\nA&X&B: DB 1\n ENDM\n M1 Z\n JMP AZB\n", {0x01, 0xC3, 0x00, 0x01}},
    {"M1 MACRO X\n DB '&&X'\n ENDM\n M1 Z\n", {0x26, 0x5A}},
    {"M1 MACRO X,Y\n DB X\n IF NOT NUL Y\n DB Y\n ENDIF\n ENDM\n M1 1\n M1 1,2\n M1 1,2,3\n", {0x01, 0x01, 0x02, 0x01, 0x02}},
    {"M1 MACRO X\n DB X\n ENDM\n M1 'A,B'\n", {0x41, 0x2C, 0x42}},
    {"M1 MACRO X\n IRP Y,<X>\n DB Y\n ENDM\n ENDM\n M1 <1,2,<3>>\n", {0x01, 0x02, 0x03}},
    {"M1 MACRO X\nX: NOP\n ENDM\n M1 FOO\n JMP FOO\n", {0x00, 0xC3, 0x00, 0x01}},
    {"M1 MACRO\n NOP\n ENDM\nLL: M1\n JMP LL\n", {0x00, 0xC3, 0x00, 0x01}},
    {"M1 MACRO N\n IF N GT 0\n DB N\n M1 %N-1\n ENDIF\n ENDM\n M1 3\n", {0x03, 0x02, 0x01}},
    {"M1 MACRO\n DB 1\nM1 MACRO\n DB 2\n ENDM\n ENDM\n M1\n M1\n M1\n", {0x01, 0x02, 0x02}},
    {" IRP X,<A,B>\n IRPC Y,12\n DB '&X&Y'\n ENDM\n ENDM\n", {0x41, 0x59, 0x41, 0x59, 0x42, 0x59, 0x42, 0x59}},
    {" IRP X,<>\n DB 1\n ENDM\n DB 2\n", {0x01, 0x02}},
    {" IRP X,<'AB',<1,2>>\n DB X\n ENDM\n", {0x41, 0x42, 0x01, 0x02}},
    {" REPT 0\n DB 1\n ENDM\n DB 2\n", {0x02}},
    {"M1 MACRO\n LOCAL A,B\nA: JMP B\nB: JMP A\n ENDM\n M1\n M1\n", {0xC3, 0x03, 0x01, 0xC3, 0x00, 0x01, 0xC3, 0x09, 0x01, 0xC3, 0x06, 0x01}},
    {"M1 MACRO X\n IF X\n EXITM\n ENDIF\n DB 9\n ENDM\n M1 1\n M1 0\n", {0x09}},
    {"V SET 0\nINC1 MACRO\nV SET V+1\n DB V\n ENDM\n INC1\n INC1\n", {0x01, 0x02}},
    {"M1 MACRO X\n DB X\n ENDM\n M1 1 ; hi\n M1 ';'\n", {0x01, 0x3B}},
    {"M1 MACRO X\n DB '&X'\n ENDM\n M1 %3+4\n M1 %65535\n M1 %-1\n", {0x37, 0x36, 0x35, 0x35, 0x33, 0x35, 0x36, 0x35, 0x35, 0x33, 0x35}},
    {" DB 'abc'\n", {0x61, 0x62, 0x63}},
    {" IF 0\n IF 1\n DB 1\n ENDIF\n ELSE\n DB 2\n ENDIF\n", {0x02}},
    {" IF 0\nM1 MACRO\n DB 1\n ENDM\n ENDIF\n DB 2\n", {0x02}},
    {" DB 1\n DS 2\n DB 2\n", {0x01, 0x02}},
    {" DB 1\n", {0x01}},
    {" PAGE 60\n TITLE 'hello'\n DB 1\n", {0x01}},
    {" DB 1;x\n", {0x01}},
    {" DB 0ffh,0Ah\n", {0xFF, 0x0A}},
    {" DB 0BH,10B,1BH,0DH,5D\n", {0x0B, 0x02, 0x1B, 0x0D, 0x05}},
    {" DW 65536,99999,0FFFFFH\n", {0x00, 0x00, 0x9F, 0x86, 0xFF, 0xFF}},
    {" MVI M,5\n MOV M,A\n MOV A,M\n INR M\n", {0x36, 0x05, 0x77, 0x7E, 0x34}},
    {"R EQU 3\n MOV R,A\n LXI R-1,5\n PUSH 6\n INR R+1\n", {0x5F, 0x11, 0x05, 0x00, 0xF5, 0x24}},
    {"RX EQU B\n MOV RX,C\n MVI RX,1\n", {0x41, 0x06, 0x01}},
    {" JMP $\n JMP $+3\n JMP $-3\n", {0xC3, 0x00, 0x01, 0xC3, 0x06, 0x01, 0xC3, 0x03, 0x01}},
    {" CZ 5\n RNZ\n CPO 1234H\n JPE 1\n RM\n", {0xCC, 0x05, 0x00, 0xC0, 0xE4, 0x34, 0x12, 0xEA, 0x01, 0x00, 0xF8}},
    {" LHLD 1234H\n SHLD 1\n LDA 2\n STA 3\n", {0x2A, 0x34, 0x12, 0x22, 0x01, 0x00, 0x3A, 0x02, 0x00, 0x32, 0x03, 0x00}},
    {"A1B2: NOP\n JMP A1B2\n", {0x00, 0xC3, 0x00, 0x01}},
    {" DB 'a\tb'\n", {0x61, 0x09, 0x62}},
    {" IF 1\nL1: ENDIF\n JMP L1\n", {0xC3, 0x00, 0x01}},
    {"M1 MACRO X\n IF NOT NUL X\n DB 1\n ENDIF\n IF NUL X AND 1\n DB 2\n ENDIF\n ENDM\n M1\n M1 3\n", {0x01}},
};

const std::vector<Made> mac_alone{
    {" NOP ; A ! RET\n", {0x00, 0xC9}},
    {" NOP ! RET! NOP\n", {0x00, 0xC9, 0x00}},
    {" IF 2\n DB 1\n ELSE\n DB 2\n ENDIF\n", {0x02}},
    {" IF 100H\n DB 1\n ELSE\n DB 2\n ENDIF\n", {0x02}},
    {" DB LOW 0FFH+1\n", {0x00}},
    {" DB LOW 180H/2\n", {0xC0}},
    {" DB HIGH 1234H AND 0FH\n", {0x00}},
    {" DB 'it''s',0DH\n DW 'AB','A'\n", {0x69, 0x74, 0x27, 0x73, 0x0D, 0x41, 0x42, 0x41, 0x00}},
    {" DW 'AB'\n", {0x41, 0x42}},
    {" MVI A,'A'\n LXI H,'AB'\n", {0x3E, 0x41, 0x21, 0x41, 0x42}},
    {" DW 1$000,0FF$00H,1010$1010B\n", {0xE8, 0x03, 0x00, 0xFF, 0xAA, 0x00}},
    {"A$B: NOP\n JMP AB\n", {0x00, 0xC3, 0x00, 0x01}},
    {"* hello\n NOP\n", {0x00}},
    {"LAB NOP\n JMP LAB\n", {0x00, 0xC3, 0x00, 0x01}},
    {" DW 'AB'-'A'\n", {0x00, 0x42}},
    {" DB LOW 'AB'\n", {0x41}},
    {"M1 MACRO X,Y\n DB X&Y\n ENDM\n M1 1,2\n", {0x0C}},
    {" IRPC X,\n DB 1\n ENDM\n DB 2\n", {0x01, 0x02}},
    {" IRP X,1\n DB X\n ENDM\n", {0x01}},
    {"M1 MACRO X\n DB '&X'\n ENDM\n M1 A^,B\n M1 A^^B\n", {0x41, 0x2C, 0x42, 0x41, 0x5E, 0x42}},
    {"M1 MACRO X\n DB '&X'\n ENDM\n M1 abc\n", {0x41, 0x42, 0x43}},
    {"A1 : DB 1\n", {0x01}},
    {"10 DB 1\n20 NOP\n", {0x01, 0x00}},
    {"100 A1: DB 1\n\n", {0x01}},
    {"M1 MACRO X\n IF NUL &X\n DB 1\n ENDIF\n ENDM\n M1\n M1 3\n", {0x01}},
    {"M2 MACRO Y\n DB '&Y'\n ENDM\nM1 MACRO X\n M2 A&X\n M2 ^X\n M2 X\n ENDM\n M1 Q\n", {0x41, 0x51, 0x58, 0x51}},
};

const std::vector<Made> m80_alone{
    {" NOP ; A ! RET\n", {0x00}},
    {" IF 2\n DB 1\n ELSE\n DB 2\n ENDIF\n", {0x01}},
    {" IF 100H\n DB 1\n ELSE\n DB 2\n ENDIF\n", {0x01}},
    {" DB LOW 180H/2\n", {0x40}},
    {" DB HIGH 1234H AND 0FH\n", {0x02}},
    {" DB 'it''s',0DH\n DW 'AB','A'\n", {0x69, 0x74, 0x27, 0x73, 0x0D, 0x42, 0x41, 0x41, 0x00}},
    {" DW 'AB'\n", {0x42, 0x41}},
    {" MVI A,'A'\n LXI H,'AB'\n", {0x3E, 0x41, 0x21, 0x42, 0x41}},
    {"M1 MACRO X\n DB X\n ENDM\n M1 'it''s'\n", {0x69, 0x74, 0x27, 0x73}},
    {" MVI A,RET\n MVI B,XRA A\n", {0x3E, 0xC9, 0x06, 0xAF}},
    {" LXI HL,1\n", {0x21, 0x01, 0x00}},
    {"DAA: NOP\n JMP DAA\n", {0x00, 0xC3, 0x00, 0x01}},
    {" DW 'AB'-'A'\n", {0x01, 0x41}},
    {" DB LOW 'AB'\n", {0x42}},
    {"M1 MACRO X\n DB X\n ENDM\n M1 1 + 2\n", {0x01}},
    {" IRPC X,A'B\n DB 1\n ENDM\n", {0x01, 0x01, 0x01}},
    {" IRPC X,\n DB 1\n ENDM\n DB 2\n", {0x02}},
    {"V SET 2\n IRP X,<%V+1,V>\n DB X\n ENDM\n", {0x03, 0x02}},
    {"M1 MACRO X\n DB '&X'\n ENDM\n M1 A^,B\n M1 A^^B\n", {0x41, 0x5E, 0x41, 0x5E, 0x5E, 0x42}},
    {"M1 MACRO X\n DB X\n ENDM\n M1 1 ! NOP\n M1 '!'\n", {0x01, 0x21}},
    {"M1 MACRO X\n DB X\n ENDM\n M1 <'!'>\n", {0x21}},
    {"M1 MACRO X\n DB '&X'\n ENDM\n M1 abc\n", {0x61, 0x62, 0x63}},
    {".A: NOP\n", {0x00}},
    {"A_B: NOP\n", {0x00}},
    {" IF 1\n DB 1\n", {0x01}},
    {" DB \"A\"\n", {0x41}},
};

const std::vector<Worth> mac_expressions{
    {"256 LT 07H", 0x0000}, {"0 LT 11B GE '0'", 0xFFFF}, {"0FFFFH XOR 255 GE 10Q*377Q", 0xFFFF}, {"7 LT 010H", 0xFFFF},
    {"07FFFH LE 'z'", 0x0000}, {"LOW 8 SHR 1B", 0x0004}, {"(3Q MOD SYC/0100H)*(LOW SYB)", 0x0000},
    {"SYB EQ +32768 EQ -8", 0x0000}, {"256 SHL 3Q", 0x0800}, {"77777Q AND -07FFFH", 0x0001},
    {"1000B LE 7+-77777Q XOR 1B", 0xFFFE}, {"SYC XOR 14Q", 0x1238}, {"377Q LE SYB", 0xFFFF}, {"04H GT 07B21H XOR +2", 0x0002},
    {"66177Q EQ (('z'))", 0x0000}, {"-0FFFFH GT 3", 0x0000}, {"32768 NE 154446Q*11B", 0xFFFF}, {"NOT 7Q NE 01H EQ 'z'", 0xFFFF},
    {"2Q AND 24195/7", 0x0000}, {"11111111B-7/177777Q LE 177777Q", 0xFFFF}, {"011H OR 11111111B", 0x00FF}, {"1 LT SYB", 0xFFFF},
    {"256 GE 7Q MOD SYB OR SYB", 0xFFFF}, {"HIGH SYC GE (HIGH 77777Q LE 0FFFFH)", 0x00FF}, {"2142Q-77777Q OR 11B", 0x8463},
    {"08000H LE 0100H GE 08000H", 0x0000}, {"(SYA) XOR (070C6H) OR 1000000000000000B", 0xF0C3},
    {"(177777Q OR  NOT 0BH)", 0xFFFF}, {"00H LT 0B", 0x0000}, {"SYB LE 15+77777Q", 0x0000},
    {"0B67CH AND  NOT 35631Q LE '0'", 0xB67C}, {"+05973H/111B GE 100000000B", 0xFFFF}, {"2+08000H*11B", 0x8002},
    {"SYC SHL 111B LT (-11B)", 0xFFFF}, {"('0' GE 177777Q)", 0x0000}, {"NOT 07FFFH OR 08000H", 0x8000},
    {"SYB XOR +2Q*011E7H NE 177777Q", 0x000F}, {"SYA AND 01H", 0x0001}, {"((+0100H EQ -SYB)-08H)", 0xFFF8},
    {"NOT 8 GE 177777Q", 0xFFFF}, {"SYA EQ -0100H GE SYC", 0x0000}, {"10Q MOD 'A' XOR 77777Q", 0x7FF7},
    {"11111111B SHL 3", 0x07F8}, {"'A' OR -11B", 0xFFFD}, {"0B OR 11111111B", 0x00FF}, {"1000B EQ 03H", 0x0000},
    {"(0Q NE 6Q) AND 0B NE 1Q", 0xFFFF}, {"0Q*011H", 0x0000}, {"HIGH '0' OR SYA", 0x0000}, {"SYC NE 0100H", 0xFFFF},
    {"08H MOD 1B*111111111111111B LE 141175Q", 0xFFFF}, {"SYC OR -11111111B", 0xFF35}, {"06H LT 32767", 0xFFFF},
    {"100000Q GE SYA", 0xFFFF}, {"4 LE 0F537H", 0xFFFF}, {"(10000B EQ -100000000B)", 0x0000}, {"(3) EQ 'A'", 0x0000},
    {"0B LE 32768", 0xFFFF}, {"11111111B XOR 111111111111111B XOR 0", 0x7F00}, {"111111111111111B/2", 0x3FFF},
    {"NOT 08000H AND ('A' LE 7 XOR 'A' AND SYB)", 0x0040}, {"1101B*1B", 0x000D}, {"HIGH 3Q NE '0'", 0x00FF},
    {"377Q NE 377Q EQ 14Q NE 1000000000000000B", 0xFFFF}, {"0FFH SHR 1B", 0x007F},
    {"177777Q-SYA OR 377Q EQ (07H XOR 11111111B GE 01H)", 0xFFFA}, {"NOT (0Q) AND 1", 0x0001},
    {"+SYC EQ 11B OR 1 MOD 377Q", 0x0001}, {"NOT 08000H NE -(SYB)-11111111B", 0x0000}, {"377Q/+11111111B", 0x0001},
};

const std::vector<Worth> m80_expressions{
    {"+1000B OR 1000B LE 3", 0x0008}, {"1110B NE 'z' SHL 11B", 0xFFFF}, {"400Q GT SYB", 0x0000}, {"08H AND (-0416DH)", 0x0000},
    {"177777Q/+77777Q MOD 'z'", 0x0000}, {"7 MOD -30363 AND 08000H", 0x8000}, {"1111111111111111B GT 7 NE 3 NE 1Q", 0xFFFF},
    {"NOT SYC GE 177777Q", 0xFFFF}, {"255/+1", 0x00FF}, {"0FFH EQ 111111111111111B/SYC OR +08H", 0x0008},
    {"(0B OR 10Q*08000H) LT 100000000B", 0xFFFF}, {"-(0FFH) OR 0FH+08000H GT 0B", 0xFFFF}, {"400Q GT -101B OR 10B", 0x0002},
    {"173662Q*'z' XOR 0FFFFH LT 65535", 0x0AD4}, {"HIGH 1 LT SYB", 0xFFFF}, {"14Q*1000B", 0x0060},
    {"+'z' MOD (77777Q)", 0x007A}, {"04H EQ 08H", 0x0000}, {"0B GE 111111111111111B", 0x0000},
    {"1000B+-SYB SHR 1000000000000000B", 0x0008}, {"01H SHR +SYB MOD 32767 GE 11B", 0x0000},
    {"HIGH 400Q SHR 10Q* LOW 07H XOR 0", 0x0000}, {"(1B GE (SYA LT 65535 GE 100000Q) AND 1000000000000000B)", 0x0000},
    {"0FFFFH MOD 100000000B LT 3", 0x0000}, {"11111111B LT SYB NE 023FDH", 0xFFFF}, {"07H+ HIGH 65535*0FFH", 0xFE08},
    {"SYB AND 07FFFH GT 01H", 0xFFF0}, {"11111111B GT  HIGH 08H MOD 100000000B SHL 177777Q", 0xFFFF},
    {"256 MOD 9 SHR +(010H)", 0x0000}, {"SYC MOD ('0')", 0x0004}, {"255 EQ 32767", 0x0000}, {"(2) XOR 0", 0x0002},
    {"7Q AND 1000000000000000B", 0x0000}, {"10B XOR 154573Q", 0xD979}, {"-SYB GT 177777Q SHL 11B", 0x0000},
    {"+3Q NE 1Q*100000Q XOR 07FFFH", 0x8000}, {"01H XOR  HIGH 3", 0x0001}, {"(08000H EQ 100000000B)", 0x0000},
    {"255 LT 03H", 0x0000}, {"(32768) MOD (NOT 400Q)*377Q AND +11B", 0x0003}, {"08DF0H EQ 169", 0x0000},
    {"SYC MOD 100000Q", 0xEDCC}, {"1101B*1000B GE 11111111B", 0x0000}, {"SYC LE SYB", 0xFFFF}, {"377Q*400Q", 0xFF00},
    {"177777Q SHR 7Q XOR 1", 0x01FE}, {"10B GT  HIGH 3Q", 0xFFFF}, {"+SYC GE SYA GT 07FFFH", 0xFFFF},
    {"SYA AND 177777Q", 0x0005}, {"LOW 7Q/8 LE 100000000B GE 54232Q", 0xFFFF}, {"111B LE 04BD1H", 0xFFFF},
    {"(LOW 0FFH+ HIGH 07H)/+SYA/07FFFH EQ 02H", 0x0000}, {"111111111111111B XOR 08000H*01H LT 256", 0x7FFF},
    {"100000000B EQ 100000Q GE (0Q)", 0xFFFF}, {"+(1Q GE 377Q)", 0x0000},
    {"'z' OR ((65535 LE SYC LT 3 MOD 08F1H)*SYA) SHR 256", 0x007A}, {"-256 NE 0 NE 1B", 0xFFFF}, {"SYC EQ 0Q", 0x0000},
    {"0100H GT 0FFH", 0xFFFF}, {"((03H-11B)) GE (07H)", 0x0000}, {"('z') XOR 0100H", 0x017A}, {"NOT 13Q SHR 111B", 0xFFFF},
    {"1100B OR 3", 0x000F}, {"111B OR 65535", 0xFFFF}, {"((+8) LE 10B AND 'z' GE 1011B)+10Q", 0x0008},
    {"(HIGH 01H AND 177777Q) SHR 77777Q EQ 08000H", 0x0000}, {"07H GT 10Q", 0x0000}, {"00H AND 03H", 0x0000},
    {"4 GT 8", 0x0000}, {"1 SHL 2", 0x0004},
};
// clang-format on

TEST(I8080Originals, BytesOfMac) {
  for (const Made& row : both) expect(mac, row.text, row.bytes);
  for (const Made& row : mac_alone) expect(mac, row.text, row.bytes);
}

TEST(I8080Originals, BytesOfMacro80) {
  for (const Made& row : both) expect(m80, row.text, row.bytes);
  for (const Made& row : m80_alone) expect(m80, row.text, row.bytes);
}

TEST(I8080Originals, ExpressionsOfMac) {
  for (const Worth& row : mac_expressions) expect(mac, row);
}

TEST(I8080Originals, ExpressionsOfMacro80) {
  for (const Worth& row : m80_expressions) expect(m80, row);
}

}  // namespace
}  // namespace sightline::assembler
