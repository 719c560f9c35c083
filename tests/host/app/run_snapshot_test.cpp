// `sightline run --save` and `--restore`, as a user runs them.
#include <gtest/gtest.h>

#include <string>

#include "tests/host/app/run_fixture.hpp"

namespace sightline::test {
namespace {

class RunSnapshot : public RunPdp7 {
 protected:
  // The text after its first `lines` lines.
  static std::string after_lines(const std::string& text, std::size_t lines) {
    std::size_t at = 0;
    for (; lines > 0 && at != std::string::npos; --lines) at = text.find('\n', at) + 1;
    return text.substr(at);
  }
};

TEST_F(RunSnapshot, ContinuesTheRun) {
  write("picture.oct", picture);
  const Arguments start{"picture.oct", "--start", "100", "--display"};
  const auto with = [](Arguments first, const Arguments& more) {
    first.insert(first.end(), more.begin(), more.end());
    return first;
  };
  ASSERT_EQ(run(with(start, {"--max-instructions", "1500", "--trace", "t", "--strokes", "s", "--dump", "d"}))
                .exit_code,
            0);
  ASSERT_EQ(
      run(with(start, {"--max-instructions", "471", "--trace", "t1", "--strokes", "s1", "--save", "a.snap"}))
          .exit_code,
      0);
  const auto rest = report({"--restore", "a.snap", "--display", "--max-instructions", "1029", "--trace", "t2",
                            "--strokes", "s2", "--dump", "d2"});
  EXPECT_EQ(read("t"), read("t1") + read("t2"));
  EXPECT_EQ(read("s"), read("s1") + read("s2"));
  EXPECT_EQ(read("d"), read("d2"));
  EXPECT_EQ(rest.at("instructions"), 1500);
  EXPECT_EQ(rest.at("restored_from"), "a.snap");
  EXPECT_FALSE(rest.contains("saved_to"));
  // Time limits count from the snapshot, too; registers can be set; a snapshot can be saved over itself and be piped.
  EXPECT_EQ(report({"--restore", "a.snap", "--display", "--max-time", "0"}).at("instructions"), 471);
  EXPECT_EQ(report({"--restore", "a.snap", "--display", "--max-instructions", "0", "--set", "AC=17"})
                .at("registers")
                .at("ac"),
            "000017");
  const auto saved =
      report({"--restore", "a.snap", "--display", "--max-instructions", "29", "--save", "a.snap"});
  EXPECT_EQ(saved.at("saved_to"), "a.snap");
  const Ran piped =
      sightline({"run", "pdp7", "--restore", "-", "--display", "--max-instructions", "1000", "--dump", "d3"},
                read("a.snap"));
  EXPECT_EQ(piped.exit_code, 0) << piped.err;
  EXPECT_EQ(read("d3"), read("d"));
}

// The connected display is part of the state: a machine is restored with or without it, however it was requested.
TEST_F(RunSnapshot, HasTheDisplayIfTheProgramHasUsedIt) {
  write("picture.oct", picture);
  for (const char* const before : {"1", "100"}) {
    ASSERT_EQ(run({"picture.oct", "--start", "100", "--max-instructions", "1000", "--dump", "whole"}).exit_code, 0);
    ASSERT_EQ(run({"picture.oct", "--start", "100", "--max-instructions", before, "--save", "a.snap"}).exit_code, 0);
    const std::string rest = std::to_string(1000 - std::stoi(before));
    for (const Arguments& option : std::vector<Arguments>{{}, {"--display"}, {"--png", "a.png"}}) {
      Arguments all{"--restore", "a.snap", "--max-instructions", rest, "--dump", "d"};
      all.insert(all.end(), option.begin(), option.end());
      const auto r = report(all);
      EXPECT_EQ(r.at("machine").at("display"), true);
      EXPECT_EQ(r.at("instructions"), 1000);
      EXPECT_EQ(read("d"), read("whole"));
    }
  }
}

TEST_F(RunSnapshot, ContinuesAn8080) {
  // MVI C 2; INR E; CALL 5; JMP 102
  write("print.com", std::string_view("\x0E\x02\x1C\xCD\x05\x00\xC3\x02\x01", 9));
  ASSERT_EQ(sightline({"run", "i8080", "--cpm", "print.com", "--max-instructions", "900", "--console-out", "c"})
                .exit_code,
            0);
  ASSERT_EQ(sightline({"run", "i8080", "--cpm", "print.com", "--max-instructions", "403", "--console-out", "c1",
                       "--save", "a.snap"})
                .exit_code,
            0);
  const Ran rest = sightline(
      {"run", "i8080", "--cpm", "--restore", "a.snap", "--max-instructions", "497", "--console-out", "c2"});
  EXPECT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(read("c"), read("c1") + read("c2"));
}

TEST_F(RunSnapshot, RejectsContradictoryOptions) {
  write("add.oct", add);
  ASSERT_EQ(run({"add.oct", "--start", "100", "--save", "a.snap"}).exit_code, 0);
  const auto refused = [this](Arguments options, int exit_code, std::string_view message) {
    options.insert(options.begin(), {"--restore", "a.snap"});
    options.insert(options.end(), {"--dump", "never"});
    const Ran ran = run(std::move(options));
    EXPECT_EQ(ran.exit_code, exit_code) << ran.err;
    EXPECT_TRUE(has(ran.err, message)) << ran.err;
    EXPECT_FALSE(exists("never"));
  };
  refused({"--load", "add.oct"}, 2,
          "--restore: found a PROGRAM too, expected one of them: the snapshot holds what it gives");
  refused({"--start", "100"}, 2, "--restore: found --start too");
  refused({"--switches", "5"}, 2, "--restore: found --switches too");
  refused({"--memory", "4k", "--no-eae"}, 4,
          "a.snap: configuration: found a machine with --memory 4k --no-eae and without --memory 8k --eae, "
          "expected that of "
          "the snapshot; add --memory 8k --eae, leave out --no-eae");
  refused({"--no-display"}, 4, "found a machine with --no-display, expected that of the snapshot; leave out --no-display");
  for (const char* const machine : {"pdp7", "i8080"}) {
    const Ran ran = sightline({"run", machine, "a.snap"});
    EXPECT_EQ(ran.exit_code, 4);
    EXPECT_TRUE(
        has(ran.err, "a.snap: found a snapshot, expected a program; continue from it with: sightline run " +
                         std::string(machine) + " --restore a.snap"))
        << ran.err;
  }
  write("tape", "x");
  refused({"--reader", "tape"}, 4, "found another input: 1 bytes");
  write("a.snap", read("a.snap") + "x");
  refused({}, 4, "a.snap: byte 12: found a file of");
  write("a.snap", add);
  refused({}, 4, "a.snap: byte 0: found no signature of a snapshot, expected a file that --save has written");
  EXPECT_TRUE(has(run({"--restore", "none.snap"}).err, "none.snap"));
  EXPECT_TRUE(has(run({"--save", "b.snap"}).err, "needs a PROGRAM"));
}

}  // namespace
}  // namespace sightline::test
