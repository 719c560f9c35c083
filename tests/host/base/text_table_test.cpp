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

TEST(TextTable, ALongCellMovesItsOwnRowOnly) {
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

}  // namespace
}  // namespace sightline::base
