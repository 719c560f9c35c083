// The writer of all SVG: its output is compared with lines written by hand.
#include "host/picture/svg.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <utility>

#include "host/picture/vector_drawing.hpp"

namespace sightline::picture {
namespace {

const std::string head =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<svg xmlns=\"http://www.w3.org/2000/svg\" "
    "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
    "     width=\"20.000mm\" height=\"10.500mm\" viewBox=\"0 0 20.000 10.500\">\n"
    "  <title>a &lt;b&gt; &amp; &quot;c&quot; ?</title>\n";

std::string points(SvgPositions positions, std::int64_t across, std::int64_t down) {
  SvgWriter svg(1, 1, "", positions);
  svg.point(across, down);
  const std::string text = std::move(svg).finish();
  const std::size_t from = text.find("</title>\n") + 9;
  return text.substr(from, text.find("</svg>") - from);
}

TEST(SvgWriter, BeginsWithSizeInMillimetresAndTheEscapedTitle) {
  EXPECT_EQ(SvgWriter(20, 10.5, "a <b> & \"c\" \t").finish(), head + "</svg>\n");
}

TEST(SvgWriter, LinesAreLayersOfPolylines) {
  SvgWriter svg(20, 10.5, "a <b> & \"c\" \t");
  svg.open_lines("pen-1", "1 \"pen\"", {255, 0, 16}, "0.3");
  svg.begin_polyline();
  svg.point(0, 1);
  svg.point(1500, 10500);
  svg.end_shape();
  svg.begin_polyline();
  svg.dot(5000, 250);
  svg.end_shape();
  svg.close_layer();
  EXPECT_EQ(std::move(svg).finish(),
            head +
                "  <g id=\"pen-1\" inkscape:groupmode=\"layer\" inkscape:label=\"1 &quot;pen&quot;\"\n"
                "     fill=\"none\" stroke=\"#ff0010\" stroke-width=\"0.3\" stroke-linecap=\"round\" "
                "stroke-linejoin=\"round\">\n"
                "    <polyline points=\"0.000,0.001 1.500,10.500\"/>\n"
                "    <polyline points=\"4.990,0.250 5.010,0.250\"/>\n"
                "  </g>\n</svg>\n");
}

TEST(SvgWriter, AreasArePolygonsAndPathsOfAnyNumberOfLoops) {
  SvgWriter svg(20, 10.5, "a <b> & \"c\" \t");
  svg.clip_rectangle("inside", 1, 2, 3, 4.5);
  svg.open_areas("faces", "0 faces", "stroke-width=\"0.2\"");
  svg.begin_path({4, 5, 6});
  for (const int x : {0, 1000}) {
    svg.begin_loop();
    svg.point(x, 0);
    svg.point(x, -500);
    svg.end_loop();
  }
  svg.end_shape();
  svg.close_layer();
  EXPECT_EQ(
      std::move(svg).finish(),
      head +
          "  <clipPath id=\"inside\"><rect x=\"1.000\" y=\"2.000\" width=\"3.000\" "
          "height=\"4.500\"/></clipPath>\n"
          "  <g id=\"faces\" inkscape:groupmode=\"layer\" inkscape:label=\"0 faces\" stroke-width=\"0.2\">\n"
          "    <path fill=\"#040506\" stroke=\"#040506\" "
          "d=\"M0.000,0.000L0.000,-0.500ZM1.000,0.000L1.000,-0.500Z\"/>\n"
          "  </g>\n</svg>\n");
}

TEST(SvgWriter, RelativeCoordinatesHaveNoLeadingZeroAndNoNeedlessBlank) {
  SvgWriter svg(20, 10.5, "a <b> & \"c\" \t", {.needless_zeros = false});
  svg.open_areas("surface", "0 surface", "");
  svg.begin_area({1, 2, 3}, false);
  svg.point(1500, 2000);
  svg.point(1600, 1999);
  svg.point(1600, 3999);
  svg.end_area();
  svg.begin_area({1, 2, 3}, true);
  svg.point(0, 0);
  svg.end_area();
  svg.begin_line();
  svg.point(1, -1);
  svg.point(-1, -1);
  svg.begin_distances();
  svg.point(5, 5);
  svg.end_shape();
  svg.close_layer();
  EXPECT_EQ(std::move(svg).finish(),
            head +
                "  <g id=\"surface\" inkscape:groupmode=\"layer\" inkscape:label=\"0 surface\" >\n"
                "    <path fill=\"#010203\" d=\"M1.5 2l.1-.001 0 2z\"/>\n"
                "    <path fill=\"#010203\" stroke=\"#010203\" d=\"M0 0z\"/>\n"
                "    <path d=\"M0.001 -0.001l-.002 0M0.005 0.005\"/>\n"
                "  </g>\n</svg>\n");
}

TEST(SvgWriter, PositionsHaveTheRequestedDecimalsAndZeros) {
  EXPECT_EQ(points({}, 0, -1), "0.000,-0.001");
  EXPECT_EQ(points({.decimals = 4}, 2381250, 5), "238.1250,0.0005");
  EXPECT_EQ(points({.needless_zeros = false}, 1500, 100000), "1.5,100");
  EXPECT_EQ(points({.needless_zeros = false}, 0, 10), "0,0.01");
  EXPECT_EQ(points({}, 9223372036854775, 1), "9223372036854.775,0.001");
}

// Large numbers of areas are written in hundredths of a millimetre: their corners are read back from relative coordinates.
TEST(SvgWriter, ManyAreasAreShortAndAtTheirPositions) {
  VectorDrawing drawing;
  drawing.width = drawing.height = 255;
  constexpr std::uint32_t count = 20'001;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float x = static_cast<float>(i % 200) * 1.25F;
    const float y = static_cast<float>(i / 200) * 2.5F;
    drawing.areas.push_back({4 * i, 4, {static_cast<std::uint8_t>(i), 1, 2}});
    for (const DrawingPoint& p : {DrawingPoint{x, y}, {x + 1.3F, y}, {x + 1.3F, y + 2.4F}, {x, y + 2.4F}}) drawing.points.push_back(p);
  }
  drawing.facets.push_back({0, 4, {}});
  const std::string svg = svg_of(drawing, {}, "many");
  EXPECT_LT(svg.size(), 60 * count);
  std::size_t at = svg.find("scale(.01)");
  ASSERT_NE(at, std::string::npos);
  for (const DrawingArea& area : drawing.areas) {
    at = svg.find(" d=\"M", at);
    ASSERT_NE(at, std::string::npos);
    const char* rest = svg.c_str() + at + 5;
    double across = 0;
    double down = 0;
    for (std::uint32_t i = 0; i < area.count; ++i) {
      if (*rest == 'l') ++rest;
      char* end = nullptr;
      across += std::strtod(rest, &end);
      down += std::strtod(end, &end);
      rest = end;
      const DrawingPoint& p = drawing.points[area.first + i];
      ASSERT_NEAR(across / 100, 10 + p.x * 180 / 255, 0.0061);
      ASSERT_NEAR(down / 100, 190 - p.y * 180 / 255, 0.0061);
    }
    ASSERT_EQ(*rest, 'z');
    ++at;
  }
}

}  // namespace
}  // namespace sightline::picture
