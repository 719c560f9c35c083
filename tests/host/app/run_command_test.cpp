// `sightline run pdp7`: every option, every way to stop, every bad input.
//
// Expected registers, times and words are worked out by hand from the instruction list (1.75 us a cycle;
// memory references two cycles, JMP and OPR one).
#include <nlohmann/json.hpp>
#include <sstream>

#include "host/picture/png.hpp"
#include "tests/host/app/command_line.hpp"

namespace {

using nlohmann::json;
using sightline::test::Arguments;
using sightline::test::has;
using sightline::test::Ran;

class RunCommand : public sightline::test::CommandLine {
 protected:
  // LAC 103, TAD 104, HLT; 3 and 5.
  static constexpr const char* add = "00100: 200103 340104 740040 000003 000005\n";
  // JMP .
  static constexpr const char* forever = "00100: 600100\n";
  // Starts the display at 106 and waits for its stop interrupt, again and again. The file: scale 1, intensity
  // 7; y 400; x 400, lit; a vector of 100 to the right, lit, then mode 0; stop and interrupt.
  static constexpr const char* picture =
      "00100: 200105 700606 700601 600102 600100 000106 020117 220400 102400 600100 003000\n";
  // The same without a stop: modes 0 and 0 again, from 106 round through all of core.
  static constexpr const char* endless =
      "00100: 200105 700606 600102\n00105: 000106 020117 220400 102400 600100\n";

