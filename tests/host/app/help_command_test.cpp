// --help explains every option, with examples; --version; the errors for unknown names.
#include <algorithm>
#include <cstdlib>
#include <map>
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
  expect_help({}, {"asm", "disasm", "run", "scene", "jones", "skala", "draw", "spin", "stripes", "turn", "flight", "sweep", "atlas", "demo", "hard", "--version"});
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
                                     "--no-display",
                                     "--dialect",
                                     "--strict",
                                     "--max-time",
                                     "--max-instructions",
                                     "--dump",
                                     "--trace",
                                     "--strokes",
                                     "--png",
                                     "--svg",
                                     "--phosphor",
                                     "--movie",
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
               "--bus",          "--console-out", "--console", "--png",     "--grey",           "--strokes", "--parallel", "--svg",
               "--parallel-out", "--serial",     "--serial-out", "--interrupt",   "--json",    "--plotter-start", "--hold",
               "T SS AAAA DD"});
  expect_help({"run"}, {"pdp7", "i8080", "--cpm", "sightline run SUBCOMMAND --help"});
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
              {"GRID", "--function", "--domain", "--x-range", "--y-range", "--xyz", "--layout", "--nodata", "--thin", "--triangulate", "--axes", "--aspect", "--stretch", "--title", "--labels", "--floor", "--colours", "--slices", "--points", "--picture", "--along", "--rotate",
               "--elevate", "--levels", "--columns", "--no-visibility", "-o", "--pixels", "--json"});
  expect_help({"compare"},
              {"SCENE", "--view", "--eye", "--eae", "--no-eae", "--picture", "--fraction", "--methods", "--views", "--seed", "--no-host-times", "twin", "native"});
  expect_help({"stripes"}, {"SCENE", "--device", "raster", "calcomp", "--stripes", "--priority", "host", "--json", "Montani"});
  expect_help({"flight"}, {"SCENE", "--bits", "--plan", "--pieces", "--frames", "Willis"});
  expect_help({"turn"}, {"MODEL", "--no-eae", "--memory", "--frames", "--level", "Plantinga"});
  expect_help({"spin"}, {"SCENE", "--size", "--pixels", "--events", "Plantinga"});
  expect_help({"draw"}, {"exact", "jones", "skala", "oracle"});
  expect_help({"skala", "lines"}, {"--rotate", "-o"});
  expect_help({"hard"}, {"CASE", "--list", "--json", "-o"});
  expect_help({"atlas"}, {"SCENE", "--lattice", "--height", "--views", "--seed", "--eae", "--no-eae", "--fraction", "--jobs", "-o",
                          "--json", "mask corner"});
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

// The option parser's own texts: type names, and sets of numbers after names.
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
      EXPECT_LE(line.size(), 80U) << line;
      expect_plain_words(line);
    }
    EXPECT_FALSE(has(help, "\n\n\n")) << help;
  }
  EXPECT_GE(commands.size(), 35U) << "found too few subcommands in the help";
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
  longest = 0;
  std::istringstream usual(unknown);
  for (std::string line; std::getline(usual, line);) longest = std::max(longest, line.size());
  EXPECT_LE(longest, 80U);
  EXPECT_GT(longest, 70U);
}

TEST_F(HelpCommand, ACommandWithMethodsListsOnePerLine) {
  const std::string help = sightline({"draw", "--help"}).out;
  const auto methods = listed_subcommands(help);
  std::vector<std::string> registered;
  const auto add = [&registered](std::string_view name) {
    if (!name.empty() && std::find(registered.begin(), registered.end(), name) == registered.end())
      registered.emplace_back(name);
  };
  for (const auto& algorithm : sightline::registry::line_algorithms()) add(algorithm.name);
  for (const auto& algorithm : sightline::registry::face_algorithms()) add(algorithm.name);
  for (const auto& algorithm : sightline::registry::height_algorithms()) add(algorithm.name);
  EXPECT_EQ(methods, registered);
  const std::string all = sightline({"--help"}).out;
  const std::string line =
      all.substr(all.find("\n  draw "), all.find("\n  compare ") - all.find("\n  draw "));
  for (const std::string& method : methods) EXPECT_TRUE(has(line, method)) << line;
  for (const char* word : {"guest ", "twin ", "native ", "oracle "})
    EXPECT_TRUE(has(all.substr(all.find("Words:")), word)) << word;
}

