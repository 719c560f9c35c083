// Drawings read by independent programs: SVG by rsvg-convert, PDF by pdftocairo, DXF by python3-ezdxf. Skipped with a message if
// these are not installed (Debian: librsvg2-bin, poppler-utils, python3-ezdxf).
#include <cstdlib>

#include "host/picture/png.hpp"
#include "tests/host/app/command_line.hpp"

namespace {

using sightline::picture::Image;

class IndependentReaders : public sightline::test::CommandLine {
 protected:
  // Runs in the directory of the test.
  [[nodiscard]] bool shell(const std::string& command) const {
    return std::system(("cd '" + path("").string() + "' && { " + command + "; } >shell.out 2>&1").c_str()) == 0;
  }
  void draw(const std::string& file) {
    const std::string source = std::string(SIGHTLINE_SOURCE_DIR) + "/host/examples/bracket.obj";
    std::vector<std::string> arguments{"draw", "exact", source, "--hatch", "30,4", "--hidden", "--size", "210x160", "--strokes", "strokes.jsonl", "-o", file};
    if (file.ends_with(".png")) arguments.insert(arguments.end(), {"--dpi", "101.6", "--pen", "0.3"});
    if (file.ends_with(".svg") || file.ends_with(".pdf")) arguments.insert(arguments.end(), {"--pen", "0.3"});
    const auto ran = sightline(arguments);
    ASSERT_EQ(ran.exit_code, 0) << ran.err;
  }
  [[nodiscard]] Image image(const std::string& file) const {
    const auto png = sightline::picture::read_png(path(file).string());
    EXPECT_TRUE(png) << (png ? "" : png.error().message());
    return png ? png->image : Image();
  }
  // The number of dark pixels in one image without a dark pixel of the other within two.
  static int count_unmatched_pixels(const Image& a, const Image& b) {
    const auto dark = [](const Image& image, int column, int row) {
      constexpr int darker = 140;
      return column >= 0 && row >= 0 && column < image.width && row < image.height &&
             image.pixels[image.index(column, row)] < darker;
    };
    int count = 0;
    for (int row = 0; row < a.height; ++row) {
      for (int column = 0; column < a.width; ++column) {
        if (!dark(a, column, row)) continue;
        bool near = false;
        for (int i = -2; i <= 2; ++i)
          for (int k = -2; k <= 2; ++k) near = near || dark(b, column + i, row + k);
        count += near ? 0 : 1;
      }
    }
    return count;
  }
  static Image white(const Image& image) {
    Image result(image.width, image.height, 1);
    for (auto& pixel : result.pixels) pixel = 255;
    return result;
  }
  // The image made by a reader must show the same as our image.
  void expect_same(const std::string& file) const {
    const Image ours = image("ours.png");
    const Image theirs = image(file);
    ASSERT_EQ(theirs.width, ours.width);
    ASSERT_EQ(theirs.height, ours.height);
    EXPECT_GT(count_unmatched_pixels(ours, white(ours)), 5000);
    EXPECT_EQ(count_unmatched_pixels(ours, theirs), 0);
    EXPECT_EQ(count_unmatched_pixels(theirs, ours), 0);
  }
};

TEST_F(IndependentReaders, SvgByRsvg) {
  if (!shell("command -v rsvg-convert && command -v pdftocairo")) GTEST_SKIP() << "rsvg-convert or pdftocairo is not installed";
  draw("a.svg");
  draw("ours.png");
  ASSERT_TRUE(
      shell("rsvg-convert -f pdf -o b.pdf a.svg && pdftocairo -png -gray -singlefile -scale-to-x 840 "
            "-scale-to-y 640 b.pdf theirs"))
      << read("shell.out");
  expect_same("theirs.png");
}

TEST_F(IndependentReaders, PdfByCairo) {
  if (!shell("command -v pdftocairo")) GTEST_SKIP() << "pdftocairo is not installed";
  draw("a.pdf");
  draw("ours.png");
  ASSERT_TRUE(shell("pdftocairo -png -gray -singlefile -scale-to-x 840 -scale-to-y 640 a.pdf theirs")) << read("shell.out");
  expect_same("theirs.png");
}

TEST_F(IndependentReaders, DxfByEzdxf) {
  if (!shell("/usr/bin/python3 -c 'import ezdxf'")) GTEST_SKIP() << "python3-ezdxf is not installed";
  draw("a.dxf");
  draw("a.svg");
  write("read.py", R"py(import json, math, re
import ezdxf
document = ezdxf.readfile("a.dxf")
assert not document.audit().errors
lines = {}
for line in document.modelspace().query("POLYLINE"):
    lines.setdefault(line.dxf.layer, []).append([(round(p.x, 3), round(p.y, 3)) for p in line.points()])
expected = {}
layer = ""
for row in open("a.svg"):
    if label := re.search('inkscape:label="([^"]*)"', row):
        layer = re.sub("[^A-Z0-9]", "_", label[1].upper()).replace("_", "-", 1)
    if path := re.search(' d="M([^l"]*)(?:l([^"]*))?"', row):
        numbers = lambda text: [float(n) for n in re.findall("-?[0-9]*[.]?[0-9]+", text or "")]
        x, y = numbers(path[1])
        corners = [(x, round(160 - y, 3))]
        steps = numbers(path[2])
        for dx, dy in zip(steps[::2], steps[1::2]):
            x, y = x + dx, y + dy
            corners.append((round(x, 3), round(160 - y, 3)))
        expected.setdefault(layer, []).append(corners)
assert set(lines) == set(expected), (set(lines), set(expected))
# Hidden lines are whole, of a dashed linetype.
hidden = [name for name in lines if name.endswith("HIDDEN")]
assert len(hidden) == 1 and document.layers.get(hidden[0]).dxf.linetype == "DASHED"
assert len(document.linetypes.get("DASHED").pattern_tags.tags) > 0
drawn = sum(math.dist(a, b) for line in lines.pop(hidden[0]) for a, b in zip(line, line[1:]))
rows = [json.loads(row) for row in open("strokes.jsonl")]
wanted = sum(math.dist(row["from"], row["to"]) for row in rows if row["hidden"])
assert wanted > 10 and abs(drawn - wanted) < 0.02, (drawn, wanted)
for name in lines:
    assert len(lines[name]) == len(expected[name]), name
    for a, b in zip(lines[name], expected[name]):
        assert len(a) == len(b)
        assert all(abs(p[0] - q[0]) < 0.002 and abs(p[1] - q[1]) < 0.002 for p, q in zip(a, b)), (a, b)
)py");
  EXPECT_TRUE(shell("/usr/bin/python3 read.py")) << read("shell.out");
}

}  // namespace
