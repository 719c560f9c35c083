// Files made by hand from Turk's description, in all encodings, and errors of each kind.
#include "host/scene/read/ply.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace sightline::scene {
namespace {

class Bytes {
 public:
  explicit Bytes(bool big) : big_(big) {}

  Bytes& put(std::uint64_t word, int size) {
    for (int i = 0; i < size; ++i) text_ += static_cast<char>(word >> (8 * (big_ ? size - 1 - i : i)));
    return *this;
  }
  Bytes& real(double value) { return put(std::bit_cast<std::uint64_t>(value), 8); }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  bool big_;
  std::string text_;
};

std::string header(const std::string& format, const std::string& vertices = "3", const std::string& faces = "1") {
  return "ply\r\nformat " + format + " 1.0\r\ncomment made by hand\r\nelement vertex " + vertices +
         "\r\nproperty double x\r\nproperty uchar confidence\r\nproperty double y\r\nproperty double z\r\n"
         "element face " + faces + "\r\nproperty list uchar short vertex_indices\r\nend_header\r\n";
}

std::string binary_triangle(bool big) {
  Bytes bytes(big);
  bytes.real(0).put(9, 1).real(0).real(0.25);
  bytes.real(3).put(9, 1).real(0).real(0);
  bytes.real(0).put(9, 1).real(-3).real(0);
  bytes.put(3, 1).put(2, 2).put(1, 2).put(0, 2);
  return bytes.text();
}

// An error, or the omissions of mending.
std::string ply_error(const std::string& bytes) {
  const auto mesh = read_ply(bytes, "a.ply");
  if (!mesh) return mesh.error().message();
  return mesh->flaw ? mesh->flaw->message() : "";
}

using Outlines = std::vector<std::vector<VertexIndex>>;

Outlines outlines(const base::Result<PolyMesh>& mesh) {
  Outlines result;
  if (mesh)
    for (const PolyFace& face : mesh->bodies.at(0).faces) result.emplace_back(face.outline.begin(), face.outline.end());
  return result;
}

TEST(Ply, AllEncodingsAreTheSameMesh) {
  const std::string text = header("ascii") + "0 9 0 0.25\n3 9 0 0\n0 9 -3 0\n3 2 1 0";
  for (const std::string& bytes : {text, header("binary_little_endian") + binary_triangle(false),
                                   header("binary_big_endian") + binary_triangle(true)}) {
    const auto mesh = read_ply(bytes, "a.ply");
    ASSERT_TRUE(mesh) << mesh.error().message();
    ASSERT_EQ(mesh->vertices.size(), 3U);
    EXPECT_EQ(mesh->vertices[0], (std::array<double, 3>{0, 0, 0.25}));
    EXPECT_EQ(mesh->vertices[2], (std::array<double, 3>{0, -3, 0}));
    EXPECT_EQ(mesh->bodies[0].faces[0].outline, (std::vector<VertexIndex>{2, 1, 0}));
    EXPECT_TRUE(mesh->notes.empty());
  }
}

TEST(Ply, ColoursAreMaterialsAndOtherElementsAreNamed) {
  const auto mesh = read_ply(
      "ply\nformat ascii 1.0\nelement camera 1\nproperty float view\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 3\nproperty list uchar int vertex_index\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nproperty list uchar float weights\nend_header\n7\n0 0 0\n1 0 0\n0 1 0\n0 0 1.5\n"
      "3 0 1 2 255 0 0 0\n3 0 2 3 255 0 1 2 0.5 nan\n3 0 1 3 255 0 0 0\n",
      "a.ply");
  ASSERT_TRUE(mesh) << mesh.error().message();
  EXPECT_EQ(mesh->materials, (std::vector<std::uint32_t>{0, 1, 0}));
  EXPECT_EQ(mesh->notes, (std::vector<std::string>{"1 of the element \"camera\""}));
  EXPECT_EQ(mesh->precision, 0.1);
}

TEST(Ply, EachKindOfErrorIsNamed) {
  const std::string rows = "0 9 0 0\n3 9 0 0\n0 9 -3 0\n";
  EXPECT_EQ(ply_error("ply"), "a.ply: line 1: found no end of the header, expected \"end_header\"") << "no line ends";
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\n"), "a.ply: line 3: found no end of the header, expected \"end_header\"");
  EXPECT_EQ(ply_error("ply\nformat ascii 2.0\nend_header\n").substr(0, 37), "a.ply: line 2: found another format, ");
  EXPECT_EQ(ply_error("ply\nelement vertex -3\n").substr(0, 26), "a.ply: line 2: found \"-3\",");
  EXPECT_NE(ply_error(header("ascii", "3000000")).find("found 3000000 of the element \"vertex\""), std::string::npos);
  EXPECT_EQ(ply_error(header("ascii") + rows), "a.ply: line 15: found the end of the file, expected a whole number");
  EXPECT_EQ(ply_error("ply\nmade by a program\n" + header("ascii").substr(5) + rows + "3 0 1 2"),
            "");  // a comment without its word
  EXPECT_EQ(ply_error(header("ascii") + rows + "3 0 1 1000000000"), "a.ply: line 15: found vertex 1000000000, expected 0 to 2");
  EXPECT_EQ(ply_error(header("ascii") + rows + "3 0 1 -1"), "a.ply: line 15: found vertex -1, expected 0 to 2");
  EXPECT_EQ(ply_error(header("ascii") + rows + "-3 0 1 2").substr(0, 41), "a.ply: line 15: found a list of -3, expec");
  EXPECT_EQ(ply_error(header("ascii") + rows + "1e300 0 1 2").substr(0, 32), "a.ply: line 15: found a list of ");
  EXPECT_EQ(ply_error(header("ascii") + rows + "2 0 1"), "a.ply: line 15: found face 0 of 2 vertices, expected 3 or more");
  EXPECT_EQ(ply_error(header("ascii") + "0 9 0 0\n3 9 inf 0\n0 9 -3 0\n3 2 1 0"),
            "a.ply: line 13: found \"inf\", expected a finite number");
  const std::string body = binary_triangle(false);
  const std::size_t begins = header("binary_little_endian").size();
  for (std::size_t length = 0; length < body.size(); ++length) {
    const std::string error = ply_error(header("binary_little_endian") + body.substr(0, length));
    EXPECT_NE(error, "") << length;
  }
  std::string damaged = body;
  damaged.replace(0, 8, Bytes(false).put(0x7ff0000000000000U, 8).text());
  EXPECT_EQ(ply_error(header("binary_little_endian") + damaged),
            "a.ply: byte " + std::to_string(begins) + ": found a coordinate that is no finite number, expected a finite number");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty "
                      "float z\nend_header\n0 0 0\n"),
            "a.ply: the header: found no element face, expected vertices and faces; a cloud of points has no "
            "surface: make a mesh of it first");
  EXPECT_NE(ply_error("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nelement "
                      "face 0\nend_header\n0 0\n")
                .find("no property z"),
            std::string::npos);
  EXPECT_NE(
      ply_error(
          "ply\nformat ascii 1.0\nelement face 1\nproperty float list\nelement vertex 0\nend_header\n0\n")
          .find("vertex_indices"),
      std::string::npos);
}

