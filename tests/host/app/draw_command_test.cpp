// `sightline draw`: files of every kind, and what a user gets wrong.
#include "host/picture/png.hpp"
#include "tests/host/app/command_line.hpp"

namespace {

using sightline::test::has;

class DrawCommand : public sightline::test::CommandLine {
 protected:
  void expect_usage_error(const sightline::test::Arguments& arguments, std::string_view what) {
    const auto ran = sightline(arguments);
    EXPECT_EQ(ran.exit_code, 2) << what;
    EXPECT_TRUE(has(ran.err, what)) << ran.err;
    EXPECT_TRUE(files().empty());
  }
};

TEST_F(DrawCommand, SkalaAsSvg) {
  ASSERT_EQ(sightline({"draw", "skala", "sinc", "--size", "120x80", "-o", "s.svg"}).exit_code, 0);
  const std::string svg = read("s.svg");
  EXPECT_TRUE(has(svg, "width=\"120.000mm\" height=\"80.000mm\" viewBox=\"0 0 120.000 80.000\""));
  EXPECT_TRUE(has(svg, "inkscape:label=\"1 lines along x\""));
  EXPECT_TRUE(has(svg, "inkscape:label=\"3 rims\""));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  ASSERT_EQ(sightline({"draw", "skala", "sinc", "--size", "120x80", "-o", "t.svg"}).exit_code, 0);
  EXPECT_EQ(svg, read("t.svg"));
}

TEST_F(DrawCommand, SkalaAsHpgl) {
  ASSERT_EQ(sightline({"draw", "skala", "peaks", "--picture", "contours", "--levels", "3", "-o", "s.plt"})
                .exit_code,
            0);
  const std::string text = read("s.plt");
  EXPECT_TRUE(text.starts_with("IN;\nSP3;\nPU"));
  EXPECT_TRUE(has(text, "SP5;\n"));
  EXPECT_TRUE(text.ends_with("PU;\nSP0;\n"));
}

TEST_F(DrawCommand, SkalaAsImageOfAnySize) {
  ASSERT_EQ(sightline({"draw", "skala", "--function", "x*z", "--picture", "surface", "--pixels", "90x70",
                       "-o", "s.png"})
                .exit_code,
            0);
  const auto png = sightline::picture::read_png(path("s.png").string());
  ASSERT_TRUE(png);
  EXPECT_EQ(png->image.width, 90);
  EXPECT_EQ(png->image.height, 70);
  EXPECT_EQ(png->image.pixels.front(), 255);
  const auto middle = png->image.pixels[png->image.index(45, 35)];
  EXPECT_TRUE(middle > 40 && middle < 250) << int{middle};
}

TEST_F(DrawCommand, AGridFileWithAHole) {
  write("h.csv", "1,2,3\n2,nan,4\n3,4,9\n");
  EXPECT_EQ(sightline({"draw", "skala", "h.csv", "--along", "both", "-o", "h.svg"}).exit_code, 0);
  write("bad.csv", "1,2\n3\n");
  const auto ran = sightline({"draw", "skala", "bad.csv", "-o", "bad.svg"});
  EXPECT_EQ(ran.exit_code, 4);
  EXPECT_TRUE(has(ran.err, "bad.csv:2")) << ran.err;
  EXPECT_FALSE(exists("bad.svg"));
}

TEST_F(DrawCommand, WrongUsage) {
  expect_usage_error({"draw"}, "skala");
  expect_usage_error({"draw", "skala", "sinc"}, "--output");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.gif"}, ".svg, .png, .plt");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.svg", "--size", "12"}, "WIDTHxHEIGHT");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.svg", "--size", "12x12"}, "--margin");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.svg", "--margin", "nan"}, "--margin");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.svg", "--pen", "nan"}, "--pen");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.png", "--pixels", "9000x10"}, "1 to 8192");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.svg", "--rotate", "nan"}, "--rotate");
  expect_usage_error({"draw", "skala", "sinc", "-o", "s.plt", "--picture", "surface"}, "plotter");
  expect_usage_error({"draw", "skala", "-o", "s.svg"}, "no function");
}

TEST_F(DrawCommand, APlaceThatCannotBeWritten) {
  EXPECT_EQ(sightline({"draw", "skala", "sinc", "-o", "nowhere/s.svg"}).exit_code, 5);
  EXPECT_EQ(sightline({"draw", "skala", "missing.csv", "-o", "s.svg"}).exit_code, 5);
}

}  // namespace
