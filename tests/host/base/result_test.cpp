#include "host/base/result.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace sightline::base {
namespace {

TEST(Error, MessageOmitsEmptyFields) {
  EXPECT_EQ((Error{"a.png", "byte 41", "no IDAT", "image data"}).message(),
            "a.png: byte 41: no IDAT, expected image data");
  EXPECT_EQ((Error{"a.png", "", "cannot read: No such file or directory"}).message(),
            "a.png: cannot read: No such file or directory");
  EXPECT_EQ((Error{"", "cell 3", "overlaps cell 4"}).message(), "cell 3: overlaps cell 4");
  EXPECT_EQ(bad_input("the eye is inside a solid").message(), "the eye is inside a solid");
}

TEST(Error, KnowsItsKind) {
  EXPECT_EQ(Error{}.kind, ErrorKind::bad_input);
  EXPECT_EQ(usage_error("--at: found 3").kind, ErrorKind::usage);
  EXPECT_EQ(program_failed("it stopped").kind, ErrorKind::program_failed);
  EXPECT_EQ(difference("word 3").kind, ErrorKind::differs);
  EXPECT_EQ(io_error("cannot write").kind, ErrorKind::io);
  EXPECT_NE(usage_error("one complaint"), io_error("one complaint"));
}

TEST(Error, MessageEndsWithTheRemedyAndTheExcerpt) {
  Error error{"--function", "5", "an assignment", "a comparison", "write == for ="};
  error.excerpt = "  x = z\n    ^";
  EXPECT_EQ(error.message(MessageStyle::position),
            "--function:5: found an assignment, expected a comparison; write == for =\n  x = z\n    ^");
}

TEST(Error, StylesNamePlacesAsEditorsOrPeopleDo) {
  const Error error{"a.hex", "3:12", "\"G\"", "a digit"};
  EXPECT_EQ(error.message(), "a.hex: 3:12: \"G\", expected a digit");
  EXPECT_EQ(error.message(MessageStyle::position), "a.hex:3:12: found \"G\", expected a digit");
  EXPECT_EQ(error.message(MessageStyle::compiler), "a.hex:3:12: error: found \"G\", expected a digit");
  const Error whole{"a.hex", "", "an empty file", "bytes"};
  EXPECT_EQ(whole.message(MessageStyle::compiler), "a.hex: error: found an empty file, expected bytes");
}

TEST(Result, HoldsAValueOrAnError) {
  const Result<std::string> good(std::string("text"));
  ASSERT_TRUE(good);
  EXPECT_EQ(*good, "text");
  EXPECT_EQ(good->size(), 4U);
  EXPECT_THROW(static_cast<void>(good.error()), std::bad_variant_access);
  const Result<std::string> bad = bad_input("nothing");
  ASSERT_FALSE(bad.has_value());
  EXPECT_EQ(bad.error(), bad_input("nothing"));
  EXPECT_THROW(static_cast<void>(*bad), std::bad_variant_access);
}

TEST(Result, ReleasesMoveOnlyValues) {
  Result<std::unique_ptr<int>> result(std::make_unique<int>(7));
  const std::unique_ptr<int> taken = std::move(*result);
  EXPECT_EQ(*taken, 7);
}

TEST(Result, HoldsAListOfErrors) {
  const Result<Done, std::vector<Error>> checked(std::vector{bad_input("one"), bad_input("two")});
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().size(), 2U);
}

}  // namespace
}  // namespace sightline::base
