// Files made by hand after the StereoLithography Interface Specification, and each kind of damage.
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

std::string stl_error(const std::string& bytes) {
  const auto mesh = read_stl(bytes, "a.stl");
  return mesh ? "" : mesh.error().message();
}

TEST(Stl, BinaryVerticesOnOnePointAreOne) {
  // A header that begins as a text does.
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

TEST(Stl, EachKindOfDamageIsNamed) {
  const std::string whole = "solid s\n" + facet("0 0 0", "1 0 0", "0 1 0") + "endsolid s\n";
  EXPECT_EQ(stl_error(whole), "");
  EXPECT_EQ(stl_error(""), "a.stl: byte 0: found the end of the file, expected \"solid\" in the first line of a text, or "
                          "the 84 bytes of a binary header");
  EXPECT_EQ(stl_error(whole.substr(0, whole.find("endsolid"))),
            "a.stl: end of file: found the end of the file, expected \"endsolid\"");
  EXPECT_EQ(stl_error("solid s\n" + facet("0 0 0", "1 0 nan", "0 1 0") + "endsolid"),
            "a.stl: line 5: found \"nan\", expected a number");
  EXPECT_EQ(stl_error("solid s\n" + facet("0 0 0", "1 0", "0 1 0") + "endsolid"),
            "a.stl: line 5: found 2 fields after it, expected \"vertex\" and 3 numbers");
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
  EXPECT_NE(stl_error(binary(triangle) + "x").find("found 135 bytes, expected 134"), std::string::npos);
  EXPECT_EQ(stl_error(binary({})), "a.stl: byte 80: found no triangles, expected a mesh");
  std::vector<float> infinite = triangle;
  infinite[4] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(stl_error(binary(infinite)),
            "a.stl: byte 112: found a coordinate that is no finite number, expected a number; triangle 0 is damaged");
}

TEST(Stl, IsToldByWhatItIs) {
  EXPECT_EQ(poly_format_of("scan.off", binary({0, 0, 0, 1, 0, 0, 0, 1, 0})), PolyFormat::stl);
  EXPECT_EQ(poly_format_of("scan.ply", "solid x\n facet normal 0 0 1\n"), PolyFormat::stl);
  EXPECT_EQ(poly_format_of("scan.stl", "OFF\n3 1 0\n"), PolyFormat::off);
  EXPECT_EQ(poly_format_of("scan.stl", "# made by x\nv 0 0 0\n"), PolyFormat::obj);
  EXPECT_EQ(poly_format_of("scan.stl", "ply\nformat ascii 1.0\n"), PolyFormat::ply);
  EXPECT_EQ(poly_format_of("-", "{\"bodies\": []}"), PolyFormat::json);
}

}  // namespace
}  // namespace sightline::scene
