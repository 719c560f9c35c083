// `sightline run pdp7`: the machine and its core, all ways to stop, reports, bad input.
//
// Expected registers, times and words are computed by hand from the instruction list (1.75 us per cycle; memory references take
// two
// cycles, JMP and OPR one).
#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/host/app/run_fixture.hpp"
#include "tests/support/effort.hpp"

namespace {

using nlohmann::json;
using sightline::test::Arguments;
using sightline::test::has;
using sightline::test::Ran;

class RunCommand : public sightline::test::RunPdp7 {};

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
  EXPECT_TRUE(has(ran.err, "stopped by      halt, PC 00103")) << ran.err;
}

// A run that is dumped and continued from the dump leaves the same state as the complete run.
TEST_F(RunCommand, ADumpContinuesTheRun) {
  // Counts without MQ: ISZ of 200, SZL, CML, TAD of 201, JMP: registers and core change in every round.
  write("loop.oct", "00100: 440200 741400 740002 340201 600100\n00200: 777770 000013\n");
  ASSERT_EQ(run({"loop.oct", "--start", "100", "--set", "MQ=123", "--max-instructions", "1e3", "--dump", "whole"}).exit_code, 0);
  ASSERT_EQ(run({"loop.oct", "--start", "100", "--set", "MQ=123", "--max-instructions", "399", "--dump", "part"}).exit_code, 0);
  EXPECT_NE(read("part"), read("whole"));
  const Ran rest = run({"part", "--max-instructions", "601", "--dump", "joined"});
  EXPECT_EQ(rest.exit_code, 0) << rest.err;
  EXPECT_EQ(read("joined"), read("whole"));
  // --start and --set apply after the loads.
  EXPECT_EQ(report({"part", "--start", "200", "--max-instructions", "0"}).at("pc"), "00200");
  EXPECT_EQ(report({"part", "--set", "MQ=7", "--max-instructions", "0"}).at("registers").at("mq"), "000007");
  EXPECT_EQ(report({"part", "--max-instructions", "0"}).at("registers").at("mq"), "000123");
  // Also from a pipe, and into a larger core.
  EXPECT_EQ(sightline({"run", "pdp7", "-", "--memory", "16k", "--max-instructions", "601"}, read("part")).exit_code, 0);
}

TEST_F(RunCommand, DumpsThatAreDamaged) {
  write("halt.oct", "00000: 740040\n");
  ASSERT_EQ(run({"halt.oct", "--memory", "4k", "--dump", "good"}).exit_code, 0);
  const std::string good = read("good");
  const auto refused = [this](const std::string& text, std::string_view message) {
    write("bad", text);
    const Ran ran = run({"bad", "--memory", "4k"});
    EXPECT_EQ(ran.exit_code, 4) << ran.err;
    EXPECT_TRUE(has(ran.err, message)) << ran.err;
  };
  const std::size_t third = good.find('\n', good.find('\n') + 1) + 1;
  refused(good.substr(0, third) + "12\n", "bad: line 3: found \"12\", expected a word, octal with 6 digits");
  refused(good.substr(0, third) + "000008\n", "bad: line 3: found \"000008\"");
  refused(good + "000000\n", "found a word for address 10000");
  write("bad", good);
  EXPECT_TRUE(has(run({"bad@100", "--memory", "4k"}).err, "a dump begins at 0"));
  // Word 32,769 is outside every core.
  ASSERT_EQ(run({"halt.oct", "--memory", "32k", "--dump", "large"}).exit_code, 0);
  write("bad", read("large") + "000000\n");
  EXPECT_TRUE(has(run({"bad", "--memory", "32k"}).err, "expected 32768 words at most"));
}

