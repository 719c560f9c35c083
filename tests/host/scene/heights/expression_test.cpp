// Expressions of x and z: their values, and errors with positions.
#include "host/scene/heights/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host/base/result.hpp"

namespace sightline::scene {
namespace {

HeightGrid grid_of(const std::string& expression, Interval domain = {-2, 2}, GridSize size = {5, 3}) {
  const auto result = sample_expression(expression, {domain, domain}, size);
  if (!result) {
    ADD_FAILURE() << result.error().message(base::MessageStyle::position);
    return {};
  }
  return *result;
}

base::Error error_of(const std::string& expression, GridSize size = {5, 3}) {
  const auto result = sample_expression(expression, {{-2, 2}, {-2, 2}}, size);
  if (!result) return result.error();
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

TEST(SampleExpression, OfXAndY) {
  const auto result = sample_expression("x + 10*y", {{-2, 2}, {0, 6}}, {5, 3});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->height(0, 0), -2);
  EXPECT_EQ(result->height(1, 1), 29);
  EXPECT_EQ(result->height(4, 2), 62);
  EXPECT_EQ(result->domain_x, (Interval{-2, 2}));
  EXPECT_EQ(result->domain_z, (Interval{0, 6}));
  EXPECT_EQ(result->names[1], "y");
  EXPECT_EQ(grid_of("x + 10*z").names[1], "z");
  const base::Error both = error_of("sin(xz) + y");
  EXPECT_EQ(both.place, "5");
  const base::Error two = error_of("cos(x) + y * z");
  EXPECT_EQ(two.place, "14");
  EXPECT_EQ(two.found, "z beside y");
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

TEST(SampleExpression, ErrorsHaveAPosition) {
  const base::Error unknown = error_of("sin(x) + frog(z)");
  EXPECT_EQ(unknown.place, "10");
  EXPECT_EQ(unknown.place, "10");
  EXPECT_NE(unknown.message(base::MessageStyle::position).find("\n  sin(x) + frog(z)\n           ^"),
            std::string::npos)
      << unknown.message(base::MessageStyle::position);
  EXPECT_EQ(unknown.file, "--function");
  EXPECT_EQ(error_of("x + w").place, "5");
  EXPECT_EQ(error_of("x + ").place, "5");
  EXPECT_EQ(error_of("(x + z").place, "7");
  EXPECT_EQ(error_of("x z").place, "3");
  EXPECT_EQ(error_of("x + * z").place, "5");
  EXPECT_EQ(error_of("max(x,z), z").place, "9");
}

// The parser counts from 0 and states that within its sentences.
TEST(SampleExpression, OnePositionIsReported) {
  for (const char* wrong : {"x + w", "x + ", "(x + z", "x z", "x + * z", "x,z", "sin(x,z)", "x : z", "\"x",
                            "sin()", ")", "max()", "(x,z)", "x ? z"}) {
    const base::Error error = error_of(wrong);
    EXPECT_EQ(error.message(base::MessageStyle::position).find("position"), std::string::npos)
        << error.message(base::MessageStyle::position);
    EXPECT_GT(error.found.size(), std::string("an error: ").size()) << wrong;
  }
  EXPECT_EQ(error_of("x,z").place, "2");
}

TEST(SampleExpression, AnAngleOfTwo) {
  EXPECT_EQ(grid_of("atan2(z, x)").height(4, 2), std::atan2(2.0, 2.0));
}

TEST(SampleExpression, AmbiguousExpressionsAreErrors) {
  EXPECT_EQ(error_of("x = 3").place, "3");
  EXPECT_NE(error_of("x = 3").message(base::MessageStyle::position).find("=="), std::string::npos);
  EXPECT_EQ(error_of("x += 3").place, "4");
  error_of("x, z");
  error_of("\"text\"");
  error_of("");
  error_of("x +\xC3\xA4");
  error_of("x\n+z");
  error_of(std::string(longest_expression + 1, '1'));
  error_of(std::string(500, '('));
}

TEST(SampleExpression, NowhereFinite) {
  const base::Error error = error_of("log(-1 - x*x)");
  EXPECT_NE(error.message(base::MessageStyle::position).find("nowhere finite"), std::string::npos);
  error_of("0/0");
  // None of the 65 x 65 points of the range, but a point of the grid.
  EXPECT_EQ(grid_of("x + 1 > 0.33 && x + 1 < 0.34 && z == -2 ? 5 : 0/0", {-2, 2}, {7, 2}).range,
            (Interval{5, 5}));
}

TEST(SampleExpression, SizesAreChecked) {
  EXPECT_NE(error_of("x", {1, 5}).message(base::MessageStyle::position).find("2 to 1024"), std::string::npos);
  error_of("x", {5, 1});
  error_of("x", {1025, 5});
  error_of("x", {5, 1025});
}

TEST(ReadDomain, TwoNumbers) {
  EXPECT_EQ(*read_domain("-3:3"), (Interval{-3, 3}));
  EXPECT_EQ(*read_domain("+1e-3:2.5"), (Interval{0.001, 2.5}));
  EXPECT_EQ(*read_domain("-1e-400:1"), (Interval{0, 1})) << "too close to 0 to differ from it";
  for (const char* bad :
       {"", ":", "3", "3:", ":3", "3:3", "3:-3", "a:b", "0:nan", "0:inf", "0:1:2", "0 :1", "0:1e999"})
    EXPECT_FALSE(read_domain(bad)) << bad;
  EXPECT_EQ(read_domain("3:-3").error().message(base::MessageStyle::position),
            "--domain: found '3:-3', expected A:B with numbers A < B, such as -3:3");
}

}  // namespace
}  // namespace sightline::scene