// The lines of a help that begin with an option: its last name and its complete description.
std::map<std::string, std::string> listed_options(const std::string& help) {
  std::map<std::string, std::string> options;
  std::istringstream lines(help.substr(0, help.find("\nExamples:")));
  std::string name;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  -")) {
      name = line.substr(2, line.find(' ', 2) - 2);
      name.erase(0, name.rfind(',') + 1);  // npos + 1 is 0
    } else if (!line.starts_with("   ")) {
      name.clear();
    }
    if (!name.empty()) options[name] += line.substr(line.find_first_not_of(' ')) + " ";
  }
  return options;
}

// `draw --help` describes options as the helps of the methods do: each listed option belongs to more than half of the methods,
// and the
// methods without it are named.
TEST_F(HelpCommand, OptionsOfMostMethodsAreListedBeforeThem) {
  const std::string help = sightline({"draw", "--help"}).out;
  const std::vector<std::string> methods = listed_subcommands(help);
  auto shared = listed_options(help.substr(help.find("Options of most subcommands:")));
  std::map<std::string, std::vector<std::string>> having;
  for (const std::string& method : methods)
    for (const auto& [name, text] : listed_options(sightline({"draw", method, "--help"}).out)) having[name].push_back(method);
  for (const auto& [name, text] : shared) {
    EXPECT_GT(2 * having[name].size(), methods.size()) << name;
    std::string lacking;
    for (const std::string& method : methods)
      if (std::find(having[name].begin(), having[name].end(), method) == having[name].end()) lacking += (lacking.empty() ? "" : ", ") + method;
    if (lacking.empty()) {
      EXPECT_FALSE(has(text, "all but")) << text;
    } else {
      EXPECT_TRUE(has(text, "all but " + lacking + ")")) << text << " found without it: " << lacking;
    }
  }
  for (const char* name : {"--output", "--size", "--view", "--eye", "--strokes", "--device", "--hidden", "--json"})
    EXPECT_EQ(shared.count(name), 1U) << name << " is not listed";
  for (const char* name : {"--hatch", "--rotate", "--frames", "--help"}) EXPECT_EQ(shared.count(name), 0U) << name;
  EXPECT_TRUE(has(help, "`sightline draw SUBCOMMAND --help` explains all options of each."));
  EXPECT_FALSE(has(sightline({"scene", "--help"}).out, "Options of most subcommands"));
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

// Every command shown there exists and knows its options: each is run with --help.
TEST_F(HelpCommand, WithoutArgumentsItShowsWhereToBegin) {
  const auto ran = sightline({});
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.err, "");
  std::istringstream lines(ran.out);
  std::size_t commands = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  sightline ")) continue;
    ++commands;
    std::istringstream words(line);
    Arguments arguments;
    std::string word;
    words >> word;
    while (words >> word) arguments.push_back(word);
    arguments.emplace_back("--help");
    EXPECT_EQ(sightline(arguments).exit_code, 0) << line;
  }
  EXPECT_GE(commands, 5U);
  EXPECT_TRUE(has(ran.out, "sightline help COMMAND")) << ran.out;
}

TEST_F(HelpCommand, HelpOfACommandIsItsOption) {
  EXPECT_EQ(sightline({"help"}).out, sightline({"--help"}).out);
  EXPECT_EQ(sightline({"help", "jones"}).out, sightline({"jones", "--help"}).out);
  EXPECT_EQ(sightline({"help", "run", "pdp7"}).out, sightline({"run", "pdp7", "--help"}).out);
  EXPECT_EQ(sightline({"help", "report"}).out, sightline({"report", "--help"}).out);
  EXPECT_FALSE(sightline({"help", "scene"}).out.empty());
}

