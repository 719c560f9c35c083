// Display words of programs of the time, decoded as their authors meant them, and the table compared with the decoders.
#include <gtest/gtest.h>

#include <set>

#include "emulators/type340/words.hpp"

namespace sightline::type340 {
namespace {

using core::Word18;

// Light Pen Diagnostic (DEC, 1964): next mode point, pen on, scale 0, intensity 0. PIXIE has the same with intensity 7.
static_assert(decode_parameter(Word18(0034110)).next == Mode::point);
static_assert(decode_parameter(Word18(0034110)).pen == true);
static_assert(decode_parameter(Word18(0034110)).scale == 0);
static_assert(decode_parameter(Word18(0034110)).intensity == 0);
static_assert(decode_parameter(Word18(0034117)).intensity == 7);
static_assert(!decode_parameter(Word18(0034117)).stop);
// PIXIE: vector, scale 3, intensity 7; the stop word of all programs; a word that does nothing.
static_assert(decode_parameter(Word18(0100177)).next == Mode::vector);
static_assert(decode_parameter(Word18(0100177)).scale == 3);
static_assert(!decode_parameter(Word18(0100177)).pen.has_value());
static_assert(decode_parameter(Word18(0003000)).stop && decode_parameter(Word18(0003000)).interrupt);
static_assert(!decode_parameter(Word18(0002000)).interrupt);
static_assert(!decode_parameter(Word18(0)).scale && !decode_parameter(Word18(0)).intensity);
// Pen off: loaded with 0.
static_assert(decode_parameter(Word18(0010000)).pen == false);
// PIXIE: Y 400 then X 400 and on to vectors (octal).
static_assert(decode_point(Word18(0220400)).y && decode_point(Word18(0220400)).coordinate == 0400);
static_assert(decode_point(Word18(0220400)).next == Mode::point);
static_assert(!decode_point(Word18(0100400)).y && decode_point(Word18(0100400)).next == Mode::vector);
static_assert(decode_point(Word18(0102000)).intensify && decode_point(Word18(0101777)).coordinate == 1023);
// PIXIE: 310010 = vector 10 right, 20 down (octal), lit.
static_assert(decode_vector(Word18(0310010)).intensify && decode_vector(Word18(0310010)).down);
static_assert(decode_vector(Word18(0310010)).dx == 010 && decode_vector(Word18(0310010)).dy == 020);
static_assert(!decode_vector(Word18(0310010)).left && !decode_vector(Word18(0310010)).escape);
static_assert(decode_vector(Word18(0777777)).dx == 127 && decode_vector(Word18(0777777)).dy == 127);
// Increment moves: R 10, L 14, U 02, D 03, diagonals by OR.
static_assert(direction_of_move(010) == Direction{1, 0} && direction_of_move(014) == Direction{-1, 0});
static_assert(direction_of_move(002) == Direction{0, 1} && direction_of_move(003) == Direction{0, -1});
static_assert(direction_of_move(017) == Direction{-1, -1} && direction_of_move(012) == Direction{1, 1});
static_assert(!direction_of_move(0).moves() && !direction_of_move(005).moves());
static_assert(decode_increment(Word18(0705016)).moves[3] == Direction{-1, 1});
static_assert(decode_increment(Word18(0705016)).escape && decode_increment(Word18(0705016)).intensify);
// PIXIE: 560004 DJP, 705312 DJS, 260003 DDS.
static_assert(decode_subroutine(Word18(0560004)).operation == SubroutineOperation::jump);
static_assert(decode_subroutine(Word18(0560004)).address == 4);
static_assert(decode_subroutine(Word18(0705312)).operation == SubroutineOperation::jump_and_save);
static_assert(decode_subroutine(Word18(0705312)).next == Mode::vector);
static_assert(decode_subroutine(Word18(0705312)).address == 05312);
static_assert(decode_subroutine(Word18(0260003)).operation == SubroutineOperation::deposit);
static_assert(decode_characters(Word18(0010237)) == std::array<std::uint8_t, 3>{1, 2, 037});
static_assert(decode_slave(Word18(0027041)).units[0].set && decode_slave(Word18(0027041)).units[0].on);
static_assert(decode_slave(Word18(0027041)).units[0].pen && decode_slave(Word18(0027041)).units[2].set);
static_assert(!decode_slave(Word18(0027041)).units[1].set && decode_slave(Word18(0027041)).units[3].on);

static_assert(following(Mode::parameter, Word18(0003000)).stops);
static_assert(following(Mode::parameter, Word18(0020117)).mode == Mode::point);
static_assert(following(Mode::point, Word18(0100400)).mode == Mode::vector);
static_assert(following(Mode::vector, Word18(0200144)).mode == Mode::vector);
static_assert(following(Mode::vector, Word18(0600344)).mode == Mode::parameter);
static_assert(following(Mode::vector_continue, Word18(0200344)).mode == Mode::parameter);
static_assert(following(Mode::increment, Word18(0400000)).mode == Mode::parameter);
static_assert(following(Mode::character, Word18(0010237)).mode == Mode::parameter);
static_assert(following(Mode::character, Word18(0010203)).mode == Mode::character);
static_assert(following(Mode::subroutine, Word18(0705312)).mode == Mode::vector);

TEST(DisplayWords, FieldsOfALayoutHaveDistinctNames) {
  for (const Layout& layout : layouts) {
    std::set<std::string_view> names;
    for (const Field& field : layout.fields) {
      EXPECT_FALSE(field.name.empty()) << layout.name;
      EXPECT_TRUE(field.kind == FieldKind::unused || names.insert(field.name).second) << field.name;
      EXPECT_TRUE(field.kind != FieldKind::flag || field.first == field.last) << field.name;
    }
  }
}

// A field extracted by its row of the table equals the decoded member of that name.
TEST(DisplayWords, TableAndDecodersAgree) {
  const auto field = [](Mode mode, std::string_view name, Word18 word) {
    for (const Field& f : layout_of(mode).fields) {
      if (f.name == name) return word.field(f.first, f.last);
    }
    ADD_FAILURE() << name;
    return 0U;
  };
  for (std::uint32_t value = 0; value <= Word18::mask; value += 37) {
    const Word18 w(value);
    ASSERT_EQ(field(Mode::point, "coordinate", w), decode_point(w).coordinate);
    ASSERT_EQ(field(Mode::point, "intensify", w) != 0, decode_point(w).intensify);
    ASSERT_EQ(field(Mode::parameter, "stop", w) != 0, decode_parameter(w).stop);
    ASSERT_EQ(field(Mode::parameter, "interrupt", w) != 0, decode_parameter(w).interrupt);
    ASSERT_EQ(field(Mode::parameter, "scale", w), decode_parameter(w).scale.value_or(field(Mode::parameter, "scale", w)));
    ASSERT_EQ(field(Mode::vector, "dx", w), decode_vector(w).dx);
    ASSERT_EQ(field(Mode::vector, "dy", w), decode_vector(w).dy);
    ASSERT_EQ(field(Mode::vector, "left", w) != 0, decode_vector(w).left);
    ASSERT_EQ(field(Mode::vector, "down", w) != 0, decode_vector(w).down);
    ASSERT_EQ(field(Mode::subroutine, "address", w), decode_subroutine(w).address);
    ASSERT_EQ(field(Mode::character, "second", w), decode_characters(w)[1]);
    ASSERT_EQ(direction_of_move(field(Mode::increment, "third", w)), decode_increment(w).moves[2]);
  }
}

}  // namespace
}  // namespace sightline::type340
