// 3MF made by hand after its specifications, and damage of each kind. Skipped where the build has no libzip or pugixml.
#include "host/scene/read/three_mf.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "host/base/crc32.hpp"
#include "host/scene/read/poly_file.hpp"

namespace sightline::scene {
namespace {

void put(std::string& bytes, std::uint64_t number, int count) {
  for (int i = 0; i < count; ++i) bytes += i < 8 ? static_cast<char>(number >> (8 * i)) : '\0';
}

#define NEEDS_THREE_MF()                                                                                            \
  if (const auto nothing = read_three_mf("", ""); nothing.error().found.find("built without") != std::string::npos) \
  GTEST_SKIP() << nothing.error().message()

// --- ZIP archives: PKWARE, APPNOTE.TXT

enum class Packing { stored, deflated, zip64 };

struct PackedFile {
  std::string name;
  std::string text;
};

std::string deflated(const std::string& text) {
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, text.size()), '\0');
  std::string copy = text;
  stream.next_in = reinterpret_cast<Bytef*>(copy.data());
  stream.avail_in = static_cast<uInt>(copy.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string zip(const std::vector<PackedFile>& files, Packing packing = Packing::stored, std::uint64_t count_lie = 0) {
  constexpr std::uint64_t elsewhere = 0xffffffff;
  const bool zip64 = packing == Packing::zip64;
  std::string archive;
  std::string directory;
  for (const PackedFile& file : files) {
    const std::uint32_t crc = base::crc32(std::span(reinterpret_cast<const std::uint8_t*>(file.text.data()), file.text.size()));
    const std::string packed = packing == Packing::deflated ? deflated(file.text) : file.text;
    const auto common = [&](std::string& bytes, std::size_t extra) {
      put(bytes, zip64 ? 45 : 20, 2);  // version
      put(bytes, 0, 2);                // flags
      put(bytes, packing == Packing::deflated ? 8 : 0, 2);
      put(bytes, 0, 4);  // time, date
      put(bytes, crc, 4);
      put(bytes, zip64 ? elsewhere : packed.size(), 4);
      put(bytes, zip64 ? elsewhere : file.text.size(), 4);
      put(bytes, file.name.size(), 2);
      put(bytes, extra, 2);
    };
    std::string sizes;  // 4.5.3
    put(sizes, 1, 2);
    put(sizes, 16, 2);
    put(sizes, file.text.size(), 8);
    put(sizes, packed.size(), 8);
    directory += "PK\1\2";
    put(directory, 20, 2);
    common(directory, zip64 ? sizes.size() + 8 : 0);
    put(directory, 0, 10);  // comment, part, attributes
    put(directory, zip64 ? elsewhere : archive.size(), 4);
    directory += file.name;
    if (zip64) {
      std::string with_offset = sizes;
      with_offset[2] = 24;
      put(with_offset, archive.size(), 8);
      directory += with_offset;
    }
    archive += "PK\3\4";
    common(archive, zip64 ? sizes.size() : 0);
    archive += file.name;
    if (zip64) archive += sizes;
    archive += packed;
  }
  const std::size_t at = archive.size();
  archive += directory;
  if (zip64) {  // 4.3.14 and 4.3.15
    const std::size_t end = archive.size();
    archive += "PK\6\6";
    put(archive, 44, 8);
    put(archive, 45, 2);
    put(archive, 45, 2);
    put(archive, 0, 8);
    put(archive, count_lie != 0 ? count_lie : files.size(), 8);
    put(archive, count_lie != 0 ? count_lie : files.size(), 8);
    put(archive, directory.size(), 8);
    put(archive, at, 8);
    archive += "PK\6\7";
    put(archive, 0, 4);
    put(archive, end, 8);
    put(archive, 1, 4);
  }
  archive += "PK\5\6";
  put(archive, 0, 4);
  put(archive, zip64 ? 0xffff : files.size(), 2);
  put(archive, zip64 ? 0xffff : files.size(), 2);
  put(archive, zip64 ? elsewhere : directory.size(), 4);
  put(archive, zip64 ? elsewhere : at, 4);
  put(archive, 0, 2);
  return archive;
}

// --- models

constexpr std::array<std::array<float, 3>, 4> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<std::uint16_t, 12> triangles{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
const std::string core = " xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"";
const std::string production = " xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"";

// A tetrahedron with corners at 0 and 1 on the axes. `p`: before the names of elements.
std::string tetrahedron(const std::string& last = "3", const std::string& p = "") {
  std::string mesh = "<" + p + "mesh><" + p + "vertices>";
  for (const auto& c : corners)
    mesh += "<" + p + "vertex x=\"" + std::to_string(c[0]) + "\" y=\"" + std::to_string(c[1]) + "\" z=\"" + std::to_string(c[2]) +
            "\"/>";
  mesh += "</" + p + "vertices><" + p + "triangles>";
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    mesh += "<" + p + "triangle v1=\"" + std::to_string(triangles[t]) + "\" v2=\"" + std::to_string(triangles[t + 1]) +
            "\" v3=\"" + (t == 9 ? last : std::to_string(triangles[t + 2])) + "\"/>";
  }
  return mesh + "</" + p + "triangles></" + p + "mesh>";
}

std::string object(const std::string& id, const std::string& contents, const std::string& more = "type=\"model\"") {
  return "<object id=\"" + id + "\" " + more + ">" + contents + "</object>";
}

std::string model(const std::string& objects, const std::string& build, const std::string& attributes = core) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model" + attributes + "><resources>" + objects + "</resources><build>" +
         build + "</build></model>";
}

std::vector<PackedFile> package(const std::string& text) {
  return {{"[Content_Types].xml", "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"/>"},
          {"_rels/.rels",
           "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
           "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
           "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
          {"3D/3dmodel.model", text}};
}

std::string threemf(const std::string& build, const std::string& attributes = "unit=\"inch\"", const std::string& last = "3") {
  return zip(package(model(
      object("1", tetrahedron(last)) + object("2",
                                              "<components><component objectid=\"1\"/>"
                                              "<component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 5 0 0\"/></components>"),
      build, " " + attributes + core)));
}

const std::string quarter_turn = "<item objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 10 20 30\"/>";

using Points = std::set<std::array<double, 3>>;

Points points_of(const PolyMesh& mesh, const PolyBody& body) {
  Points points;
  for (const PolyFace& face : body.faces)
    for (const VertexIndex v : face.outline) points.insert(mesh.vertices[v]);
  return points;
}

const Points unit_points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

// The bodies' points; the error as a test failure.
std::vector<Points> bodies_of(const std::string& archive) {
  std::vector<Points> bodies;
  const auto mesh = read_three_mf(archive, "a");
  EXPECT_TRUE(mesh) << mesh.error().message();
  if (!mesh) return bodies;
  for (const PolyBody& body : mesh->bodies) bodies.push_back(points_of(*mesh, body));
  return bodies;
}

std::string error_of(const std::string& bytes) {
  const auto mesh = read_three_mf(bytes, "a");
  return mesh ? "" : mesh.error().message();
}

testing::AssertionResult has(const std::string& message, const std::string& part) {
  return message.find(part) != std::string::npos ? testing::AssertionSuccess()
                                                 : testing::AssertionFailure() << message << "\nwithout: " << part;
}

TEST(ThreeMf, BuildsItsItems) {
  NEEDS_THREE_MF();
  const auto mesh = read_three_mf(threemf(quarter_turn + "<item objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 0 0 100\"/>"), "a");
  ASSERT_TRUE(mesh) << mesh.error().message();
  ASSERT_EQ(mesh->bodies.size(), 3U);
  // Rows times matrix: x' = -y + 10, y' = x + 20, z' = z + 30.
  EXPECT_EQ(points_of(*mesh, mesh->bodies[0]), (Points{{10, 20, 30}, {10, 21, 30}, {9, 20, 30}, {10, 20, 31}}));
  EXPECT_EQ(points_of(*mesh, mesh->bodies[1]), (Points{{0, 0, 100}, {2, 0, 100}, {0, 2, 100}, {0, 0, 102}}));
  EXPECT_EQ(points_of(*mesh, mesh->bodies[2]), (Points{{10, 0, 100}, {12, 0, 100}, {10, 2, 100}, {10, 0, 102}}));
  EXPECT_EQ(mesh->unit, "inch");
  EXPECT_EQ(mesh->vertical, std::optional<std::size_t>(2));
  const auto silent = read_three_mf(threemf("<item objectid=\"1\"/>", "xml:lang=\"en\""), "a");
  ASSERT_TRUE(silent);
  EXPECT_EQ(silent->unit, "mm");  // what the specification says of a model that does not say it
}

TEST(ThreeMf, ToldByContent) { EXPECT_EQ(poly_format_of("a.stl", threemf("")), PolyFormat::threemf); }

TEST(ThreeMf, ArchivesOfEachKind) {
  NEEDS_THREE_MF();
  auto files = package(model(object("1", tetrahedron()), "<item objectid=\"1\"/>"));
  files.push_back({"Metadata/thumbnail.png", "\x89PNG\r\n"});
  for (const Packing packing : {Packing::stored, Packing::deflated, Packing::zip64})
    EXPECT_EQ(bodies_of(zip(files, packing)), std::vector<Points>{unit_points});
  // Names of parts may differ by case; the model may have any name.
  files[1].text.replace(files[1].text.find("/3D/3dmodel.model"), 17, "/3d/Part.Model");
  files[2].name = "3D/PART.model";
  EXPECT_EQ(bodies_of(zip(files)), std::vector<Points>{unit_points});
  EXPECT_EQ(bodies_of(zip({files[2]})), std::vector<Points>{unit_points});
}

TEST(ThreeMf, PrefixedNamesAndOtherNamespaces) {
  NEEDS_THREE_MF();
  const std::string text =
      "<x:model xmlns:x=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
      "xmlns:y=\"http://example.com/\"><x:metadata "
      "name=\"a\">b</x:metadata><y:build><y:item objectid=\"9\"/></y:build><x:resources><y:object id=\"1\"/><x:object id=\"1\">" +
      tetrahedron("3", "x:") +
      "</x:object></x:resources><x:build><y:item objectid=\"9\"/><x:item objectid=\"1\"/></x:build></x:model>";
  EXPECT_EQ(bodies_of(zip(package(text))), std::vector<Points>{unit_points});
}

TEST(ThreeMf, ComponentsOfComponentsAndNames) {
  NEEDS_THREE_MF();
  const auto moved = [](const std::string& id, const std::string& by) {
    return "<components><component objectid=\"" + id + "\" transform=\"" + by + "\"/></components>";
  };
  // Scaled by 2 about 0, then moved by 1 along x, then a quarter turn about z.
  const std::string text =
      model(object("1", tetrahedron()) + object("2", moved("1", "2 0 0 0 2 0 0 0 2 0 0 0"), "name=\"bracket &amp; pin\"") +
                object("3", moved("2", "1 0 0 0 1 0 0 0 1 1 0 0"), "name=\"outer\""),
            "<item objectid=\"3\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 0\"/>");
  const auto mesh = read_three_mf(zip(package(text)), "a");
  ASSERT_TRUE(mesh) << mesh.error().message();
  ASSERT_EQ(mesh->bodies.size(), 1U);
  EXPECT_EQ(points_of(*mesh, mesh->bodies[0]), (Points{{0, 1, 0}, {0, 3, 0}, {-2, 1, 0}, {0, 1, 2}}));
  EXPECT_EQ(mesh->bodies[0].name, "bracket & pin");
}

// As slicers write them: each object in a part of its own. Here one has another unit.
TEST(ThreeMf, ProductionParts) {
  NEEDS_THREE_MF();
  auto files = package(
      model(object("2",
                   "<components><component p:path=\"/3D/Objects/a.model\" objectid=\"1\"/><component "
                   "p:path=\"/3D/Objects/b.model\" objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 7 0 0\"/></components>"),
            "<item objectid=\"2\"/><item objectid=\"1\" p:path=\"/3D/Objects/a.model\" transform=\"1 0 0 0 1 0 0 0 1 0 0 9\"/>",
            core + production + " requiredextensions=\"p\""));
  files.push_back({"3D/Objects/a.model", model(object("1", tetrahedron()), "<item objectid=\"1\"/>", core + production)});
  files.push_back({"3D/Objects/b.model", model(object("1", tetrahedron()), "", core + " unit=\"centimeter\"")});
  EXPECT_EQ(bodies_of(zip(files)),
            (std::vector<Points>{
                unit_points, {{7, 0, 0}, {17, 0, 0}, {7, 10, 0}, {7, 0, 10}}, {{0, 0, 9}, {1, 0, 9}, {0, 1, 9}, {0, 0, 10}}}));
  files.pop_back();
  EXPECT_TRUE(
      has(error_of(zip(files)),
          "a: 3D/3dmodel.model, object 2, component 2: found the part \"/3D/Objects/b.model\", expected the name of a part"));
  files.pop_back();
  files.push_back({"3D/Objects/a.model", model(object("5", tetrahedron()), "", core)});
  EXPECT_TRUE(
      has(error_of(zip(files)),
          "3D/3dmodel.model, object 2, component 1: found the object \"1\", expected the id of an object of 3D/Objects/a.model"));
}

TEST(ThreeMf, WhatIsNotPrintedIsLeftOut) {
  NEEDS_THREE_MF();
  const std::string objects = object("1", tetrahedron()) + object("2", tetrahedron(), "type=\"support\"") +
                              object("3", tetrahedron(), "type=\"other\"") + object("4", tetrahedron(), "type=\"surface\"") +
                              object("5", "<components><component objectid=\"1\"/><component objectid=\"3\"/></components>");
  const auto mesh =
      read_three_mf(zip(package(model(objects,
                                      "<item objectid=\"5\"/><item objectid=\"2\"/><item objectid=\"4\"/>"
                                      "<item objectid=\"1\" printable=\"0\"/><item objectid=\"1\" printable=\"0\"/>"))),
                    "a");
  ASSERT_TRUE(mesh) << mesh.error().message();
  EXPECT_EQ(mesh->bodies.size(), 2U);
  EXPECT_EQ(mesh->notes, (std::vector<std::string>{"2 items that are not to be printed", "1 object of type \"other\"",
                                                   "1 object of type \"support\""}));
  EXPECT_TRUE(has(error_of(zip(package(model(objects, "<item objectid=\"2\"/>")))),
                  "3D/3dmodel.model: found only 1 object of type \"support\""));
}

// As PrusaSlicer writes them: all volumes of an object are one mesh.
TEST(ThreeMf, ModifiersOfPrusaSlicerAreLeftOut) {
  NEEDS_THREE_MF();
  auto files = package(model(object("1", tetrahedron()), "<item objectid=\"1\"/>"));
  const auto volume = [](const std::string& range, const std::string& type) {
    return "<volume " + range +
           "><metadata type=\"volume\" key=\"name\" value=\"a\"/><metadata type=\"volume\" key=\"volume_type\" value=\"" + type +
           "\"/></volume>";
  };
  files.push_back({"Metadata/Slic3r_PE_model.config",
                   "<config><object id=\"1\">" + volume("firstid=\"0\" lastid=\"0\"", "ModelPart") +
                       volume("firstid=\"1\" lastid=\"2\"", "ParameterModifier") +
                       volume("firstid=\"9\" lastid=\"99999999999\"", "SupportBlocker") + "</object><object id=\"2\">" +
                       volume("firstid=\"0\" lastid=\"3\"", "NegativeVolume") + "</object></config>"});
  const auto mesh = read_three_mf(zip(files), "a");
  ASSERT_TRUE(mesh) << mesh.error().message();
  ASSERT_EQ(mesh->bodies.size(), 1U);
  EXPECT_EQ(mesh->bodies[0].faces.size(), 2U);
  EXPECT_EQ(points_of(*mesh, mesh->bodies[0]), unit_points);  // triangles 0 2 1 and 1 2 3
  EXPECT_EQ(mesh->notes, std::vector<std::string>{"2 modifiers"});
}

// --- whole packages with the parts, names and attributes that slicers write

constexpr const char* picture = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR";  // the beginning of one

const std::string relations_start =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n";

std::string relation(const std::string& target, int id, const std::string& type) {
  return " <Relationship Target=\"" + target + "\" Id=\"rel-" + std::to_string(id) + "\" Type=\"" + type + "\"/>\n";
}

const std::string model_type = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
const std::string thumbnail_type = "http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail";

// A tetrahedron as slicers write it: a line for each element, and attributes of their own in some triangles.
std::string slicer_mesh(const std::string& painted) {
  std::string text = "   <mesh>\n    <vertices>\n";
  for (const auto& c : corners)
    text += "     <vertex x=\"" + std::to_string(c[0]) + "\" y=\"" + std::to_string(c[1]) + "\" z=\"" + std::to_string(c[2]) + "\"/>\n";
  text += "    </vertices>\n    <triangles>\n";
  for (std::size_t t = 0; t < triangles.size(); t += 3)
    text += "     <triangle v1=\"" + std::to_string(triangles[t]) + "\" v2=\"" + std::to_string(triangles[t + 1]) + "\" v3=\"" +
            std::to_string(triangles[t + 2]) + "\"" + (t == 3 ? painted : "") + "/>\n";
  return text + "    </triangles>\n   </mesh>\n";
}

// Bambu Studio and OrcaSlicer: each object is a part of its own, of which the model places the volumes; modifiers are volumes of type
// "other"; settings, pictures and tool paths lie in Metadata.
TEST(ThreeMf, AsBambuStudioWritesIt) {
  NEEDS_THREE_MF();
  const std::string spaces =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\"" + core +
      " xmlns:BambuStudio=\"http://schemas.bambulab.com/package/2021\"" + production + " requiredextensions=\"p\">\n";
  const auto placed = [](const std::string& path, int id, const std::string& at) {
    return "    <component p:path=\"" + path + "\" objectid=\"" + std::to_string(id) + "\" p:UUID=\"0001000" + std::to_string(id) +
           "-b206-40ff-9872-83e8017abed1\" transform=\"1 0 0 0 1 0 0 0 1 " + at + "\"/>\n";
  };
  const auto volume = [](int id, const std::string& type) {
    return "  <object id=\"" + std::to_string(id) + "\" p:UUID=\"0001000" + std::to_string(id) +
           "-81cb-4c03-9d28-80fed5dfa1dc\" type=\"" + type + "\">\n" + slicer_mesh(" paint_color=\"8\"") + "  </object>\n";
  };
  const std::string objects_of_part = spaces + " <metadata name=\"BambuStudio:3mfVersion\">1</metadata>\n <resources>\n";
  const std::string end_of_part = " </resources>\n <build/>\n</model>\n";
  const std::vector<PackedFile> files{
      {"[Content_Types].xml",
       "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
       " <Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
       " <Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
       " <Default Extension=\"png\" ContentType=\"image/png\"/>\n <Default Extension=\"gcode\" ContentType=\"text/x.gcode\"/>\n</Types>\n"},
      {"Metadata/plate_1.png", picture},
      {"Metadata/plate_1_small.png", picture},
      {"Metadata/plate_1.json", "{\"bbox_all\":[120.0,120.0,136.0,136.0],\"filament_colors\":[\"#FFFFFF\"]}"},
      {"_rels/.rels", relations_start + relation("/Metadata/plate_1.png", 2, thumbnail_type) +
                          relation("/Metadata/plate_1.png", 4, "http://schemas.bambulab.com/package/2021/cover-thumbnail-middle") +
                          relation("/3D/3dmodel.model", 1, model_type) + "</Relationships>\n"},
      {"3D/3dmodel.model",
       spaces +
           " <metadata name=\"Application\">BambuStudio-01.09.00.70</metadata>\n <metadata name=\"BambuStudio:3mfVersion\">1</metadata>\n"
           " <metadata name=\"Title\"></metadata>\n <resources>\n"
           "  <object id=\"3\" p:UUID=\"00000001-61cb-4c03-9d28-80fed5dfa1dc\" type=\"model\">\n   <components>\n" +
           placed("/3D/Objects/object_1.model", 1, "0 0 0") + placed("/3D/Objects/object_1.model", 2, "0 0 5") +
           "   </components>\n  </object>\n"
           "  <object id=\"5\" p:UUID=\"00000002-61cb-4c03-9d28-80fed5dfa1dc\" type=\"model\">\n   <components>\n" +
           placed("/3D/Objects/object_2.model", 4, "0.5 0 0") +
           "   </components>\n  </object>\n </resources>\n <build p:UUID=\"2c7c17d8-22b5-4d84-8835-1976022ea369\">\n"
           "  <item objectid=\"3\" p:UUID=\"00000003-b1ec-4553-aec9-835e5b724bb4\" transform=\"1 0 0 0 1 0 0 0 1 128 120 0.25\" "
           "printable=\"1\"/>\n"
           "  <item objectid=\"5\" p:UUID=\"00000005-b1ec-4553-aec9-835e5b724bb4\" transform=\"2 0 0 0 2 0 0 0 2 10 20 0\" "
           "printable=\"1\"/>\n"
           "  <item objectid=\"5\" p:UUID=\"00010005-b1ec-4553-aec9-835e5b724bb4\" transform=\"1 0 0 0 1 0 0 0 1 400 20 0\" "
           "printable=\"0\"/>\n"
           " </build>\n</model>\n"},
      {"3D/_rels/3dmodel.model.rels", relations_start + relation("/3D/Objects/object_1.model", 1, model_type) +
                                          relation("/3D/Objects/object_2.model", 2, model_type) + "</Relationships>\n"},
      {"3D/Objects/object_1.model", objects_of_part + volume(1, "model") + volume(2, "other") + end_of_part},
      {"3D/Objects/object_2.model", objects_of_part + volume(4, "model") + end_of_part},
      {"Metadata/model_settings.config",
       "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<config>\n  <object id=\"3\">\n    <metadata key=\"name\" value=\"lid &amp; hinge\"/>\n"
       "    <part id=\"1\" subtype=\"normal_part\">\n      <metadata key=\"matrix\" value=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\"/>\n    </part>\n"
       "    <part id=\"2\" subtype=\"modifier_part\">\n      <metadata key=\"wall_loops\" value=\"6\"/>\n    </part>\n  </object>\n"
       "  <plate>\n    <metadata key=\"plater_id\" value=\"1\"/>\n    <metadata key=\"thumbnail_file\" value=\"Metadata/plate_1.png\"/>\n"
       "  </plate>\n</config>\n"},
      {"Metadata/project_settings.config", "{\n    \"layer_height\": \"0.2\",\n    \"printable_area\": [\"0x0\", \"256x0\"]\n}\n"},
      {"Metadata/slice_info.config", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<config>\n  <header/>\n</config>\n"},
      {"Metadata/plate_1.gcode", "; HEADER_BLOCK_START\nG28\n"},
      {"Metadata/plate_1.gcode.md5", "D41D8CD98F00B204E9800998ECF8427E"}};
  for (const Packing packing : {Packing::stored, Packing::deflated, Packing::zip64}) {
    const auto mesh = read_three_mf(zip(files, packing), "a");
    ASSERT_TRUE(mesh) << mesh.error().message();
    ASSERT_EQ(mesh->bodies.size(), 2U);
    EXPECT_EQ(points_of(*mesh, mesh->bodies[0]), (Points{{128, 120, 0.25}, {129, 120, 0.25}, {128, 121, 0.25}, {128, 120, 1.25}}));
    EXPECT_EQ(points_of(*mesh, mesh->bodies[1]), (Points{{11, 20, 0}, {13, 20, 0}, {11, 22, 0}, {11, 20, 2}}));
    EXPECT_EQ(mesh->unit, "mm");
    EXPECT_EQ(mesh->notes, (std::vector<std::string>{"1 item that is not to be printed", "1 object of type \"other\""}));
  }
}

// PrusaSlicer: all objects are in one model, the volumes of each in one mesh, which a file of settings divides.
TEST(ThreeMf, AsPrusaSlicerWritesIt) {
  NEEDS_THREE_MF();
  const std::vector<PackedFile> files{
      {"[Content_Types].xml",
       "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
       " <Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\" />\n"
       " <Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\" />\n"
       " <Default Extension=\"png\" ContentType=\"image/png\" />\n</Types>\n"},
      {"Metadata/thumbnail.png", picture},
      {"_rels/.rels", relations_start + relation("/3D/3dmodel.model", 1, model_type) +
                          relation("/Metadata/thumbnail.png", 2, thumbnail_type) + "</Relationships>\n"},
      {"3D/3dmodel.model",
       "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\"" + core +
           " xmlns:slic3rpe=\"http://schemas.slic3r.org/3mf/2017/06\">\n <metadata name=\"slic3rpe:Version3mf\">1</metadata>\n"
           " <metadata name=\"slic3rpe:MmPaintingVersion\">1</metadata>\n <metadata name=\"Title\">two</metadata>\n"
           " <metadata name=\"Application\">PrusaSlicer-2.7.4</metadata>\n <resources>\n  <object id=\"1\" type=\"model\">\n" +
           slicer_mesh(" slic3rpe:mmu_segmentation=\"8\"") + "  </object>\n  <object id=\"2\" type=\"model\">\n" +
           slicer_mesh(" slic3rpe:custom_supports=\"4\" slic3rpe:custom_seam=\"8\"") +
           "  </object>\n </resources>\n <build>\n"
           "  <item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 125 105 0\" printable=\"1\"/>\n"
           "  <item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 50 60 0.5\" printable=\"1\"/>\n </build>\n</model>\n"},
      {"Metadata/Slic3r_PE.config", "; generated by PrusaSlicer 2.7.4\n\n; avoid_crossing_perimeters = 0\n; layer_height = 0.2\n"},
      {"Metadata/Slic3r_PE_model.config",
       "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<config>\n <object id=\"1\" instances_count=\"1\">\n"
       "  <metadata type=\"object\" key=\"name\" value=\"a.stl\"/>\n  <volume firstid=\"0\" lastid=\"3\">\n"
       "   <metadata type=\"volume\" key=\"name\" value=\"a.stl\"/>\n   <metadata type=\"volume\" key=\"volume_type\" value=\"ModelPart\"/>\n"
       "   <metadata type=\"volume\" key=\"matrix\" value=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\"/>\n"
       "   <mesh edges_fixed=\"0\" degenerate_facets=\"0\" facets_removed=\"0\" facets_reversed=\"0\" backwards_edges=\"0\"/>\n"
       "  </volume>\n </object>\n</config>\n"},
      {"Metadata/layer_heights_profile.txt", "object_id=1|0;0.2;1;0.2"}};
  const auto mesh = read_three_mf(zip(files, Packing::deflated), "a");
  ASSERT_TRUE(mesh) << mesh.error().message();
  ASSERT_EQ(mesh->bodies.size(), 2U);
  EXPECT_EQ(points_of(*mesh, mesh->bodies[0]), (Points{{125, 105, 0}, {126, 105, 0}, {125, 106, 0}, {125, 105, 1}}));
  EXPECT_EQ(points_of(*mesh, mesh->bodies[1]), (Points{{50, 60, 0.5}, {50, 61, 0.5}, {49, 60, 0.5}, {50, 60, 1.5}}));
  EXPECT_EQ(mesh->notes, std::vector<std::string>{});
}

TEST(ThreeMf, DamagedArchivesAreNamed) {
  NEEDS_THREE_MF();
  const std::string archive = threemf(quarter_turn);
  EXPECT_TRUE(has(error_of(archive.substr(0, archive.size() - 30)), "found the end of the file"));
  EXPECT_TRUE(has(error_of(archive.substr(0, 60) + archive.substr(61)), "found no entry of the ZIP directory"));
  EXPECT_TRUE(has(error_of(zip({{"a.txt", "text"}})), "without a file *.model"));
  std::string other = archive;
  other[other.find("<triangle ") + 1] = 'T';
  EXPECT_TRUE(has(error_of(other), "3D/3dmodel.model: found other contents than the checksum says"));
  const std::size_t entry = archive.rfind("PK\1\2");  // of the model
  other = archive;
  other[entry + 8] = 1;  // encrypted
  EXPECT_TRUE(has(error_of(other), "3D/3dmodel.model: found an encrypted file"));
  other = archive;
  other[entry + 10] = 77;
  EXPECT_TRUE(has(error_of(other), "3D/3dmodel.model: found an unknown compression method"));
  for (const std::uint64_t lie : {std::uint64_t{4}, std::uint64_t{1} << 28, std::uint64_t{1} << 60}) {
    const std::string error = error_of(zip(package("<model/>"), Packing::zip64, lie));
    EXPECT_FALSE(error.empty()) << lie;
  }
}

TEST(ThreeMf, ArchivesThatFillMemoryAreRefused) {
  NEEDS_THREE_MF();
  const std::string blanks(30'000'000, ' ');
  EXPECT_TRUE(has(error_of(zip(package(blanks), Packing::deflated)), "3D/3dmodel.model: found 30000000 bytes compressed to "));
  // What the directory says of the size is not taken for granted.
  std::string small = zip(package(model(object("1", tetrahedron()), "<item objectid=\"1\"/>")), Packing::deflated);
  const std::size_t entry = small.rfind("PK\1\2");
  const auto with_size = [&](std::uint64_t size) {
    std::string bytes;
    put(bytes, size, 4);
    return small.substr(0, entry + 24) + bytes + small.substr(entry + 28);
  };
  EXPECT_FALSE(error_of(with_size(10)).empty());
  EXPECT_FALSE(error_of(with_size(100'000)).empty());
  EXPECT_TRUE(has(error_of(with_size(0xfffffff0)), "3D/3dmodel.model: found 4294967280 bytes, expected at most 1073741824"));
}

TEST(ThreeMf, DamagedModelsAreNamed) {
  NEEDS_THREE_MF();
  const auto error_in = [](const std::string& objects, const std::string& build, const std::string& attributes = core) {
    return error_of(zip(package(model(objects, build, attributes))));
  };
  const std::string one = "<item objectid=\"1\"/>";
  EXPECT_TRUE(
      has(error_of(threemf(quarter_turn, "unit=\"inch\"", "1000000000")), "face 3: found vertex 1000000000, expected 0 to 3"));
  EXPECT_TRUE(has(error_of(threemf(quarter_turn, "unit=\"inch\"", "-1")),
                  "3D/3dmodel.model, object 1, face 3: found vertex \"-1\", expected 0 to 3"));
  EXPECT_TRUE(
      has(error_of(threemf(quarter_turn, "unit=\"mile\"")), "3D/3dmodel.model: found the unit \"mile\", expected micron"));
  EXPECT_TRUE(has(error_of(threemf(quarter_turn, "requiredextensions=\"b\" xmlns:b=\"http://x/beamlattice/2017/02\"")),
                  "3D/3dmodel.model: found that the extension \"b\" is required"));
  std::string mesh = tetrahedron();
  mesh.replace(mesh.find("1.000000"), 8, "ten");
  EXPECT_TRUE(has(error_in(object("1", mesh), one), "object 1, vertex 1: found \"ten\", expected a number"));
  mesh.replace(mesh.find(" x=\"ten\""), 8, "");
  EXPECT_TRUE(has(error_in(object("1", mesh), one), "object 1, vertex 1: found no attribute x"));
  EXPECT_TRUE(has(error_in(object("1", tetrahedron()) + object("1", tetrahedron()), one),
                  "object 1: found a second object with this id"));
  EXPECT_TRUE(has(error_in(object("", tetrahedron()), one), "3D/3dmodel.model: found an object without id"));
  EXPECT_TRUE(
      has(error_in(object("1", tetrahedron()), "<item objectid=\"3\"/>"), "3D/3dmodel.model, build: found the object \"3\""));
  EXPECT_TRUE(has(error_in(object("1", tetrahedron()), "<item objectid=\"1\" transform=\"1 0 0\"/>"),
                  "3D/3dmodel.model, item 1: found a transform of 3 numbers"));
  EXPECT_TRUE(has(error_in(object("1", tetrahedron()), "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 0 0\"/>"),
                  "item 1: found the transform"));
  EXPECT_TRUE(has(error_in(object("1", tetrahedron()), ""), "3D/3dmodel.model: found nothing that is built"));
  EXPECT_TRUE(has(error_in(object("1", "<mesh/>"), one), "found no faces"));
  EXPECT_TRUE(has(error_of(zip(package("<model>\n <resources>\n  <object id=1/></resources></model>"))),
                  "3D/3dmodel.model, line 3, column "));
  EXPECT_TRUE(has(error_of(zip(package(std::string(4'000'000, '<')))), "3D/3dmodel.model, line 1"));
  EXPECT_TRUE(has(error_of(zip(package("<html/>"))), "3D/3dmodel.model: found the element \"html\""));
  std::string deep;
  for (int i = 0; i < 300'000; ++i) deep += "<a>";
  EXPECT_TRUE(has(error_of(zip(package(deep))), "3D/3dmodel.model, line 1, column"));
  auto files = package(model(object("1", tetrahedron()), one));
  files[2].name = "3D/other.model";
  EXPECT_TRUE(has(error_of(zip(files)), "_rels/.rels: found the model \"/3D/3dmodel.model\""));
}

// Object i consists of copies of object i - 1.
std::string chain(int length, int copies, const std::string& first) {
  std::string objects = object("0", first);
  for (int i = 1; i <= length; ++i) {
    std::string components;
    for (int c = 0; c < copies; ++c) components += "<component objectid=\"" + std::to_string(i - 1) + "\"/>";
    objects += object(std::to_string(i), "<components>" + components + "</components>");
  }
  return zip(package(model(objects, "<item objectid=\"" + std::to_string(length) + "\"/>")));
}

TEST(ThreeMf, ComponentsWithoutEndAreRefused) {
  NEEDS_THREE_MF();
  const auto refers_to = [](const std::string& id) { return "<components><component objectid=\"" + id + "\"/></components>"; };
  EXPECT_TRUE(has(error_of(zip(package(model(object("1", refers_to("1")), "<item objectid=\"1\"/>")))),
                  "object 1: found an object that contains itself"));
  EXPECT_TRUE(
      has(error_of(zip(package(model(object("1", refers_to("2")) + object("2", refers_to("3")) + object("3", refers_to("2")),
                                     "<item objectid=\"1\"/>")))),
          "object 2: found an object that contains itself"));
  EXPECT_TRUE(has(error_of(chain(100'000, 1, tetrahedron())), "found components in more than 100 levels"));
  EXPECT_EQ(bodies_of(chain(100, 1, tetrahedron())), std::vector<Points>{unit_points});
  // 2^60 copies: of a tetrahedron, and of nothing.
  EXPECT_TRUE(has(error_of(chain(60, 2, tetrahedron())), "found more than 100000000 corners of faces, copies counted"));
  EXPECT_TRUE(has(error_of(chain(60, 2, "<mesh/>")), "found no faces"));
  // 10^10 components without faces.
  std::string many;
  std::string items;
  for (int i = 0; i < 100'000; ++i) many += "<component objectid=\"0\"/>";
  for (int i = 0; i < 100'000; ++i) items += "<item objectid=\"2\"/>";
  const std::string empty = object("0", "<mesh/>") + object("1", tetrahedron()) +
                            object("2", "<components>" + many + "<component objectid=\"1\"/></components>");
  EXPECT_EQ(bodies_of(zip(package(model(empty, items)))).size(), 100'000U);
  EXPECT_TRUE(has(error_of(chain(22, 2, tetrahedron())), "found more than 1000000 copies of meshes"));
}

TEST(ThreeMf, NoDamageEndsTheProgram) {
  NEEDS_THREE_MF();
  std::mt19937 random(1971);
  const std::string text = model(object("1", tetrahedron()) + object("2", "<components><component objectid=\"1\"/></components>"),
                                 "<item objectid=\"2\"/>");
  int refused = 0;
  for (int i = 0; i < 600; ++i) {
    const bool in_archive = i % 2 == 0;
    std::string bytes = in_archive ? threemf(quarter_turn) : text;
    const std::size_t damages = 1 + random() % 4;
    for (std::size_t d = 0; d < damages; ++d) bytes[random() % bytes.size()] = static_cast<char>(random());
    if (i % 5 == 0) bytes.resize(random() % bytes.size());
    const auto read = read_three_mf(in_archive ? bytes : zip(package(bytes)), "a");
    refused += read ? 0 : 1;
    if (!read) {
      EXPECT_FALSE(read.error().found.empty()) << "damage " << i;
    }
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace sightline::scene
