// Files made by hand from the StereoLithography Interface Specification, and errors of each kind.
#include "host/scene/read/stl.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "host/scene/read/poly_file.hpp"

namespace sightline::scene {
namespace {

void put_32(std::string& bytes, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> (8 * i));
}

std::string binary(const std::vector<float>& coordinates, const std::string& header = "") {
  std::string bytes = header;
  bytes.resize(80, ' ');
  put_32(bytes, static_cast<std::uint32_t>(coordinates.size() / 9));
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (i % 9 == 0)
      for (int n = 0; n < 3; ++n) put_32(bytes, 0);
    put_32(bytes, std::bit_cast<std::uint32_t>(coordinates[i]));
    if (i % 9 == 8) bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal 0 0 1\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c + "\nendloop\nendfacet\n";
}

// An error, or the omissions of mending.
std::string stl_error(const std::string& bytes) {
  const auto mesh = read_stl(bytes, "a.stl");
  if (!mesh) return mesh.error().message();
  return mesh->flaw ? mesh->flaw->message() : "";
}

std::size_t face_count(const base::Result<PolyMesh>& mesh) {
  std::size_t count = 0;
  if (mesh)
    for (const PolyBody& body : mesh->bodies) count += body.faces.size();
  return count;
}

TEST(Stl, BinaryVerticesOnOnePointAreOne) {
  // A header that begins like a text file.
  const std::string bytes = binary({0, 0, 0, 1.5F, 0, 0, 0, 1.5F, 0, 1.5F, 0, -0.0F, 0, 0, 0, 0, 0, -1.5F}, "solid part");
  ASSERT_TRUE(is_binary_stl(bytes));
  const auto mesh = read_stl(bytes, "a.stl");
  ASSERT_TRUE(mesh) << mesh.error().message();
  EXPECT_EQ(mesh->vertices.size(), 4U);
  ASSERT_EQ(mesh->bodies.size(), 1U);
  EXPECT_EQ(mesh->bodies[0].faces[1].outline, (std::vector<VertexIndex>{1, 0, 3}));
  EXPECT_EQ(mesh->vertical, std::optional<std::size_t>(2));
  EXPECT_EQ(mesh->precision, 0x1p-23);  // floats from 1 to 2 are that far apart
}

TEST(Stl, TextWithTwoSolids) {
  const auto mesh = read_stl("SOLID one two\n" + facet("0 0 0", "1 0 0", "0 1 0") + "endsolid one two\n\nsolid\n" +
                                 facet("0 0 1e0", "1.25 0 1", "0 1 1") + "endsolid\n",
                             "a.stl");
  ASSERT_TRUE(mesh) << mesh.error().message();
  ASSERT_EQ(mesh->bodies.size(), 2U);
  EXPECT_TRUE(mesh->grouped);
  EXPECT_EQ(mesh->bodies[0].name, "one two");
  EXPECT_EQ(mesh->vertices[4][0], 1.25);
  EXPECT_EQ(mesh->precision, 0.01);
}

// In numbers written by %e all have the same number of digits, and the last digit of the largest is coarser than those of the
// others. If
// the largest has fewer digits, trailing zeros were omitted.
TEST(Stl, PrecisionOfNumbersWithAnExponent) {
  const auto precision = [](const std::string& large, const std::string& small) {
    const std::string text = "solid\n" + facet("0 0 0", large + " 0 0", "0 " + small + " 0") + "endsolid\n";
    return read_stl(text, "a.stl")->precision;
  };
  EXPECT_EQ(precision("1.778000e+02", "9.475650e+01"), 1e-4);
  EXPECT_EQ(precision("177.800", "94.7565"), 1e-3);
  EXPECT_EQ(precision("177.8", "94.7565"), 1e-4);
  EXPECT_EQ(precision("123.456", "94.7565"), 1e-3);
  EXPECT_EQ(precision("1.234567e+09", "9.5e+08"), 1e3);
  EXPECT_EQ(precision("177", "94"), 0);
  EXPECT_EQ(precision("1770000", "940000"), 1);  // rounded to whole numbers
}

TEST(Stl, EachKindOfErrorIsNamed) {
  const std::string whole = "solid s\n" + facet("0 0 0", "1 0 0", "0 1 0") + "endsolid s\n";
  EXPECT_EQ(stl_error(whole), "");
  EXPECT_EQ(stl_error(""), "a.stl: byte 0: found the end of the file, expected \"solid\" in the first line of a text, or "
                          "the 84 bytes of a binary header");
  EXPECT_EQ(stl_error(whole.substr(0, whole.find("endfacet"))),
            "a.stl: end of file: found the end of the file, expected \"endfacet\"");
  EXPECT_EQ(stl_error("solid s\nendsolid s\n"), "a.stl: end of file: found no faces, expected a mesh");
  EXPECT_EQ(stl_error("solid s\n" + facet("0 0 0", "1 0 nan", "0 1 0") + "endsolid"),
            "a.stl: line 5: found \"nan\", expected a finite number");
  EXPECT_EQ(stl_error("solid s\n" + facet("0 0 0", "1 0", "0 1 0") + "endsolid"),
            "a.stl: line 6: found \"vertex\", expected a number");
  EXPECT_EQ(stl_error("solid s\n" + facet("0 0 0", "1 0 0", "0 1 0\nvertex 1 1 0") + "endsolid"),
            "a.stl: line 7: found a fourth vertex, expected triangles");
  EXPECT_EQ(stl_error("solid s\nfacets\nendsolid"), "a.stl: line 2: found \"facets\", expected \"facet\" or \"endsolid\"");
  EXPECT_EQ(stl_error("solid s\nendsolid\nmore"), "a.stl: line 3: found \"more\", expected \"solid\"");
  const std::vector<float> triangle{0, 0, 0, 1, 0, 0, 0, 1, 0};
  EXPECT_EQ(stl_error(binary(triangle).substr(0, 100)),
            "a.stl: byte 100: found the end of the file after 100 bytes, expected 134, as byte 80 says 1 triangles; export "
            "the file again, or write it as text");
  std::string lies = binary(triangle);
  lies[83] = '\x7f';
  EXPECT_NE(stl_error(lies).find("byte 80 says 2130706433 triangles"), std::string::npos) << stl_error(lies);
  // Truncated, with a header that begins like a text file.
  EXPECT_EQ(stl_error(binary(triangle, "solid part facet").substr(0, 100)).substr(0, 55),
            "a.stl: byte 100: found the end of the file after 100 by");
  EXPECT_EQ(stl_error(binary({})), "a.stl: byte 80: found no faces, expected a mesh");
  EXPECT_EQ(stl_error(binary({}) + std::string(50, 'x')),
            "a.stl: byte 80: found no faces, and 50 bytes after them, expected a mesh; if the file has triangles, export it "
            "again with their number");
  std::vector<float> infinite = triangle;
  infinite[4] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(stl_error(binary(infinite)),
            "a.stl: byte 112: found a coordinate of triangle 0 that is no finite number, expected a number");
}

TEST(Stl, BytesAfterTheTrianglesAreIgnored) {
  const std::vector<float> triangle{0, 0, 0, 1, 0, 0, 0, 1, 0};
  for (const char* header : {"", "solid", "solid facet normal endsolid", "COLOR=\x01\x02\x03\xff"}) {
    const std::string bytes = binary(triangle, header) + std::string(37, 'x');
    EXPECT_FALSE(is_binary_stl(bytes));
    EXPECT_TRUE(begins_as_binary_stl(bytes));
    const auto mesh = read_stl(bytes, "a.stl");
    ASSERT_TRUE(mesh) << header << mesh.error().message();
    EXPECT_EQ(face_count(mesh), 1U);
    EXPECT_EQ(mesh->notes, (std::vector<std::string>{"37 bytes after the last triangle"}));
    EXPECT_EQ(poly_format_of("a.stl", bytes), PolyFormat::stl);
    EXPECT_EQ(poly_format_of("-", bytes), PolyFormat::stl);
  }
}

// In the specification line ends matter only for names.
TEST(Stl, ATextMayBeLaidOutInAnyWay) {
  const std::string lines = "solid a b\n" + facet("0 0 0", "1 0 0", "0 1 0") + facet("0 0 0", "0 1 0", "0 0 1") + "endsolid a b\n";
  const auto replaced = [](std::string text, const std::string& end) {
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + end.size())) text.replace(at, 1, end);
    return text;
  };
  const auto expected = read_stl(lines, "a.stl");
  ASSERT_EQ(face_count(expected), 2U);
  for (const char* end : {"\r", "\r\n", " ", "\n\n \t", "\r\r\n"}) {
    const auto mesh = read_stl(replaced(lines, end), "a.stl");
    ASSERT_EQ(face_count(mesh), 2U) << end;
    EXPECT_EQ(mesh->vertices, expected->vertices);
    EXPECT_EQ(mesh->bodies[0].name, "a b");
    EXPECT_TRUE(mesh->notes.empty());
  }
  const auto two = read_stl(replaced(lines + lines, " "), "a.stl");
  ASSERT_TRUE(two) << two.error().message();
  ASSERT_EQ(two->bodies.size(), 2U);
  EXPECT_EQ(two->bodies[1].faces.size(), 2U);
  EXPECT_EQ(two->bodies[1].name, "a b");
}

