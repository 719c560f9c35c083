// The RB09 as users see it: the test system of tests/data/disk_system boots from an image and takes commands through the console;
// damaged images are errors, and an image is written back completely or not at all.
#include <gtest/gtest.h>

#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "tests/host/app/command_line.hpp"
#include "tests/host/live/disk_system.hpp"
#include "tests/support/effort.hpp"

namespace sightline::test {
namespace {

class Disk : public CommandLine {
 protected:
  void SetUp() override {
    ASSERT_EQ(sightline({"asm", "pdp7", disk_system_file("boot.s").string(), "-o", "boot.rim"}).exit_code, 0);
    image_ = disk_system_image();
    write("disk", image_);
  }
  void put(std::size_t place, std::uint32_t word) { put_disk_word(image_, place, word); }
  static std::uint32_t word(const std::string& image, std::size_t place) {
    std::uint32_t word = 0;
    for (unsigned n = 4; n-- > 0;) word = word << 8 | static_cast<unsigned char>(image[4 * place + n]);
    return word;
  }
  // Boots and executes `steps` after the prompt, with further options of the command line.
  Ran session(std::vector<std::string> steps, std::vector<std::string> more = {}) {
    std::vector<std::string> words{"run", "pdp7", "boot.rim", "--disk", "disk", "--console", "unix", "--expect", "*"};
    words.insert(words.end(), steps.begin(), steps.end());
    words.insert(words.end(), more.begin(), more.end());
    return sightline(words);
  }

  std::string image_;
};

TEST_F(Disk, ASystemBootsReadsAndWrites) {
  put(3 * 64, 'Q');
  write("disk", image_);
  const Ran ran = session({"--send", "r3", "--expect", "r3Q\r\n*", "--send", "w5Z", "--expect", "w5Zk\r\n*", "--send", "r5",
                           "--expect", "r5Z\r\n*", "--send", "h"},
                          {"--strict"});
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_EQ(ran.out, "*r3Q\r\n*w5Zk\r\n*r5Z\r\n*h");
  EXPECT_NE(ran.err.find("stopped by      halt"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("384 words read and 64 written in 4 transfers, 0 timing errors"), std::string::npos) << ran.err;
  // Only the written word changes; sector 5 received 64 words of core from 500 on, of which the first is Z.
  const std::string after = read("disk");
  ASSERT_EQ(after.size(), bytes_of_disk);
  EXPECT_EQ(word(after, 5 * 64), static_cast<std::uint32_t>('Z'));
  for (std::size_t place = 0; place < bytes_of_disk / 4; ++place) {
    if (place == 5 * 64) continue;
    ASSERT_EQ(word(after, place), word(image_, place)) << place;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"boot.rim", "disk"}));
}

TEST_F(Disk, ALockedDiskIsNotChanged) {
  const Ran ran = session({"--send", "w5Z", "--expect", "w5Z!", "--send", "h"}, {"--disk-read-only"});
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_EQ(read("disk"), image_);
}

TEST_F(Disk, AMonitorSessionCanSwapDisks) {
  write("other", std::string(bytes_of_disk, '\0'));
  const Ran ran = sightline({"monitor", "pdp7", "boot.rim", "--disk", "disk", "--console", "unix"},
                            "expect \"*\"\nsend \"w5Z\"\nexpect \"k\"\nshow devices\nattach disk other\nsend \"r5\"\nexpect \"r5\"\n"
                            "run for 100ms\ndetach disk\nsend \"r5\"\nexpect \"!\"\n");
  EXPECT_EQ(ran.exit_code, 0) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("track 0 sector 6 word 0 (decimal)"), std::string::npos) << ran.out;
  EXPECT_EQ(word(read("disk"), 5 * 64), static_cast<std::uint32_t>('Z'));
  EXPECT_EQ(read("other"), std::string(bytes_of_disk, '\0'));
}

