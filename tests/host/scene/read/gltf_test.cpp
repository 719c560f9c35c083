// glTF and GLB made by hand after the specification, and damage of each kind.
#include "host/scene/read/gltf.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "host/scene/check/poly_scene.hpp"
#include "host/scene/read/poly_file.hpp"

namespace sightline::scene {
namespace {

void put(std::string& bytes, std::uint64_t number, int count) {
  for (int i = 0; i < count; ++i) bytes += i < 8 ? static_cast<char>(number >> (8 * i)) : '\0';
}

// --- a tetrahedron with corners at 0 and 1 on the axes, as the buffer of a glTF file

constexpr std::array<std::array<float, 3>, 4> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<std::uint16_t, 12> triangles{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

std::string tetrahedron_buffer(float first = 0) {
  std::string bytes;
  for (std::size_t v = 0; v < corners.size(); ++v)
    for (const float c : corners[v]) put(bytes, std::bit_cast<std::uint32_t>(v == 0 && first != 0 ? first : c), 4);
  for (const std::uint16_t v : triangles) put(bytes, v, 2);
  return bytes;
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = word << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? letters[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

const std::string two_nodes = R"([{"name":"frame","translation":[10,0,0],"children":[1,2]},{"name":"plain","mesh":0},)"
                              R"({"name":"mirror","mesh":0,"scale":[-2,2,2],"translation":[0,0,5]}])";

std::string gltf(const std::string& nodes, const std::string& buffer, const std::string& more = "") {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
         R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)"
         R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},)"
         R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],"bufferViews":[)"
         R"({"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],)"
         R"("buffers":[{"byteLength":72)" +
         buffer + "}]" + more + "}";
}

std::string inside(const std::string& bytes) { return R"(,"uri":"data:application/octet-stream;base64,)" + base64(bytes) + "\""; }

std::string glb() {
  std::string json = gltf(two_nodes, "");
  while (json.size() % 4 != 0) json += ' ';
  const std::string buffer = tetrahedron_buffer();
  std::string bytes = "glTF";
  put(bytes, 2, 4);
  put(bytes, 12 + 8 + json.size() + 8 + buffer.size(), 4);
  put(bytes, json.size(), 4);
  bytes += "JSON" + json;
  put(bytes, buffer.size(), 4);
  bytes += "BIN";
  bytes += '\0';
  return bytes + buffer;
}

using Points = std::set<std::array<double, 3>>;

Points points_of(const PolyMesh& mesh, const PolyBody& body) {
  Points points;
  for (const PolyFace& face : body.faces)
    for (const VertexIndex v : face.outline) points.insert(mesh.vertices[v]);
  return points;
}