TEST(Stl, AMissingEndIsNoted) {
  const std::string one = "solid a\n" + facet("0 0 0", "1 0 0", "0 1 0");
  const auto mesh = read_stl(one, "a.stl");
  ASSERT_TRUE(mesh) << mesh.error().message();
  EXPECT_EQ(mesh->notes, (std::vector<std::string>{"a missing \"endsolid\""}));
  const auto two = read_stl(one + one, "a.stl");
  ASSERT_TRUE(two) << two.error().message();
  EXPECT_EQ(two->bodies.size(), 2U);
  EXPECT_EQ(two->notes, (std::vector<std::string>{"2 missing \"endsolid\""}));
}

TEST(Stl, FacetsWithoutFiniteCornersAreOmittedWhenMended) {
  for (const char* corner : {"nan 0 0", "0 -inf 0", "0 0 1e400", "-1.#IND 0 0", "0 1.#QNAN 0", "0 0 1.#INF00", "-nan(ind) 0 0"}) {
    const std::string text = "solid a\n" + facet(corner, "1 0 0", "0 1 0") + facet("0 0 0", "1 0 0", "0 1 0") + "endsolid\n";
    const auto mended = read_poly(text, "a.stl", PolyFormat::stl, {.mend = true});
    ASSERT_TRUE(mended) << mended.error().message();
    EXPECT_EQ(mended->scene.vertices.size(), 3U) << corner;
    ASSERT_EQ(mended->scene.bodies.size(), 1U);
    EXPECT_EQ(mended->scene.bodies[0].faces.size(), 1U);
    EXPECT_EQ(mended->report.notes, (std::vector<std::string>{"1 face with a coordinate that is no finite number"}));
    const auto strict = read_poly(text, "a.stl", PolyFormat::stl);
    ASSERT_FALSE(strict);
    EXPECT_EQ(strict.error().place, "line 4") << corner;
  }
  std::vector<float> bad{0, 0, 0, 1, 0, 0, 0, 1, 0};
  bad[3] = std::numeric_limits<float>::quiet_NaN();
  const auto none = read_poly(binary(bad), "a.stl", PolyFormat::stl, {.mend = true});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().place, "byte 108");
  bad.insert(bad.end(), {0, 0, 0, 1, 0, 0, 0, 1, 0});
  const auto some = read_poly(binary(bad), "a.stl", PolyFormat::stl, {.mend = true});
  ASSERT_TRUE(some) << some.error().message();
  EXPECT_EQ(some->scene.vertices.size(), 3U);
}

TEST(Stl, IsRecognisedByItsContents) {
  EXPECT_EQ(poly_format_of("scan.off", binary({0, 0, 0, 1, 0, 0, 0, 1, 0})), PolyFormat::stl);
  EXPECT_EQ(poly_format_of("scan.ply", "solid x\n facet normal 0 0 1\n"), PolyFormat::stl);
  EXPECT_EQ(poly_format_of("-", "SOLID x\r FACET NORMAL 0 0 1\r"), PolyFormat::stl);
  EXPECT_EQ(poly_format_of("-", "OFF8 6 12\n"), PolyFormat::off);
  EXPECT_EQ(poly_format_of("scan.stl", "OFF\n3 1 0\n"), PolyFormat::off);
  EXPECT_EQ(poly_format_of("scan.stl", "# made by x\nv 0 0 0\n"), PolyFormat::obj);
  EXPECT_EQ(poly_format_of("scan.stl", "ply\nformat ascii 1.0\n"), PolyFormat::ply);
  EXPECT_EQ(poly_format_of("-", "{\"bodies\": []}"), PolyFormat::json);
}

}  // namespace
}  // namespace sightline::scene
