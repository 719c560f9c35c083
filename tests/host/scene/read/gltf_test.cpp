// glTF, GLB and 3MF made by hand after their specifications, and damage of each kind. Skipped where the build has no assimp.
#include "host/scene/read/assimp_mesh.hpp"

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

#include "host/base/crc32.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/read/poly_file.hpp"
#include "host/scene/read/zip.hpp"

namespace sightline::scene {
namespace {

void put(std::string& bytes, std::uint64_t number, int count) {
  for (int i = 0; i < count; ++i) bytes += i < 8 ? static_cast<char>(number >> (8 * i)) : '\0';
}

bool assimp_is_there() {
  const auto nothing = read_by_assimp("{}", "", AssimpFormat::gltf, "");
  return nothing || nothing.error().found.find("built without") == std::string::npos;
}

#define NEEDS_ASSIMP() \
  if (!assimp_is_there()) GTEST_SKIP() << "this build has no assimp (Debian: libassimp-dev)"

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
         R"("buffers":[{"byteLength":72)" + buffer + "}]" + more + "}";
}

std::string inside(const std::string& bytes) {
  return R"(,"uri":"data:application/octet-stream;base64,)" + base64(bytes) + "\"";
}

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

// --- a 3MF archive of stored files

struct StoredFile {
  std::string name;
  std::string text;
};