// Only Ctrl-C ends this session: earlier writes are written back.
TEST_F(Disk, CtrlCInAPipedMonitorWritesTheDiskBack) {
  write("commands", "expect \"*\"\nsend \"w5Z\"\nexpect \"k\"\nrun until 1==0\nev 1\n");
  const Ran ran = run_interrupted({"monitor", "pdp7", "boot.rim", "--disk", "disk", "--console", "unix", "--do", "commands"});
  EXPECT_EQ(ran.exit_code, 130) << ran.out << ran.err;
  EXPECT_EQ(word(read("disk"), 5 * 64), static_cast<std::uint32_t>('Z')) << ran.out;
}

// Killed at any moment: the image is the old one or the new one, without additional files.
TEST_F(Disk, AKilledRunLeavesACompleteImage) {
  const Arguments words{"run", "pdp7", "boot.rim", "--disk", "disk", "--console", "unix", "--expect", "*", "--send", "w5Z", "--expect", "k"};
  ASSERT_EQ(sightline(words).exit_code, 0);
  const std::string written = read("disk");
  ASSERT_TRUE(written != image_);
  std::mt19937 random(33);
  const auto begun = std::chrono::steady_clock::now();
  static_cast<void>(sightline(words));
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begun);
  for (int n = 0; n < sightline::tests::effort(12, 4); ++n) {
    write("disk", image_);
    start_and_kill(words, whole * (70 + static_cast<int>(random() % 35)) / 100);
    const std::string now = read("disk");
    EXPECT_TRUE(now == image_ || now == written) << n;
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"boot.rim", "disk"}));
}

