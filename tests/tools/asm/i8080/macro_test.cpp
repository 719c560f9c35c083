// Macros and repeats of the 8080 assembler.
#include <gtest/gtest.h>

#include "tests/tools/asm/i8080/assemble.hpp"

namespace sightline::assembler {
namespace {

TEST(I8080Macro, ParametersStandForTheirTexts) {
  EXPECT_EQ(bytes8080("LOAD MACRO R,V\n MVI R,V\n ENDM\n LOAD A,1\n load b , 2 \n LOAD C,(3+4)*2\n"),
            (Bytes{0x3E, 1, 0x06, 2, 0x0E, 14}));
  EXPECT_EQ(bytes8080("P MACRO X,Y\n DB X\n IF NOT NUL Y\n DB Y\n ENDIF\n ENDM\n P 1\n P 2,3\n P 4,\n"),
            (Bytes{1, 2, 3, 4}));
}

TEST(I8080Macro, WholeNamesOnlyAndNotInStringsOrComments) {
  EXPECT_EQ(bytes8080("P MACRO X\nXY SET 9\n DB X,XY,'X' ; X\n DB 0FH\n ENDM\n P 5"), (Bytes{5, 9, 'X', 15}));
}

TEST(I8080Macro, Concatenation) {
  EXPECT_EQ(bytes8080("P MACRO X,N\nL&X&N: DB '&X','a&N&b'\n DB LOW L&X&N\n ENDM\n P QQ,7\n DB LOW LQQ7"),
            (Bytes{'Q', 'Q', 'a', '7', 'b', 0, 0}));
  EXPECT_EQ(bytes8080("P MACRO C\n J&C $\n ENDM\n P NZ\n P MP"), (Bytes{0xC2, 0, 0, 0xC3, 3, 0}));
}

TEST(I8080Macro, BracketsEscapesAndValues) {
  EXPECT_EQ(bytes8080("P MACRO L\n DB L\n ENDM\n P <1,2,3>\n P <'a,b'>\n P 'c,d'\n P 6^,7\n"),
            (Bytes{1, 2, 3, 'a', ',', 'b', 'c', ',', 'd', 6, 7}));
  EXPECT_EQ(bytes8080("P MACRO N\n DB '&N'\n ENDM\nV SET 3\n P %V*4\n P V*4"),
            (Bytes{'1', '2', 'V', '*', '4'}));
  EXPECT_EQ(bytes8080("P MACRO S\n S\n ENDM\n P <MVI A,1 ! RET>\n"), (Bytes{0x3E, 1, 0xC9}));
  EXPECT_EQ(bytes8080("IN1 MACRO X\n DB X\n ENDM\nOUT1 MACRO Y\n IN1 <Y>\n ENDM\n OUT1 <1,2>"),
            (Bytes{1, 2}));
}

TEST(I8080Macro, LocalNamesDifferInEveryCall) {
  const auto assembly =
      assemble8080("W MACRO\n LOCAL LL,EE\nLL: DCR A\n JZ EE\n JMP LL\nEE:\n ENDM\n W\n W\n");
  EXPECT_EQ(messages(assembly), Texts{});
  EXPECT_EQ(bytes_of(assembly), (Bytes{0x3D, 0xCA, 7, 0, 0xC3, 0, 0, 0x3D, 0xCA, 14, 0, 0xC3, 7, 0}));
}

TEST(I8080Macro, Repeats) {
  EXPECT_EQ(bytes8080("N SET 0\n REPT 3\n DB N\nN SET N+1\n ENDM\n REPT 0\n DB 99\n ENDM\n"),
            (Bytes{0, 1, 2}));
  EXPECT_EQ(bytes8080(" IRP X,<1,<2,3>,'a,b'>\n DB X\n ENDM\n"), (Bytes{1, 2, 3, 'a', ',', 'b'}));
  EXPECT_EQ(bytes8080(" IRP R,<B,C,A>\n MOV M,R\n ENDM\n"), (Bytes{0x70, 0x71, 0x77}));
  EXPECT_EQ(bytes8080(" IRPC X,1A9\n DB '&X'\n ENDM\n"), (Bytes{'1', 'A', '9'}));
  EXPECT_EQ(bytes8080(" IRP X,<>\n DB 1\n ENDM\n"), Bytes{1});
  EXPECT_EQ(bytes8080(" REPT 2\n IRPC X,12\n DB X\n ENDM\n DB 0\n ENDM\n"), (Bytes{1, 2, 0, 1, 2, 0}));
  EXPECT_EQ(bytes8080(" REPT 2\n LOCAL LL\nLL: JMP LL\n ENDM\n"), (Bytes{0xC3, 0, 0, 0xC3, 3, 0}));
}

TEST(I8080Macro, DefinitionsInsideDefinitions) {
  EXPECT_EQ(bytes8080("MAKE MACRO NAME1,V\nNAME1 MACRO X\n DB V,X\n ENDM\n ENDM\n MAKE ONE,1\n MAKE TWO,2\n "
                      "ONE 8\n TWO 9\n"),
            (Bytes{1, 8, 2, 9}));
  EXPECT_EQ(bytes8080("P MACRO\n DB 1\nP MACRO\n DB 2\n ENDM\n ENDM\n P\n P\n"), (Bytes{1, 2}));
}

TEST(I8080Macro, RecursionAndExit) {
  EXPECT_EQ(
      bytes8080("DOWN MACRO N\n IF N EQ 0\n EXITM\n ENDIF\n DB N\n DOWN %N-1\n ENDM\n DOWN 3\n DB 0FFH"),
      (Bytes{3, 2, 1, 255}));
  EXPECT_EQ(bytes8080("N SET 0\n REPT 10\n IF N EQ 2\n EXITM\n ELSE\n DB N\n ENDIF\nN SET N+1\n ENDM\n DB 9"),
            (Bytes{0, 1, 9}));
}

TEST(I8080Macro, ComparisonsOfArguments) {
  EXPECT_EQ(
      bytes8080(
          "P MACRO X,Y\n IFB <X>\n DB 0\n EXITM\n ENDIF\n IFIDN <X>,<HL>\n DB 1\n ENDIF\n IFDIF <X>,<HL>\n "
          "DB 2\n "
          "ENDIF\n IFNB <Y>\n DB 3\n ENDIF\n IF '&X' EQ 'HL'\n DB 4\n ENDIF\n ENDM\n P\n P HL\n P DE,1\n"),
      (Bytes{0, 1, 4, 2, 3}));
}

TEST(I8080Macro, WhatFollowsACallOnItsLineComesAfterIt) {
  EXPECT_EQ(bytes8080("P MACRO\n DB 1 ! DB 2\n ENDM\n DB 0 ! P ! DB 3 ! P\n"), (Bytes{0, 1, 2, 3, 1, 2}));
  EXPECT_EQ(bytes8080("P MACRO ! DB 5 ! ENDM ! P ! P"), (Bytes{5, 5}));
}

TEST(I8080Macro, PrivateCommentsAreNotExpanded) {
  const auto assembly = assemble8080("P MACRO\n NOP ;; private\n RET ; public\n ENDM\n P\n");
  const std::string listing = write_listing(assembly.listing);
  EXPECT_EQ(listing.find("+ NOP ;;"), std::string::npos) << listing;
  EXPECT_NE(listing.find("+ RET ; public"), std::string::npos) << listing;
}

TEST(I8080Macro, ThousandsOfLines) {
  std::string text = "M1 MACRO R,V\n LOCAL LL\nLL: MVI R,V\n JMP LL\n ENDM\n ORG 100H\n";
  for (int i = 0; i < 5000; ++i) {
    text += "L" + std::to_string(i) + ": LXI H,L" + std::to_string(i * 7 % 5000) + " ! MOV A,M ; fetch\n";
    if (i % 10 == 0) text += " M1 A,'x'\n";
  }
  const auto assembly = assemble8080(text);
  EXPECT_TRUE(assembly.ok());
  EXPECT_EQ(assembly.image.count(), 5000U * 4 + 500 * 5);
}

}  // namespace
}  // namespace sightline::assembler
