// The built command on a pseudo terminal. Its settings are restored however the command ends.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <utmp.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "tests/host/app/command_line.hpp"

namespace sightline::test {
namespace {

using std::chrono::steady_clock;
constexpr std::chrono::seconds patience{30};

class Terminal : public CommandLine {
 protected:
  void SetUp() override {
    // Echoes typed characters; ! ends.
    write("echo.s",
          "100/\nbegin, lac (252\n  jms type\nwait, 700301\n  jmp wait\n  700312\n  jms type\n  and (177\n  sad (41\n  hlt\n"
          "  jmp wait\ntype, 0\n  700406\n  700401\n  jmp .-1\n  jmp i type\n  start begin\n");
    ASSERT_EQ(sightline({"asm", "pdp7", "echo.s", "-o", "echo.rim"}).exit_code, 0);
    ASSERT_EQ(openpty(&master_, &slave_, nullptr, nullptr, nullptr), 0);
    // The terminal closes when the test closes it, not when the command does.
    ASSERT_EQ(fcntl(master_, F_SETFD, FD_CLOEXEC), 0);
    ASSERT_EQ(tcgetattr(slave_, &before_), 0);
  }
  void TearDown() override {
    if (child_ > 0) static_cast<void>(kill(child_, SIGKILL));
    hang_up();
    if (slave_ >= 0) close(slave_);
  }