TEST_F(Disk, WritingBackKeepsThePermissionsOfTheImage) {
  std::filesystem::permissions(path("disk"), std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  EXPECT_EQ(session({"--send", "w5Z", "--expect", "k"}).exit_code, 0);
  EXPECT_EQ(word(read("disk"), 5 * 64), static_cast<std::uint32_t>('Z'));
  EXPECT_EQ(std::filesystem::status(path("disk")).permissions(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

// An image that cannot be written back is an error before the run.
TEST_F(Disk, AReadOnlyImageIsAnErrorUnlessTheDriveIsLocked) {
  std::filesystem::permissions(path("disk"), std::filesystem::perms::owner_read);
  if (access(path("disk").c_str(), W_OK) == 0) GTEST_SKIP() << "this user may write every file";
  const Ran ran = session({"--send", "w5Z", "--expect", "k"});
  EXPECT_EQ(ran.exit_code, 5);
  EXPECT_EQ(ran.out, "");
  EXPECT_NE(ran.err.find("--disk-read-only leaves it as it is"), std::string::npos) << ran.err;
  EXPECT_EQ(session({"--send", "h"}, {"--disk-read-only"}).exit_code, 0);
  EXPECT_TRUE(read("disk") == image_);
}

// The other outputs of a run are written although the disk cannot be.
TEST_F(Disk, ARemovedFolderLosesOnlyTheDisk) {
  std::filesystem::create_directory(path("folder"));
  std::filesystem::rename(path("disk"), path("folder/disk"));
  write("gone.s",
        "100/\nbegin, 707141\n  lac (777700\n  707124\n  cla\n  707142\n  707104\n  lac (3000\n  707144\n  707121\n  jmp .-1\n"
        "  lac (252\n  700406\nwait, 700301\n  jmp wait\n  hlt\n  start begin\n");
  ASSERT_EQ(sightline({"asm", "pdp7", "gone.s", "-o", "gone.rim"}).exit_code, 0);
  // The folder is removed when the program has written and reports it; then a key ends it.
  const std::string script = "cd '" + path(".").string() + "' && mkfifo keys && { " + command_of_this_build() +
                             " run pdp7 gone.rim --disk folder/disk --console ascii --dump d < keys > out 2> err & exec 3> keys; "
                             "until test -s out; do sleep 0.02; done; rm -r folder; echo x >&3; exec 3>&-; wait $!; }";
  const int status = std::system(script.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 5) << read("err");
  EXPECT_TRUE(exists("d")) << read("err");
  EXPECT_NE(read("err").find("folder/disk: cannot write: No such file or directory"), std::string::npos) << read("err");
}

TEST_F(Disk, ATransferContinuesFromASnapshot) {
  // The boot program waits a revolution of 34 ms, some 19,300 instructions, then 256 words pass in 1.7 ms.
  constexpr int all = 60000;
  const auto run_for = [this](std::vector<std::string> words, int instructions, std::vector<std::string> more) {
    words.insert(words.end(), {"--disk", "disk", "--max-instructions", std::to_string(instructions)});
    words.insert(words.end(), more.begin(), more.end());
    const Ran ran = sightline(words);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return ran.out;
  };
  run_for({"run", "pdp7", "boot.rim"}, all, {"--dump", "whole"});
  for (const int first : {0, 100, 19000, 19320, 19400, 19500, 19700, 19900, 21000}) {
    const std::string report = run_for({"run", "pdp7", "boot.rim"}, first, {"--save", "s"});
    const bool under_way = report.find(" 0 words read") == std::string::npos && report.find(" 256 words read") == std::string::npos;
    EXPECT_EQ(under_way, first >= 19320 && first <= 19900) << first << report;
    run_for({"run", "pdp7", "--restore", "s"}, all - first, {"--dump", "half"});
    EXPECT_TRUE(read("half") == read("whole")) << first;
  }
  // With another disk it is a different machine.
  image_[0] = 1;
  write("other", image_);
  const Ran other = sightline({"run", "pdp7", "--restore", "s", "--disk", "other"});
  EXPECT_EQ(other.exit_code, 4);
  EXPECT_NE(other.err.find("found another medium, expected the disk image of the run that made the snapshot"), std::string::npos) << other.err;
}

// A snapshot holds what its run has written: the image may be the one before that run, or the one that it has written back, but
// no sector that the run has not written may be another.
TEST_F(Disk, ASnapshotTakesTheImageThatItsRunHasWrittenBack) {
  // Writes words 0 to 77 of core on the first sector again and again; word 20 counts.
  write("writes.s",
        "100/\nbegin, isz 20\n  707141\n  lac (777700\n  707124\n  cla\n  707142\n  707104\n  lac (3000\n  707144\n  707121\n"
        "  jmp .-1\n  jmp begin\n  start begin\n");
  ASSERT_EQ(sightline({"asm", "pdp7", "writes.s", "-o", "writes.rim"}).exit_code, 0);
  const Ran first = sightline({"run", "pdp7", "writes.rim", "--disk", "disk", "--max-time", "0.3", "--save", "s"});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const std::string written = read("disk");
  ASSERT_TRUE(written != image_);
  const auto restored = [this](const std::string& image) {
    write("copy", image);
    const Ran ran = sightline({"run", "pdp7", "--restore", "s", "--disk", "copy", "--max-time", "0.3", "--dump", "d"});
    return ran.exit_code == 0 ? read("d") + read("copy") : ran.err;
  };
  const std::string from_before = restored(image_);
  EXPECT_TRUE(restored(written) == from_before);
  ASSERT_EQ(sightline({"run", "pdp7", "writes.rim", "--disk", "disk", "--max-time", "0.6"}).exit_code, 0);
  EXPECT_TRUE(restored(read("disk")) == from_before);  // a later content of the same sector
  // Two other words are exchanged: each is as valid as before.
  std::string exchanged = written;
  for (unsigned n = 0; n < 4; ++n) std::swap(exchanged[4 * 8000 + n], exchanged[4 * (180 * words_per_track) + n]);
  ASSERT_TRUE(exchanged != written);
  EXPECT_NE(restored(exchanged).find("found another medium"), std::string::npos);
  EXPECT_EQ(read("copy"), exchanged);
}

TEST_F(Disk, DamagedImagesAreErrors) {
  const auto refused = [this](const std::string& image) {
    write("bad", image);
    const Ran ran = sightline({"run", "pdp7", "boot.rim", "--disk", "bad"});
    EXPECT_EQ(ran.exit_code, 4);
    EXPECT_EQ(read("bad"), image);
    return ran.err;
  };
  EXPECT_NE(refused(image_.substr(1)).find("found 4095999 bytes, expected 4096000"), std::string::npos);
  EXPECT_NE(refused(image_ + " ").find("found 4096001 bytes"), std::string::npos);
  EXPECT_NE(refused("").find("found 0 bytes"), std::string::npos);
  put(1000, 01000000);
  EXPECT_NE(refused(image_).find("bad: byte 4000: found 1000000, expected a word of 18 bits"), std::string::npos);
  EXPECT_EQ(sightline({"run", "pdp7", "boot.rim", "--disk", "missing"}).exit_code, 5);
  EXPECT_EQ(sightline({"run", "pdp7", "boot.rim", "--disk-read-only"}).exit_code, 2);
}

TEST_F(Disk, ADivideCanMakeAWordLate) {
  // The boot program, then a transfer during divides of 5.5 us and more, with words of 1.8 us.
  write("late.s",
        "100/\nbegin, 707141\n  lac (777700\n  707124\n  cla\n  707142\n  707104\n  lac (2000\n  707144\nloop, 640323\n  17777\n"
        "  707121\n  jmp loop\n  707132\n  hlt\n  start begin\n");
  ASSERT_EQ(sightline({"asm", "pdp7", "late.s", "-o", "late.rim"}).exit_code, 0);
  const Ran late = sightline({"run", "pdp7", "late.rim", "--disk", "disk", "--timing", "disk_word=1800"});
  EXPECT_EQ(late.exit_code, 0) << late.err;
  EXPECT_NE(late.err.find("timing error"), std::string::npos) << late.err;
}

// Choices where the documents are silent: 703361 skips the CMA or not, 703317 skips it (TTS) or has no effect.
TEST_F(Disk, ChoicesAreSet) {
  const auto ac = [this](const std::string& word, const std::vector<std::string>& more) {
    write("choice.oct", "100:\n750000 " + word + " 740001 740040\n");
    std::vector<std::string> line{"run", "pdp7", "choice.oct", "--start", "100", "--dump", "dump"};
    line.insert(line.end(), more.begin(), more.end());
    const Ran ran = sightline(line);
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return read("dump").find("777777") == std::string::npos ? 0 : 1;
  };
  EXPECT_EQ(ac("703361", {}), 0);
  EXPECT_EQ(ac("703361", {"--timing", "skip_703361=0"}), 1);
  EXPECT_EQ(ac("703341", {"--timing", "skip_703361=0"}), 0);
  EXPECT_EQ(ac("703317", {}), 0);
  EXPECT_EQ(ac("703317", {"--timing", "device_33_each_pulse=0"}), 1);
  EXPECT_EQ(ac("703301", {"--timing", "device_33_each_pulse=0"}), 0);
  // A snapshot belongs to a machine with the same choices.
  ASSERT_EQ(sightline({"run", "pdp7", "boot.rim", "--disk", "disk", "--max-time", "0.1", "--save", "s"}).exit_code, 0);
  for (const char* const other : {"disk_clear_stops=0", "disk_late_stops=0", "disk_after_last=64", "skip_703361=0"}) {
    const Ran ran = sightline({"run", "pdp7", "--restore", "s", "--disk", "disk", "--timing", other});
    EXPECT_EQ(ran.exit_code, 4) << other;
    EXPECT_NE(ran.err.find(std::string(other).substr(0, 9)), std::string::npos) << ran.err;
  }
  EXPECT_EQ(sightline({"run", "pdp7", "boot.rim", "--disk", "disk", "--timing", "disk_after_last=1024000"}).exit_code, 2);
}

}  // namespace
}  // namespace sightline::test