// Six times the volume: positive if the faces are seen counterclockwise from outside.
double volume(const PolyMesh& mesh, const PolyBody& body) {
  double sum = 0;
  for (const PolyFace& face : body.faces) {
    const auto& a = mesh.vertices[face.outline[0]];
    const auto& b = mesh.vertices[face.outline[1]];
    const auto& c = mesh.vertices[face.outline[2]];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

std::string error_of(const std::string& bytes) {
  const auto mesh = bytes.starts_with("glTF") ? read_glb(bytes, "a", "") : read_gltf(bytes, "a", "");
  return mesh ? "" : mesh.error().message();
}

TEST(Gltf, GltfAppliesTheTransformsOfItsNodes) {
  for (const bool binary : {false, true}) {
    const auto mesh = binary ? read_glb(glb(), "a", "") : read_gltf(gltf(two_nodes, inside(tetrahedron_buffer())), "a", "");
    ASSERT_TRUE(mesh) << mesh.error().message();
    ASSERT_EQ(mesh->bodies.size(), 2U);
    EXPECT_TRUE(mesh->grouped);
    EXPECT_EQ(mesh->bodies[0].name, "plain");
    EXPECT_EQ(points_of(*mesh, mesh->bodies[0]), (Points{{10, 0, 0}, {11, 0, 0}, {10, 1, 0}, {10, 0, 1}}));
    EXPECT_EQ(points_of(*mesh, mesh->bodies[1]), (Points{{10, 0, 5}, {8, 0, 5}, {10, 2, 5}, {10, 0, 7}}));
    EXPECT_EQ(volume(*mesh, mesh->bodies[0]), 1);
    EXPECT_EQ(volume(*mesh, mesh->bodies[1]), 8);  // a mirror turns no face inside out
    EXPECT_EQ(mesh->unit, "m");
    EXPECT_EQ(mesh->vertical, std::optional<std::size_t>(1));
    EXPECT_GE(mesh->precision, 0x1p-20);  // of floats from 8 to 16
  }
}

TEST(Gltf, WhatIsReadIsASolidOfEachNode) {
  const auto read = read_poly(glb(), "a.glb", PolyFormat::glb, {.mend = true});
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_TRUE(check_poly_scene(read->scene).empty());
  EXPECT_EQ(read->report.faces.sheets, 0U);
  EXPECT_EQ(read->report.faces.turned_faces, 0U);
  EXPECT_EQ(face_count(read->scene), 8U);
}

TEST(Gltf, ToldByContent) {
  EXPECT_EQ(poly_format_of("a.stl", glb()), PolyFormat::glb);
  EXPECT_EQ(poly_format_of("a.json", gltf(two_nodes, "")), PolyFormat::gltf);
  EXPECT_EQ(poly_format_of("-", "\n {\"scenes\": [{\"asset\\\"\": 1}],\n\"asset\" : {}}"), PolyFormat::gltf);
  EXPECT_EQ(poly_format_of("a.gltf", "{\"bodies\": [{\"asset\": 1}], \"name\": \"asset\"}"), PolyFormat::json);
  EXPECT_EQ(poly_format_of("-", "{\"asset"), PolyFormat::json);
}

TEST(Gltf, BuffersComeFromTheFolderAlone) {
  const std::filesystem::path folder = std::filesystem::current_path() / "gltf_test";
  std::filesystem::create_directories(folder / "in" / "sub");
  const auto write = [&](const char* name) { std::ofstream(folder / name, std::ios::binary) << tetrahedron_buffer(); };
  for (const char* name : {"in/a b.bin", "in/sub/c.bin", "out.bin"}) write(name);
  std::error_code ignored;
  std::filesystem::remove(folder / "in" / "link.bin", ignored);
  std::filesystem::create_symlink(folder / "out.bin", folder / "in" / "link.bin");
  const auto error_with = [&](const std::string& uri, const std::string& from) {
    const auto mesh = read_gltf(gltf(two_nodes, ",\"uri\":\"" + uri + "\""), "a", from);
    return mesh ? std::string() : mesh.error().message();
  };
  const std::string in = (folder / "in").string();
  EXPECT_EQ(error_with("a%20b.bin", in), "");
  EXPECT_EQ(error_with("sub/c.bin", in), "");
  EXPECT_EQ(error_with("sub/../a b.bin", in), "");
  for (const std::string uri : {"../out.bin", "sub/../../out.bin", "%2e%2e/out.bin", "link.bin"})
    EXPECT_NE(error_with(uri, in).find("outside of the file's folder"), std::string::npos) << uri << ": " << error_with(uri, in);
  EXPECT_NE(error_with((folder / "out.bin").string(), in).find("outside"), std::string::npos);
  EXPECT_NE(error_with("none.bin", in).find("not in the file's folder"), std::string::npos);
  EXPECT_NE(error_with("a%20b.bin", "").find("standard input"), std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST(Gltf, DamageIsNamed) {
  const auto has = [](const std::string& message, const std::string& part) {
    return message.find(part) != std::string::npos ? testing::AssertionSuccess() : testing::AssertionFailure() << message;
  };
  std::string bytes = glb();
  EXPECT_TRUE(has(error_of(bytes.substr(0, 100)), "a: byte 8: found a length of"));
  EXPECT_TRUE(has(error_of(bytes.substr(0, 10)), "byte 10: found the end of the file"));
  bytes[4] = 3;
  EXPECT_TRUE(has(error_of(bytes), "byte 4: found version 3"));
  bytes = glb();
  bytes[15] = 9;
  EXPECT_TRUE(has(error_of(bytes), "byte 12: found a chunk of"));
  EXPECT_TRUE(has(error_of("{\"asset\": {\"version\": }"), "line 1"));
  EXPECT_TRUE(has(error_of(gltf(two_nodes, inside(tetrahedron_buffer()), R"(,"extensionsRequired":["EXT_meshopt_compression"])")),
                  "extensionsRequired: found \"EXT_meshopt_compression\""));
  EXPECT_TRUE(has(error_of(gltf(two_nodes, inside(tetrahedron_buffer(std::numeric_limits<float>::quiet_NaN())))),
                  "vertex 0: found a coordinate that is no finite number"));
}

// --- one primitive of any kind

// A glTF file of one mesh whose positions are accessor 0; `accessors` begins with it.
std::string one_primitive(const std::string& primitive, const std::string& accessors, const std::string& bytes,
                          const std::string& views = "", const std::string& node = "\"mesh\":0") {
  const std::string size = std::to_string(bytes.size());
  return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{)" + node + R"(}],"meshes":[{"primitives":[)" +
         primitive + R"(]}],"accessors":[)" + accessors + R"(],"bufferViews":[{"buffer":0,"byteLength":)" + size + "}" + views +
         R"(],"buffers":[{"byteLength":)" + size + inside(bytes) + "}]}";
}

std::string floats(const std::vector<float>& numbers) {
  std::string bytes;
  for (const float number : numbers) put(bytes, std::bit_cast<std::uint32_t>(number), 4);
  return bytes;
}

const std::string five_positions = R"({"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"})";
const std::string zigzag = floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0});

// The triangles by their corners, each beginning with its least one.
std::set<std::array<std::array<double, 3>, 3>> triangles_of(const std::string& text) {
  std::set<std::array<std::array<double, 3>, 3>> result;
  const auto mesh = read_gltf(text, "a", "");
  EXPECT_TRUE(mesh) << mesh.error().message();
  if (!mesh) return result;
  for (const PolyBody& body : mesh->bodies) {
    for (const PolyFace& face : body.faces) {
      std::array<std::array<double, 3>, 3> corner{};
      for (std::size_t c = 0; c < 3; ++c) corner[c] = mesh->vertices[face.outline[c]];
      std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
      result.insert(corner);
    }
  }
  return result;
}

TEST(Gltf, TrianglesStripsAndFans) {
  const std::array<double, 3> a{0, 0, 0};
  const std::array<double, 3> b{1, 0, 0};
  const std::array<double, 3> c{0, 1, 0};
  const std::array<double, 3> d{1, 1, 0};
  const std::array<double, 3> e{0, 2, 0};
  using Triangles = std::set<std::array<std::array<double, 3>, 3>>;
  const auto with = [](const std::string& more) {
    return one_primitive(R"({"attributes":{"POSITION":0})" + more + "}", five_positions, zigzag);
  };
  EXPECT_EQ(triangles_of(with("")), (Triangles{{a, b, c}}));
  EXPECT_EQ(triangles_of(with(R"(,"mode":5)")), (Triangles{{a, b, c}, {c, b, d}, {c, d, e}}));  // 3.7.2.1, figure of the modes
  EXPECT_EQ(triangles_of(with(R"(,"mode":6)")), (Triangles{{a, b, c}, {a, c, d}, {a, d, e}}));
  // Two strips that are joined by degenerate triangles, with indices of one byte.
  const std::string indexed = zigzag + std::string("\0\1\2\2\3\3\4\1", 8);
  EXPECT_EQ(triangles_of(one_primitive(
                R"({"attributes":{"POSITION":0},"indices":1,"mode":5})",
                five_positions + R"(,{"bufferView":0,"byteOffset":60,"componentType":5121,"count":8,"type":"SCALAR"})", indexed)),
            (Triangles{{a, b, c}, {e, d, b}}));
}

TEST(Gltf, WholeNumbersOfEachSizeAndStride) {
  std::string bytes;
  for (const std::array<int, 3> point : {std::array{0, 0, 0}, std::array{-32768, 0, 0}, std::array{0, 32767, 0}}) {
    for (const int c : point) put(bytes, static_cast<std::uint16_t>(c), 2);
    put(bytes, 0xffff, 2);  // to the next stride
  }
  const auto read = [&](const std::string& more) {
    const auto mesh = read_gltf(one_primitive(R"({"attributes":{"POSITION":0}})",
                                              R"({"bufferView":1,"componentType":5122,"count":3,"type":"VEC3")" + more + "}",
                                              bytes, R"(,{"buffer":0,"byteLength":24,"byteStride":8})"),
                                "a", "");
    return mesh ? mesh->vertices : std::vector<std::array<double, 3>>();
  };
  EXPECT_EQ(read(""), (std::vector<std::array<double, 3>>{{0, 0, 0}, {-32768, 0, 0}, {0, 32767, 0}}));
  // 3.6.2.2: max(c / 32767, -1)
  EXPECT_EQ(read(R"(,"normalized":true)"), (std::vector<std::array<double, 3>>{{0, 0, 0}, {-1, 0, 0}, {0, 1, 0}}));
}

TEST(Gltf, SparseElementsReplaceOthersOrZeros) {
  std::string bytes = zigzag;
  put(bytes, 1, 2);
  put(bytes, 2, 2);
  bytes += floats({5, 6, 7, 8, 9, 10});
  const std::string sparse =
      R"(,"sparse":{"count":2,"indices":{"bufferView":0,"byteOffset":60,"componentType":5123},"values":{"bufferView":0,"byteOffset":64}}})";
  const std::string primitive = R"({"attributes":{"POSITION":0}})";
  using Triangles = std::set<std::array<std::array<double, 3>, 3>>;
  const std::array<double, 3> a{0, 0, 0};
  const std::array<double, 3> b{5, 6, 7};
  const std::array<double, 3> c{8, 9, 10};
  EXPECT_EQ(
      triangles_of(one_primitive(primitive, R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3")" + sparse, bytes)),
      (Triangles{{a, b, c}}));
  EXPECT_EQ(triangles_of(one_primitive(primitive, R"({"componentType":5126,"count":3,"type":"VEC3")" + sparse, bytes)),
            (Triangles{{a, b, c}}));
  std::string descending = bytes;
  std::swap(descending[60], descending[62]);
  const std::string error =
      error_of(one_primitive(primitive, R"({"componentType":5126,"count":3,"type":"VEC3")" + sparse, descending));
  EXPECT_NE(error.find("accessors[0].sparse.indices: found 1 at 1, expected ascending numbers below 3"), std::string::npos)
      << error;
}

// Entries by name, several meshes in a node, the stride in the accessor.
TEST(Gltf, VersionOne) {
  const std::string text =
      R"({"asset":{"version":"1.0"},"scene":"s","scenes":{"s":{"nodes":["n"]}},"nodes":{"n":{"children":["m"],)"
      R"("translation":[10,0,0]},"m":{"meshes":["one","one"],"name":"both"}},"meshes":{"one":{"primitives":[{"attributes":)"
      R"({"POSITION":"p"},"indices":"i"}]}},"accessors":{"p":{"bufferView":"v","byteStride":12,"componentType":5126,"count":4,)"
      R"("type":"VEC3"},"i":{"bufferView":"w","byteStride":0,"componentType":5123,"count":12,"type":"SCALAR"}},"bufferViews":)"
      R"({"v":{"buffer":"b","byteOffset":0,"byteLength":48},"w":{"buffer":"b","byteOffset":48,"byteLength":24}},"buffers":{"b":)"
      R"({"byteLength":72)" +
      inside(tetrahedron_buffer()) + "}}}";
  const auto mesh = read_gltf(text, "a", "");
  ASSERT_TRUE(mesh) << mesh.error().message();
  ASSERT_EQ(mesh->bodies.size(), 1U);
  EXPECT_EQ(mesh->bodies[0].name, "both");
  EXPECT_EQ(mesh->bodies[0].faces.size(), 8U);
  EXPECT_EQ(points_of(*mesh, mesh->bodies[0]), (Points{{10, 0, 0}, {11, 0, 0}, {10, 1, 0}, {10, 0, 1}}));
}

// The tetrahedron, written by libdraco's own encoder with 11 bits: by edgebreaker, and as a sequence.
TEST(Gltf, DracoCompression) {
  constexpr std::array compressed{
      "RFJBQ08CAgEBAAAABAQAAwAAAS8BARAB/wAAAQAJAwAAAgEBAQADAwEQATADAFCCJJEEAAAAAP8HAAAAAAAAAAAAAAAAAAAAAIA/Cw==",
      "RFJBQ08CAgEAAAAEBAEAAQIAAgMAAwECAQMBAQAJAwAAAgABAQADAwEgASADACCEUCIBAAAAAP8HAAAAAAAAAAAAAAAAAAAAAIA/Cw=="};
  for (const std::string text : compressed) {
    const auto file = [](const std::string& data, const std::string& id) {
      return R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_draco_mesh_compression"],"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
             R"({"attributes":{"POSITION":0},"indices":1,"extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":)" +
             id +
             R"(}}}}]}],"accessors":[{"componentType":5126,"count":4,"type":"VEC3"},{"componentType":5123,"count":12,"type":"SCALAR"}],)"
             R"("bufferViews":[{"buffer":0,"byteLength":76}],"buffers":[{"byteLength":76,"uri":"data:;base64,)" +
             data + "\"}]}";
    };
    const auto mesh = read_gltf(file(text, "0"), "a", "");
    if (!mesh && mesh.error().found.find("built without") != std::string::npos) GTEST_SKIP() << mesh.error().message();
    ASSERT_TRUE(mesh) << mesh.error().message();
    EXPECT_EQ(points_of(*mesh, mesh->bodies[0]), (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    EXPECT_EQ(volume(*mesh, mesh->bodies[0]), 1);
    const std::string place = "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression: found ";
    EXPECT_NE(error_of(file(text, "7")).find(place + "no positions with the id 7"), std::string::npos)
        << error_of(file(text, "7"));
    const std::string other = "AAAA" + text.substr(4);
    EXPECT_NE(error_of(file(other, "0")).find(place + "no header of Draco"), std::string::npos) << error_of(file(other, "0"));
    // The number of faces is byte 13 or 11: a number of five bytes there is far more than 76 bytes can hold.
    const bool edgebreaker = text == compressed[0];
    const std::string header = edgebreaker ? std::string("DRACO\2\2\1\1\0\0\0\4", 13) : std::string("DRACO\2\2\1\0\0\0", 11);
    const std::string lie = header + "\xff\xff\xff\x7f" + std::string(76 - header.size() - 4, '\1');
    EXPECT_NE(error_of(file(base64(lie), "0")).find(place + "268435455 faces in 76 bytes"), std::string::npos)
        << error_of(file(base64(lie), "0"));
  }
}

TEST(Gltf, DamageOfEachKindHasAPlace) {
  const std::string position = R"({"attributes":{"POSITION":0}})";
  const auto accessor = [&](const std::string& members) {
    return error_of(one_primitive(position, "{" + members + "}", zigzag));
  };
  const auto node = [&](const std::string& members) {
    return error_of(one_primitive(position, five_positions, zigzag, "", members));
  };
  struct Damage {
    std::string error;
    std::string part;
  };
  const std::string good = R"("bufferView":0,"componentType":5126,"type":"VEC3",)";
  const std::string whole = gltf(two_nodes, inside(tetrahedron_buffer()));
  const auto replaced = [&](const std::string& what, const std::string& by) {
    std::string text = whole;
    text.replace(text.find(what), what.size(), by);
    return error_of(text);
  };
  const std::vector<Damage> damages{
      {accessor(good + R"("count":6)"),
       "accessors[0].count: found 6 elements of 12 bytes, expected at most the 60 bytes that bufferViews[0] has left"},
      {accessor(good + R"("count":4294967296)"),
       "accessors[0].count: found 4294967296, expected a whole number up to 4294967295"},
      {accessor(good + R"("count":-1)"), "accessors[0].count: found -1"},
      {accessor(good + R"("count":1.5)"), "accessors[0].count: found 1.5"},
      {accessor(good + R"("count":"5")"), "accessors[0].count: found a string"},
      {accessor(good + R"("count":1,"byteOffset":61)"), "accessors[0].byteOffset: found 61, expected a whole number up to 60"},
      {accessor(good + R"("count":4294967295)"), "accessors[0].count: found 4294967295 elements of 12 bytes"},
      {accessor(R"("componentType":5126,"type":"VEC3","count":4000000000)"),
       "accessors[0].count: found 4000000000, expected at most 10000000 without"},
      {accessor(R"("bufferView":0,"componentType":5130,"type":"VEC3","count":5)"), "accessors[0].componentType: found 5130"},
      {accessor(R"("bufferView":0,"componentType":5126,"type":"MAT4","count":1)"), "accessors[0].type: found a string"},
      {accessor(R"("bufferView":0,"componentType":5126,"type":"VEC2","count":5)"),
       "accessors[0].type: found positions of 2 numbers"},
      {accessor(R"("bufferView":3,"componentType":5126,"type":"VEC3","count":5)"),
       "accessors[0].bufferView: found 3, expected the number of one of the 1 bufferViews"},
      {node(R"("mesh":"one")"), "nodes[0].mesh: found \"one\", expected the number of one of the 1 meshes, from 0"},
      {node("\"mesh\":0" +
            [] {
              std::string members;
              for (int i = 0; i < 1000; ++i) members += ",\"a\":0";
              return members;
            }()),
       "nodes[0]: found an object of 1001 members, expected at most 1000"},
      {node(R"("mesh":1)"), "nodes[0].mesh: found 1, expected the number of one of the 1 meshes, from 0"},
      {node(R"("mesh":0,"children":[0])"), "nodes[0]: found a node that is its own descendant"},
      {node(R"("mesh":0,"children":[7])"), "nodes[0].children[0]: found 7"},
      {node(R"("mesh":0,"children":7)"), "nodes[0].children: found 7, expected an array"},
      {node(R"("mesh":0,"matrix":[1,2])"), "nodes[0].matrix: found an array of 2, expected an array of 16"},
      {node(R"("mesh":0,"scale":[1,"a",1])"), "nodes[0].scale[1]: found a string, expected a number"},
      {node(R"("mesh":0,"scale":[1e308,1e308,1e308],"translation":[0,1e308,0])"),
       "meshes[0].primitives[0], vertex 2: found a coordinate that is no finite number"},
      {replaced(R"("byteLength":72)", R"("byteLength":73)"),
       "buffers[0].byteLength: found 73, expected at most the 72 bytes that are there"},
      {replaced(R"("byteLength":24)", R"("byteLength":25)"),
       "bufferViews[1].byteLength: found 25, expected a whole number up to 24"},
      {replaced(R"("byteLength":48)", R"("byteLength":48,"byteStride":8)"),
       "bufferViews[0].byteStride: found 8, expected at least the 12 bytes"},
      {replaced(";base64,A", ";base64,*"), "buffers[0].uri: found a character that is none of base64"},
      {replaced(R"("uri":)", R"("name":)"), "buffers[0].uri: found none"},
      {replaced(R"("primitives":[)", R"("primitives":7,"other":[)"), "meshes[0].primitives: found 7"},
      {replaced(R"("indices":1)", R"("indices":0)"), "accessors[0]: found indices that are no whole numbers"},
      {replaced(R"("scene":0)", R"("scene":1)"), "scene: found 1"},
      {error_of(R"({"asset":)" + std::string(1'000'000, '[')), "line 1, column"},
  };
  for (std::size_t i = 0; i < damages.size(); ++i)
    EXPECT_NE(damages[i].error.find(damages[i].part), std::string::npos)
        << i << ": " << damages[i].error << "\nwithout: " << damages[i].part;
}

TEST(Gltf, FacesWithoutTheirVerticesAreLeftOut) {
  const std::string accessors =
      five_positions + R"(,{"bufferView":0,"byteOffset":60,"componentType":5121,"count":7,"type":"SCALAR"})";
  const std::string primitive = R"({"attributes":{"POSITION":0},"indices":1})";
  const auto mesh = read_gltf(one_primitive(primitive, accessors, zigzag + std::string("\0\1\2\0\1\5\0\0", 8)), "a", "");
  ASSERT_TRUE(mesh) << mesh.error().message();
  EXPECT_EQ(mesh->bodies[0].faces.size(), 1U);
  EXPECT_EQ(mesh->notes,
            (std::vector<std::string>{"1 vertex beyond the last whole triangle", "1 face with a vertex that is not there"}));
  const std::string none = error_of(one_primitive(primitive, accessors, zigzag + std::string("\5\1\2\0\1\5\0\0", 8)));
  EXPECT_NE(none.find("meshes[0].primitives[0].indices: found no face whose vertices are all there"), std::string::npos) << none;
}

// A small file cannot ask for much memory or time: 27 million corners of each primitive, all of them 0.
TEST(Gltf, ManyCornersAreRefused) {
  const std::string strip = R"({"attributes":{"POSITION":0},"mode":5,"indices":1})";
  const std::string text =
      R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)" + strip + "," + strip + "," + strip + "," +
      strip +
      R"(]}],"accessors":[{"componentType":5126,"count":3,"type":"VEC3"},{"componentType":5123,"count":9000000,"type":"SCALAR"}]})";
  const std::string error = error_of(text);
  EXPECT_NE(error.find("meshes[0].primitives[3]: found more than 100000000 corners of faces"), std::string::npos) << error;
}

TEST(Gltf, NoDamageEndsTheProgram) {
  std::mt19937 random(1971);
  const std::array<std::string, 2> whole{glb(), gltf(two_nodes, inside(tetrahedron_buffer()))};
  int refused = 0;
  for (int i = 0; i < 600; ++i) {
    std::string bytes = whole[static_cast<std::size_t>(i) % whole.size()];
    const std::size_t damages = 1 + random() % 4;
    for (std::size_t d = 0; d < damages; ++d) bytes[random() % bytes.size()] = static_cast<char>(random());
    if (i % 5 == 0) bytes.resize(random() % bytes.size());
    const auto read = i % 2 == 0 ? read_glb(bytes, "a", "") : read_gltf(bytes, "a", "");
    refused += read ? 0 : 1;
    if (!read) {
      EXPECT_FALSE(read.error().found.empty()) << "damage " << i;
    }
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace sightline::scene
