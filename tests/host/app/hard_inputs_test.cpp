// Every input of a hard case works with `sightline compare`, as a file and in the view of its case; all cases have the recorded
// results.
#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "host/compare/hard_cases/manifest.hpp"
#include "host/compare/hard_cases/run_case.hpp"
#include "tests/host/app/command_line.hpp"

namespace {

namespace compare = sightline::compare;
using sightline::test::Arguments;
using sightline::test::has;

class HardInputs : public sightline::test::CommandLine, public testing::WithParamInterface<const char*> {
 protected:
  // Checks a command that occurs several times only once.
  void expect(const std::string& command, int exit_code, const std::string& part) {
    if (!done_.insert(command).second) return;
    std::istringstream words(command);
    Arguments arguments;
    for (std::string word; words >> word;) arguments.push_back(word);
    arguments.erase(arguments.begin());
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, exit_code) << command << '\n' << ran.out << ran.err;
    EXPECT_TRUE(has(exit_code == 0 ? ran.out : ran.err, part)) << command << '\n' << ran.out << ran.err;
  }

 private:
  std::set<std::string> done_;
};

INSTANTIATE_TEST_SUITE_P(, HardInputs, testing::Values("jones", "skala", "willis", "montani-re", "plantinga"),
                         [](const auto& group) { return group.param == std::string("montani-re") ? "montani_re" : group.param; });

TEST_P(HardInputs, GoThroughCompare) {
  const auto manifest = compare::read_manifest(compare::hard_case_text("manifest.json"), "manifest.json");
  ASSERT_TRUE(manifest) << manifest.error().message();
  std::size_t compared = 0;
  for (const auto& group : manifest->groups) {
    if (group.id != GetParam()) continue;
    for (const compare::HardCase& hard : group.cases) {
      const std::string_view text = compare::hard_case_text(hard.input);
      if (text.empty()) continue;
      write(hard.input, text);
      const std::string plain = "sightline compare --no-host-times " + hard.input;
      const std::string stem = hard.input.substr(0, hard.input.rfind('.'));
      if (hard.input.ends_with(".txt")) {
        expect(plain, 4, "expected a scene or a grid; `sightline hard " + stem + "` takes this file");
        expect("sightline hard " + stem, 0, hard.input);
        continue;
      }
      // No reader accepts the file, or the eye is at an invalid position.
      const bool on_a_wall = hard.expect.program_refuses && hard.id != "J2";  // J2 is in an opening, a valid eye for others
      const bool refused = hard.expect.refused || on_a_wall || hard.expect.eye_refused;
      if (refused) {
        expect(plain, 4, hard.input + ": ");
        continue;
      }
      if (text.find("nan") != std::string_view::npos) {
        expect(plain, 4, "undefined heights");
        continue;
      }
      ++compared;
      expect(plain, 0, hard.input.ends_with(".json") || hard.input.ends_with(".off") ? "0, exact" : "skala-8080 and its twin, the same program in C++, give the same dots");
      if (const std::string command = compare_command(hard); !command.empty()) expect(command + " --no-host-times", 0, "");
    }
  }
  EXPECT_GT(compared, 4U);
}

class HardBounds : public sightline::test::CommandLine {};

// Willis's method is omitted where it would take minutes or more, by count, and nothing else is.
TEST_F(HardBounds, OmitWorkBeyondTheLimit) {
  for (const char* file : {"J10.json", "J12.json", "J12-far.json"}) {
    write(file, compare::hard_case_text(file));
    const auto ran = sightline({"compare", "--no-host-times", file});
    EXPECT_EQ(ran.exit_code, 0) << file << '\n' << ran.err;
    for (const char* method : {"willis", "willis-8080"})
      EXPECT_TRUE(has(ran.out, std::string(method) + " not compared: found ")) << file << '\n' << ran.out;
    EXPECT_TRUE(has(ran.out, "pieces to be separated by cuts, expected at most 500000 pairs\n")) << file << '\n' << ran.out;
    EXPECT_TRUE(has(ran.out, "montani-re  ")) << ran.out;
    EXPECT_TRUE(has(ran.out, "stripes-8080  ")) << ran.out;
  }
}

TEST_F(HardBounds, AllCasesComeOutAsRecorded) {
  const auto ran = sightline({"hard"});
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  const auto manifest = compare::read_manifest(compare::hard_case_text("manifest.json"), "manifest.json");
  ASSERT_TRUE(manifest) << manifest.error().message();
  std::size_t cases = 0;
  for (const auto& group : manifest->groups) cases += group.cases.size();
  const std::string counts = std::to_string(cases) + " cases and " + std::to_string(manifest->families.size()) + " searches";
  EXPECT_TRUE(has(ran.out, counts + " for a first failure, all as recorded\n")) << ran.out;
}

}  // namespace
