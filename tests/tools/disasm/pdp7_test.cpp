// Every word of 18 bits disassembled and assembled again.
#include "tools/asm/pdp7.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "tests/support/effort.hpp"
#include "tools/disasm/disasm.hpp"

namespace sightline::disassembler {
namespace {

using core::Word18;

assembler::Assembly assemble(std::string text) {
  const std::vector<assembler::SourceFile> sources{{"disassembly", std::move(text)}};
  return assembler::assemble_pdp7(sources);
}

std::string at_100(std::uint32_t word) {
  return disassemble_word(Word18(word), 0100);
}

// Whole sources of 32K words at a time.
TEST(DisassemblePdp7, EveryWordComesBack) {
  for (std::uint32_t block = 0; block < 8; block += tests::effort(1U, 3U)) {
    image::CoreImage image;
    for (std::uint32_t i = 0; i <= image::last_address; ++i) image.words[i] = Word18(block << 15 | i);
    image.start = block;
    const assembler::Assembly assembly = assemble(disassemble_pdp7(image));
    ASSERT_TRUE(assembly.diagnostics.empty()) << assembler::to_string(assembly.diagnostics.front());
    ASSERT_EQ(assembly.image, image);
  }
}

TEST(DisassemblePdp7, AtMostAFifthStayOctal) {
  int octal = 0;
  for (std::uint32_t word = 0; word <= Word18::mask; ++word)
    octal += std::isdigit(at_100(word)[0]) != 0 ? 1 : 0;
  EXPECT_LE(octal, 0777777 / 5);
  EXPECT_GT(octal, 0);
}

TEST(DisassemblePdp7, UsesTheNamesOfTheInstructionTable) {
  EXPECT_EQ(at_100(0200123), "lac 123");
  EXPECT_EQ(at_100(0620017), "jmp i 17");
  EXPECT_EQ(at_100(0), "cal");
  EXPECT_EQ(at_100(0020005), "cal i 5");
  EXPECT_EQ(at_100(0760005), "law 5");
  EXPECT_EQ(at_100(0777777), "lam");
  EXPECT_EQ(at_100(0740000), "nop");
  EXPECT_EQ(at_100(0740040), "hlt");
  EXPECT_EQ(at_100(0751100), "spa cla");
  EXPECT_EQ(at_100(0741300), "sna spa");
  EXPECT_EQ(at_100(0740300), "sza sma");
  EXPECT_EQ(at_100(0754010), "cla rcl");
  EXPECT_EQ(at_100(0740030), "740030");  // both rotates
  EXPECT_EQ(at_100(0742000), "742000");  // rotate twice, without a rotate
  EXPECT_EQ(at_100(0653122), "mul");
  EXPECT_EQ(at_100(0653111), "mul-11");
  EXPECT_EQ(at_100(0640450), "norm+4");
  EXPECT_EQ(at_100(0640505), "lrs 5");
  EXPECT_EQ(at_100(0660622), "llss 22");
  EXPECT_EQ(at_100(0640200), "640200");
  EXPECT_EQ(at_100(0700606), "idla");
  EXPECT_EQ(at_100(0701777), "701777");
  EXPECT_EQ(disassemble_word(Word18(0200123), 040000), "lac 40123");
}

TEST(DisassemblePdp7, SourceHasOriginsAndComments) {
  const image::CoreImage image{{{0100, Word18(0750000)}, {0101, Word18(0600100)}, {0200, Word18(7)}}, 0100};
  EXPECT_EQ(disassemble_pdp7(image),
            "00100/\n"
            "        cla              / 00100 750000\n"
            "        jmp 100          / 00101 600100\n"
            "00200/\n"
            "        cal 7            / 00200 000007\n"
            "        start 00100\n");
  EXPECT_EQ(disassemble_pdp7({}), "");
}

// --- The dialect of Bell Laboratories ---

assembler::Assembly assemble_bell(std::string text) {
  assembler::Options options;
  options.dialect = assembler::Dialect::bell;
  const std::vector<assembler::SourceFile> sources{{"disassembly", std::move(text)}};
  return assembler::assemble_pdp7(sources, options);
}

// 8K words at a time, the limit of the dialect.
TEST(DisassemblePdp7Bell, EveryWordComesBack) {
  for (std::uint32_t block = 0; block < 32; block += tests::effort(1U, 9U)) {
    image::CoreImage image;
    for (std::uint32_t i = 0; i <= image::field_mask; ++i) image.words[i] = Word18(block << 13 | i);
    const auto source = disassemble_pdp7_bell(image);
    ASSERT_TRUE(source) << source.error().message();
    const assembler::Assembly assembly = assemble_bell(*source);
    ASSERT_TRUE(assembly.diagnostics.empty()) << assembler::to_string(assembly.diagnostics.front());
    ASSERT_EQ(assembly.image.words, image.words);
  }
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

// The Jones program with both multiplications, and every example: from DEC's language to that of Bell Laboratories and back.
TEST(DisassemblePdp7Bell, FirmwareAndExamplesComeBack) {
  namespace fs = std::filesystem;
  const fs::path root = SIGHTLINE_SOURCE_DIR;
  std::map<std::string, std::vector<assembler::SourceFile>> programs;
  for (const std::string folder : {"firmware/pdp7/jones", "host/examples/pdp7", "host/examples/type340"}) {
    for (const auto& entry : fs::directory_iterator(root / folder)) {
      if (entry.path().extension() != ".s") continue;
      const std::string name = folder.starts_with("firmware") ? folder : entry.path().string();
      programs[name].push_back({entry.path().string(), text_of(entry.path())});
    }
  }
  auto& jones = programs["firmware/pdp7/jones"];
  ASSERT_EQ(jones.size(), 9U);
  std::sort(jones.begin(), jones.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  jones.push_back({"scene", "scene, 0\n"});
  ASSERT_GE(programs.size(), 10U);
  for (const auto& [name, sources] : programs) {
    for (const std::uint32_t eae : {0U, 1U}) {
      assembler::Options options;
      options.defines = {{"EAE", eae}};
      const auto assembled = assembler::assemble_pdp7(sources, options);
      ASSERT_TRUE(assembled.ok()) << name << assembler::to_string(assembled.diagnostics.front());
      const auto source = disassemble_pdp7_bell(assembled.image);
      ASSERT_TRUE(source) << name << source.error().message();
      const auto again = assemble_bell(*source);
      EXPECT_TRUE(again.diagnostics.empty()) << name;
      EXPECT_EQ(again.image.words, assembled.image.words) << name;
      const std::vector<assembler::SourceFile> dec{{"again", disassemble_pdp7(assembled.image)}};
      const auto in_dec = assembler::assemble_pdp7(dec, {});
      EXPECT_TRUE(in_dec.diagnostics.empty()) << name;
      EXPECT_EQ(in_dec.image.words, assembled.image.words) << name;
    }
  }
}

// Programs as they are in core: scattered runs of words, with or without a start address.
TEST(DisassemblePdp7, GeneratedProgramsComeBackInBothDialects) {
  std::mt19937 random(1970);
  const auto below = [&random](std::uint32_t limit) { return static_cast<std::uint32_t>(random() % limit); };
  for (int program = 0; program < tests::effort(1000, 200); ++program) {
    image::CoreImage image;
    for (std::uint32_t run = 1 + below(4); run > 0; --run) {
      std::uint32_t at = below(017700);
      for (std::uint32_t n = 1 + below(30); n > 0; --n) image.words[at++] = Word18(below(01000000));
    }
    if (below(2) == 0) image.start = below(020000);
    const std::vector<assembler::SourceFile> dec{{"again", disassemble_pdp7(image)}};
    const auto in_dec = assembler::assemble_pdp7(dec, {});
    ASSERT_TRUE(in_dec.diagnostics.empty()) << assembler::to_string(in_dec.diagnostics.front());
    ASSERT_EQ(in_dec.image, image) << program;
    const auto source = disassemble_pdp7_bell(image);
    ASSERT_TRUE(source) << source.error().message();
    const auto in_bell = assemble_bell(*source);
    ASSERT_TRUE(in_bell.diagnostics.empty()) << assembler::to_string(in_bell.diagnostics.front());
    ASSERT_EQ(in_bell.image.words, image.words) << program;
  }
}

TEST(DisassemblePdp7Bell, WritesItsNumbersAndComments) {
  const image::CoreImage image{{{0, Word18(0200010)}, {0100, Word18(0653111)}, {0101, Word18(0740030)}}, 0100};
  const auto source = disassemble_pdp7_bell(image);
  ASSERT_TRUE(source);
  EXPECT_EQ(*source,
            ".. = 0\n"
            "   lac 010               \" 00000 200010\n"
            ". = 000100\n"
            "   mul-011               \" 00100 653111\n"
            "   0740030               \" 00101 740030\n"
            "\" start 00100\n");
}

TEST(DisassemblePdp7Bell, RefusesWhatTheDialectCannotAddress) {
  const auto source = disassemble_pdp7_bell({{{017777, Word18(0)}, {020000, Word18(0)}}, {}});
  ASSERT_FALSE(source);
  EXPECT_EQ(source.error().found, "a word at 20000");
}

}  // namespace
}  // namespace sightline::disassembler
