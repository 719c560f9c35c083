// Display files as text: a worked file with the word formats of the time, and round trips of random words.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tools/asm/pdp7.hpp"
#include "tools/disasm/disasm.hpp"

namespace sightline::disassembler {
namespace {

using core::Word18;

image::CoreImage file_of(std::vector<std::uint32_t> words, std::uint32_t address = 0) {
  image::CoreImage image;
  for (const std::uint32_t word : words) image.words[address++] = Word18(word);
  return image;
}

TEST(DisassembleType340, AWorkedFileAndModeZeroAfterItsStop) {
  EXPECT_EQ(disassemble_type340(file_of(
                {0020117, 0220400, 0100400, 0200144, 0236000, 0600344, 0003000, 0140000, 0764043, 0370000})),
            "00000/\n"
            "        020117           / 00000 parameter, scale 0 (x1), intensity 7, then point\n"
            "        220400           / 00001 point, y 400, dark, then point\n"
            "        100400           / 00002 point, x 400, dark, then vector\n"
            "        200144           / 00003 vector, dx +144 dy +0, lit\n"
            "        236000           / 00004 vector, dx +0 dy +74, lit\n"
            "        600344           / 00005 vector, dx -144 dy +0, lit, then parameter\n"
            "        003000           / 00006 parameter, stop and interrupt\n"
            "        140000           / 00007 parameter, then increment\n"
            "        764043           / 00010 increment, up-left right up down, lit, then parameter\n"
            "        370000           / 00011 parameter, pen off, then subroutine\n");
}

TEST(DisassembleType340, TheOtherModes) {
  EXPECT_EQ(disassemble_type340(file_of({0060000, 0010240, 0333437, 0174000, 0560004, 0705312, 0600001,
                                         0120000, 0310010, 0040000, 0000750, 0002000})),
            "00000/\n"
            "        060000           / 00000 parameter, then character\n"
            "        010240           / 00001 character, A B space\n"
            "        333437           / 00002 character, LF CR escape, then parameter\n"
            "        174000           / 00003 parameter, pen on, then subroutine\n"
            "        560004           / 00004 subroutine, DJP jump to 00004, then subroutine\n"
            "        705312           / 00005 subroutine, DJS jump and save to 05312, then vector\n"
            "        600001           / 00006 vector, dx +1 dy +0, lit, then parameter\n"
            "        120000           / 00007 parameter, then vector continue\n"
            "        310010           / 00010 vector continue, dx +10 dy -20, lit\n"
            "        040000           / 00011 parameter, then slave\n"
            "        000750           / 00012 slave, unit 2 on with pen, unit 3 on, then parameter\n"
            "        002000           / 00013 parameter, stop\n");
}

TEST(DisassembleType340, AnyWordsComeBack) {
  std::mt19937 random(340);
  image::CoreImage image;
  for (std::uint32_t address = 0; address < 020000; ++address) {
    if (random() % 50 != 0) image.words[address] = Word18(static_cast<std::uint32_t>(random()));
  }
  const std::vector<assembler::SourceFile> sources{{"display file", disassemble_type340(image)}};
  const assembler::Assembly assembly = assembler::assemble_pdp7(sources);
  ASSERT_TRUE(assembly.diagnostics.empty()) << assembler::to_string(assembly.diagnostics.front());
  EXPECT_EQ(assembly.image, image);
}

}  // namespace
}  // namespace sightline::disassembler
