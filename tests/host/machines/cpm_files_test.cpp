// The file functions of CP/M 2.2 on a folder of the host. Expected codes and layouts are those of the Interface Guide (1979); the
// tests
// read and write the contents of files by std::fstream.
#include "host/machines/cpm.hpp"
#include "host/machines/cpm_files.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace sightline::test {
namespace {

namespace fs = std::filesystem;
using machines::CpmFiles;

constexpr std::uint16_t fcb = 0x5C, transfer = 0x80;
constexpr int not_found = 0xFF;

class CpmDrives : public testing::Test {
 protected:
  void SetUp() override {
    static int number = 0;
    base_ = fs::temp_directory_path() / ("sightline-cpm-" + std::to_string(::getpid()) + "-" + std::to_string(number++));
    fs::create_directories(base_ / "a");
    fs::create_directories(base_ / "b");
    files_.emplace(std::vector<machines::CpmDrive>{{0, base_ / "a", false}, {1, base_ / "b", true}});
  }
  void TearDown() override {
    files_.reset();
    std::error_code ignored;
    fs::remove_all(base_, ignored);
  }

  // Stores "B:NAME.TYP" in the block, all else 0.
  void name(const std::string& text, std::uint16_t at = fcb) {
    std::fill_n(memory_.begin() + at, 36, std::uint8_t{0});
    put_name(text, at);
  }
  void put_name(std::string text, std::uint16_t at) {
    if (text.size() > 1 && text[1] == ':') {
      memory_[at] = static_cast<std::uint8_t>(text[0] - 'A' + 1);
      text.erase(0, 2);
    }
    std::fill_n(memory_.begin() + at + 1, 11, std::uint8_t{' '});
    const std::size_t dot = std::min(text.find('.'), text.size());
    for (std::size_t n = 0; n < text.size(); ++n)
      if (n != dot) memory_[at + 1 + (n < dot ? n : n - dot - 1 + 8)] = static_cast<std::uint8_t>(text[n]);
  }
  int call(int function, int de = fcb) {
    const auto answer = files_->call(static_cast<std::uint8_t>(function), static_cast<std::uint16_t>(de), memory_);
    fault_ = answer.fault ? std::string(1, answer.fault->drive) + ": " + std::string(answer.fault->why) : "";
    return answer.hl;
  }
  void host_file(const std::string& path, const std::string& content) { std::ofstream(base_ / path, std::ios::binary) << content; }
  std::string host_file(const std::string& path) {
    std::ifstream in(base_ / path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  std::string record() const { return {memory_.begin() + transfer, memory_.begin() + transfer + 128}; }
  void record(char c) { std::fill_n(memory_.begin() + transfer, 128, static_cast<std::uint8_t>(c)); }
  void random(std::uint32_t number) {
    for (int n = 0; n < 3; ++n) memory_[fcb + 33U + static_cast<unsigned>(n)] = static_cast<std::uint8_t>(number >> 8 * n);
  }
  // Names in the order that functions 17 and 18 return.
  std::vector<std::string> search(const std::string& pattern) {
    name(pattern);
    std::vector<std::string> names;
    for (int code = call(17); code != not_found; code = call(18)) {
      const std::size_t entry = transfer + static_cast<std::size_t>(code) * 32;
      names.emplace_back(memory_.begin() + static_cast<std::ptrdiff_t>(entry) + 1,
                         memory_.begin() + static_cast<std::ptrdiff_t>(entry) + 12);
    }
    return names;
  }

  fs::path base_;
  std::vector<std::uint8_t> memory_ = std::vector<std::uint8_t>(65536);
  std::optional<CpmFiles> files_;
  std::string fault_;
};

TEST_F(CpmDrives, ATextEndsInItsLastRecordWithControlZ) {
  host_file("a/Text.txt", std::string(130, 'x'));
  name("TEXT.TXT");
  EXPECT_EQ(call(15), 0);
  EXPECT_EQ(memory_[fcb + 15], 2);  // RC
  EXPECT_EQ(call(20), 0);
  EXPECT_EQ(record(), std::string(128, 'x'));
  EXPECT_EQ(memory_[fcb + 32], 1);  // CR
  EXPECT_EQ(call(20), 0);
  EXPECT_EQ(record(), "xx" + std::string(126, '\x1A'));
  EXPECT_EQ(call(20), 1);
  EXPECT_EQ(memory_[fcb + 32], 2);
}

// BDOS 2.2 clears S2, the module, in functions 15 and 22. MAC and others leave bytes there, which would mean megabytes.
TEST_F(CpmDrives, MakingAFileClearsTheModule) {
  name("NEW.DAT");
  memory_[fcb + 13] = 'F';
  memory_[fcb + 14] = 'T';
  EXPECT_EQ(call(22), 0);
  EXPECT_EQ(memory_[fcb + 14], 0);
  record('x');
  EXPECT_EQ(call(21), 0);
  EXPECT_EQ(host_file("a/NEW.DAT"), std::string(128, 'x'));
}

TEST_F(CpmDrives, ChangesAreOnTheHostAtOnce) {
  name("NEW.DAT");
  EXPECT_EQ(call(15), not_found);
  EXPECT_EQ(call(22), 0);
  record('1');
  EXPECT_EQ(call(21), 0);
  record('2');
  EXPECT_EQ(call(21), 0);
  EXPECT_EQ(host_file("a/NEW.DAT"), std::string(128, '1') + std::string(128, '2'));
  EXPECT_EQ(call(16), 0);
  name("NEW.DAT");
  EXPECT_EQ(call(22), not_found) << "a folder has only one file with a name";
  EXPECT_EQ(host_file("a/NEW.DAT").size(), 256U);
}

TEST_F(CpmDrives, AnExtentHas128RecordsAndTheNextFollowsAutomatically) {
  std::string content;
  for (int n = 0; n < 130; ++n) content += std::string(128, static_cast<char>('A' + n % 26));
  host_file("a/BIG", content);
  name("BIG");
  EXPECT_EQ(call(15), 0);
  EXPECT_EQ(memory_[fcb + 15], 128);
  std::string read;
  while (call(20) == 0) read += record();
  EXPECT_EQ(read, content);
  EXPECT_EQ(memory_[fcb + 12], 1);  // EX
  EXPECT_EQ(memory_[fcb + 32], 2);
  name("BIG");
  memory_[fcb + 12] = 1;
  EXPECT_EQ(call(15), 0);
  EXPECT_EQ(memory_[fcb + 15], 2);
  memory_[fcb + 12] = 2;
  EXPECT_EQ(call(15), not_found);
}

TEST_F(CpmDrives, RecordsAtRandom) {
  host_file("a/R", std::string(128, 'a') + std::string(128, 'b') + std::string(128, 'c'));
  name("R");
  ASSERT_EQ(call(15), 0);
  random(2);
  EXPECT_EQ(call(33), 0);
  EXPECT_EQ(record()[0], 'c');
  EXPECT_EQ(call(20), 0) << "a sequential access begins with the same record";
  EXPECT_EQ(record()[0], 'c');
  random(3);
  EXPECT_EQ(call(33), 1);
  random(128);
  EXPECT_EQ(call(33), 4) << "an extent that was never written";
  random(65536);
  EXPECT_EQ(call(33), 6);
  EXPECT_EQ(call(34), 6);
  random(200);
  record('z');
  EXPECT_EQ(call(40), 0);
  EXPECT_EQ(host_file("a/R").size(), 201U * 128);
  EXPECT_EQ(host_file("a/R").substr(3 * 128, 128), std::string(128, '\0'));
  EXPECT_EQ(memory_[fcb + 12], 1);
  EXPECT_EQ(memory_[fcb + 32], 72);
  EXPECT_EQ(call(36), 0);
  EXPECT_EQ(memory_[fcb + 33], 200);
  name("R");
  EXPECT_EQ(call(35), 0);
  EXPECT_EQ(memory_[fcb + 33] | memory_[fcb + 34] << 8 | memory_[fcb + 35] << 16, 201);
}

TEST_F(CpmDrives, AShortLastRecordIsPaddedBeforeMoreIsWritten) {
  host_file("a/T", "abc");
  name("T");
  ASSERT_EQ(call(15), 0);
  random(2);
  record('q');
  EXPECT_EQ(call(34), 0);
  EXPECT_EQ(host_file("a/T"), "abc" + std::string(125, '\x1A') + std::string(128, '\0') + std::string(128, 'q'));
}

TEST_F(CpmDrives, NamesAreListedInOrderAndOnlyThoseThatCpmCanHave) {
  for (const char* const each : {"b.txt", "A.TXT", "toolongname.txt", "c.text", ".hidden", "two.dots.x", "sp ace", "noext", "B.COM"})
    host_file(std::string("a/") + each, "x");
  fs::create_directory(base_ / "a" / "DIR");
  fs::create_symlink("/etc/passwd", base_ / "a" / "LINK");
  EXPECT_EQ(search("????????.???"), (std::vector<std::string>{"A       TXT", "B       COM", "B       TXT", "NOEXT      "}));
  EXPECT_EQ(search("?.TXT"), (std::vector<std::string>{"A       TXT", "B       TXT"}));
  name("LINK");
  EXPECT_EQ(call(15), not_found);
  name("DIR");
  EXPECT_EQ(call(15), not_found);
}

TEST_F(CpmDrives, ADirectoryEntryContainsTheExtent) {
  host_file("a/E", std::string(129 * 128, 'x'));
  name("E");
  memory_[fcb + 12] = '?';
  EXPECT_EQ(call(17), 0);
  EXPECT_EQ(memory_[transfer], 0);  // user
  EXPECT_EQ(memory_[transfer + 12], 0);
  EXPECT_EQ(memory_[transfer + 15], 128);
  EXPECT_EQ(call(18), 0);
  EXPECT_EQ(memory_[transfer + 12], 1);
  EXPECT_EQ(memory_[transfer + 15], 1);
  EXPECT_EQ(call(18), not_found);
  // Deleting found files does not lose the position of the search.
  host_file("a/F", "");
  host_file("a/G", "");
  name("?");
  EXPECT_EQ(call(17), 0);
  fs::remove(base_ / "a" / "E");
  EXPECT_EQ(call(18), 0);
  EXPECT_EQ(memory_[transfer + 1], 'F');
}

TEST_F(CpmDrives, FilesAreDeletedAndRenamed) {
  for (const char* const each : {"a/X1", "a/X2", "a/Y"}) host_file(each, "x");
  name("X?");
  EXPECT_EQ(call(19), 0);
  EXPECT_FALSE(fs::exists(base_ / "a" / "X1"));
  EXPECT_FALSE(fs::exists(base_ / "a" / "X2"));
  EXPECT_EQ(call(19), not_found);
  name("Y");
  put_name("Z.NEW", fcb + 16);
  EXPECT_EQ(call(23), 0);
  EXPECT_EQ(host_file("a/Z.NEW"), "x");
  host_file("a/Y", "y");
  EXPECT_EQ(call(23), not_found) << "the new name exists";
  EXPECT_EQ(host_file("a/Z.NEW"), "x");
}

TEST_F(CpmDrives, DrivesAreSelectedAndLocked) {
  host_file("b/ON.B", "b");
  EXPECT_EQ(call(12, 0), 0x22);
  EXPECT_EQ(call(24, 0), 1) << "the CCP has selected the current disk";
  EXPECT_EQ(call(14, 1), 0);
  EXPECT_EQ(call(25, 0), 1);
  EXPECT_EQ(call(24, 0), 3);
  EXPECT_EQ(call(29, 0), 2);
  name("ON.B");
  EXPECT_EQ(call(15), 0);
  call(21);
  EXPECT_EQ(fault_, "B: R/O");
  call(19);
  EXPECT_EQ(fault_, "B: R/O");
  EXPECT_EQ(host_file("b/ON.B"), "b");
  call(14, 2);
  EXPECT_EQ(fault_, "C: Select");
  name("P:X");
  call(15);
  EXPECT_EQ(fault_, "P: Select");
  call(13, 0);
  EXPECT_EQ(call(25, 0), 0);
  call(28, 0);
  name("NEW");
  call(22);
  EXPECT_EQ(fault_, "A: R/O");
  EXPECT_EQ(call(37, 1), 0);
  EXPECT_EQ(call(22), 0);
  EXPECT_EQ(fault_, "");
  call(32, 5);
  EXPECT_EQ(call(32, 0xFF), 5);
}

TEST_F(CpmDrives, UsersHaveAreas) {
  host_file("a/ZERO", "0");
  fs::create_directories(base_ / "a/3");
  host_file("a/3/THREE", "3");
  host_file("a/3/ZERO", "other");
  EXPECT_EQ(search("????????.???"), (std::vector<std::string>{"ZERO       "}));
  call(32, 3);
  EXPECT_EQ(search("????????.???"), (std::vector<std::string>{"THREE      ", "ZERO       "}));
  EXPECT_EQ(memory_[transfer], 3) << "the user of an entry";
  name("ZERO");
  EXPECT_EQ(call(15), 0);
  EXPECT_EQ(call(20), 0);
  EXPECT_EQ(record().substr(0, 5), "other");
  call(32, 9);
  EXPECT_EQ(call(15), not_found);
  EXPECT_EQ(call(19), not_found);
  EXPECT_FALSE(fs::exists(base_ / "a/9")) << "reading makes no area";
  name("NINE");
  EXPECT_EQ(call(22), 0);
  record('9');
  EXPECT_EQ(call(21), 0);
  EXPECT_EQ(host_file("a/9/NINE"), std::string(128, '9'));
  // With ? as drive the entries of all users, each with its user.
  name("X");
  memory_[fcb] = '?';
  std::string found;
  for (int code = call(17); code != not_found; code = call(18))
    found += std::to_string(memory_[transfer]) + std::string(memory_.begin() + transfer + 1, memory_.begin() + transfer + 6) + ' ';
  EXPECT_EQ(found, "0ZERO  3THREE 3ZERO  9NINE  ");
}

TEST_F(CpmDrives, AFolderMadeAgainIsOpenedAgain) {
  host_file("a/F", "first");
  name("F");
  EXPECT_EQ(call(15), 0);
  fs::remove_all(base_ / "a");
  EXPECT_EQ(call(20), 0);
  EXPECT_EQ(fault_, "A: Bad Sector");
  ASSERT_EQ(files_->troubles().size(), 1U);
  EXPECT_NE(files_->troubles()[0].text.find("no longer exists"), std::string::npos) << files_->troubles()[0].text;
  fs::create_directory(base_ / "a");
  host_file("a/F", "second");
  EXPECT_EQ(call(20), 0);
  EXPECT_EQ(fault_, "");
  EXPECT_EQ(record().substr(0, 6), "second");
}

TEST_F(CpmDrives, AFileCanBeReadOnly) {
  host_file("a/KEEP", "k");
  name("KEEP");
  memory_[fcb + 9] |= 0x80;
  EXPECT_EQ(call(30), 0);
  EXPECT_EQ(fs::status(base_ / "a" / "KEEP").permissions() & fs::perms::owner_write, fs::perms::none);
  name("KEEP");
  EXPECT_EQ(call(15), 0);
  EXPECT_EQ(memory_[fcb + 9], ' ' | 0x80);
  call(21);
  EXPECT_EQ(fault_, "A: File R/O");
  call(19);
  EXPECT_EQ(fault_, "A: File R/O");
  EXPECT_EQ(host_file("a/KEEP"), "k");
  name("KEEP");
  EXPECT_EQ(call(30), 0);
  EXPECT_EQ(call(19), 0);
}

TEST_F(CpmDrives, AFullDiskIsCodeTwoAndLeavesNoHalfRecord) {
  name("FULL");
  ASSERT_EQ(call(22), 0);
  ASSERT_EQ(call(21), 0);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto signal = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 200;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const int code = call(21);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, signal);
  EXPECT_EQ(code, 2);
  EXPECT_EQ(host_file("a/FULL").size(), 128U);
  EXPECT_EQ(memory_[fcb + 32], 1);
}

TEST_F(CpmDrives, OpeningWithoutClosingLeaksNothing) {
  const auto open_files = [] { return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator()); };
  const auto before = open_files();
  for (char c = 'A'; c <= 'Z'; ++c) host_file(std::string("a/") + c, "x");
  for (int n = 0; n < 20000; ++n) {
    name(std::string(1, static_cast<char>('A' + n % 26)));
    ASSERT_EQ(call(15), 0);
  }
  EXPECT_LE(open_files(), before + 8);
}

TEST_F(CpmDrives, AFileOf8MegabytesIsTheLargest) {
  fs::resize_file((host_file("a/HUGE", ""), base_ / "a" / "HUGE"), std::uint64_t{9} << 20);
  name("HUGE");
  EXPECT_EQ(call(35), 0);
  EXPECT_EQ(memory_[fcb + 35], 1);  // 65536 records
  random(65535);
  EXPECT_EQ(call(33), 0);
  EXPECT_EQ(call(20), 0);
  EXPECT_EQ(call(20), 1);
  EXPECT_EQ(call(21), 2);
}

TEST(CpmArguments, BecomeTheTailAndTwoBlocks) {
  std::vector<std::uint8_t> memory(65536, 0xAA);
  machines::cpm::put_arguments(" b:from.txt *.c?m", memory);
  const std::string tail = " B:FROM.TXT *.C?M";
  EXPECT_EQ(memory[0x80], tail.size());
  EXPECT_EQ(std::string(memory.begin() + 0x81, memory.begin() + 0x81 + static_cast<std::ptrdiff_t>(tail.size())), tail);
  EXPECT_EQ(memory[0x81 + tail.size()], 0);
  EXPECT_EQ(memory[0x5C], 2);
  EXPECT_EQ(std::string(memory.begin() + 0x5D, memory.begin() + 0x68), "FROM    TXT");
  EXPECT_EQ(memory[0x6C], 0);
  EXPECT_EQ(std::string(memory.begin() + 0x6D, memory.begin() + 0x78), "????????C?M");
}

TEST(CpmDriveOption, IsALetterAFolderAndALock) {
  const auto drive = machines::parse_cpm_drive("c=/tmp,ro");
  ASSERT_TRUE(drive);
  EXPECT_EQ(drive->number, 2U);
  EXPECT_EQ(drive->folder, "/tmp");
  EXPECT_TRUE(drive->read_only);
  for (const char* const bad : {"", "a", "a=", "q=/tmp", "=/tmp", "/tmp", "a=/no/such/folder", "a=/etc/passwd"})
    EXPECT_FALSE(machines::parse_cpm_drive(bad)) << bad;
}

// Any calls with any blocks: folders next to those of the drives, targets of links and the read-only drive are unchanged, and all
// created
// names are valid in CP/M.
TEST_F(CpmDrives, NothingOutsideIsTouchedByAnyCall) {
  fs::create_directory(base_ / "outside");
  host_file("outside/CANARY", "canary");
  host_file("b/LOCKED", "locked");
  fs::create_symlink(base_ / "outside" / "CANARY", base_ / "a" / "CANARY");
  fs::create_directory_symlink(base_ / "outside", base_ / "a" / "OUTSIDE");
  std::mt19937 dice(1979);
  const auto die = [&dice](unsigned sides) { return dice() % sides; };
  constexpr std::string_view likely("ABCANARY/.\\ ?*\x80\xFF\x00", 17);
  for (int n = 0; n < 60000; ++n) {
    const auto at = static_cast<std::uint16_t>(die(4) == 0 ? dice() : 0x5C);
    for (std::uint16_t k = 0; k < 36; ++k) {
      if (die(3) == 0) memory_[static_cast<std::uint16_t>(at + k)] = static_cast<std::uint8_t>(die(3) == 0 ? dice() : static_cast<std::uint8_t>(likely[die(static_cast<unsigned>(likely.size()))]));
    }
    if (die(8) == 0) put_name(die(2) == 0 ? "CANARY" : "../X", 0x5C);
    if (die(2) == 0) memory_[at] = static_cast<std::uint8_t>(die(3));
    std::uint8_t function;
    do function = static_cast<std::uint8_t>(12 + die(29));
    while (!CpmFiles::answers(function));
    call(function, at);
    // Records at high positions would make many long files.
    if (function == 34 || function == 40) fs::resize_file((host_file("a/S", ""), base_ / "a" / "S"), 0);
  }
  EXPECT_EQ(host_file("outside/CANARY"), "canary");
  EXPECT_EQ(std::distance(fs::directory_iterator(base_ / "outside"), fs::directory_iterator()), 1);
  EXPECT_EQ(host_file("b/LOCKED"), "locked");
  EXPECT_EQ(std::distance(fs::directory_iterator(base_ / "b"), fs::directory_iterator()), 1);
  EXPECT_EQ(std::distance(fs::directory_iterator(base_), fs::directory_iterator()), 3);
  EXPECT_TRUE(fs::is_symlink(base_ / "a" / "CANARY"));
  for (const auto& entry : fs::directory_iterator(base_ / "a")) {
    const std::string made = entry.path().filename();
    EXPECT_LE(made.size(), 12U);
    EXPECT_TRUE(std::all_of(made.begin(), made.end(), [](char c) { return c > ' ' && c < 0x7F && c != '/'; })) << made;
  }
}

}  // namespace
}  // namespace sightline::test
