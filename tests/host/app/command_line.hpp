// Runs the built command in a separate directory, as a user would from a shell.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

namespace sightline::test {

struct Ran {
  int exit_code = -1;  // 1000 + signal if a signal ended it
  std::string out;
  std::string err;
};

using Arguments = std::vector<std::string>;

// The path of the command of the build to which this test program belongs.
inline const std::string& command_of_this_build() {
  static const std::string path = [] {
    std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    while (!std::filesystem::exists(folder / "CMakeCache.txt")) {
      if (folder == folder.parent_path()) throw std::runtime_error("this test is in no folder of a build");
      folder = folder.parent_path();
    }
    return (folder / "host/app/sightline").string();
  }();
  return path;
}

class CommandLine : public ::testing::Test {
 protected:
  CommandLine() {
    std::string pattern = (std::filesystem::temp_directory_path() / "sightline-test-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
      throw std::system_error(errno, std::generic_category(), "mkdtemp");
    directory_ = pattern;
  }
  ~CommandLine() override {
    std::error_code ignored;
    std::filesystem::remove_all(directory_, ignored);
  }

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return directory_ / name; }
  void write(const std::string& name, std::string_view text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream stream(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  }
  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
  // Everything in the directory except the helper's own files.
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(directory_)) {
      const std::string name = entry.path().filename().string();
      if (!name.starts_with(".std")) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  // `interrupt_after`: sends Ctrl-C after this time; zero: never.
  Ran sightline(const Arguments& arguments, std::string_view input = "",
                std::chrono::milliseconds interrupt_after = {}) {
    write(".stdin", input);
    std::vector<std::string> words{command_of_this_build()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, directory_.c_str());
    posix_spawn_file_actions_addopen(&actions, 0, ".stdin", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, stdout_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, ".stderr", O_WRONLY | O_CREAT | O_TRUNC, 0600);
    // A shell starts background tests with Ctrl-C ignored, and the command would inherit that.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t defaults;
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGINT);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    pid_t process = 0;
    const int failed = posix_spawn(&process, words.front().c_str(), &actions, &attributes, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (failed != 0) throw std::system_error(failed, std::generic_category(), "posix_spawn");
    if (interrupt_after.count() != 0) {
      std::this_thread::sleep_for(interrupt_after);
      kill(process, SIGINT);
    }
    int status = 0;
    waitpid(process, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status),
            stdout_ == ".stdout" ? read(stdout_) : "", read(".stderr")};
  }

  // Starts the command and kills it after this time.
  void start_and_kill(const Arguments& arguments, std::chrono::microseconds after) const {
    const pid_t process = fork();
    if (process == 0) {
      if (chdir(directory_.c_str()) != 0) _exit(127);
      std::vector<std::string> words{command_of_this_build()};
      words.insert(words.end(), arguments.begin(), arguments.end());
      std::vector<char*> argv;
      for (std::string& word : words) argv.push_back(word.data());
      argv.push_back(nullptr);
      for (const int descriptor : {0, 1, 2}) dup2(open("/dev/null", O_RDWR), descriptor);
      execv(argv.front(), argv.data());
      _exit(127);
    }
    std::this_thread::sleep_for(after);
    kill(process, SIGKILL);
    waitpid(process, nullptr, 0);
  }

  // Sends Ctrl-C to a command that must then end in order. On a loaded computer the command may start slowly and die of a Ctrl-C
  // before
  // its handler is installed: then it is started again and given more time.
  Ran run_interrupted(const Arguments& arguments) {
    Ran ran;
    for (std::chrono::milliseconds after{300}; after < std::chrono::seconds(20); after *= 4) {
      ran = sightline(arguments, "", after);
      if (ran.exit_code < 1000) break;
    }
    return ran;
  }

  void send_stdout_to(const std::string& file) { stdout_ = file; }

 private:
  std::filesystem::path directory_;
  std::string stdout_ = ".stdout";
};

[[nodiscard]] inline bool has(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace sightline::test
