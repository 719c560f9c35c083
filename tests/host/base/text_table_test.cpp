// Tables of plain text: cells in columns of fixed widths.
#include "host/base/text_table.hpp"

#include <gtest/gtest.h>

namespace sightline::base {
namespace {

TEST(TextTable, PadsCellsToTheirColumns) {
  TextTable table({-8, 6, 6});
  table.row({"scene", "lines", "s"});
  table.row({"house", "128", "0.25"});
  EXPECT_EQ(table.text(), "scene    lines     s\nhouse      128  0.25\n");
}

TEST(TextTable, ALongCellShiftsOnlyItsRow) {
  TextTable table({-4, 3});
  table.row({"a", "1"});
  table.row({"longer", "12345"});
  EXPECT_EQ(table.text(), "a     1\nlonger12345\n");
}

TEST(TextTable, LeavesNoBlanksAtTheEndOfALine) {
  TextTable table({-4, -4, 0});
  table.row({"a", "b", ""});
  table.row({"c"});
  table.line("a note of any length");
  EXPECT_EQ(table.text(), "a   b\nc\na note of any length\n");
}

TEST(TextTable, OmitsColumnsInANarrowTerminal) {
  TextTable table({-12, 12, -12, 12});
  table.row({"scene", "lines", "  paper", "s"});
  table.row({"house", "128", "  of 1971", "0.25"});
  table.line("a note that is longer than the terminal");
  EXPECT_EQ(table.text_within(48, {2, 1}), table.text()) << "it fits";
  EXPECT_EQ(table.text_within(47, {2, 1}),
            "scene  lines  paper       s\nhouse    128  of 1971  0.25\na note that is longer than the terminal\n")
      << "narrow columns are enough";
  EXPECT_EQ(table.text_within(26, {2, 1}),
            "scene  lines     s\nhouse    128  0.25\na note that is longer than the terminal\n"
            "left out, for a wider terminal: paper\n");
  EXPECT_EQ(table.text_within(5, {2, 1}),
            "scene     s\nhouse  0.25\na note that is longer than the terminal\n"
            "left out, for a wider terminal: paper, lines\n")
      << "the others stay";
}

}  // namespace
}  // namespace sightline::base
