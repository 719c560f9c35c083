// `sightline spin` and `sightline draw plantinga`: pictures, event files saved and reused, and usage errors.
#include <array>
#include <cstddef>
#include <sstream>

#include "tests/host/app/command_line.hpp"

namespace {

using sightline::test::has;

class SpinCommand : public sightline::test::CommandLine {
 protected:
  // A tetrahedron in front of another.
  void write_models() const {
    write("two.off",
          "OFF\n8 8 0\n0 0 0\n9 1 0\n4 8 1\n3 2 9\n20 -3 1\n31 0 2\n24 7 3\n25 1 12\n"
          "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n3 4 6 5\n3 4 5 7\n3 5 6 7\n3 4 7 6\n");
    write("other.off", "OFF\n4 4 0\n0 0 0\n9 1 0\n4 9 1\n3 2 9\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  }
};

// The big-endian number of frames in the chunk acTL of an animated PNG.
std::size_t frames_of(const std::string& png) {
  const std::size_t at = png.find("acTL");
  if (!png.starts_with("\x89PNG") || at == std::string::npos || at + 8 > png.size()) return 0;
  std::size_t count = 0;
  for (std::size_t i = 4; i < 8; ++i) count = 256 * count + static_cast<unsigned char>(png[at + i]);
  return count;
}

TEST_F(SpinCommand, WritesAnAnimatedPicture) {
  write_models();
  const auto ran = sightline({"spin", "two.off", "--step", "30", "--size", "64", "-o", "two.apng"});
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "12 edges")) << ran.out;
  EXPECT_TRUE(has(ran.out, "12 frames")) << ran.out;
  EXPECT_EQ(frames_of(read("two.apng")), 12U);
  ASSERT_EQ(
      sightline({"spin", "two.off", "--step", "30", "--size", "64", "--wire", "-o", "wire.apng"}).exit_code,
      0);
  EXPECT_NE(read("wire.apng"), read("two.apng")) << "the wire frame shows hidden lines";
}

// A model with another vertical axis turns like the model with a vertical y axis: the columns give the positions of that model's
// x, y
// and z in the file, the signs their directions.
TEST_F(SpinCommand, TurnsAboutTheAxisThatPointsUp) {
  write_models();
  const sightline::test::Arguments sizes{"--step", "90", "--size", "64"};
  const auto spin = [&](sightline::test::Arguments arguments) {
    arguments.insert(arguments.begin(), "spin");
    arguments.insert(arguments.end(), sizes.begin(), sizes.end());
    return sightline(arguments);
  };
  ASSERT_EQ(spin({"two.off", "-o", "y.apng"}).exit_code, 0);
  struct Standing {
    const char* vertical;
    std::array<std::size_t, 3> from;
    std::array<int, 3> sign;
  };
  for (const Standing& standing :
       {Standing{"x", {1, 0, 2}, {1, -1, 1}}, Standing{"-x", {1, 0, 2}, {-1, 1, 1}},
        Standing{"-y", {0, 1, 2}, {-1, -1, 1}}, Standing{"z", {0, 2, 1}, {1, -1, 1}},
        Standing{"-z", {0, 2, 1}, {1, 1, -1}}}) {
    std::istringstream model(read("two.off"));
    std::string line;
    std::string turned;
    for (int number = 0; std::getline(model, line); ++number) {
      std::array<int, 3> p{};
      std::istringstream row(line);
      if (number >= 2 && number < 10 && row >> p[0] >> p[1] >> p[2]) {
        line.clear();
        for (std::size_t a = 0; a < 3; ++a)
          line += std::to_string(standing.sign[a] * p[standing.from[a]]) + ' ';
      }
      turned += line + '\n';
    }
    write("turned.off", turned);
    const auto ran = spin({"turned.off", "--vertical", standing.vertical, "-o", "turned.apng"});
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
    EXPECT_EQ(read("turned.apng"), read("y.apng")) << standing.vertical;
  }
}

TEST_F(SpinCommand, TurnsAboutAnyAxisAndInPerspective) {
  write_models();
  const auto spin = [&](sightline::test::Arguments more) {
    sightline::test::Arguments arguments{"spin", "two.off", "--step", "90", "--size", "64"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return sightline(arguments);
  };
  // Axis and elevation of the turn without options: the same picture but for the scale.
  const auto plain = spin({"--axis", "0,1,0", "-o", "plain.apng"});
  ASSERT_EQ(plain.exit_code, 0) << plain.err;
  EXPECT_EQ(frames_of(read("plain.apng")), 4U);
  ASSERT_EQ(spin({"--elevation", "0", "-o", "level.apng"}).exit_code, 0);
  EXPECT_EQ(read("level.apng"), read("plain.apng"));
  const auto other = spin({"--axis", "1,2,0", "--elevation", "25", "--distance", "2.5", "-o", "other.apng"});
  ASSERT_EQ(other.exit_code, 0) << other.err;
  EXPECT_TRUE(has(other.out, "12 edges")) << other.out;
  EXPECT_NE(read("other.apng"), read("plain.apng"));
  const auto refused = [&](sightline::test::Arguments more, const char* says) {
    more.insert(more.end(), {"-o", "bad.apng"});
    const auto ran = spin(more);
    EXPECT_EQ(ran.exit_code, 2) << says;
    EXPECT_TRUE(has(ran.err, says)) << ran.err;
    EXPECT_FALSE(exists("bad.apng"));
  };
  refused({"--axis", "0,0,0"}, "--axis: found 0,0,0");
  refused({"--axis", "1,2000,0"}, "from -1000 to 1000");
  refused({"--axis", "1,2"}, "--axis");
  refused({"--distance", "1"}, "--distance");
  refused({"--elevation", "90"}, "--elevation");
  refused({"--distance", "2", "--events", "e.events"}, "--events: found with --distance");
  refused({"--axis", "1,0,0", "--tape", "t.tape"}, "--tape: found with --axis");
  refused({"--elevation", "5", "--tolerance", "1"}, "--tolerance: found with --elevation");
}

// An eye far away stays within the coordinates of both methods, also for a mesh that fills the grid.
TEST_F(SpinCommand, MethodsAgreeFromFarAway) {
  write_models();
  for (const char* const scene : {"bars", "two.off"}) {
    for (const char* const method : {"exact", "plantinga"}) {
      const auto ran = sightline({"spin", scene, "--axis", "1,3,0", "--elevation", "20", "--distance", "8", "--step", "60", "--size", "128", "--method", method,
                                  "-o", std::string(method) + ".apng"});
      ASSERT_EQ(ran.exit_code, 0) << scene << ran.err;
    }
    EXPECT_EQ(read("exact.apng"), read("plantinga.apng")) << scene;
  }
}

TEST_F(SpinCommand, SavesAndReusesEvents) {
  write_models();
  const sightline::test::Arguments spin{"spin", "two.off", "--events", "two.events", "--size",
                                        "64",   "--step",  "45",       "-o",         "a.apng"};
  const auto made = sightline(spin);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string events = read("two.events");
  EXPECT_TRUE(events.starts_with("SIGHTLINE EVENTS\n"));
  const std::string picture = read("a.apng");
  const auto again = sightline(spin);
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(read("two.events"), events);
  EXPECT_EQ(read("a.apng"), picture);
  EXPECT_EQ(again.out, made.out);
}

TEST_F(SpinCommand, RejectsEventFilesThatDoNotMatch) {
  write_models();
  ASSERT_EQ(
      sightline({"spin", "two.off", "--events", "two.events", "--step", "90", "-o", "a.apng"}).exit_code, 0);
  const std::string events = read("two.events");
  const auto refused = [&](const std::string& bytes, const sightline::test::Arguments& more,
                           const char* model) {
    write("bad.events", bytes);
    sightline::test::Arguments arguments{"spin",   model, "--events", "bad.events",
                                         "--step", "90",  "-o",       "b.apng"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 4) << ran.err;
    EXPECT_TRUE(has(ran.err, "bad.events")) << ran.err;
    EXPECT_FALSE(exists("b.apng"));
    EXPECT_EQ(read("bad.events"), bytes) << "it may be somebody's: it is left as it is";
  };
  for (const std::size_t length : {std::size_t{0}, std::size_t{17}, events.size() / 2, events.size() - 1})
    refused(events.substr(0, length), {}, "two.off");
  refused(events, {}, "other.off");
  refused(events, {"--tolerance", "1"}, "two.off");
  refused("not an event file at all, but long enough to be read as one", {}, "two.off");
  std::string flipped = events;
  flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 4);
  refused(flipped, {}, "two.off");
}

TEST_F(SpinCommand, NamesTheErrors) {
  write_models();
  write("bad.off", "OFF\n1\n");
  struct Case {
    sightline::test::Arguments arguments;
    int exit_code;
    const char* what;
  };
  const std::vector<Case> cases{
      {{"spin", "nowhere.off", "-o", "a.apng"}, 5, "nowhere.off"},
      {{"spin", "bad.off", "-o", "a.apng"}, 4, "bad.off"},
      {{"spin", "two.off"}, 2, "--output"},
      {{"spin", "two.off", "-o", "two.svg"}, 2, "two.svg: expected a name that ends in .apng or .png"},
      {{"spin", "two.off", "--step", "0", "-o", "a.apng"}, 2, "--step"},
      {{"spin", "two.off", "--tolerance", "nan", "-o", "a.apng"}, 2, "--tolerance"},
      {{"spin", "two.off", "-o", "no/folder/a.apng"}, 5, "no/folder/a.apng"},
  };
  for (const Case& wrong : cases) {
    const auto ran = sightline(wrong.arguments);
    EXPECT_EQ(ran.exit_code, wrong.exit_code) << wrong.what << '\n' << ran.err;
    EXPECT_TRUE(has(ran.err, wrong.what)) << ran.err;
    EXPECT_FALSE(exists("a.apng"));
  }
}

TEST_F(SpinCommand, DrawsOneViewAndRejectsOthers) {
  write_models();
  const auto drawn =
      sightline({"draw", "plantinga", "two.off", "--orthographic", "-3,0,-10", "-o", "two.svg"});
  ASSERT_EQ(drawn.exit_code, 0) << drawn.err;
  EXPECT_TRUE(has(read("two.svg"), "<svg"));
  const auto above =
      sightline({"draw", "plantinga", "two.off", "--orthographic", "-3,-1,-10", "-o", "a.svg"});
  EXPECT_EQ(above.exit_code, 4);
  EXPECT_TRUE(has(above.err, "two.off: camera: ")) << above.err;
  EXPECT_TRUE(has(above.err, "y = 0")) << above.err;
  EXPECT_EQ(sightline({"draw", "plantinga", "two.off", "--eye", "0,0,99", "-o", "a.svg"}).exit_code, 4);
  EXPECT_FALSE(exists("a.svg"));
}

}  // namespace
