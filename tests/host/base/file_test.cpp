// Files are written completely or not at all; the errors of reading and writing.
#include "host/base/file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>

#include "tests/support/approve.hpp"

namespace sightline::base {
namespace {

// A separate directory for each test in the build tree, removed afterwards.
class FileTest : public testing::Test {
 protected:
  void SetUp() override {
    directory_ = std::filesystem::current_path() /
                 (std::string("sightline-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(directory_);
    std::filesystem::create_directories(directory_);
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }
  [[nodiscard]] std::string path(const std::string& name) const { return (directory_ / name).string(); }
  [[nodiscard]] long files() const {
    return std::distance(std::filesystem::directory_iterator(directory_),
                         std::filesystem::directory_iterator());
  }

  std::filesystem::path directory_;
};

TEST_F(FileTest, AppearsOnlyWhenComplete) {
  {
    auto file = AtomicFile::create(path("log"));
    ASSERT_TRUE(file) << file.error().message();
    file->write(std::string_view("half"));
    EXPECT_FALSE(std::filesystem::exists(path("log")));
  }
  EXPECT_EQ(files(), 0);
  ASSERT_TRUE(write_file_atomically(path("log"), std::string_view("first")));
  {
    auto file = AtomicFile::create(path("log"));
    ASSERT_TRUE(file) << file.error().message();
    file->write(std::string_view("second, given up"));
  }
  EXPECT_EQ(tests::read_whole(path("log")), "first");
  ASSERT_TRUE(write_file_atomically(path("log"), std::string_view("third")));
  EXPECT_EQ(tests::read_whole(path("log")), "third");
  EXPECT_EQ(files(), 1);
}

TEST_F(FileTest, KeepsLinksAndLeftoverFiles) {
  ASSERT_TRUE(write_file_atomically(path("target"), std::string_view("old")));
  ASSERT_TRUE(write_file_atomically(path("link.partial"), std::string_view("somebody else's")));
  ASSERT_TRUE(write_file_atomically(path("target.partial"), std::string_view("somebody else's")));
  std::filesystem::create_symlink(path("target"), path("link"));
  ASSERT_TRUE(write_file_atomically(path("link"), std::string_view("new")));
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_EQ(tests::read_whole(path("target")), "new");
  EXPECT_EQ(tests::read_whole(path("target.partial")), "somebody else's");
}

// Such a link may lead anywhere: to a disk that is not mounted, or out of an unpacked archive of somebody else.
TEST_F(FileTest, ADanglingLinkIsAnError) {
  std::filesystem::create_symlink(path("nothing"), path("link"));
  const auto written = write_file_atomically(path("link"), std::string_view("x"));
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message().find("symbolic link to " + path("nothing")), std::string::npos)
      << written.error().message();
  EXPECT_FALSE(std::filesystem::exists(path("nothing")));
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  std::filesystem::create_symlink(path("circle"), path("circle"));
  EXPECT_FALSE(write_file_atomically(path("circle"), std::string_view("x")));
  EXPECT_EQ(files(), 2);
}

TEST_F(FileTest, AFileThatIsReplacedKeepsItsPermissions) {
  const std::string name = path("private");
  ASSERT_TRUE(write_file_atomically(name, std::string_view("old")));
  ASSERT_EQ(chmod(name.c_str(), 0640), 0);
  ASSERT_TRUE(write_file_atomically(name, std::string_view("new")));
  struct stat status {};
  ASSERT_EQ(stat(name.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0640U);
}

// As a user other than root: in a separate process if root runs the tests.
TEST_F(FileTest, AReadOnlyFileIsNotReplaced) {
  const std::string name = path("locked");
  ASSERT_TRUE(write_file_atomically(name, std::string_view("old")));
  ASSERT_EQ(chmod(name.c_str(), 0444), 0);
  ASSERT_EQ(chmod(directory_.c_str(), 0777), 0);
  enum Outcome : int { refused, replaced, other_error, out_of_reach };
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    constexpr uid_t nobody = 65534;
    if (geteuid() == 0 && setuid(nobody) != 0) _exit(out_of_reach);
    if (!write_file_atomically(path("beside"), std::string_view("new"))) _exit(out_of_reach);
    const auto done = write_file_atomically(name, std::string_view("new"));
    if (done) _exit(replaced);
    _exit(done.error().message() == name + ": cannot write: Permission denied" ? refused : other_error);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  if (WEXITSTATUS(status) == out_of_reach) GTEST_SKIP() << "another user cannot write in the build folder";
  EXPECT_EQ(WEXITSTATUS(status), refused);
  EXPECT_EQ(tests::read_whole(name), "old");
}

TEST_F(FileTest, ErrorsNameFileAndCause) {
  const auto nowhere = write_file_atomically(path("no/such/file"), std::string_view("x"));
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().message(), path("no/such/file") + ": cannot write: No such file or directory");
  const auto directory = write_file_atomically(directory_.string(), std::string_view("x"));
  ASSERT_FALSE(directory);
  EXPECT_NE(directory.error().message().find("Is a directory"), std::string::npos);
  const auto full = write_file_atomically("/dev/full", std::string_view("x"));
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().message(), "/dev/full: cannot write: No space left on device");
  EXPECT_TRUE(write_file_atomically("/dev/null", std::string_view("x")));
  EXPECT_FALSE(read_file(directory_.string()));
  ASSERT_TRUE(write_file_atomically(path("big"), std::string_view("12345")));
  EXPECT_FALSE(read_file(path("big"), 4));
  EXPECT_TRUE(read_file(path("big"), 5));
}

}  // namespace
}  // namespace sightline::base
