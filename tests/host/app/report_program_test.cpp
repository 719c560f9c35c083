// `sightline report` executes the program sightline-report: where it looks for it, the arguments it passes, the error without it.
// A script takes the place of the program.
#include <cstdlib>

#include "tests/host/app/command_line.hpp"

namespace sightline::test {
namespace {

class ReportProgram : public CommandLine {
 protected:
  ReportProgram() {
    std::filesystem::create_directory(path("bin"));
    std::filesystem::copy_file(command_of_this_build(), path("bin/sightline"));
  }

  void write_program(const std::string& name, const std::string& said) {
    std::filesystem::create_directories(path(name).parent_path());
    write(name, "#!/bin/sh\necho " + said + " \"$@\"\nexit 4\n");
    std::filesystem::permissions(path(name), std::filesystem::perms::owner_all);
  }

  // Runs a copy of the command and returns the exit code; its output is in `out` and `err`.
  int run_copy(const std::string& arguments) {
    const int status = std::system(
        ("cd '" + path("").string() + "' && bin/sightline " + arguments + " > out 2> err").c_str());
    return WEXITSTATUS(status);
  }
};

TEST_F(ReportProgram, WithoutItTheErrorNamesTheCommandThatMakesIt) {
  EXPECT_EQ(run_copy("report -o x"), 5);
  EXPECT_EQ(read("out"), "");
  EXPECT_TRUE(has(read("err"), "tools/dev report")) << read("err");
  EXPECT_EQ(run_copy("--help"), 0);
  EXPECT_TRUE(has(read("out"), "\n  report ")) << read("out");
}

TEST_F(ReportProgram, GetsTheArgumentsAndGivesTheExitCode) {
  write_program("bin/sightline-report", "beside");
  EXPECT_EQ(run_copy("report --part 1 -o 'a b'"), 4);
  EXPECT_EQ(read("out"), "beside report --part 1 -o a b\n");
}

TEST_F(ReportProgram, IsFoundInAnInstallation) {
  write_program("libexec/sightline/sightline-report", "installed");
  EXPECT_EQ(run_copy("report --help"), 4);
  EXPECT_EQ(read("out"), "installed report --help\n");
}

}  // namespace
}  // namespace sightline::test