// The last line but one is the error.
TEST_F(HelpCommand, UnknownNamesAreReportedWithTheNearestName) {
  const auto complaint = [this](const Arguments& arguments) {
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 2) << ran.out;
    EXPECT_EQ(ran.out, "");
    return ran.err.substr(0, ran.err.find('\n'));
  };
  EXPECT_EQ(complaint({"jons", "house"}), "sightline: unknown command jons; did you mean \"jones\"?");
  EXPECT_EQ(complaint({"jons", "--help"}), "sightline: unknown command jons; did you mean \"jones\"?");
  EXPECT_EQ(complaint({"help", "jons"}), "sightline: unknown command jons; did you mean \"jones\"?");
  EXPECT_EQ(complaint({"help", "run", "pdp"}), "sightline: unknown command pdp; did you mean \"pdp7\"?");
  EXPECT_EQ(complaint({"run", "pdp7", "--lode", "x"}), "sightline: unknown option --lode; did you mean \"--load\"?");
  EXPECT_EQ(complaint({"jones", "--outptu=x", "house"}),
            "sightline: unknown option --outptu; did you mean \"--output\"?");
  EXPECT_EQ(complaint({"draw", "exact", "house", "--colour", "red"}), "sightline: unknown option --colour");
  const std::string all = complaint({"frobnicate"});
  for (const char* name : {"frobnicate", "demo", "jones", "scene"}) EXPECT_TRUE(has(all, name)) << all;
  EXPECT_EQ(complaint({"demo", "house"}), "sightline: found \"house\", expected no more arguments");
  EXPECT_TRUE(has(complaint({"run"}), "expected one of pdp7, i8080"));
  // Values that begin with a minus are not options.
  EXPECT_EQ(complaint({"jones", "house", "--scale", "-5"}),
            "sightline: --scale: found \"-5\", expected a whole number from 64 to 4096");
}

TEST_F(HelpCommand, AnOptionBeforeItsSubcommandIsAnErrorWithItsPlace) {
  for (const Arguments& words : {Arguments{"draw", "--view", "iso", "exact", "boxes-3", "-o", "b.svg"}, Arguments{"draw", "--view=iso"}}) {
    const auto ran = sightline(words);
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(has(ran.err, "--view: found before the subcommand, expected after it, as in `draw exact --view`")) << ran.err;
  }
}

// -o is required here: the message must still mention the misspelt option.
TEST_F(HelpCommand, AnUnknownOptionIsReportedBeforeAMissingOne) {
  const auto ran = sightline({"draw", "exact", "house", "--sise", "3x3"});
  EXPECT_TRUE(has(ran.err, "unknown option --sise; did you mean \"--size\"?")) << ran.err;
  EXPECT_FALSE(has(ran.err, "--output")) << ran.err;
}

TEST_F(HelpCommand, UnknownScenesAndFunctionsHaveANearestName) {
  EXPECT_TRUE(has(sightline({"jones", "hosue"}).err, "did you mean \"house\"?"));
  EXPECT_TRUE(has(sightline({"skala", "lines", "sinq"}).err, "did you mean \"sinc\"?"));
  EXPECT_FALSE(has(sightline({"jones", "something-else"}).err, "did you mean"));
}

// Copied into a shell, a command broken into lines acts like the same command in one line.
TEST_F(HelpCommand, BrokenExamplesAreWholeCommands) {
  const auto words_of = [this](const char* columns) {
    ::setenv("COLUMNS", columns, 1);
    const std::string help = sightline({"sweep", "--help"}).out;
    ::unsetenv("COLUMNS");
    std::istringstream lines(help.substr(help.find("Examples:")));
    std::string commands;
    bool goes_on = false;
    for (std::string line; std::getline(lines, line); ) {
      if (!goes_on && !(line.starts_with("  ") && line[2] != ' ')) continue;
      goes_on = line.ends_with('\\');
      commands += line.substr(0, line.size() - (goes_on ? 1 : 0)) + (goes_on ? "" : "\n");
    }
    std::string words;
    for (const char c : commands) {
      if (c != ' ') words += c;
      if (c == ' ' && !words.empty() && words.back() != ' ' && words.back() != '\n') words += ' ';
    }
    return words;
  };
  EXPECT_EQ(words_of("60"), words_of("1000"));
  EXPECT_TRUE(has(words_of("60"), "sbatch --array=1-10 --wrap 'sightline sweep part.off")) << words_of("60");
}

}  // namespace
