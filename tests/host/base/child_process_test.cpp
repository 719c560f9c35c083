// What a process of its own answers, throws, and dies of.
#include "host/base/child_process.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace sightline::base {
namespace {

using Answer = Result<std::string>;

TEST(Apart, TheAnswerIsComplete) {
  const std::string large(3'000'000, '\0');
  const auto answer = run_in_child([&]() -> Answer { return "x" + large; });
  ASSERT_TRUE(answer);
  EXPECT_EQ(*answer, "x" + large);
  EXPECT_EQ(*run_in_child([]() -> Answer { return std::string(); }), "");
}

TEST(Apart, ErrorsKeepTheirFields) {
  const Error error{"file", "line 3", "found", "expected", "remedy"};
  const auto answer = run_in_child([&]() -> Answer { return error; });
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error(), error);
}

TEST(Apart, WhatItChangesIsLost) {
  int here = 1;
  EXPECT_TRUE(run_in_child([&]() -> Answer {
    here = 2;
    return std::to_string(here);
  }));
  EXPECT_EQ(here, 1);
}

TEST(Apart, NothingItDoesEndsThisProcess) {
  EXPECT_EQ(run_in_child([]() -> Answer { throw std::runtime_error("thrown"); }).error().found, "thrown");
  EXPECT_EQ(run_in_child([]() -> Answer { std::abort(); }).error().found, "crashed (Aborted)");
  EXPECT_EQ(run_in_child([]() -> Answer { std::_Exit(0); }).error().found, "crashed");
  EXPECT_EQ(run_in_child([]() -> Answer {
              std::raise(SIGKILL);
              return std::string();
            }).error().found.substr(0, 10), "takes more");
  volatile bool forever = true;
  const auto endless = run_in_child([&]() -> Answer {
    while (forever) {
    }
    return std::string();
  }, {.seconds = 1});
  EXPECT_EQ(endless.error().found.substr(0, 25), "takes more than 1 seconds");
}

}  // namespace
}  // namespace sightline::base
