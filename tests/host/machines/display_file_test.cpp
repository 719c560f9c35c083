// The words that the display reads, for files of a few words decoded by hand: the operation of a subroutine word is in bits 0-1
// (2 jumps,
// 3 also saves the return), the next mode in bits 2-4 (0 parameter, 4 vector, 7 subroutine), the address in bits 5-17; bit 0 of a
// vector
// escapes to parameter mode.
#include "host/machines/display_file.hpp"

#include <gtest/gtest.h>

#include <map>

namespace sightline::test {
namespace {

using type340::Mode;
using Words = std::map<std::uint32_t, std::uint32_t>;
using Modes = std::map<std::uint32_t, Mode>;

Modes modes_of(const Words& words, const type340::Options& options = {}, const type340::Registers& registers = {}) {
  return machines::display_file(options, registers, 0100, [&words](std::uint32_t address) {
    const auto found = words.find(address);
    return core::Word18(found == words.end() ? 0200177 : found->second);
  });
}

TEST(DisplayFile, FollowsModesToTheStop) {
  EXPECT_EQ(modes_of({{0100, 0020117}, {0101, 0220400}, {0102, 0102400}, {0103, 0600100}, {0104, 0003000}}),
            (Modes{{0100, Mode::parameter}, {0101, Mode::point}, {0102, Mode::point}, {0103, Mode::vector}, {0104, Mode::parameter}}));
}

TEST(DisplayFile, GoesToSubroutinesAndBack) {
  const Words words{{0100, 0160000}, {0101, 0700200}, {0102, 0003000}, {0200, 0600177}};
  EXPECT_EQ(modes_of(words, {.subroutines_347 = true}),
            (Modes{{0100, Mode::parameter}, {0101, Mode::subroutine}, {0200, Mode::vector}, {0102, Mode::parameter}}));
  EXPECT_EQ(modes_of(words), (Modes{{0100, Mode::parameter}, {0101, Mode::subroutine}}));  // waits there without the Type 347
}

TEST(DisplayFile, MayJumpBackToItsBeginning) {
  EXPECT_EQ(modes_of({{0100, 0160000}, {0101, 0400100}}, {.subroutines_347 = true}),
            (Modes{{0100, Mode::parameter}, {0101, Mode::subroutine}}));
}

// Vectors through all of core; an edge ended the pass after two of them.
TEST(DisplayFile, EndsWhereThePassEnded) {
  type340::Registers registers;
  EXPECT_EQ(modes_of({{0100, 0100000}}, {}, registers).size(), 017777U + 1);
  registers.address = 0103;
  registers.vertical_edge = true;
  EXPECT_EQ(modes_of({{0100, 0100000}}, {}, registers), (Modes{{0100, Mode::parameter}, {0101, Mode::vector}, {0102, Mode::vector}}));
}

}  // namespace
}  // namespace sightline::test