constexpr const char* four_vertices =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
constexpr const char* four_rows = "0 0 0\n1 0 0\n0 1 0\n0 0 1.5\n";

// Every other triangle of a strip is turned, and -1 starts another strip.
TEST(Ply, StripsOfTriangles) {
  const auto read = [](const std::string& element, const std::string& rows) {
    return read_ply(std::string("ply\nformat ascii 1.0\n") + four_vertices + element + "end_header\n" + four_rows + rows, "a.ply");
  };
  const std::string strips = "element tristrips 1\nproperty list int int vertex_indices\n";
  EXPECT_EQ(outlines(read(strips, "4 0 1 2 3\n")), (Outlines{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(outlines(read(strips, "9 0 1 2 -1 3 2 1 0 -1\n")), (Outlines{{0, 1, 2}, {3, 2, 1}, {1, 2, 0}}));
  // Degenerate triangles count for the turning.
  EXPECT_EQ(outlines(read(strips, "5 0 1 1 2 3\n")), (Outlines{{1, 2, 3}}));
  const auto thin = read(strips, "6 0 1 -1 1 2 3\n");
  EXPECT_EQ(outlines(thin), (Outlines{{0, 1}, {1, 2, 3}}));
  EXPECT_TRUE(thin->flaw);
  EXPECT_EQ(outlines(read("element tristrips 1\nproperty int a\nproperty list uchar uint vertex_index\n", "7 3 0 1 2\n")),
            (Outlines{{0, 1, 2}}));
  const auto both = read("element tristrips 1\nproperty list int int vertex_indices\nelement face 2\n"
                         "property list uchar int vertex_indices\nproperty uchar red\n",
                         "3 0 1 2\n3 0 2 3 9\n3 0 3 1 8\n");
  EXPECT_EQ(outlines(both), (Outlines{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}));
  EXPECT_EQ(both->materials, (std::vector<std::uint32_t>{0, 1, 2}));
  const auto bad = read(strips, "3 0 1 4\n");
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().message(), "a.ply: line 14: found vertex 4, expected 0 to 3");
  EXPECT_FALSE(read("element tristrips 1\nproperty list int int strip\n", "3 0 1 2\n"));
}

TEST(Ply, VariantsOfTheFormatAreRead) {
  const std::string face = "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string body = std::string("end_header\n") + four_rows + "3 0 1 2\n";
  const std::string head = "ply\nformat ascii 1.0\n";
  const Outlines one{{0, 1, 2}};
  EXPECT_EQ(outlines(read_ply(head + "comment " + std::string(20'000, 'x') + "\nobj_info made\n" + four_vertices + face + body, "a.ply")), one);
  EXPECT_EQ(outlines(read_ply(head + four_vertices + "element nothing 5\n" + face + body, "a.ply")), one);
  EXPECT_EQ(outlines(read_ply(head + four_vertices + "element face 1\nproperty list float double vertex_index\n" + body, "a.ply")), one);
  // Lines that end with CR, and a body that begins with the byte of an LF.
  std::string old = "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty uchar first\nproperty list uchar uchar vertex_indices\n" +
                    std::string(four_vertices) + "end_header\n";
  for (char& c : old) c = c == '\n' ? '\r' : c;
  old += std::string("\n\3\0\1\2", 5) + std::string(48, '\0');
  EXPECT_EQ(outlines(read_ply(old, "a.ply")), one);
  std::string text = head + four_vertices + face + body;
  for (char& c : text) c = c == '\n' ? '\r' : c;
  EXPECT_EQ(outlines(read_ply(text, "a.ply")), one);
}

TEST(Ply, FacesBeforeVertices) {
  const std::string faces_first =
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n";
  EXPECT_EQ(ply_error(faces_first + "3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n"), "");
  EXPECT_EQ(ply_error(faces_first + "3 0 1 3\n0 0 0\n1 0 0\n0 1 0\n"), "a.ply: found vertex 3, expected one below 3");
}

}  // namespace
}  // namespace sightline::scene