std::string zip(const std::vector<StoredFile>& files) {
  std::string archive;
  std::string directory;
  for (const StoredFile& file : files) {
    const std::string& text = file.text;
    const std::uint32_t crc = base::crc32(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
    const auto common = [&](std::string& bytes) {
      put(bytes, 20, 2);  // version
      put(bytes, 0, 8);   // flags, stored, time, date
      put(bytes, crc, 4);
      put(bytes, text.size(), 4);
      put(bytes, text.size(), 4);
      put(bytes, file.name.size(), 2);
      put(bytes, 0, 2);
    };
    directory += "PK\1\2";
    put(directory, 20, 2);
    common(directory);
    put(directory, 0, 10);  // comment, part, attributes
    put(directory, archive.size(), 4);
    directory += file.name;
    archive += "PK\3\4";
    common(archive);
    archive += file.name + text;
  }
  const std::size_t at = archive.size();
  archive += directory + "PK\5\6";
  put(archive, 0, 4);
  put(archive, files.size(), 2);
  put(archive, files.size(), 2);
  put(archive, directory.size(), 4);
  put(archive, at, 4);
  put(archive, 0, 2);
  return archive;
}

std::string threemf(const std::string& build, const std::string& attributes = "unit=\"inch\"", const std::string& last = "3") {
  std::string model = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model " + attributes +
                      " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources>"
                      "<object id=\"1\" type=\"model\"><mesh><vertices>";
  for (const auto& c : corners)
    model += "<vertex x=\"" + std::to_string(c[0]) + "\" y=\"" + std::to_string(c[1]) + "\" z=\"" + std::to_string(c[2]) + "\"/>";
  model += "</vertices><triangles>";
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    model += "<triangle v1=\"" + std::to_string(triangles[t]) + "\" v2=\"" + std::to_string(triangles[t + 1]) + "\" v3=\"" +
             (t == 9 ? last : std::to_string(triangles[t + 2])) + "\"/>";
  }
  model += "</triangles></mesh></object><object id=\"2\" type=\"model\"><components><component objectid=\"1\"/>"
           "<component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/></components></object></resources><build>" +
           build + "</build></model>";
  return zip({{"[Content_Types].xml", "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"/>"},
              {"_rels/.rels",
               "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
               "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
               "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
              {"3D/3dmodel.model", model}});
}

const std::string quarter_turn = "<item objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 10 20 30\"/>";

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

std::string error_of(const std::string& bytes, AssimpFormat format) {
  const auto mesh = read_by_assimp(bytes, "a", format, "");
  return mesh ? "" : mesh.error().message();
}

TEST(AssimpMesh, GltfAppliesTheTransformsOfItsNodes) {
  NEEDS_ASSIMP();
  for (const bool binary : {false, true}) {
    const auto mesh = binary ? read_by_assimp(glb(), "a", AssimpFormat::glb, "")
                             : read_by_assimp(gltf(two_nodes, inside(tetrahedron_buffer())), "a", AssimpFormat::gltf, "");
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

TEST(AssimpMesh, ThreemfBuildsItsItems) {
  NEEDS_ASSIMP();
  const auto mesh = read_by_assimp(threemf(quarter_turn + "<item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 0 0 100\"/>"), "a",
                                   AssimpFormat::threemf, "");
  ASSERT_TRUE(mesh) << mesh.error().message();
  ASSERT_EQ(mesh->bodies.size(), 3U);
  // Rows times matrix: x' = -y + 10, y' = x + 20, z' = z + 30.
  EXPECT_EQ(points_of(*mesh, mesh->bodies[0]), (Points{{10, 20, 30}, {10, 21, 30}, {9, 20, 30}, {10, 20, 31}}));
  EXPECT_EQ(points_of(*mesh, mesh->bodies[1]), (Points{{0, 0, 100}, {2, 0, 100}, {0, 2, 100}, {0, 0, 102}}));
  EXPECT_EQ(points_of(*mesh, mesh->bodies[2]), (Points{{10, 0, 100}, {12, 0, 100}, {10, 2, 100}, {10, 0, 102}}));
  EXPECT_EQ(mesh->unit, "inch");
  EXPECT_EQ(mesh->vertical, std::optional<std::size_t>(2));
  const auto silent = read_by_assimp(threemf("<item objectid=\"1\"/>", "xml:lang=\"en\""), "a", AssimpFormat::threemf, "");
  ASSERT_TRUE(silent);
  EXPECT_EQ(silent->unit, "mm");  // what the specification says of a model that does not say it
}

TEST(AssimpMesh, WhatIsReadIsASolidOfEachNode) {
  NEEDS_ASSIMP();
  const auto read = read_poly(glb(), "a.glb", PolyFormat::glb, {.mend = true});
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_TRUE(check_poly_scene(read->scene).empty());
  EXPECT_EQ(read->report.faces.sheets, 0U);
  EXPECT_EQ(read->report.faces.turned_faces, 0U);
  EXPECT_EQ(face_count(read->scene), 8U);
}

TEST(AssimpMesh, ToldByContent) {
  EXPECT_EQ(poly_format_of("a.stl", glb()), PolyFormat::glb);
  EXPECT_EQ(poly_format_of("a.stl", threemf("")), PolyFormat::threemf);
  EXPECT_EQ(poly_format_of("a.json", gltf(two_nodes, "")), PolyFormat::gltf);
  EXPECT_EQ(poly_format_of("-", "\n {\"scenes\": [{\"asset\\\"\": 1}],\n\"asset\" : {}}"), PolyFormat::gltf);
  EXPECT_EQ(poly_format_of("a.gltf", "{\"bodies\": [{\"asset\": 1}], \"name\": \"asset\"}"), PolyFormat::json);
  EXPECT_EQ(poly_format_of("-", "{\"asset"), PolyFormat::json);
}

TEST(AssimpMesh, BuffersComeFromTheFolderAlone) {
  NEEDS_ASSIMP();
  const std::filesystem::path folder = std::filesystem::current_path() / "assimp_mesh_test";
  std::filesystem::create_directories(folder / "in" / "sub");
  const auto write = [&](const char* name) { std::ofstream(folder / name, std::ios::binary) << tetrahedron_buffer(); };
  for (const char* name : {"in/a b.bin", "in/sub/c.bin", "out.bin"}) write(name);
  std::error_code ignored;
  std::filesystem::remove(folder / "in" / "link.bin", ignored);
  std::filesystem::create_symlink(folder / "out.bin", folder / "in" / "link.bin");
  const auto error_with = [&](const std::string& uri, const std::string& from) {
    const auto mesh = read_by_assimp(gltf(two_nodes, ",\"uri\":\"" + uri + "\""), "a", AssimpFormat::gltf, from);
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

TEST(AssimpMesh, DamageIsNamed) {
  NEEDS_ASSIMP();
  const auto has = [](const std::string& message, const std::string& part) {
    return message.find(part) != std::string::npos ? testing::AssertionSuccess() : testing::AssertionFailure() << message;
  };
  std::string bytes = glb();
  EXPECT_TRUE(has(error_of(bytes.substr(0, 100), AssimpFormat::glb), "a: byte 8: found a length of"));
  EXPECT_TRUE(has(error_of(bytes.substr(0, 10), AssimpFormat::glb), "byte 10: found the end of the file"));
  bytes[4] = 3;
  EXPECT_TRUE(has(error_of(bytes, AssimpFormat::glb), "byte 4: found version 3"));
  bytes = glb();
  bytes[15] = 9;
  EXPECT_TRUE(has(error_of(bytes, AssimpFormat::glb), "byte 12: found a chunk of"));
  EXPECT_TRUE(has(error_of("{\"asset\": {\"version\": }", AssimpFormat::gltf), "line 1"));
  EXPECT_TRUE(has(error_of(gltf(two_nodes, inside(tetrahedron_buffer()), R"(,"extensionsRequired":["KHR_mesh_quantization"])"), AssimpFormat::gltf),
                  "extensionsRequired: found \"KHR_mesh_quantization\""));
  EXPECT_TRUE(
      has(error_of(gltf(two_nodes, inside(tetrahedron_buffer(std::numeric_limits<float>::quiet_NaN()))),
                   AssimpFormat::gltf),
          "vertex 0: found a coordinate that is no finite number"));
  const std::string archive = threemf(quarter_turn);
  EXPECT_TRUE(has(error_of(archive.substr(0, archive.size() - 30), AssimpFormat::threemf), "found the end of the file"));
  EXPECT_TRUE(has(error_of(archive.substr(0, 60) + archive.substr(61), AssimpFormat::threemf),
                  "found no entry of the ZIP directory"));
  EXPECT_TRUE(has(error_of(zip({{"a.txt", "text"}}), AssimpFormat::threemf), "without a file *.model"));
  EXPECT_TRUE(has(error_of(threemf(quarter_turn, "unit=\"inch\"", "1000000000"), AssimpFormat::threemf),
                  "face 3: found vertex 1000000000, expected 0 to 3"));
  EXPECT_TRUE(
      has(error_of(threemf(quarter_turn, "requiredextensions=\"p\" xmlns:p=\"http://x/production/2015/06\""),
                   AssimpFormat::threemf),
          "3D/3dmodel.model: found that the extension \"p\" is required"));
  EXPECT_TRUE(has(error_of(zip({{"3D/3dmodel.model", "<model xmlns:p=\"http://x/production/2015/06\"><resources><object id=\"2\"><components><component "
                                                     "p:path=\"/3D/Objects/o.model\" objectid=\"1\"/></components></object></resources><build>"
                                                     "<item objectid=\"2\"/></build></model>"}}),
                           AssimpFormat::threemf),
                  "3D/3dmodel.model: found a component in another part, \"/3D/Objects/o.model\""));
}

// Whatever assimp does with it, this program goes on.
TEST(AssimpMesh, NoDamageEndsTheProgram) {
  NEEDS_ASSIMP();
  std::mt19937 random(1971);
  const std::array<std::pair<std::string, AssimpFormat>, 3> whole{
      {{glb(), AssimpFormat::glb},
       {threemf(quarter_turn), AssimpFormat::threemf},
       {gltf(two_nodes, inside(tetrahedron_buffer())), AssimpFormat::gltf}}};
  int refused = 0;
  for (int i = 0; i < 90; ++i) {
    auto [bytes, format] = whole[static_cast<std::size_t>(i) % whole.size()];
    const std::size_t damages = 1 + random() % 4;
    for (std::size_t d = 0; d < damages; ++d) bytes[random() % bytes.size()] = static_cast<char>(random());
    if (i % 5 == 0) bytes.resize(random() % bytes.size());
    const auto read = read_by_assimp(bytes, "a", format, "");
    refused += read ? 0 : 1;
    if (!read) {
      EXPECT_FALSE(read.error().found.empty()) << "damage " << i;
    }
  }
  EXPECT_GT(refused, 20);
}

TEST(Zip, EntriesAndBeginnings) {
  const std::string archive = zip({{"a.txt", "alpha"}, {"folder/b.txt", ""}});
  const auto entries = zip_entries(archive);
  ASSERT_TRUE(entries) << entries.error().message();
  ASSERT_EQ(entries->size(), 2U);
  EXPECT_EQ((*entries)[0].name, "a.txt");
  EXPECT_EQ(zip_beginning(archive, (*entries)[0], 3), "alp");
  EXPECT_EQ(zip_beginning(archive, (*entries)[0], 30), "alpha");
  EXPECT_EQ((*entries)[1].name, "folder/b.txt");
  EXPECT_EQ(zip_beginning(archive, (*entries)[1], 3), "");
}

}  // namespace
}  // namespace sightline::scene