  void start(std::vector<std::string> arguments) {
    const std::string command = command_of_this_build();
    child_ = fork();
    ASSERT_GE(child_, 0);
    if (child_ == 0) {
      static_cast<void>(chdir(path(".").c_str()));
      static_cast<void>(setenv("XDG_STATE_HOME", path("state").c_str(), 1));
      static_cast<void>(setenv("TERM", "xterm", 1));
      static_cast<void>(login_tty(slave_));
      std::vector<char*> words{const_cast<char*>(command.c_str())};
      for (std::string& argument : arguments) words.push_back(argument.data());
      words.push_back(nullptr);
      execv(command.c_str(), words.data());
      _exit(127);
    }
  }
  void set_columns(unsigned short columns) {
    const winsize size{40, columns, 0, 0};
    ASSERT_EQ(ioctl(slave_, TIOCSWINSZ, &size), 0);
  }
  void type(std::string_view keys) { ASSERT_EQ(write_to(master_, keys), keys.size()); }
  // Reads until the text has been displayed.
  [[nodiscard]] bool shows(std::string_view text) {
    const auto end = steady_clock::now() + patience;
    while (shown_.find(text) == std::string::npos) {
      if (steady_clock::now() > end) return false;
      pollfd input{master_, POLLIN, 0};
      if (poll(&input, 1, 100) <= 0) continue;
      std::array<char, 1024> buffer{};
      const ssize_t n = ::read(master_, buffer.data(), buffer.size());
      if (n <= 0) return shown_.find(text) != std::string::npos;
      shown_.append(buffer.data(), static_cast<std::size_t>(n));
    }
    return true;
  }
  // The exit code, 1000 + signal if a signal ended it, -1 if it does not end.
  [[nodiscard]] int ends() {
    const auto end = steady_clock::now() + patience;
    int status = 0;
    while (waitpid(child_, &status, WNOHANG) == 0) {
      if (steady_clock::now() > end) return -1;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    child_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }
  [[nodiscard]] pid_t child() const { return child_; }
  void send_signal(int number) { ASSERT_EQ(kill(child_, number), 0); }
  void hang_up() {
    if (master_ >= 0) close(master_);
    master_ = -1;
  }
  [[nodiscard]] bool restored() const {
    termios now{};
    return tcgetattr(slave_, &now) == 0 && now.c_iflag == before_.c_iflag && now.c_oflag == before_.c_oflag &&
           now.c_lflag == before_.c_lflag && now.c_cflag == before_.c_cflag;
  }
  [[nodiscard]] bool raw() const {
    termios now{};
    return tcgetattr(slave_, &now) == 0 && (now.c_lflag & (ICANON | ECHO | ISIG)) == 0;
  }
  void start_echo() {
    start({"run", "pdp7", "echo.rim", "--console", "parity", "--dump", "d"});
    ASSERT_TRUE(shows("*")) << shown_;
    ASSERT_TRUE(raw());
  }

  std::string shown_;

 private:
  static std::size_t write_to(int descriptor, std::string_view text) {
    const ssize_t n = ::write(descriptor, text.data(), text.size());
    return n < 0 ? 0 : static_cast<std::size_t>(n);
  }

  int master_ = -1;
  int slave_ = -1;
  pid_t child_ = 0;
  termios before_{};
};

TEST_F(Terminal, KeysAreEchoedByTheProgramAlone) {
  start_echo();
  type("a\003b!");
  ASSERT_TRUE(shows("stopped by      halt")) << shown_;
  EXPECT_NE(shown_.find("*a\003b!\r\n"), std::string::npos) << shown_;
  EXPECT_EQ(ends(), 0);
  EXPECT_TRUE(restored());
}

// In a pipe the table has all columns.
TEST_F(Terminal, TablesOmitColumnsOnANarrowTerminal) {
  const std::vector<std::string> words{"compare", "boxes-1", "--orthographic", "3,0,4", "--no-host-times", "--methods", "exact,turn-pdp7", "-o", "none"};
  const std::string whole = sightline(words).out;
  EXPECT_NE(whole.find("  the paper says\n"), std::string::npos) << whole;
  EXPECT_EQ(whole.find("left out"), std::string::npos) << whole;
  set_columns(66);
  start(words);
  ASSERT_TRUE(shows("none: no pictures: nothing differs in any of them (--all writes them)\r\n")) << shown_;
  EXPECT_EQ(ends(), 0);
  EXPECT_NE(shown_.find("  wrong\r\n"), std::string::npos) << shown_;
  EXPECT_NE(shown_.find("left out, for a wider terminal: the paper says, read\r\n"), std::string::npos) << shown_;
  const std::string table = shown_.substr(0, shown_.find("left out"));
  std::size_t row = table.find('\n') + 1;
  for (std::size_t end = 0; (end = table.find("\r\n", row)) != std::string::npos; row = end + 2) EXPECT_LE(end - row, 66U) << table;
  EXPECT_FALSE(exists("none"));
}

TEST_F(Terminal, CtrlEEntersTheMonitorAndReturns) {
  start_echo();
  type("a\005");
  ASSERT_TRUE(shows("pdp7> ")) << shown_;
  EXPECT_FALSE(raw());
  type("continue\r");
  const auto end = steady_clock::now() + patience;
  while (!raw() && steady_clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  shown_.clear();
  type("b");
  ASSERT_TRUE(shows("b")) << shown_;
  type("\005");
  ASSERT_TRUE(shows("pdp7> ")) << shown_;
  type("history 1\rquit\r");
  ASSERT_TRUE(shows("stopped by      operator")) << shown_;
  EXPECT_EQ(ends(), 0);
  EXPECT_TRUE(restored());
  EXPECT_TRUE(exists("d"));
}

TEST_F(Terminal, TheMonitorHasAPromptAndKeepsItsLines) {
  start({"monitor", "pdp7", "echo.s"});
  ASSERT_TRUE(shows("pdp7> ")) << shown_;
  type("break wait\r");
  ASSERT_TRUE(shows("breakpoint 1: wait")) << shown_;
  type("continue\r");
  ASSERT_TRUE(shows("breakpoint 1\r\n00102 wait")) << shown_;
  type("quit\r");
  EXPECT_EQ(ends(), 0);
  EXPECT_TRUE(restored());
  EXPECT_TRUE(has(read("state/sightline/monitor"), "continue"));
}

// The counts are those of the scenes: a box has 6 faces and 8 corners.
TEST_F(Terminal, ACommandThatOnlyWritesAFileReportsIt) {
  write("slab.off", "OFF\n8 6 0\n0 0 0\n4 0 0\n4 3 0\n0 3 0\n0 0 1\n4 0 1\n4 3 1\n0 3 1\n"
                    "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
  struct Said {
    Arguments words;
    std::string line;
  };
  const std::vector<Said> all{
      // Of a box nine edges are visible from a corner, four from the front.
      {{"draw", "exact", "slab.off", "--view", "iso", "-o", "a.svg"}, "sightline: a.svg: 9 lines, "},
      {{"draw", "exact", "slab.off", "--view", "front", "--size", "A4", "-o", "a.svg"}, "sightline: a.svg: 4 lines, "},
      {{"draw", "exact", "slab.off", "--size", "A4", "--landscape", "-o", "a.pdf"}, ", 297 x 210 mm"},
      {{"draw", "exact", "slab.off", "--view", "front", "--strokes", "a.jsonl", "-o", "a.svg"}, "sightline: a.jsonl: 4 lines"},
      {{"draw", "exact", "slab.off", "--pixels", "300x200", "-o", "a.png"}, ", 300 x 200 pixels"},
      {{"draw", "montani-re", "slab.off", "--fill", "-o", "a.svg"}, "sightline: a.svg: 6 faces filled, 200 x 200 mm"},
      {{"draw", "willis", "slab.off", "-o", "a.png"}, "sightline: a.png: 6 faces, 512 x 512 pixels"},
      {{"draw", "willis", "slab.off", "--frames", "2", "-o", "a.apng"}, "sightline: a.apng: 2 frames, 512 x 512 pixels"},
      {{"draw", "skala", "sinc", "--slices", "9", "--points", "9", "--picture", "surface", "-o", "a.svg"}, "sightline: a.svg: "},
      {{"explain", "jones", "house", "-o", "a.html"}, " steps; open it in a browser"},
      {{"sweep", "slab.off", "--views", "2", "--jobs", "1", "-o", "v.jsonl"}, "sightline: v.jsonl: 2 views\r\n"},
      {{"sweep", "slab.off", "--views", "2", "--jobs", "1", "-o", "v.jsonl"}, "sightline: v.jsonl: 2 views, 2 of them already there"},
      {{"scene", "generate", "boxes", "3", "-o", "a.json"}, "sightline: a.json: 3 solids, 18 faces, 24 vertices"},
      {{"scene", "convert", "slab.off", "-o", "a.obj"}, "sightline: a.obj: 1 solid, 6 faces, 8 vertices"},
      {{"scene", "tape", "corridor8", "-o", "a.txt"}, "sightline: a.txt: 8 cells, "},
      {{"disasm", "pdp7", "echo.rim", "-o", "a.dis"}, "sightline: a.dis: "}};
  for (const Said& said : all) {
    shown_.clear();
    start(said.words);
    EXPECT_TRUE(shows(said.line)) << said.words[0] << " " << said.words[1] << ": " << shown_;
    EXPECT_EQ(ends(), 0);
    // In a script there is no message.
    std::filesystem::remove(path("v.jsonl"));
    const Ran ran = sightline(said.words);
    EXPECT_EQ(ran.exit_code, 0);
    EXPECT_EQ(ran.err, "") << said.words[0] << " " << said.words[1];
  }
}

TEST_F(Terminal, NoMessageForJsonAndStandardOutput) {
  for (const Arguments& words : {Arguments{"draw", "exact", "boxes-1", "--json", "-o", "a.svg"}, Arguments{"draw", "exact", "boxes-1", "-o", "-"},
                                 Arguments{"scene", "generate", "boxes", "1"}}) {
    shown_.clear();
    start(words);
    EXPECT_TRUE(shows(words.back() == "-" ? "</svg>" : "}\r\n")) << shown_;
    EXPECT_EQ(ends(), 0);
    EXPECT_FALSE(has(shown_, "sightline: ")) << shown_;
  }
}

TEST_F(Terminal, AtThePromptEachCommandReportsItsEffect) {
  start({"monitor", "pdp7", "echo.s"});
  ASSERT_TRUE(shows("pdp7> ")) << shown_;
  // Deposited and shown in octal: 10. is 12.
  type("deposit 300 10.\r");
  EXPECT_TRUE(shows("00300 000012")) << shown_;
  type("deposit 300 1 2 3\r");
  EXPECT_TRUE(shows("3 words in 00300-00302")) << shown_;
  type("deposit ac 7\r");
  EXPECT_TRUE(shows("AC 000007")) << shown_;
  type("break 101\rbreak 102\rdelete\r");
  EXPECT_TRUE(shows("2 breakpoints removed")) << shown_;
  type("attach reader echo.rim\r");
  EXPECT_TRUE(shows("reader: echo.rim, " + std::to_string(std::filesystem::file_size(path("echo.rim"))) + " bytes")) << shown_;
  type("detach reader\r");
  EXPECT_TRUE(shows("reader: detached")) << shown_;
  type("send \"ab\"\r");
  EXPECT_TRUE(shows("2 keys are typed in the next run")) << shown_;
  type("trace t.txt\rstep 3\rtrace off\r");
  EXPECT_TRUE(shows("t.txt: 3 instructions")) << shown_;
  type("save s.snap\r");
  EXPECT_TRUE(shows("s.snap: ")) << shown_;
  EXPECT_TRUE(exists("s.snap"));
  type("quit\r");
  EXPECT_EQ(ends(), 0);
  const Ran ran = sightline({"monitor", "pdp7", "echo.s"}, "deposit 300 10.\nattach reader echo.rim\ntrace t.txt\ntrace off\nsave s.snap\n");
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.out, "");
  // A file of commands prints the same at a prompt as in a pipe.
  write("c", "deposit 300 10.\nexamine 300\n");
  start({"monitor", "pdp7", "echo.s"});
  ASSERT_TRUE(shows("pdp7> ")) << shown_;
  shown_.clear();
  type("do c\r");
  ASSERT_TRUE(shows("00300 000012")) << shown_;
  ASSERT_TRUE(shows("pdp7> ")) << shown_;
  EXPECT_EQ(shown_.find("00300 000012"), shown_.rfind("00300 000012")) << shown_;
  type("quit\r");
  EXPECT_EQ(ends(), 0);
}

TEST_F(Terminal, CtrlCAndCtrlEReturnToTheMonitor) {
  start({"monitor", "pdp7", "echo.s"});
  ASSERT_TRUE(shows("pdp7> ")) << shown_;
  type("continue\r");
  ASSERT_TRUE(shows("*")) << shown_;
  type("\003");
  ASSERT_TRUE(shows("stopped by interrupted")) << shown_;
  type("back 5\rquit\r");
  EXPECT_EQ(ends(), 0);
  shown_.clear();
  start({"monitor", "pdp7", "echo.s", "--console", "parity"});
  ASSERT_TRUE(shows("pdp7> ")) << shown_;
  type("continue\r");
  ASSERT_TRUE(shows("*")) << shown_;
  type("a\005");
  ASSERT_TRUE(shows("stopped by operator")) << shown_;
  type("quit\r");
  EXPECT_EQ(ends(), 0);
  EXPECT_TRUE(restored());
}

TEST_F(Terminal, SignalsEndItInOrder) {
  for (const int number : {SIGTERM, SIGINT, SIGQUIT}) {
    shown_.clear();
    start_echo();
    send_signal(number);
    EXPECT_TRUE(shows("all outputs hold")) << shown_;
    EXPECT_EQ(ends(), 128 + number);
    EXPECT_TRUE(restored());
    EXPECT_TRUE(exists("d"));
    std::filesystem::remove(path("d"));
  }
}

TEST_F(Terminal, ASuspendedRunRestoresTheTerminalMeanwhile) {
  start_echo();
  send_signal(SIGTSTP);
  const auto end = steady_clock::now() + patience;
  while (!restored() && steady_clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(restored());
  send_signal(SIGCONT);
  while (!raw() && steady_clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(raw());
  type("!");
  EXPECT_TRUE(shows("halt")) << shown_;
  EXPECT_EQ(ends(), 0);
  EXPECT_TRUE(restored());
}

TEST_F(Terminal, AClosedTerminalEndsTheRunAndFilesAreWritten) {
  start_echo();
  hang_up();
  const int code = ends();
  EXPECT_TRUE(code == 128 + SIGHUP || code == 0) << code;
  EXPECT_TRUE(exists("d"));
}

// At the prompt Ctrl-C discards the line, as in a shell.
TEST_F(Terminal, CtrlCAtThePromptDiscardsTheLine) {
  start({"monitor", "pdp7", "echo.rim"});
  ASSERT_TRUE(shows("pdp7> ")) << shown_;
  type("deposit 100 1\003");
  ASSERT_TRUE(shows("^C")) << shown_;
  shown_.clear();
  type("examine 100\r");
  ASSERT_TRUE(shows("00100 200117")) << shown_;
  type("quit\r");
  EXPECT_EQ(ends(), 0);
  EXPECT_TRUE(restored());
}

// The machine runs, with and without the terminal as its console: signals other than Ctrl-C end the session, not only the run.
TEST_F(Terminal, ASignalInARunOfTheMonitorEndsTheSessionInOrder) {
  for (const bool console : {false, true}) {
    for (const int number : {SIGTERM, SIGHUP}) {
      shown_.clear();
      std::filesystem::remove(path("state/sightline/monitor"));
      std::vector<std::string> words{"monitor", "pdp7", "echo.s"};
      if (console) words.insert(words.end(), {"--console", "parity"});
      start(words);
      ASSERT_TRUE(shows("pdp7> ")) << shown_;
      type("continue\r");
      ASSERT_TRUE(shows("*")) << shown_;
      send_signal(number);
      EXPECT_EQ(ends(), 128 + number);
      EXPECT_TRUE(restored());
      EXPECT_NE(read("state/sightline/monitor").find("continue"), std::string::npos);
    }
  }
}

TEST_F(Terminal, SigintFromOutsideStopsTheRunAndReturnsToThePrompt) {
  start({"monitor", "pdp7", "echo.s", "--console", "parity"});
  ASSERT_TRUE(shows("pdp7> ")) << shown_;
  type("continue\r");
  ASSERT_TRUE(shows("*")) << shown_;
  send_signal(SIGINT);
  ASSERT_TRUE(shows("stopped by signal")) << shown_;
  shown_.clear();
  type("evaluate 1+2\r");
  ASSERT_TRUE(shows("3 = 3.")) << shown_;
  type("quit\r");  // a Ctrl-D that comes before the line editor reads the terminal again is lost
  EXPECT_EQ(ends(), 0);
  EXPECT_TRUE(restored());
}

// A session that `run` has passed to the monitor: a signal that ends the monitor ends the run.
TEST_F(Terminal, ASignalAfterCtrlEEndsTheRun) {
  start_echo();
  type("\005");
  ASSERT_TRUE(shows("pdp7> ")) << shown_;
  send_signal(SIGTERM);
  EXPECT_EQ(ends(), 128 + SIGTERM);
  EXPECT_TRUE(restored());
  EXPECT_TRUE(exists("d"));
}

// A program that hangs in the host, here because the terminal is full, is ended by the second signal; `timeout` sends two at
// once.
TEST_F(Terminal, TheSecondSignalEndsAtOnce) {
  write("loud.s", "100/\nbegin, lac (301\nloop, 700406\n  jmp loop\n  start begin\n");
  ASSERT_EQ(sightline({"asm", "pdp7", "loud.s", "-o", "loud.rim"}).exit_code, 0);
  start({"run", "pdp7", "loud.rim", "--console", "ascii", "--speed", "max", "--timing", "teletype_character=1"});
  const auto end = steady_clock::now() + patience;
  while (!raw() && steady_clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // the terminal is full
  send_signal(SIGTERM);
  send_signal(SIGTERM);
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  EXPECT_EQ(kill(child(), 0), 0);
  send_signal(SIGTERM);
  EXPECT_EQ(ends(), 1000 + SIGTERM);
  EXPECT_TRUE(restored());
}

// The output at the end of a session, the typed lines here, is written then, too.
TEST_F(Terminal, ASignalAtThePromptEndsTheSessionInOrder) {
  start({"monitor", "pdp7", "echo.rim"});
  ASSERT_TRUE(shows("pdp7> ")) << shown_;
  shown_.clear();
  type("examine 100\r");
  // The answer and the next prompt: from then on the command reads a line.
  ASSERT_TRUE(shows("00100 200117")) << shown_;
  shown_.erase(0, shown_.find("00100 200117"));
  ASSERT_TRUE(shows("pdp7> ")) << shown_;
  send_signal(SIGTERM);
  EXPECT_EQ(ends(), 128 + SIGTERM);
  EXPECT_TRUE(restored());
  EXPECT_NE(read("state/sightline/monitor").find("examine"), std::string::npos);
}

}  // namespace
}  // namespace sightline::test
