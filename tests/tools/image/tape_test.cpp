// RIM and HRI tapes, line by line, and the messages about damaged ones.
#include "tools/image/tape.hpp"

#include <gtest/gtest.h>

#include <string>

namespace sightline::image {
namespace {

using core::Word18;

// DAC 100, 123456, JMP 100, three lines per word.
const Tape rim_lines{0204, 0201, 0200, 0212, 0234, 0256, 0260, 0201, 0200};
// 123456 and 000001, then JMP 100 with hole 7.
const Tape hri_lines{0212, 0234, 0256, 0200, 0200, 0201, 0260, 0201, 0300};

Tape without_feed(const Tape& tape) {
  Tape lines;
  for (const std::uint8_t line : tape) {
    if (line != 0) lines.push_back(line);
  }
  return lines;
}

Tape with(Tape tape, std::size_t at, std::uint8_t line) {
  tape.at(at) = line;
  return tape;
}

Tape first_lines(const Tape& tape, std::size_t n) {
  return Tape(tape.begin(), tape.begin() + static_cast<std::ptrdiff_t>(n));
}

template <class T>
std::string message(const base::Result<T>& result) {
  return result ? "no error" : result.error().message(base::MessageStyle::compiler);
}

TEST(Rim, IsReadAndWrittenLineByLine) {
  const CoreImage image{{{0100, Word18(0123456)}}, 0100};
  const auto read = read_rim(rim_lines, "t");
  ASSERT_TRUE(read) << message(read);
  EXPECT_EQ(read.value(), image);
  const auto written = write_rim(image, "t");
  ASSERT_TRUE(written) << message(written);
  Tape expected = rim_lines;
  expected.insert(expected.end(), {0200, 0200, 0200});  // the word the loader reads ahead
  EXPECT_EQ(without_feed(written.value()), expected);
}

TEST(Rim, WithoutAStartEndsWithHlt) {
  const auto written = write_rim(CoreImage{{{5, Word18(1)}}, {}}, "t");
  ASSERT_TRUE(written);
  EXPECT_EQ(without_feed(written.value()),
            (Tape{0204, 0200, 0205, 0200, 0200, 0201, 0274, 0200, 0240, 0200, 0200, 0200}));
}

TEST(Rim, LeaderMayBeReadableAndFeedMayStandBetweenWords) {
  Tape tape{0, 0176, 0011, 0};
  tape.insert(tape.end(), rim_lines.begin(), rim_lines.begin() + 6);
  tape.insert(tape.end(), {0, 0, 0});
  tape.insert(tape.end(), rim_lines.begin() + 6, rim_lines.end());
  EXPECT_TRUE(read_rim(tape, "t"));
}

TEST(Rim, DamageIsReportedWithItsByte) {
  EXPECT_EQ(message(read_rim({}, "t")),
            "t:byte 0: error: found the end of the tape, expected DAC address, JMP start or HLT");
  EXPECT_EQ(message(read_rim(first_lines(rim_lines, 6), "t")),
            "t:byte 6: error: found the end of the tape, expected DAC address, JMP start or HLT");
  EXPECT_EQ(message(read_rim(first_lines(rim_lines, 3), "t")),
            "t:byte 3: error: found the end of the tape, expected the data word for address 00100");
  EXPECT_EQ(message(read_rim(first_lines(rim_lines, 5), "t")),
            "t:byte 5: error: found the end of the tape inside a word, expected three lines of the data word "
            "for address 00100");
  EXPECT_EQ(message(read_rim(with(rim_lines, 4, 0034), "t")),
            "t:byte 4: error: found line 034 without hole 8 inside a word, expected three lines with hole 8 "
            "of the data word for address 00100");
  EXPECT_EQ(
      message(read_rim(with(rim_lines, 3, 0012), "t")),
      "t:byte 3: error: found line 012 without hole 8, expected hole 8 of the data word for address 00100");
  EXPECT_EQ(message(read_rim(with(rim_lines, 0, 0220), "t")),
            "t:byte 0: error: found word 200100, expected DAC address, JMP start or HLT");
  EXPECT_EQ(message(read_rim(with(rim_lines, 1, 0301), "t")),
            "t:byte 1: error: found line 301 with hole 7 before the third line of a word, expected three "
            "lines with hole 8 of DAC address, JMP start or HLT");
  EXPECT_EQ(message(read_rim(with(rim_lines, 8, 0300), "t")),
            "t:byte 6: error: found word 600100 with hole 7, expected a RIM tape without hole 7");
}

TEST(Rim, RefusesWhatItsLoaderCannotLoad) {
  EXPECT_EQ(message(write_rim(CoreImage{{{020000, Word18(1)}}, {}}, "t")),
            "t: error: found a word at 20000, expected at most 17777 on a RIM tape");
  EXPECT_EQ(message(write_rim(CoreImage{{{017762, Word18(1)}}, {}}, "t")),
            "t: error: found a word at 17762, expected none where the RIM loader runs (17762-17776)");
  EXPECT_TRUE(write_rim(CoreImage{{{017761, Word18(1)}, {017777, Word18(1)}}, {}}, "t"));
  EXPECT_EQ(message(write_rim(CoreImage{{}, 020000}, "t")),
            "t: error: found start address 20000, expected at most 17777 on a RIM tape");
}

TEST(Hri, IsReadAndWrittenLineByLine) {
  const CoreImage image{{{0300, Word18(0123456)}, {0301, Word18(1)}}, 0100};
  const auto read = read_hri(hri_lines, "t", 0300);
  ASSERT_TRUE(read) << message(read);
  EXPECT_EQ(read.value(), image);
  const auto written = write_hri(image, "t");
  ASSERT_TRUE(written);
  EXPECT_EQ(without_feed(written.value()), hri_lines);
}

TEST(Hri, FillsGapsAndKeepsTheBank) {
  const CoreImage image{{{020000, Word18(1)}, {020002, Word18(3)}}, 020002};
  const auto written = write_hri(image, "t");
  ASSERT_TRUE(written);
  const auto read = read_hri(written.value(), "t", 020000);
  ASSERT_TRUE(read);
  EXPECT_EQ(read.value().words,
            (std::map<std::uint32_t, Word18>{{020000, Word18(1)}, {020001, Word18(0)}, {020002, Word18(3)}}));
  EXPECT_EQ(read.value().start, 020002U);
}

TEST(Hri, DamageIsReportedWithItsByte) {
  EXPECT_EQ(
      message(read_hri(with(hri_lines, 8, 0200), "t", 0)),
      "t:byte 9: error: found the end of the tape, expected a word, the last with hole 7 in its third line");
  EXPECT_EQ(message(read_hri(with(hri_lines, 5, 0301), "t", 0)),
            "t:byte 3: error: found last word 000001, expected JMP start or HLT");
  EXPECT_EQ(message(read_hri(first_lines(hri_lines, 8), "t", 0)),
            "t:byte 8: error: found the end of the tape inside a word, expected three lines of a word, the "
            "last with hole 7 in its third line");
  EXPECT_EQ(message(read_hri(hri_lines, "t", 077777)),
            "t:byte 3: error: found a word after address 77777, expected the last word, with hole 7");
  EXPECT_EQ(message(write_hri(CoreImage{}, "t")),
            "t: error: found an image without words, expected at least one for an HRI tape");
  EXPECT_EQ(message(write_hri(CoreImage{{{020000, Word18(1)}}, 5}, "t")),
            "t: error: found start address 00005, expected one in the bank of the last word, 20000, on an "
            "HRI tape");
}

// A punch that was a line or two ahead: hole 7 is before the third line of the last word.
TEST(EarlyHole7, EndsAnHriTapeWithAWarning) {
  for (const std::size_t line : {6U, 7U}) {
    const Tape tape = with(with(hri_lines, 8, 0200), line, static_cast<std::uint8_t>(hri_lines[line] | 0100));
    std::vector<std::string> warnings;
    const auto read = read_hri(tape, "t", 0300, &warnings);
    ASSERT_TRUE(read) << message(read);
    EXPECT_EQ(read.value(), (CoreImage{{{0300, Word18(0123456)}, {0301, Word18(1)}}, 0100}));
    EXPECT_EQ(warnings, (std::vector<std::string>{"t: byte " + std::to_string(line) + ": hole 7 in line " +
                                                  std::to_string(line - 5) +
                                                  " of the last word, expected it in line 3; the tape is read up to this word"}));
    EXPECT_EQ(recognise(tape, "t").value(), Format::hri);
    EXPECT_TRUE(read_hri(tape, "t", 0300));
  }
}

TEST(EarlyHole7, EndsARimTapeWithAWarning) {
  Tape tape = with(rim_lines, 7, 0301);
  for (int with_read_ahead = 0; with_read_ahead < 2; ++with_read_ahead) {
    std::vector<std::string> warnings;
    EXPECT_EQ(recognise(tape, "t").value(), Format::rim);
    const auto read = read_image(tape, "t", {}, &warnings);
    ASSERT_TRUE(read) << message(read);
    EXPECT_EQ(read.value(), (CoreImage{{{0100, Word18(0123456)}}, 0100}));
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings[0].substr(0, 30), "t: byte 7: hole 7 in line 2 of");
    tape.insert(tape.end(), {0200, 0200, 0200});
  }
}

TEST(EarlyHole7, InsideATapeIsDamage) {
  EXPECT_EQ(message(read_hri(with(hri_lines, 1, 0334), "t", 0)),
            "t:byte 1: error: found line 334 with hole 7 before the third line of a word, expected three lines with hole 8 "
            "of a word, the last with hole 7 in its third line");
  EXPECT_EQ(message(read_rim(with(rim_lines, 3, 0312), "t")),
            "t:byte 3: error: found line 312 with hole 7 before the third line of a word, expected three lines with hole 8 "
            "of the data word for address 00100");
  // A last word other than JMP and HLT is still an error.
  EXPECT_EQ(message(read_hri(first_lines(with(hri_lines, 4, 0300), 6), "t", 0)),
            "t:byte 3: error: found last word 000001, expected JMP start or HLT");
}

TEST(Recognition, IsByContent) {
  const std::string text = "00100: 123456\n";
  const Tape octal_bytes(text.begin(), text.end());
  EXPECT_EQ(recognise(octal_bytes, "t").value(), Format::octal);
  EXPECT_EQ(recognise(rim_lines, "t").value(), Format::rim);
  EXPECT_EQ(recognise(hri_lines, "t").value(), Format::hri);
  // An HRI tape whose first word is a DAC is still HRI.
  EXPECT_EQ(recognise(Tape{0204, 0201, 0200, 0274, 0200, 0340, 0}, "t").value(), Format::hri);
  EXPECT_EQ(message(recognise({}, "t")),
            "t: error: found an empty file, expected an octal core image, a RIM tape or an HRI tape");
  EXPECT_EQ(message(recognise(Tape{0, 1, 2}, "t")),
            "t: error: found no line with hole 8, expected an octal core image, a RIM tape or an HRI tape");
  EXPECT_EQ(message(recognise(Tape{0277, 0277, 0277}, "t")),
            "t:byte 0: error: found word 777777 and no hole 7 that ends a block, expected DAC address (RIM "
            "tape) or hole 7 in the last word (HRI tape)");
}

TEST(Recognition, ReadsWithTheAddressThatTheFormatNeeds) {
  EXPECT_TRUE(read_image(rim_lines, "t", {}));
  EXPECT_TRUE(read_image(hri_lines, "t", 5));
  EXPECT_EQ(message(read_image(hri_lines, "t", {})),
            "t: error: found an HRI tape without an address, expected the address at which to read it in");
  EXPECT_EQ(message(read_image(rim_lines, "t", 5)),
            "t: error: found an address for a RIM tape, expected none: the tape has its own");
}

}  // namespace
}  // namespace sightline::image