  Ran run(Arguments options) {
    options.insert(options.begin(), {"run", "pdp7"});
    return sightline(options);
  }
  json report(Arguments options) {
    options.push_back("--json");
    const Ran ran = run(std::move(options));
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return json::parse(ran.out, nullptr, false);
  }
};

TEST_F(RunCommand, JsonReport) {
  write("add.oct", add);
  const json r = report({"--load", "add.oct", "--start", "100"});
  EXPECT_EQ(r.at("schema"), "sightline/run-pdp7/1");
  EXPECT_EQ(r.at("stop_reason"), "halt");
  EXPECT_EQ(r.at("pc"), "00103");
  EXPECT_EQ(r.at("instructions"), 3);
  EXPECT_EQ(r.at("machine_cycles"), 5);
  EXPECT_EQ(r.at("emulated_ns"), 5 * 1750);
  EXPECT_EQ(r.at("stolen_cycles"), 0);
  EXPECT_EQ(r.at("display_words"), 0);
  EXPECT_EQ(r.at("passes"), 0);
  EXPECT_EQ(r.at("registers").at("ac"), "000010");
  EXPECT_EQ(r.at("machine").at("core_words"), 8192);
  EXPECT_EQ(r.at("machine").at("display"), false);
}

TEST_F(RunCommand, TableForAPerson) {
  write("add.oct", add);
  const Ran ran = run({"--load", "add.oct", "--start", "100"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(has(ran.out, "halt, PC 00103")) << ran.out;
  EXPECT_TRUE(has(ran.out, "0.000008750 s")) << ran.out;
  EXPECT_EQ(ran.err, "");
}

TEST_F(RunCommand, DumpAndTrace) {
  write("add.oct", add);
  ASSERT_EQ(run({"--load", "add.oct", "--start", "100", "--set", "MQ=654321", "--set", "L=1", "--set",
                 "SC=12", "--memory", "4k", "--dump", "core", "--trace", "trace"})
                .exit_code,
            0);
  const std::string dump = read("core");
  EXPECT_TRUE(dump.starts_with("00103 000010 1 654321 12\n")) << dump.substr(0, 100);
  EXPECT_EQ(std::count(dump.begin(), dump.end(), '\n'), 1 + 4096 / 8);
  EXPECT_TRUE(has(dump, "\n200103 340104 740040 000003 000005 000000 000000 000000\n"));
  std::istringstream lines(read("trace"));
  std::string first, second, third;
  std::getline(lines, first);
  std::getline(lines, second);
  std::getline(lines, third);
  const auto fields = [](const std::string& line) {
    std::istringstream stream(line);
    return std::vector<std::string>{std::istream_iterator<std::string>(stream), {}};
  };
  EXPECT_EQ(fields(first),
            (std::vector<std::string>{"0", "00100", "200103", "lac", "103", "000003", "1", "654321"}));
  EXPECT_EQ(fields(second),
            (std::vector<std::string>{"3500", "00101", "340104", "tad", "104", "000010", "1", "654321"}));
  EXPECT_EQ(fields(third),
            (std::vector<std::string>{"7000", "00102", "740040", "hlt", "000010", "1", "654321"}));
}

TEST_F(RunCommand, OutputsOnStandardOutputReplaceTheTable) {
  write("add.oct", add);
  const Ran ran = run({"--load", "add.oct", "--start", "100", "--trace", "-"});
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 3);
  EXPECT_FALSE(has(ran.out, "stopped by"));
}

TEST_F(RunCommand, WhereItStarts) {
  write("zero.oct", "00000: 750001 740040\n");  // CLC, HLT
  EXPECT_EQ(report({"--load", "zero.oct"}).at("pc"), "00002");
  write("add.s", "100/\n\tlac .+3\n\ttad .+3\n\thlt\n\t3\n\t5\n\tSTART 101\n");
  ASSERT_EQ(sightline({"asm", "pdp7", "add.s", "-o", "add.rim"}).exit_code, 0);
  EXPECT_EQ(report({"--load", "add.rim"}).at("registers").at("ac"), "000005");
  EXPECT_EQ(report({"--load", "add.rim", "--start", "100"}).at("registers").at("ac"), "000010");
  EXPECT_EQ(report({"--load", "add.rim", "--set", "PC=102"}).at("instructions"), 1);
  EXPECT_EQ(report({"--load", "add.rim", "--start", "100", "--set", "PC=102"}).at("instructions"), 1);
  // START turns the interrupt system off; --set comes after it.
  EXPECT_EQ(report({"--load", "add.rim", "--set", "ION=1"}).at("registers").at("ion"), 1);
}

TEST_F(RunCommand, RegistersAndSwitches) {
  write("halt.oct", "00000: 740040\n");
  const json r = report({"--load", "halt.oct", "--set", "AC=123456", "--set", "l=1", "--set", "MQ=7", "--set",
                         "SC=77", "--set", "SR=55", "--switches", "66"});
  EXPECT_EQ(r.at("registers"),
            json::parse(R"({"pc":"00001","ac":"123456","l":1,"mq":"000007","sc":"77","sr":"000055",
                                             "ion":0})"));
  write("las.oct", "00000: 750004 740040\n");
  EXPECT_EQ(report({"--load", "las.oct", "--switches", "707070"}).at("registers").at("ac"), "707070");
}

TEST_F(RunCommand, SwitchScript) {
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

TEST_F(RunCommand, Limits) {
  write("forever.oct", forever);
  const json by_count = report({"--load", "forever.oct", "--start", "100", "--max-instructions", "5000000"});
  EXPECT_EQ(by_count.at("stop_reason"), "instruction_limit");
  EXPECT_EQ(by_count.at("instructions"), 5000000);
  const json by_time = report({"--load", "forever.oct", "--start", "100", "--max-time", "0.175"});
  EXPECT_EQ(by_time.at("stop_reason"), "time_limit");
  EXPECT_EQ(by_time.at("instructions"), 100000);
  EXPECT_EQ(report({"--load", "forever.oct", "--max-instructions", "0"}).at("instructions"), 0);
}

TEST_F(RunCommand, CtrlCStopsCleanly) {
  write("forever.oct", forever);
  const Ran ran =
      sightline({"run", "pdp7", "--load", "forever.oct", "--start", "100", "--dump", "core", "--json"}, "",
                std::chrono::milliseconds(500));
  EXPECT_EQ(ran.exit_code, 130);
  EXPECT_EQ(json::parse(ran.out).at("stop_reason"), "interrupted");
  EXPECT_TRUE(read("core").starts_with("00100 "));
}

TEST_F(RunCommand, MemorySizes) {
  write("far.oct", "10000: 000001\n");
  const Ran small = run({"--load", "far.oct", "--memory", "4k"});
  EXPECT_EQ(small.exit_code, 4);
  EXPECT_TRUE(has(small.err, "far.oct: error: found a word for address 10000")) << small.err;
  EXPECT_EQ(report({"--load", "far.oct", "--max-instructions", "1"}).at("machine").at("extend_mode"), false);
  for (const auto& [size, words] : std::vector<std::pair<std::string, int>>{{"16k", 16384}, {"32K", 32768}}) {
    const json r = report({"--load", "far.oct", "--memory", size, "--max-instructions", "1"});
    EXPECT_EQ(r.at("machine").at("core_words"), words);
    EXPECT_EQ(r.at("machine").at("extend_mode"), true);
  }
  EXPECT_EQ(run({"--load", "far.oct", "--memory", "12k"}).exit_code, 2);
  EXPECT_EQ(run({"--load", "far.oct", "--start", "20000"}).exit_code, 2);
  EXPECT_EQ(run({"--load", "far.oct", "--set", "PC=20000"}).exit_code, 2);
  // EEM exists only above 8K: elsewhere nothing obeys it.
  write("eem.oct", "00000: 707702 740040\n");
  EXPECT_TRUE(report({"--load", "eem.oct", "--memory", "16k"}).at("unanswered").empty());
  EXPECT_EQ(report({"--load", "eem.oct"}).at("unanswered").at(0).at("word"), "707702");
}

TEST_F(RunCommand, EaePresentOrAbsent) {
  write("lmq.oct", "00000: 652000 740040\n");  // LMQ, HLT
  EXPECT_EQ(report({"--load", "lmq.oct", "--set", "AC=12"}).at("registers").at("mq"), "000012");
  EXPECT_EQ(report({"--load", "lmq.oct", "--set", "AC=12", "--eae"}).at("registers").at("mq"), "000012");
  const Ran without = run({"--load", "lmq.oct", "--set", "AC=12", "--no-eae", "--json"});
  EXPECT_EQ(json::parse(without.out).at("registers").at("mq"), "000000");
  EXPECT_TRUE(has(without.err, "warning: PC 00000: 652000")) << without.err;
  EXPECT_EQ(run({"--load", "lmq.oct", "--eae", "--no-eae"}).exit_code, 2);
}

TEST_F(RunCommand, OneWarningACode) {
  // Device 55 twice, the display that is not there once, HLT.
  write("odd.oct", "00100: 705512 705512 700606 740040\n");
  const Ran ran = run({"--load", "odd.oct", "--start", "100", "--json"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 2) << ran.err;
  EXPECT_TRUE(has(ran.err, "PC 00100: 705512")) << ran.err;
  EXPECT_TRUE(has(ran.err, "PC 00102: 700606")) << ran.err;
  EXPECT_EQ(json::parse(ran.out).at("unanswered").at(0).at("count"), 2);
  EXPECT_FALSE(has(run({"--load", "odd.oct", "--start", "100", "--display"}).err, "700606"));
}

TEST_F(RunCommand, StrictAndXctChainAreFailuresOfTheGuest) {
  write("odd.oct", "00100: 750001 705502 740040\n");
  const Ran strict = run({"--load", "odd.oct", "--start", "100", "--strict", "--json", "--dump", "core"});
  EXPECT_EQ(strict.exit_code, 3);
  EXPECT_TRUE(has(strict.err, "PC 00101")) << strict.err;
  EXPECT_EQ(json::parse(strict.out).at("stop_reason"), "strict");
  EXPECT_TRUE(read("core").starts_with("00102 777777 "));
  write("chain.oct", "00100: 400100\n");
  const Ran chain = run({"--load", "chain.oct", "--start", "100", "--json"});
  EXPECT_EQ(chain.exit_code, 3);
  EXPECT_TRUE(has(chain.err, "PC 00100")) << chain.err;
  EXPECT_EQ(json::parse(chain.out).at("stop_reason"), "xct_chain");
}

TEST_F(RunCommand, SeveralLoadsLaterOnesWin) {
  write("add.oct", add);
  write("patch.oct", "000011\n");
  for (const Arguments& loads : std::vector<Arguments>{{"--load", "add.oct", "patch.oct@104"},
                                                       {"--load", "add.oct", "--load", "patch.oct@104"}}) {
    Arguments options = loads;
    options.insert(options.end(), {"--start", "100"});
    EXPECT_EQ(report(options).at("registers").at("ac"), "000014");
  }
  write("add.s", "100/\n\tlac .+3\n\thlt\n\thlt\n\t77\n");
  ASSERT_EQ(sightline({"asm", "pdp7", "add.s", "--format", "hri", "-o", "add.hri"}).exit_code, 0);
  EXPECT_EQ(report({"--load", "add.hri@100", "--start", "100"}).at("registers").at("ac"), "000077");
  EXPECT_EQ(run({"--load", "add.hri", "--start", "100"}).exit_code, 4);
}

TEST_F(RunCommand, PictureOfTheLastCompletePass) {
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

TEST_F(RunCommand, ADisplayFileThatNeverStops) {
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

TEST_F(RunCommand, DisplayOptions) {
  // IDLA of a file that enters mode 3 (characters) at once, with a stop after it: without the 342 it hangs.
  write("text.oct", "00100: 200103 700606 600102 000104 060117 015437\n");
  const Arguments options{"--load", "text.oct", "--start", "100", "--max-time", "0.1", "--strokes", "s"};
  Arguments with = options;
  with.insert(with.end(), {"--display-option", "342"});
  ASSERT_EQ(run(options).exit_code, 0);
  EXPECT_EQ(read("s"), "");
  ASSERT_EQ(run(with).exit_code, 0);
  EXPECT_NE(read("s"), "");
  EXPECT_EQ(run({"--display-option", "999", "--max-instructions", "1"}).exit_code, 2);
}

TEST_F(RunCommand, TapeReaderPunchAndTeletype) {
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

TEST_F(RunCommand, KeyboardScript) {
  // KSF, JMP .-1, KRB, SAD 111, HLT, TLS, TSF, JMP .-1, JMP 100; 111: what carriage return comes as.
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

TEST_F(RunCommand, BadFiles) {
  write("bad.oct", "00100: 200103 34010x\n");
  const Ran ran = run({"--load", "bad.oct", "--dump", "core"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "bad.oct:1:15")) << ran.err;
  EXPECT_FALSE(exists("core"));
  EXPECT_EQ(run({"--load", "none"}).exit_code, 5);
  EXPECT_EQ(run({"--load", "."}).exit_code, 5);
}

TEST_F(RunCommand, OutputsThatCannotBeWrittenAreKnownBeforeTheRun) {
  write("forever.oct", forever);
  const Ran ran = run({"--load", "forever.oct", "--start", "100", "--dump", "core", "--png", "no/where.png"});
  EXPECT_EQ(ran.exit_code, 5);
  EXPECT_TRUE(has(ran.err, "no/where.png")) << ran.err;
  EXPECT_EQ(files(), std::vector<std::string>{"forever.oct"});
}

TEST_F(RunCommand, WrongUsage) {
  write("add.oct", add);
  for (const Arguments& wrong : std::vector<Arguments>{{"--load"},
                                                       {"--load", "add.oct", "--start", "8"},
                                                       {"--load", "add.oct", "--start", "-1"},
                                                       {"--load", "add.oct@100000"},
                                                       {"--load", "add.oct", "--set", "XX=1"},
                                                       {"--load", "add.oct", "--set", "AC"},
                                                       {"--load", "add.oct", "--set", "AC=1000000"},
                                                       {"--load", "add.oct", "--set", "L=2"},
                                                       {"--load", "add.oct", "--set", "SC=100"},
                                                       {"--load", "add.oct", "--max-instructions", "many"},
                                                       {"--load", "add.oct", "--max-instructions", "-1"},
                                                       {"--load", "add.oct", "--max-time", "-1"},
                                                       {"--load", "add.oct", "--max-time", "nan"},
                                                       {"--load", "add.oct", "--max-time", "1e99"},
                                                       {"--load", "add.oct", "--dump", "x", "--trace", "x"},
                                                       {"--load", "add.oct", "--dump", "-", "--json"}}) {
    const Ran ran = run(wrong);
    EXPECT_EQ(ran.exit_code, 2) << ran.err;
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(files(), std::vector<std::string>{"add.oct"});
  }
}

TEST_F(RunCommand, SameBytesEveryTime) {
  write("picture.oct", picture);
  std::vector<std::string> first;
  for (int turn = 0; turn < 2; ++turn) {
    const Ran ran =
        run({"--load", "picture.oct", "--start", "100", "--max-time", "0.01", "--dump", "d", "--trace", "t",
             "--strokes", "s", "--png", "p", "--phosphor", "f", "--svg", "v", "--json"});
    ASSERT_EQ(ran.exit_code, 0);
    const std::vector<std::string> all{ran.out,   read("d"), read("t"), read("s"),
                                       read("p"), read("f"), read("v")};
    for (const std::string& text : all) EXPECT_FALSE(text.empty());
    if (turn == 0) first = all;
    EXPECT_EQ(all, first);
  }
}

}  // namespace
