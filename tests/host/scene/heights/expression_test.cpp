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

TEST(SampleExpression, TextsThatAreNoExpressions) {
  for (const char* wrong : {"x + w", "x + ", "(x + z", "x z", "x + * z", "x,z", "sin(x,z)", "x : z", "\"x",
                            "sin()", ")", "max()", "(x,z)", "x ? z"}) {
    const base::Error error = error_of(wrong);
    EXPECT_FALSE(error.place.empty() || error.found.empty() || error.expected.empty()) << wrong;
  }
  EXPECT_EQ(error_of("x,z").place, "2");
}

// Places of the errors, counted by hand.
TEST(SampleExpression, Errors) {
  const auto message = [](const std::string& text) {
    base::Error error = error_of(text);
    error.excerpt.clear();
    return error.message(base::MessageStyle::position);
  };
  EXPECT_EQ(message("x + w"),
            "--function:5: found the unknown name w, expected x, y or z, pi, e or a function: sin cos tan asin acos atan atan2 sinh cosh tanh "
            "asinh acosh atanh exp ln log log2 log10 sqrt abs sign rint min max sum avg");
  EXPECT_EQ(message("x + "), "--function:5: found the end of the expression, expected a number, x, y, z, pi, e, a function or '('");
  EXPECT_EQ(message("(x + z"), "--function:7: found the end of the expression, expected an operator or ')'");
  EXPECT_EQ(message("x : z"), "--function:3: found ':', expected an operator or the end");
  EXPECT_EQ(message("x ? z"), "--function:6: found the end of the expression, expected ':' and the value if the condition does not hold");
  EXPECT_EQ(message("1 + atan2(z)"), "--function:5: found atan2 of 1 value, expected 2 values");
  EXPECT_EQ(message("sin x"), "--function:5: found 'x', expected '(' and the values of sin");
  EXPECT_EQ(message("x == 1e999"), "--function:6: found a number beyond the largest double, expected a number up to 1.7e308");
  EXPECT_EQ(message("x *= 2"), "--function:4: found an assignment, expected == for a comparison");
  EXPECT_EQ(message(std::string(101, '(')), "--function:101: found an expression within more than 100 others, expected a flatter one");
  for (const std::string deep : {"(", "sin(", "x?", "x?1:", "x^"}) {
    std::string text;
    while (text.size() + deep.size() < longest_expression) text += deep;
    EXPECT_NE(message(text), "") << deep;
  }
}

// Worked out by hand.
TEST(Expression, Values) {
  struct Case {
    const char* text;
    double x, z, value;
  };
  for (const Case& each : {Case{"2^3^2", 0, 0, 512}, {"-2^2", 0, 0, -4}, {"(-2)^2", 0, 0, 4}, {"2^-1^2", 0, 0, 0.5}, {"2*-x", 3, 0, -6}, {"7-4-2", 0, 0, 1}, {"16/4/2", 0, 0, 2},
                           {"1+2*3", 0, 0, 7}, {"x>z?1:2", 1, 0, 1}, {"x>z?1:2", 0, 1, 2}, {"x?1:z?2:3", 0, 0, 3}, {"1<2==2", 0, 0, 0}, {"1||0&&0", 0, 0, 1}, {"0.5&&0.1", 0, 0, 1},
                           {"2 < 1 || 3 != 3", 0, 0, 0}, {"x<=-1", -1, 0, 1}, {"min(3,1,2)", 0, 0, 1}, {"max(3,1,x)", 9, 0, 9}, {"sum(1,2,3)", 0, 0, 6}, {"avg(x,z)", 1, 4, 2.5}, {"min(x)", 5, 0, 5},
                           {"atan2(0,-1)", 0, 0, std::numbers::pi}, {"log(e)", 0, 0, 1}, {"ln(e)", 0, 0, 1}, {"log2(8)", 0, 0, 3}, {"log10(1000)", 0, 0, 3}, {"sign(x)", -7, 0, -1},
                           {"sign(x)", 0, 0, 0}, {"rint(x)", 2.5, 0, 3}, {"rint(x)", -2.5, 0, -2}, {"abs(x)", -2, 0, 2}, {"1e-1*.5", 0, 0, 0.05}, {"2.", 0, 0, 2}, {"+x", 4, 0, 4},
                           {"x - -z", 4, 1, 5}, {"x^4-x^3", 2, 0, 8}, {"x^0.5", 9, 0, 3}, {"cosh(0)+sinh(0)+tanh(0)+exp(0)", 0, 0, 2}, {"asinh(0)+acosh(1)+atanh(0)", 0, 0, 0}}) {
    const auto parsed = Expression::parse(each.text);
    ASSERT_TRUE(parsed) << each.text << ": " << parsed.error().message();
    EXPECT_DOUBLE_EQ((*parsed)(each.x, each.z), each.value) << each.text;
  }
  EXPECT_EQ(Expression::parse("x+y")->second(), 'y');
  EXPECT_EQ((*Expression::parse("sin(sqrt(-1)) ? 1 : 2"))(0, 0), 1) << "NaN is not 0";
}

// Texts of other languages, and what is no part of this one.
TEST(Expression, Refused) {
  for (const char* wrong : {"", " ", "x z", "2x", "1..2", "1.2.3", ".", "1e", "0x10", "x**z", "x^", "?x:z", "!x", "x&z", "x|z", "x%2", "x>>1", "- -x", "--x", "+-x", "sin", "sin()", "sin(x,z)",
                            "min()", "_pi", "_e", "\"a\"", "x,z", "(x,z)", "x)", "()", "x=1", "x=>1", "x!z", "X", "SIN(x)", "sin (", "f(x)", "pi(x)", "x(2)"})
    EXPECT_FALSE(Expression::parse(wrong)) << wrong;
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