TEST_F(RunCommand, CountsMayHaveAnExponent) {
  write("forever.oct", forever);
  EXPECT_EQ(report({"forever.oct", "--start", "100", "--max-instructions", "1e3"}).at("instructions"), 1000);
  EXPECT_TRUE(has(run({"forever.oct", "--max-instructions", "1.5"}).err, "expected a whole decimal number such as"));
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
  // START turns the interrupt system off; --set applies after it.
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
      run_interrupted({"run", "pdp7", "--load", "forever.oct", "--start", "100", "--dump", "core", "--json"});
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
  // EEM exists only above 8K: elsewhere it has no effect.
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
  // Device 55 twice, the absent display once, HLT.
  write("odd.oct", "00100: 705512 705512 700606 740040\n");
  const Ran ran = run({"--load", "odd.oct", "--start", "100", "--no-display", "--json"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 2) << ran.err;
  EXPECT_TRUE(has(ran.err, "PC 00100: 705512")) << ran.err;
  EXPECT_TRUE(has(ran.err, "PC 00102: 700606")) << ran.err;
  EXPECT_EQ(json::parse(ran.out).at("unanswered").at(0).at("count"), 2);
  EXPECT_FALSE(has(run({"--load", "odd.oct", "--start", "100"}).err, "700606"));
}

// Device 55 and JMP 100, longer than the command runs silently: the warning comes once, before the end of the run.
TEST_F(RunCommand, WarnsWhileTheProgramRuns) {
  write("waits.oct", "00100: 705512 600100\n");
  const Ran ran = run({"--load", "waits.oct", "--start", "100", "--max-instructions", "20000000", "--json"});
  const std::size_t first = ran.err.find("PC 00100: 705512 does nothing, no device 55 in this machine obeys it (");
  ASSERT_NE(first, std::string::npos) << ran.err;
  EXPECT_TRUE(has(ran.err, " times so far)")) << ran.err;
  EXPECT_EQ(ran.err.find("705512", first + 20), std::string::npos) << ran.err;
  EXPECT_EQ(json::parse(ran.out).at("unanswered").at(0).at("count"), 10'000'000);
  // A shorter run has the warning at its end, with the whole count.
  EXPECT_TRUE(has(run({"--load", "waits.oct", "--start", "100", "--max-instructions", "6"}).err, "obeys it (3 times)"));
}

// The program runs the same with a display attached from the beginning and with one connected at its first use.
TEST_F(RunCommand, TheDisplayIsConnectedAtItsFirstUse) {
  write("picture.oct", picture);
  const Arguments program{"picture.oct", "--start", "100", "--max-time", "0.02", "--json", "--trace", "trace", "--dump", "dump", "--save", "snap"};
  const auto with = [&program](const std::string& option) {
    Arguments all = program;
    all.push_back(option);
    return all;
  };
  const Ran always = run(with("--display"));
  const std::vector<std::string> kept{read("trace"), read("dump"), read("snap")};
  const Ran used = run(program);
  EXPECT_EQ(used.err, "");
  EXPECT_EQ(used.out, always.out);
  EXPECT_EQ(json::parse(used.out).at("machine").at("display"), true);
  EXPECT_GT(json::parse(used.out).at("passes"), 10);
  EXPECT_TRUE(kept == (std::vector<std::string>{read("trace"), read("dump"), read("snap")}));
  const Ran without = run(with("--no-display"));
  EXPECT_EQ(json::parse(without.out).at("machine").at("display"), false);
  EXPECT_EQ(json::parse(without.out).at("display_words"), 0);
  EXPECT_TRUE(has(without.err, "PC 00101: 700606 does nothing, no device 06 in this machine obeys it")) << without.err;
  write("add.oct", add);
  EXPECT_EQ(report({"add.oct", "--start", "100"}).at("machine").at("display"), false);
  EXPECT_FALSE(has(run({"add.oct", "--start", "100"}).out, "display"));
  // IDLA stops a strict run of a machine without display. An output of the display needs one.
  EXPECT_EQ(run({"picture.oct", "--start", "100", "--strict", "--no-display"}).exit_code, 3);
  EXPECT_EQ(run({"picture.oct", "--start", "100", "--strict", "--max-time", "0.01"}).exit_code, 0);
  for (const char* const option : {"--png", "--svg", "--phosphor", "--movie", "--strokes"})
    EXPECT_EQ(run({"add.oct", "--start", "100", "--no-display", option, "out"}).exit_code, 2) << option;
  EXPECT_EQ(run({"add.oct", "--start", "100", "--no-display", "--display"}).exit_code, 2);
}

// 700547 is an instruction of a Graphic-2, which a kernel of 1970 executes without one; 700601 is IDSI of the Type 340.
TEST_F(RunCommand, AGraphic2IsNotAType340) {
  write("graphic.oct", "00100: 700547 740040 700601 740040\n");
  EXPECT_EQ(report({"graphic.oct", "--start", "100"}).at("machine").at("display"), false);
  EXPECT_EQ(report({"graphic.oct", "--start", "102"}).at("machine").at("display"), true);
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

TEST_F(RunCommand, BadFiles) {
  write("bad.oct", "00100: 200103 34010x\n");
  const Ran ran = run({"--load", "bad.oct", "--dump", "core"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "bad.oct:1:15")) << ran.err;
  EXPECT_FALSE(exists("core"));
  EXPECT_EQ(run({"--load", "none"}).exit_code, 5);
  EXPECT_EQ(run({"--load", "."}).exit_code, 5);
}

TEST_F(RunCommand, UnwritableOutputsAreReportedBeforeTheRun) {
  write("forever.oct", forever);
  const Ran ran = run({"--load", "forever.oct", "--start", "100", "--dump", "core", "--png", "no/where.png"});
  EXPECT_EQ(ran.exit_code, 5);
  EXPECT_TRUE(has(ran.err, "no/where.png")) << ran.err;
  EXPECT_EQ(files(), std::vector<std::string>{"forever.oct"});
}

TEST_F(RunCommand, AProgramNeedsNoOption) {
  write("add.oct", add);
  const Ran named = run({"--load", "add.oct", "--start", "100", "--json"});
  const Ran ran = run({"add.oct", "--start", "100", "--json"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(ran.out, named.out);
}

// 3 and 5, in one source and in two, and in the language of Bell Laboratories, whose programs begin at 0.
TEST_F(RunCommand, SourcesAreAssembled) {
  write("add.s", "100/\nbegin, lac (3\n tad (5\n hlt\n start begin\n");
  EXPECT_EQ(report({"add.s"}).at("registers").at("ac"), "000010");
  write("first.s", "100/\nbegin, lac three\n tad five\n hlt\nthree, 3\n");
  write("second.s", "five, 5\n start begin\n");
  EXPECT_EQ(report({"first.s", "second.s"}).at("registers").at("ac"), "000010");
  write("bell.s", ".. = 0\n lac d3\n tad d3\n hlt\nd3: 3\n");
  EXPECT_EQ(report({"bell.s", "--dialect", "bell"}).at("registers").at("ac"), "000006");
  write("wrong.s", "100/\n lac foo\n");
  const Ran ran = run({"wrong.s"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_EQ(ran.out, "");
  EXPECT_TRUE(has(ran.err, "wrong.s:2:6: error: found undefined symbol 'foo'")) << ran.err;
  const Ran monitored = sightline({"monitor", "pdp7", "wrong.s"});
  EXPECT_EQ(monitored.exit_code, ran.exit_code);
  EXPECT_EQ(monitored.err, ran.err);
}

TEST_F(RunCommand, ASourceAtAnAddressIsAnErrorThatNamesTheAssembler) {
  write("add.s", "100/\n hlt\n start 100\n");
  const Ran ran = run({"add.s@100"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "add.s: found a source file, expected an assembled program; assemble it with: "
                           "sightline asm pdp7 add.s -o PROGRAM"))
      << ran.err;
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
  NEEDS_OPTIMISED_CODE();
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

// 3 cycles of 1750 ns and the EAE steps that its description gives; IORS with 500 ns more; a clock whose first tick, at the first
// boundary after its period, interrupts and halts.
TEST_F(RunCommand, TimesThatCanBeSet) {
  write("mul.oct", "00000: 653122 000007 740040\n");  // 18 steps
  write("div.oct", "00000: 653323 000007 740040\n");  // 19
  write("norm.oct", "00000: 640444 740040\n");        // of 000007: 14
  write("lls.oct", "00000: 640621 740040\n");         // 17
  write("lmq.oct", "00000: 652000 740040\n");
  write("iors.oct", "00000: 700314 740040\n");
  write("clock.oct", "00000: 600100\n00001: 740040\n00007: 777777\n00100: 700044 700042 600102\n");
  struct Case {
    std::string file, setting;
    int expected_ns;
  };
  for (const Case& c : std::vector<Case>{{"mul.oct", "eae_multiply_step=100", 5250 + 1800},
                                         {"div.oct", "eae_divide_step=100", 5250 + 1900},
                                         {"norm.oct", "eae_normalize_step=100", 3500 + 1400},
                                         {"lls.oct", "eae_shift_step=100", 3500 + 1700},
                                         {"lmq.oct", "eae_setup=123", 3500 + 123},
                                         {"iors.oct", "iot_stretch.03=500", 3500 + 500},
                                         {"iors.oct", "iot_stretch.04=500", 3500},
                                         {"clock.oct", "clock_hertz=50", 20'000'750 + 5250},
                                         {"clock.oct", "clock_hertz=400", 2'500'750 + 5250},
                                         {"clock.oct", "interrupt_cycles=3", 20'000'750 + 5250 + 3500},
                                         {"clock.oct", "clock_tick_cycles=2", 20'000'750 + 5250 + 1750}}) {
    const json r = report({"--load", c.file, "--set", "AC=7", "--timing", c.setting, "--max-time", "1"});
    EXPECT_EQ(r.at("emulated_ns"), c.expected_ns) << c.file << " " << c.setting;
    EXPECT_EQ(r.at("stop_reason"), "halt");
  }
  const json r = report({"--load", "mul.oct", "--timing", "reader_line=7", "--timing", "iot_stretch.77=1",
                         "--timing", "reader_line=8"});
  EXPECT_EQ(r.at("timing"), json::parse(R"({"reader_line":8,"iot_stretch.77":1})"));
  EXPECT_EQ(report({"--load", "mul.oct"}).at("timing"), json::object());
}

TEST_F(RunCommand, TimesThatCannotBeSet) {
  write("halt.oct", "00000: 740040\n");
  for (const auto& [setting, word] :
       std::vector<std::pair<std::string, std::string>>{{"eae_setup", "found \"\""},
                                                        {"eae_setup=", "found \"\""},
                                                        {"eae_setup=fast", "found \"fast\""},
                                                        {"eae_setup=1.5", "found \"1.5\""},
                                                        {"eae_setup=-1", "0 to 10000 (ns)"},
                                                        {"eae_setup=10001", "0 to 10000 (ns)"},
                                                        {"eae_setup=99999999999999999999", "0 to 10000 (ns)"},
                                                        {"clock_hertz=0", "1 to 400 (Hz)"},
                                                        {"interrupt_cycles=101", "1 to 100 (cycles)"},
                                                        {"machine_cycle=1", "eae_setup eae_shift_step"},
                                                        {"=1", "NAME=VALUE"},
                                                        {"iot_stretch=1", "iot_stretch.DD"},
                                                        {"iot_stretch.3=1", "two octal digits"},
                                                        {"iot_stretch.08=1", "two octal digits"},
                                                        {"iot_stretch.100=1", "two octal digits"},
                                                        {"iot_stretch.DD=1", "two octal digits"}}) {
    const Ran ran = run({"--load", "halt.oct", "--timing", setting});
    EXPECT_EQ(ran.exit_code, 2) << setting;
    EXPECT_TRUE(has(ran.err, "--timing")) << ran.err;
    EXPECT_TRUE(has(ran.err, word)) << ran.err;
  }
}

}  // namespace
