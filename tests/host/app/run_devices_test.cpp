// `sightline run pdp7` with its devices: display and light pen, switches, tapes, teletype.
//
// Expected words and times are computed by hand from the instruction list and the display's word formats.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/picture/png.hpp"
#include "tests/host/app/run_fixture.hpp"

namespace {

using nlohmann::json;
using sightline::test::Arguments;
using sightline::test::has;
using sightline::test::Ran;

class RunDevices : public sightline::test::RunPdp7 {};

TEST_F(RunDevices, SwitchScript) {
  write("wait.oct", "00000: 750004 741200 600000 740040\n");  // LAS, SNA, JMP 0, HLT
  write("turns.txt", "# a person\n0.5 1234   # now\n\n  1.5 1\n");
  const json r = report({"--load", "wait.oct", "--switches", "turns.txt"});
  EXPECT_EQ(r.at("registers").at("ac"), "001234");
  EXPECT_GE(r.at("emulated_ns"), 500'000'000);
  EXPECT_LT(r.at("emulated_ns"), 500'020'000);
  write("bad.txt", "0 1\n0.5 8\n");
  const Ran bad = run({"--load", "wait.oct", "--switches", "bad.txt"});
  EXPECT_EQ(bad.exit_code, 4);
  EXPECT_TRUE(has(bad.err, "bad.txt:2: error: found \"8\"")) << bad.err;
  write("bad.txt", "soon 1\n");
  EXPECT_EQ(run({"--load", "wait.oct", "--switches", "bad.txt"}).exit_code, 4);
  EXPECT_EQ(run({"--load", "wait.oct", "--switches", "none.txt"}).exit_code, 5);
  EXPECT_EQ(run({"--load", "wait.oct", "--switches", "1000000"}).exit_code, 2);
}

TEST_F(RunDevices, PictureOfTheLastCompletePass) {
  write("picture.oct", picture);
  const json r = report({"--load", "picture.oct", "--start", "100", "--max-time", "0.1", "--png", "p.png",
                         "--svg", "p.svg", "--phosphor", "photo.png", "--strokes", "strokes"});
  EXPECT_EQ(r.at("machine").at("display"), true);
  EXPECT_GT(r.at("passes"), 100);
  EXPECT_GE(r.at("display_words"), r.at("passes").get<int>() * 5);
  EXPECT_GE(r.at("stolen_cycles"), r.at("display_words"));
  const auto png = sightline::picture::read_png(path("p.png").string());
  ASSERT_TRUE(png);
  std::vector<std::uint8_t> expected(std::size_t{1024} * 1024);
  for (std::size_t x = 0400; x <= 0500; ++x) expected[(1023 - 0400) * 1024 + x] = 255;
  EXPECT_EQ(png->image.pixels, expected);
  EXPECT_TRUE(has(png->text.at(1).second, "last complete pass"));
  EXPECT_TRUE(has(read("p.svg"), "<polyline"));
  EXPECT_TRUE(sightline::picture::read_png(path("photo.png").string()));
  EXPECT_TRUE(has(read("strokes"), " 256 256 7 00110\n")) << read("strokes").substr(0, 200);
  EXPECT_TRUE(has(read("strokes"), " 320 256 7 00111\n"));
}

// Ten photographs per second: the one at 0.1 s equals that of a run that ends there, whose first boundary is at most a cycle
// later.
TEST_F(RunDevices, AMovieIsASequenceOfPhotographs) {
  write("picture.oct", picture);
  const Arguments plain{"--load", "picture.oct", "--start", "100", "--max-time", "0.35"};
  Arguments filmed = plain;
  filmed.insert(filmed.end(), {"--movie", "m.png", "--movie-rate", "10", "--strokes", "filmed"});
  const json with = report(filmed);
  Arguments drawn = plain;
  drawn.insert(drawn.end(), {"--strokes", "drawn"});
  EXPECT_EQ(with.at("instructions"), report(drawn).at("instructions"));
  EXPECT_EQ(read("filmed"), read("drawn"));
  // acTL: the number of frames, big-endian, after the name of the chunk.
  const std::string movie = read("m.png");
  const std::size_t control = movie.find("acTL");
  ASSERT_NE(control, std::string::npos);
  EXPECT_EQ(movie.substr(control + 4, 4), std::string("\0\0\0\3", 4));
  // fcTL: the delay, 1 of 10 seconds.
  const std::size_t frame = movie.find("fcTL");
  EXPECT_EQ(movie.substr(frame + 24, 4), std::string("\0\1\0\12", 4));
  ASSERT_EQ(run({"--load", "picture.oct", "--start", "100", "--max-time", "0.1", "--phosphor", "photo.png"}).exit_code, 0);
  const auto first = sightline::picture::read_png(path("m.png").string());
  const auto photo = sightline::picture::read_png(path("photo.png").string());
  ASSERT_TRUE(first && photo);
  int differ = 0;
  for (std::size_t n = 0; n < photo->image.pixels.size(); ++n)
    differ = std::max(differ, std::abs(int{first->image.pixels[n]} - int{photo->image.pixels[n]}));
  EXPECT_LE(differ, 1);
  EXPECT_EQ(run({"--load", "picture.oct", "--movie", "m", "--movie-rate", "0"}).exit_code, 2);
}

TEST_F(RunDevices, AnOldPictureDrawsAWarning) {
  // IDLA once, then a loop: the only pass, of 65 points on a line, ends within a millisecond.
  write("once.oct", "00100: 200105 700606 600102 000000 000000 000106 020117 220400 102400 600100 003000\n");
  const Arguments options{"--load", "once.oct", "--start", "100", "--png", "p.png"};
  const auto with = [&options](Arguments more) {
    more.insert(more.begin(), options.begin(), options.end());
    return more;
  };
  const Ran young = run(with({"--max-time", "0.2"}));
  EXPECT_FALSE(has(young.err, "the picture shows")) << young.err;
  const Ran old = run(with({"--max-time", "0.3"}));
  EXPECT_TRUE(has(old.err, "the picture shows a pass that ended 0.299")) << old.err;
  EXPECT_TRUE(has(old.out + old.err, "1 stop codes")) << old.out;
  // The window before the end contains no stroke; a longer window contains the point.
  EXPECT_EQ(run(with({"--max-time", "0.3", "--png-window", "0.1"})).exit_code, 0);
  const auto empty = sightline::picture::read_png(path("p.png").string());
  EXPECT_EQ(std::count(empty->image.pixels.begin(), empty->image.pixels.end(), 255), 0);
  EXPECT_TRUE(has(empty->text.at(1).second, "0 points of the last 0.1"));
  const Ran all = run(with({"--max-time", "0.3", "--png-window", "0.31"}));
  EXPECT_FALSE(has(all.err, "the picture shows")) << all.err;
  const auto full = sightline::picture::read_png(path("p.png").string());
  EXPECT_EQ(std::count(full->image.pixels.begin(), full->image.pixels.end(), 255), 65);
  EXPECT_EQ(run(with({"--png-window", "0"})).exit_code, 2);
  EXPECT_EQ(run(with({"--png-window", "x"})).exit_code, 2);
}

TEST_F(RunDevices, ADisplayFileThatNeverStops) {
  write("endless.oct", endless);
  const Ran ran =
      run({"--load", "endless.oct", "--start", "100", "--max-time", "0.2", "--png", "p.png", "--json"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(json::parse(ran.out).at("passes"), 0);
  EXPECT_EQ(json::parse(ran.out).at("passes_started"), 1);
  EXPECT_TRUE(has(ran.err, "no complete pass")) << ran.err;
  const auto png = sightline::picture::read_png(path("p.png").string());
  ASSERT_TRUE(png);
  EXPECT_TRUE(has(png->text.at(1).second, "no complete pass"));
  EXPECT_GE(std::count(png->image.pixels.begin(), png->image.pixels.end(), 255), 65);
}

TEST_F(RunDevices, DisplayOptions) {
  // IDLA of a file that enters mode 3 (characters) at once, followed by a stop: without the 342 it hangs.
  write("text.oct", "00100: 200103 700606 600102 000104 060117 015437\n");
  const Arguments options{"--load", "text.oct", "--start", "100", "--max-time", "0.1", "--strokes", "s"};
  Arguments with = options;
  with.insert(with.end(), {"--display-option", "342"});
  const Ran without = run(options);
  ASSERT_EQ(without.exit_code, 0);
  EXPECT_TRUE(has(without.err, "Type 342 character generator and waits there; --display-option 342 attaches it")) << without.err;
  EXPECT_EQ(read("s"), "");
  ASSERT_EQ(run(with).exit_code, 0);
  EXPECT_NE(read("s"), "");
  EXPECT_EQ(run({"--display-option", "999", "--max-instructions", "1"}).exit_code, 2);
}

TEST_F(RunDevices, TapeReaderPunchAndTeletype) {
  // RSA, RSF, JMP .-1, RRB; PLS, PSF, JMP .-1; TLS, TSF, JMP .-1; HLT.
  write("copy.oct", "00100: 700104 700101 600101 700112 700206 700201 600105 700406 700401 600110 740040\n");
  write("tape", "\301");
  ASSERT_EQ(run({"--load", "copy.oct", "--start", "100", "--reader", "tape", "--punch", "punched",
                 "--teletype", "typed"})
                .exit_code,
            0);
  EXPECT_EQ(read("punched"), "\301");
  EXPECT_EQ(read("typed"), "A");
  const Ran hungry = run({"--load", "copy.oct", "--start", "100", "--max-time", "1", "--json"});
  EXPECT_TRUE(json::parse(hungry.out).at("reader_out_of_tape"));
  EXPECT_TRUE(has(hungry.err, "no more tape")) << hungry.err;
  EXPECT_EQ(run({"--load", "copy.oct", "--reader", "none"}).exit_code, 5);
}

TEST_F(RunDevices, KeyboardScript) {
  // KSF, JMP .-1, KRB, SAD 111, HLT, TLS, TSF, JMP .-1, JMP 100; 111: the code of carriage return.
  write("echo.oct", "00100: 700301 600100 700312 540111 740040 700406 700401 600106 600100 000215\n");
  write("keys.txt", "# greets\n0.2 Hi \\101\n1.5 \\r\n");
  ASSERT_EQ(run({"--load", "echo.oct", "--start", "100", "--keyboard", "keys.txt", "--teletype", "typed"})
                .exit_code,
            0);
  EXPECT_EQ(read("typed"), "Hi A");
  write("keys.txt", "1 a\n0.5 b\n");
  EXPECT_EQ(run({"--load", "echo.oct", "--keyboard", "keys.txt"}).exit_code, 4);
  write("keys.txt", "1 \\q\n");
  const Ran bad = run({"--load", "echo.oct", "--keyboard", "keys.txt"});
  EXPECT_EQ(bad.exit_code, 4);
  EXPECT_TRUE(has(bad.err, "keys.txt:1: error:")) << bad.err;
}

// Starts the display at 110, waits for IDSP, IDRC, HLT. The file: pen on, scale 0, intensity 7; y 400; x 144, dark; a vector of
// 177
// to the right, lit; stop. Every pulse of that vector moves one point to the right. The pen at (151, 256) first sees 147; the
// flag
// comes with the next pulse, at 148 = 2 * 112 octal; 256 = 2 * 200.
TEST_F(RunDevices, LightPenFindsAVector) {
  write("find.oct",
        "00100: 200107 700606 700701 600102 700712 740040\n"
        "00107: 000110 034117 220400 100144 600177 003000\n");
  const auto ac = [this](std::string_view script) {
    write("pen.txt", script);
    const json r =
        report({"--load", "find.oct", "--start", "100", "--light-pen", "pen.txt", "--max-time", "0.01"});
    EXPECT_EQ(r.at("machine").at("display"), true);
    return r.at("stop_reason") == "halt" ? r.at("registers").at("ac").get<std::string>() : "not found";
  };
  EXPECT_EQ(ac("0 151 256\n"), "112200");
  EXPECT_EQ(ac("0 151 256 2  # a finer pen: from 149, flag at 150\n"), "113200");
  EXPECT_EQ(ac("# below and above by one point more than the radius\n0 151 251\n"), "not found");
  EXPECT_EQ(ac("0 151 261\n"), "not found");
  EXPECT_EQ(ac("0 151 260\n"), "112200");
  EXPECT_EQ(ac("0 0 0 1023\n"), "063200");  // sees 101, is at 102
  EXPECT_EQ(ac("0 151 256\n0 off\n"), "not found");
  EXPECT_EQ(ac(""), "not found");
}

// A lit point: the flag comes with the word after it, before the beam moves. X 600, Y 400 octal.
TEST_F(RunDevices, LightPenFindsAPoint) {
  write("point.oct",
        "00100: 200107 700606 700701 600102 700712 740040\n"
        "00107: 000110 034117 220400 002600 003000\n");
  write("near.txt", "0 380 252\n");
  write("far.txt", "0 379 252\n");
  const Arguments options{"--load", "point.oct", "--start", "100", "--max-time", "0.01", "--light-pen"};
  Arguments near = options;
  near.push_back("near.txt");
  EXPECT_EQ(report(near).at("registers").at("ac"), "300200");
  Arguments far = options;
  far.push_back("far.txt");
  EXPECT_EQ(report(far).at("stop_reason"), "time_limit");
}

// The picture above, repeated: IDSP, SKP, JMP found, IDSI, JMP 102, JMP 100; found: IDRC, HLT.
TEST_F(RunDevices, LightPenIsPointedInTime) {
  write("again.oct",
        "00100: 200112 700606 700701 741000 600110 700601 600102 600100 700712 740040\n"
        "00112: 000113 034117 220400 100144 600177 003000\n");
  write("pen.txt", "0 500 500\n0.005 off\n0.0200 151 256\n");
  const json r =
      report({"--load", "again.oct", "--start", "100", "--light-pen", "pen.txt", "--max-time", "1"});
  EXPECT_EQ(r.at("stop_reason"), "halt");
  EXPECT_EQ(r.at("registers").at("ac"), "112200");
  // No later than two passes of under 300 us.
  EXPECT_GE(r.at("emulated_ns"), 20'000'000);
  EXPECT_LT(r.at("emulated_ns"), 20'600'000);
}

TEST_F(RunDevices, LightPenScriptsThatAreWrong) {
  write("halt.oct", "00000: 740040\n");
  for (const std::string line : {"1 100", "1", "1 1024 0", "1 0 1024", "1 0 0 1024", "1 -1 0", "1 0 0 4 5",
                                 "1 x 0", "1 on", "soon off", "-1 off", "0.1 0 0", "1 0 0x"}) {
    write("pen.txt", "0.5 off\n" + line + "\n");
    const Ran ran = run({"--load", "halt.oct", "--light-pen", "pen.txt"});
    EXPECT_EQ(ran.exit_code, 4) << line;
    EXPECT_TRUE(has(ran.err, "pen.txt:2: error: found")) << ran.err;
  }
  EXPECT_EQ(run({"--load", "halt.oct", "--light-pen", "none.txt"}).exit_code, 5);
}

}  // namespace
