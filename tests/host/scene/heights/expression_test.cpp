// Expressions of x and z: what they mean, and errors that point at their place.
#include "host/scene/heights/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sightline::scene {
namespace {

HeightGrid grid_of(const std::string& expression, Interval domain = {-2, 2}, GridSize size = {5, 3}) {
  const auto result = sample_expression(expression, domain, size);
  if (const auto* error = std::get_if<HeightError>(&result)) {
    ADD_FAILURE() << error->message();
    return {};
  }
  return std::get<HeightGrid>(result);
}

HeightError error_of(const std::string& expression, GridSize size = {5, 3}) {
  const auto result = sample_expression(expression, {-2, 2}, size);
  if (const auto* error = std::get_if<HeightError>(&result)) return *error;
  ADD_FAILURE() << "no error: " << expression;
  return {};
}

TEST(SampleExpression, OfXAndZ) {
  const HeightGrid grid = grid_of("x + 10*z");
  ASSERT_EQ(grid.heights.size(), 15U);
  EXPECT_EQ(grid.height(0, 0), -22);
  EXPECT_EQ(grid.height(1, 1), -1);
  EXPECT_EQ(grid.height(4, 2), 22);
  EXPECT_EQ(grid.range, (Interval{-22, 22}));
  EXPECT_EQ(grid.domain_z, (Interval{-2, 2}));
}

TEST(SampleExpression, FunctionsConstantsAndChoice) {
  EXPECT_NEAR(grid_of("sin(sqrt(x*x+z*z))").height(0, 2), std::sin(std::sqrt(8.0)), 1e-15);
  EXPECT_EQ(grid_of("x >= 0 ? 1 : 0").height(0, 0), 0);
  EXPECT_EQ(grid_of("x >= 0 ? 1 : 0").height(2, 0), 1);
  EXPECT_EQ(grid_of("x == 0").height(2, 0), 1);
  EXPECT_NEAR(grid_of("cos(pi) + ln(e)").height(0, 0), 0, 1e-15);
  EXPECT_EQ(grid_of("2^3^2 + x*0").height(0, 0), 512);
  EXPECT_EQ(grid_of("-2.5e1").height(3, 1), -25);
}

TEST(SampleExpression, UndefinedHeightsAreHoles) {
  const HeightGrid grid = grid_of("sqrt(x)");
  EXPECT_TRUE(std::isnan(grid.height(0, 0)));
  EXPECT_EQ(grid.height(2, 0), 0);
  EXPECT_FALSE(std::isfinite(grid_of("1/x").height(2, 1)));
}

TEST(SampleExpression, ErrorsPointAtTheirPlace) {
  const HeightError unknown = error_of("sin(x) + frog(z)");
  EXPECT_EQ(unknown.place, "10");
  EXPECT_EQ(unknown.caret, 9U);
  EXPECT_NE(unknown.message().find("\n  sin(x) + frog(z)\n           ^"), std::string::npos)
      << unknown.message();
  EXPECT_EQ(unknown.source, "--function");
  EXPECT_EQ(error_of("x + y").caret, 4U);
  EXPECT_EQ(error_of("x + ").caret, 4U);
  EXPECT_EQ(error_of("(x + z").caret, 6U);
  EXPECT_EQ(error_of("x z").caret, 2U);
  EXPECT_EQ(error_of("x + * z").caret, 4U);
  EXPECT_EQ(error_of("max(x,z), z").caret, 8U);
}

// The parser counts from 0 and says so in the middle of its sentences.
TEST(SampleExpression, OnePlaceIsSaid) {
  for (const char* wrong : {"x + y", "x + ", "(x + z", "x z", "x + * z", "x,z", "sin(x,z)", "x : z", "\"x",
                            "sin()", ")", "max()", "(x,z)", "x ? z"}) {
    const HeightError error = error_of(wrong);
    EXPECT_EQ(error.message().find("position"), std::string::npos) << error.message();
    EXPECT_GT(error.found.size(), std::string("an error: ").size()) << wrong;
  }
  EXPECT_EQ(error_of("x,z").caret, 1U);
}

TEST(SampleExpression, AnAngleOfTwo) {
  EXPECT_EQ(grid_of("atan2(z, x)").height(4, 2), std::atan2(2.0, 2.0));
}

TEST(SampleExpression, WhatOtherwiseWouldBeTakenForSomethingElse) {
  EXPECT_EQ(error_of("x = 3").caret, 2U);
  EXPECT_NE(error_of("x = 3").message().find("=="), std::string::npos);
  EXPECT_EQ(error_of("x += 3").caret, 3U);
  error_of("x, z");
  error_of("\"text\"");
  error_of("");
  error_of("x +\xC3\xA4");
  error_of("x\n+z");
  error_of(std::string(longest_expression + 1, '1'));
  error_of(std::string(500, '('));
}

TEST(SampleExpression, NowhereFinite) {
  const HeightError error = error_of("log(-1 - x*x)");
  EXPECT_NE(error.message().find("nowhere finite"), std::string::npos);
  error_of("0/0");
  // Nothing of the 65 x 65 points of the range, but a point of the grid.
  EXPECT_EQ(grid_of("x + 1 > 0.33 && x + 1 < 0.34 && z == -2 ? 5 : 0/0", {-2, 2}, {7, 2}).range,
            (Interval{5, 5}));
}

TEST(SampleExpression, SizesAtTheDoor) {
  EXPECT_NE(error_of("x", {1, 5}).message().find("2 to 1024"), std::string::npos);
  error_of("x", {5, 1});
  error_of("x", {1025, 5});
  error_of("x", {5, 1025});
}

TEST(ReadDomain, TwoNumbers) {
  EXPECT_EQ(std::get<Interval>(read_domain("-3:3")), (Interval{-3, 3}));
  EXPECT_EQ(std::get<Interval>(read_domain("+1e-3:2.5")), (Interval{0.001, 2.5}));
  EXPECT_EQ(std::get<Interval>(read_domain("-1e-400:1")), (Interval{0, 1}))
      << "too near 0 to be told from it";
  for (const char* bad :
       {"", ":", "3", "3:", ":3", "3:3", "3:-3", "a:b", "0:nan", "0:inf", "0:1:2", "0 :1", "0:1e999"})
    EXPECT_TRUE(std::holds_alternative<HeightError>(read_domain(bad))) << bad;
  EXPECT_EQ(std::get<HeightError>(read_domain("3:-3")).message(),
            "--domain: found '3:-3', expected A:B with numbers A < B, such as -3:3");
}

}  // namespace
}  // namespace sightline::scene
