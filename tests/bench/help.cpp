// The processor time of a complete run of `sightline` for help: how long a user waits for it.
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace sightline {
namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// User and system time of one run of the command without its output; reports an error to the benchmark if the run fails.
void help(benchmark::State& state, const std::string& arguments) {
  std::vector<std::string> words{SIGHTLINE_COMMAND};
  std::istringstream rest(arguments);
  for (std::string word; rest >> word;) words.push_back(word);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  for (auto _ : state) {
    pid_t child = 0;
    int status = 0;
    rusage usage{};
    if (posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ) != 0 ||
        wait4(child, &status, 0, &usage) < 0 || status != 0) {
      state.SkipWithError("the command fails");
      break;
    }
    state.SetIterationTime(seconds(usage.ru_utime) + seconds(usage.ru_stime));
  }
  posix_spawn_file_actions_destroy(&actions);
}

BENCHMARK_CAPTURE(help, without_arguments, "")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(help, of_all, "--help")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(help, of_the_longest, "help run pdp7")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sightline
