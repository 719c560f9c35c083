// 8080 bytes disassembled and assembled again.
#include "tools/disasm/i8080.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <string>

#include "tools/asm/i8080.hpp"

namespace sightline::disassembler {
namespace {

image::ByteImage again(const image::ByteImage& image) {
  const std::vector<assembler::SourceFile> sources{{"disassembly", disassemble_i8080(image)}};
  assembler::I8080Options options;
  options.listing = false;
  const auto assembly = assembler::assemble_i8080(sources, options);
  for (const auto& diagnostic : assembly.diagnostics) ADD_FAILURE() << to_string(diagnostic);
  return assembly.image;
}

TEST(DisassembleI8080, EveryOpcodeWithSeveralOperandsComesBack) {
  for (unsigned opcode = 0; opcode < 256; ++opcode) {
    image::ByteImage image;
    std::uint16_t at = 0x0100;
    for (const unsigned operand : {0x00U, 0x09U, 0x7FU, 0x80U, 0xA0U, 0xFFU}) {
      for (const unsigned byte : {opcode, operand, operand ^ 0x5AU})
        image.put(at++, static_cast<std::uint8_t>(byte));
      for (int i = 0; i < 3; ++i)
        image.put(at++, 0);  // an instruction begins after these, whatever precedes them
    }
    EXPECT_EQ(again(image), image) << opcode;
  }
}

TEST(DisassembleI8080, AllOfMemoryComesBack) {
  std::mt19937 random(8080);
  image::ByteImage image;
  for (std::uint32_t i = 0; i < image::byte_memory_size; ++i)
    image.put(static_cast<std::uint16_t>(i), static_cast<std::uint8_t>(random()));
  image.start = 0x1234;
  EXPECT_EQ(again(image), image);
}

TEST(DisassembleI8080, ScatteredBytesComeBack) {
  std::mt19937 random(1985);
  image::ByteImage image;
  for (int i = 0; i < 20000; ++i)
    image.put(static_cast<std::uint16_t>(random()), static_cast<std::uint8_t>(random()));
  EXPECT_EQ(again(image), image);
}

// Skala's monitor with all its files, read in each dialect; tests/tools/asm/i8080/dialect_test.cpp has the generated programs.
TEST(DisassembleI8080, FirmwareComesBackInEachDialect) {
  const std::filesystem::path folder = std::filesystem::path(SIGHTLINE_SOURCE_DIR) / "firmware/i8080/skala";
  const auto text_of = [&folder](const std::string& name) -> std::optional<std::string> {
    std::ifstream file(folder / name);
    if (!file) return std::nullopt;
    return std::string{std::istreambuf_iterator<char>(file), {}};
  };
  assembler::I8080Options options;
  options.include = text_of;
  const std::vector<assembler::SourceFile> sources{{"skala.asm", *text_of("skala.asm")}};
  const auto firmware = assembler::assemble_i8080(sources, options);
  ASSERT_TRUE(firmware.ok()) << to_string(firmware.diagnostics.front());
  ASSERT_GT(firmware.image.count(), 1000U);
  const std::vector<assembler::SourceFile> disassembly{{"again", disassemble_i8080(firmware.image)}};
  for (const auto dialect : {assembler::I8080Dialect::common, assembler::I8080Dialect::mac, assembler::I8080Dialect::m80,
                             assembler::I8080Dialect::intel}) {
    assembler::I8080Options again;
    again.dialect = dialect;
    const auto assembly = assembler::assemble_i8080(disassembly, again);
    EXPECT_TRUE(assembly.diagnostics.empty()) << to_string(assembly.diagnostics.front());
    EXPECT_EQ(assembly.image, firmware.image);
  }
}

TEST(DisassembleI8080, Text) {
  const auto text = [](std::uint8_t a, std::uint8_t b, std::uint8_t c) {
    return disassemble_i8080_instruction({a, b, c}).text;
  };
  EXPECT_EQ(text(0x00, 0, 0), "NOP");
  EXPECT_EQ(text(0x3E, 0x41, 0), "MVI     A,41H");
  EXPECT_EQ(text(0x21, 0xCD, 0xAB), "LXI     H,0ABCDH");
  EXPECT_EQ(text(0xF5, 0, 0), "PUSH    PSW");
  EXPECT_EQ(text(0x31, 0, 1), "LXI     SP,0100H");
  EXPECT_EQ(text(0x70, 0, 0), "MOV     M,B");
  EXPECT_EQ(text(0xFF, 0, 0), "RST     7");
  EXPECT_EQ(text(0xDD, 0x34, 0x12), "CALL    1234H");
  EXPECT_EQ(disassemble_i8080_instruction({0xCB, 0, 0}).bytes, 3);
  EXPECT_TRUE(disassemble_i8080_instruction({0xCB, 0, 0}).duplicate);
  EXPECT_FALSE(disassemble_i8080_instruction({0xC3, 0, 0}).duplicate);
}

TEST(DisassembleI8080, WholeSource) {
  image::ByteImage image;
  std::uint16_t at = 0x0100;
  for (const unsigned byte : {0x3EU, 0xFFU, 0xCBU, 0x00U, 0x01U, 0xC3U, 0x00U})
    image.put(at++, static_cast<std::uint8_t>(byte));
  image.put(0xF000, 0xC9);
  image.start = 0x0100;
  EXPECT_EQ(disassemble_i8080(image),
            "        ORG     0100H\n"
            "        MVI     A,0FFH          ; 0100 3E FF\n"
            "        DB      0CBH,00H,01H    ; 0102 CB 00 01  acts as JMP     0100H\n"
            "        DB      0C3H,00H        ; 0105 C3 00  part of an instruction\n"
            "        ORG     0F000H\n"
            "        RET                     ; F000 C9\n"
            "        END     0100H\n");
}

}  // namespace
}  // namespace sightline::disassembler
