// --help teaches every option, with examples; --version; the errors of a lost user.
#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "host/algorithms/registry/faces.hpp"
#include "host/algorithms/registry/heights.hpp"
#include "host/algorithms/registry/lines.hpp"
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
  expect_help({"run"}, {"pdp7", "i8080", "--load", "--cpm", "sightline run SUBCOMMAND --help"});
  expect_help({"scene", "tape"}, {"SCENE", "--at", "--eye", "-o"});
  expect_help({"scene", "check"}, {"SCENE", "--json"});
  expect_help({"scene", "info"}, {"SCENE", "--json"});
  expect_help({"scene", "list"}, {"--json"});
  expect_help({"scene"}, {"tape", "check", "info", "list", "convert", "generate", "decompose"});
  expect_help({"disasm"}, {"pdp7", "type340"});
  expect_help({"jones"}, {"SCENE", "--eae", "--no-eae", "--at", "--eye", "--scale", "--switches", "--stereo",
                          "--immediate", "-o"});
  expect_help({"demo"}, {"-o"});
  for (const char* algorithm : {"exact", "jones", "oracle"}) {
    expect_help({"draw", algorithm},
                {"SCENE", "--eye", "--look-at", "--orthographic", "--forward", "--right", "--up", "--vertical",
                 "--field", "--all-edges", "--hidden", "--json", "-o", "--size", "--margin", "--pen", "--pixels"});
  }
  expect_help({"draw", "skala"},
              {"GRID", "--function", "--domain", "--slices", "--points", "--picture", "--along", "--rotate",
               "--elevate", "--levels", "--columns", "--no-visibility", "-o", "--pixels", "--json"});
  expect_help({"compare"},
              {"SCENE", "--view", "--eye", "--eae", "--no-eae", "--picture", "guest", "twin", "native"});
  expect_help({"spin"}, {"SCENE", "--size", "--pixels", "--events", "Plantinga"});
  expect_help({"draw"}, {"exact", "jones", "skala", "oracle"});
  expect_help({"skala", "lines"}, {"--rotate", "-o"});
  expect_help({"sweep"}, {"SCENE", "--views", "--seed", "--shard", "--algorithm", "--guest", "--eae",
                          "--no-eae", "--time", "--jobs", "-o", "parallel", "sbatch"});
}

// The subcommands that a help lists.
std::vector<std::string> listed_subcommands(const std::string& help) {
  std::vector<std::string> names;
  std::istringstream lines(help);
  std::string line;
  bool listed = false;
  while (std::getline(lines, line)) {
    if (line == "Subcommands:" || line.empty()) listed = line == "Subcommands:";
    if (listed && line.starts_with("  ") && line[2] != ' ')
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

// What the option parser itself would say: types of its own, sets of numbers behind names.
void expect_plain_words(const std::string& line) {
  EXPECT_FALSE(has(line, "->") || has(line, " OR {") || has(line, ":{")) << line;
  if (!line.starts_with("  -")) return;
  for (const char* type : {" TEXT", "UINT", " INT", "FLOAT", "REQUIRED", "Excludes:"})
    EXPECT_FALSE(has(line.substr(0, 28), type)) << line;
}

TEST_F(HelpCommand, EveryLineFitsAndIsInPlainWords) {
  std::vector<Arguments> commands{{}};
  for (std::size_t n = 0; n < commands.size(); ++n) {
    Arguments arguments = commands[n];
    arguments.emplace_back("--help");
    const std::string help = sightline(arguments).out;
    for (const std::string& name : listed_subcommands(help)) {
      commands.push_back(commands[n]);
      commands.back().push_back(name);
    }
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_LE(line.size(), 100U) << line;
      expect_plain_words(line);
    }
    EXPECT_FALSE(has(help, "\n\n\n")) << help;
  }
  EXPECT_GE(commands.size(), 35U) << "subcommands are not found in the help";
}

TEST_F(HelpCommand, IsAsWideAsTheTerminal) {
  ::setenv("COLUMNS", "60", 1);
  std::istringstream narrow(sightline({"jones", "--help"}).out);
  ::setenv("COLUMNS", "none", 1);
  const std::string unknown = sightline({"jones", "--help"}).out;
  ::unsetenv("COLUMNS");
  EXPECT_EQ(unknown, sightline({"jones", "--help"}).out);
  std::size_t longest = 0;
  for (std::string line; std::getline(narrow, line);) longest = std::max(longest, line.size());
  EXPECT_LE(longest, 60U);
  EXPECT_GT(longest, 50U);
}

TEST_F(HelpCommand, ACommandOfMethodsListsThemALineEach) {
  const std::string help = sightline({"draw", "--help"}).out;
  const auto methods = listed_subcommands(help);
  std::vector<std::string> registered;
  const auto add = [&registered](std::string_view name) {
    if (!name.empty() && std::find(registered.begin(), registered.end(), name) == registered.end())
      registered.emplace_back(name);
  };
  for (const auto& algorithm : sightline::registry::line_algorithms()) add(algorithm.name);
  for (const auto& algorithm : sightline::registry::face_algorithms()) add(algorithm.name);
  for (const auto& method : sightline::registry::height_methods()) add(method.algorithm);
  EXPECT_EQ(methods, registered);
  EXPECT_FALSE(has(help, "--vertical")) << help;
  const std::string all = sightline({"--help"}).out;
  const std::string line =
      all.substr(all.find("\n  draw "), all.find("\n  compare ") - all.find("\n  draw "));
  for (const std::string& method : methods) EXPECT_TRUE(has(line, method)) << line;
  for (const char* word : {"guest ", "twin ", "native ", "oracle "})
    EXPECT_TRUE(has(all.substr(all.find("Words:")), word)) << word;
}

TEST_F(HelpCommand, OptionsWithoutEffectAreNotOffered) {
  EXPECT_TRUE(has(sightline({"skala", "lines", "--help"}).out, "--both"));
  for (const char* picture : {"surface", "contours"}) {
    const std::string help = sightline({"skala", picture, "--help"}).out;
    EXPECT_FALSE(has(help.substr(0, help.find("Examples:")), "--both")) << help;
  }
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
