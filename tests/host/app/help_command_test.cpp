// --help teaches every option, with examples; --version; the errors of a lost user.
#include "tests/host/app/command_line.hpp"

namespace {

using sightline::test::Arguments;
using sightline::test::has;

class HelpCommand : public sightline::test::CommandLine {
 protected:
  void expect_help(Arguments arguments, const std::vector<std::string>& names) {
    arguments.push_back("--help");
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.err, "");
    for (const std::string& name : names)
      EXPECT_TRUE(has(ran.out, name)) << name << " is missing in\n" << ran.out;
    EXPECT_TRUE(has(ran.out, "Exit codes: 0"));
    const std::size_t examples = ran.out.find("Examples:");
    ASSERT_NE(examples, std::string::npos) << ran.out;
    std::size_t count = 0;
    for (std::size_t at = examples; (at = ran.out.find("sightline ", at)) != std::string::npos; ++at) ++count;
    EXPECT_GE(count, 2U) << ran.out;
  }
};

TEST_F(HelpCommand, NamesEveryOption) {
  expect_help({}, {"asm", "disasm", "run", "scene", "jones", "skala", "draw", "spin", "sweep", "demo", "--version"});
  expect_help({"asm", "pdp7"},
              {"SOURCE", "-D", "-o", "--format", "rim", "hri", "octal", "--listing", "--symbols"});
  expect_help({"disasm", "pdp7"}, {"FILE", "-o"});
  expect_help({"disasm", "type340"}, {"FILE", "-o"});
  const std::vector<std::string> run{"--load",
                                     "--start",
                                     "--memory",
                                     "4k",
                                     "8k",
                                     "16k",
                                     "32k",
                                     "--eae",
                                     "--no-eae",
                                     "--set",
                                     "--switches",
                                     "--display",
                                     "--strict",
                                     "--max-time",
                                     "--max-instructions",
                                     "--dump",
                                     "--trace",
                                     "--strokes",
                                     "--png",
                                     "--svg",
                                     "--phosphor",
                                     "--json",
                                     "--reader",
                                     "--punch",
                                     "--keyboard",
                                     "--teletype",
                                     "--display-option",
                                     "--light-pen",
                                     "--timing",
                                     "eae_setup",
                                     "interrupt_cycles",
                                     "iot_stretch.DD"};
  expect_help({"run", "pdp7"}, run);
  expect_help({"run", "i8080"},
              {"--load",         "--start",      "--cpm",     "--clock",          "--set",     "--max-instructions",
               "--max-states",   "--strict",     "--board",   "--plotter",        "--dump",    "--trace",
               "--bus",          "--console",    "--png",     "--grey",           "--strokes", "--parallel", "--svg",
               "--parallel-out", "--serial",     "--serial-out", "--interrupt",   "--json",    "--plotter-start",
               "T SS AAAA DD"});
  expect_help({"run"}, {"pdp7", "i8080", "--load", "--phosphor", "--cpm"});
  expect_help({"scene", "tape"}, {"SCENE", "--at", "-o"});
  expect_help({"scene", "check"}, {"SCENE", "--json"});
  expect_help({"scene", "info"}, {"SCENE", "--json"});
  expect_help({"scene", "list"}, {"--json"});
  expect_help({"scene"}, {"tape", "check", "info", "list", "--at"});
  expect_help({"disasm"}, {"pdp7", "type340"});
  expect_help({"jones"}, {"SCENE", "--eae", "--no-eae", "--at", "--scale", "--switches", "--stereo",
                          "--immediate", "-o"});
  expect_help({"demo"}, {"-o"});
  for (const char* algorithm : {"exact", "jones", "oracle"}) {
    expect_help({"draw", algorithm},
                {"SCENE", "--eye", "--look-at", "--orthographic", "--forward", "--right", "--up", "--vertical",
                 "--field", "--all-edges", "--hidden", "--json", "-o", "--size", "--margin", "--pen", "--pixels"});
  }
  expect_help({"draw", "skala"},
              {"GRID", "--function", "--domain", "--slices", "--points", "--picture", "--along", "--rotate",
               "--elevate", "--levels", "--columns", "--no-visibility", "-o", "--pixels"});
  expect_help({"draw"}, {"exact", "jones", "skala", "oracle"});
  expect_help({"skala", "lines"}, {"--rotate", "-o"});
  expect_help({"sweep"}, {"SCENE", "--views", "--seed", "--shard", "--algorithm", "--guest", "--no-eae",
                          "--time", "--jobs", "-o", "parallel", "sbatch"});
}

TEST_F(HelpCommand, ShowsTheCommandAsItIsTyped) {
  EXPECT_TRUE(has(sightline({"run", "pdp7", "--help"}).out, "Usage: sightline run pdp7 [OPTIONS]"));
  EXPECT_TRUE(has(sightline({"scene", "tape", "--help"}).out, "Usage: sightline scene tape [OPTIONS] SCENE"));
}

TEST_F(HelpCommand, Version) {
  const auto ran = sightline({"--version"});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(ran.out.starts_with("sightline ")) << ran.out;
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 1);
}

TEST_F(HelpCommand, ALostUserIsToldWhatThereIs) {
  const auto nothing = sightline({});
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_TRUE(has(nothing.err, "asm")) << nothing.err;
  EXPECT_TRUE(has(nothing.err, "sightline --help")) << nothing.err;
  const auto unknown = sightline({"frobnicate"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_TRUE(has(unknown.err, "frobnicate")) << unknown.err;
  EXPECT_TRUE(has(sightline({"run", "pdp7", "--lode", "x"}).err, "--lode"));
}

}  // namespace
