// `sightline sweep`: shards that together equal the whole, interruptions, threads, and usage errors; with GNU parallel if it is
// installed (tools/dev installs it).
#include <sys/file.h>

#include <sstream>

#include "tests/host/app/command_line.hpp"
#include "tests/support/effort.hpp"

namespace {

using sightline::test::Arguments;
using sightline::test::has;

class SweepCommand : public sightline::test::CommandLine {
 protected:
  [[nodiscard]] static Arguments sweep(const Arguments& more) {
    Arguments all{"sweep", "boxes-4", "--views", "20", "--algorithm", "exact,oracle"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  std::string whole() { return sightline(sweep({"--jobs", "1"})).out; }
  void expect_error(const Arguments& arguments, int code, std::string_view what) {
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, code) << ran.err;
    EXPECT_TRUE(has(ran.err, what)) << ran.err;
    EXPECT_EQ(ran.out, "");
  }
};

TEST_F(SweepCommand, OneLinePerViewForAnyNumberOfThreads) {
  const auto ran = sightline(sweep({"--jobs", "1"}));
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.err, "exact               lines          20      20           0, exact")) << ran.err;
  EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 20);
  EXPECT_TRUE(ran.out.starts_with("{\"schema\":\"sightline/sweep/2\",\"scene\":\"boxes-4\","));
  EXPECT_TRUE(has(ran.out, "\"view\":19,"));
  EXPECT_TRUE(has(ran.out, "\"exact\":true"));
  EXPECT_FALSE(has(ran.out, "\"host_s\":"));
  EXPECT_EQ(sightline(sweep({"--jobs", "5"})).out, ran.out);
  EXPECT_TRUE(has(sightline(sweep({"--time"})).out, "\"host_s\":"));
  EXPECT_NE(sightline(sweep({"--seed", "2"})).out, ran.out);
}

TEST_F(SweepCommand, ConsecutiveShardsEqualTheWhole) {
  std::string joined;
  for (const char* shard : {"1/3", "2/3", "3/3"}) joined += sightline(sweep({"--shard", shard})).out;
  const auto one = sightline(sweep({"--jobs", "1"}));
  EXPECT_EQ(joined, one.out);
  // All lines in one file give the table of one run, and nothing is computed again.
  write("all.jsonl", joined);
  const auto all = sightline(sweep({"-o", "all.jsonl"}));
  EXPECT_EQ(all.exit_code, 0) << all.err;
  EXPECT_EQ(all.out, one.err) << "the table";
  EXPECT_EQ(read("all.jsonl"), joined);
}

// The table of a guest must keep all its numbers; the command that it prints shows the named view with the same measures.
TEST_F(SweepCommand, TheCommandOfTheWorstViewShowsIt) {
  const Arguments command{"sweep", "house", "--views", "6", "--algorithm", "jones-twin", "-o", "s.jsonl"};
  const auto ran = sightline(command);
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const std::string lines = read("s.jsonl");
  write("s.jsonl", lines.substr(0, lines.size() / 2));
  EXPECT_EQ(sightline(command).out, ran.out) << "resumed";
  EXPECT_EQ(read("s.jsonl"), lines);
  const std::string shown = "  sightline ";
  std::istringstream words(ran.out.substr(ran.out.rfind(shown) + shown.size()));
  Arguments compare;
  for (std::string word; words >> word;) compare.push_back(word);
  ASSERT_EQ(compare.size(), 8U) << ran.out;
  EXPECT_EQ(compare[0], "compare");
  EXPECT_EQ(compare[2], "--only-view");
  compare.emplace_back("--json");
  const auto compared = sightline(compare);
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  const auto number_in = [](const std::string& text, const std::string& key, std::size_t from) {
    const std::size_t at = text.find(key, from);
    return at == std::string::npos ? std::string() : text.substr(at + key.size(), text.find_first_of(",}", at) - at - key.size());
  };
  const std::string line = lines.substr(lines.find("\"view\":" + compare[3] + ","));
  const std::string wrong = number_in(line, "\"wrong\":", line.find("\"method\":\"jones-twin\""));
  ASSERT_FALSE(wrong.empty());
  EXPECT_TRUE(has(compared.out, "\"median\": " + wrong + ",")) << wrong << "\n" << compared.out;
}

TEST_F(SweepCommand, AFunctionBySkalasProgram) {
  NEEDS_OPTIMISED_CODE();
  const auto ran = sightline({"sweep", "sinc", "--views", "2", "-o", "s.jsonl"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* const method : {"skala-8080", "skala-twin", "skala "}) EXPECT_TRUE(has(ran.out, method)) << ran.out;
  EXPECT_TRUE(has(read("s.jsonl"), "\"angles\":{\"rotate\":")) << read("s.jsonl");
  expect_error({"sweep", "sinc", "--views", "2", "--algorithm", "jones"}, 2, "jones does not apply: it draws scenes");
  expect_error({"sweep", "sinc", "--views", "2", "--faces"}, 2, "--faces: found sinc, expected a scene");
}

TEST_F(SweepCommand, ResumesAnInterruptedSweep) {
  const std::string all = whole();
  std::size_t middle = 0;
  for (int i = 0; i < 7; ++i) middle = all.find('\n', middle) + 1;
  // Complete lines; a truncated line; no complete line.
  for (const std::size_t length : {middle, middle + 40, std::size_t{11}, std::size_t{0}, all.size()}) {
    write("s.jsonl", all.substr(0, length));
    EXPECT_EQ(sightline(sweep({"-o", "s.jsonl"})).exit_code, 0);
    EXPECT_EQ(read("s.jsonl"), all) << length;
  }
}

TEST_F(SweepCommand, AForeignFileIsNotOverwritten) {
  const std::string all = whole();
  const std::string first = all.substr(0, all.find('\n') + 1);
  for (const std::string& text : {std::string("my notes\n"), first + first, all + "more\n"}) {
    write("s.jsonl", text);
    expect_error(sweep({"-o", "s.jsonl"}), 4, "s.jsonl: line ");
    EXPECT_EQ(read("s.jsonl"), text);
  }
  write("s.jsonl", all);
  expect_error(sweep({"-o", "s.jsonl", "--seed", "2"}), 4, "s.jsonl: line 1 ");
}

TEST_F(SweepCommand, OneSweepAtATimeWritesAFile) {
  write("s.jsonl", "");
  const int file = open(path("s.jsonl").c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(flock(file, LOCK_EX), 0);
  expect_error(sweep({"-o", "s.jsonl"}), 5, "another sweep");
  close(file);
}

TEST_F(SweepCommand, InterruptedAndResumed) {
  const Arguments many{"sweep", "boxes-4", "--views", "1000000", "--algorithm", "oracle", "-o", "s.jsonl"};
  const auto ran = sightline(many, "", std::chrono::milliseconds(1500));
  EXPECT_EQ(ran.exit_code, 130) << ran.err;
  EXPECT_TRUE(has(ran.err, "the same command resumes there")) << ran.err;
  EXPECT_TRUE(read("s.jsonl").ends_with("}}\n"));
}

TEST_F(SweepCommand, TheGuestOfASceneOfCells) {
  const auto ran = sightline({"sweep", "roberts", "--views", "2", "--guest", "--algorithm", "oracle"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(has(ran.out, "\"jones-pdp7\":{\"method\":\"jones-pdp7\"")) << ran.out;
  EXPECT_TRUE(has(ran.out, "\"jones-twin\":{\"method\":\"jones-twin\"")) << ran.out;
  expect_error({"sweep", "boxes-4", "--views", "2", "--guest"}, 2, "--guest");
}

TEST_F(SweepCommand, ShardsOfATurnEqualTheWhole) {
  const auto turned = [&](const char* shard) {
    const auto ran = sightline({"sweep", "house", "--views", "8", "--turn", "--shard", shard});
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return ran.out;
  };
  const std::string all = turned("1/1");
  EXPECT_TRUE(has(all, "\"directions\":\"all\"")) << all;
  EXPECT_EQ(turned("1/3") + turned("2/3") + turned("3/3"), all);
  write("s.jsonl", all);
  expect_error({"sweep", "house", "--views", "8", "-o", "s.jsonl"}, 4, "s.jsonl: line 1 ");
  expect_error({"sweep", "boxes-4", "--views", "2", "--turn"}, 2, "--turn: found boxes-4");
}

TEST_F(SweepCommand, WrongUsage) {
  expect_error({"sweep"}, 2, "SCENE");
  expect_error({"sweep", "boxes-4"}, 2, "--views");
  expect_error(sweep({"--shard", "0/3"}), 2, "I/N");
  expect_error(sweep({"--shard", "4/3"}), 2, "I/N");
  expect_error(sweep({"--shard", "1/"}), 2, "I/N");
  expect_error({"sweep", "boxes-4", "--views", "2", "--algorithm", "guess"}, 2, "jones");
  expect_error({"sweep", "boxes-4", "--views", "2", "--algorithm", "montani"}, 2, "did you mean \"montani-re\"?");
  expect_error({"sweep", "boxes-4", "--views", "2", "--algorithm", "jones-pdp7"}, 2, "jones-pdp7 does not apply: Jones's program takes");
  expect_error({"sweep", "house", "--views", "2", "--turn", "--level"}, 2, "--level");
  expect_error({"sweep", "boxes-0", "--views", "2"}, 2, "size");
  expect_error({"sweep", "nowhere.off", "--views", "2"}, 5, "nowhere.off");
  expect_error(sweep({"-o", "nowhere/s.jsonl"}), 5, "nowhere/s.jsonl");
  expect_error(sweep({"-o", "/dev/full"}), 5, "/dev/full");
}

TEST_F(SweepCommand, SpreadByGnuParallel) {
  if (std::system("parallel --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "GNU parallel is not installed";
  const std::string all = whole();
  // In the order that parallel keeps; then as files, concatenated by name.
  const auto spread = [&](const std::string& options, const std::string& output) {
    return std::system(("cd '" + path("").string() + "' && parallel --will-cite -j3 " + options + " '" +
                        sightline::test::command_of_this_build() +
                        "' sweep boxes-4 --views 20 --algorithm exact,oracle --jobs 1 --shard {}/6 " + output)
                           .c_str());
  };
  ASSERT_EQ(spread("-k", "::: 1 2 3 4 5 6 > merged.jsonl"), 0);
  EXPECT_EQ(read("merged.jsonl"), all);
  ASSERT_EQ(spread("", "-o part-{}.jsonl ::: 6 5 4 3 2 1 && cat part-*.jsonl > files.jsonl"), 0);
  EXPECT_EQ(read("files.jsonl"), all);
}

}  // namespace
