// See assimp_mesh.hpp.
#include "host/scene/read/assimp_mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace sightline::scene {

// The keys of the outermost object are examined; nothing is parsed.
bool is_gltf(std::string_view text) {
  std::size_t depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') {
      if (depth-- <= 1) return false;
    }
    if (c != '"') continue;
    const std::size_t begin = ++i;
    while (i < text.size() && text[i] != '"') i += text[i] == '\\' ? 2 : 1;
    if (depth != 1 || i >= text.size() || text.substr(begin, i - begin) != "asset") continue;
    const std::size_t after = text.find_first_not_of(" \t\r\n", i + 1);
    if (after != std::string_view::npos && text[after] == ':') return true;
  }
  return false;
}

}  // namespace sightline::scene

#ifndef SIGHTLINE_HAS_ASSIMP

namespace sightline::scene {

base::Result<PolyMesh> read_by_assimp(std::string_view, std::string_view source, AssimpFormat, const std::string&) {
  return base::Error{std::string(source), "", "found glTF or 3MF, which this program was built without",
                     "STL, PLY, OFF, OBJ or JSON",
                     "install assimp (Debian: libassimp-dev) and build again, or export the mesh as STL, PLY or OBJ"};
}

}  // namespace sightline::scene

#else

#include <assimp/Importer.hpp>
#include <assimp/DefaultLogger.hpp>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/LogStream.hpp>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/base/child_process.hpp"
#include "host/base/file.hpp"
#include "host/base/json.hpp"
#include "host/scene/model/vertex_pool.hpp"
#include "host/scene/read/poly_text.hpp"
#include "host/scene/read/precision.hpp"
#include "host/scene/read/zip.hpp"

namespace sightline::scene {
namespace {

constexpr std::uint64_t most_corners = 100'000'000;

// --- the frame of a file, before assimp sees it

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << (8 * i);
  return word;
}

base::Error at_byte(std::size_t byte, std::string found, std::string expected, std::string remedy = "") {
  return {"", "byte " + std::to_string(byte), std::move(found), std::move(expected), std::move(remedy)};
}

constexpr const char* export_again = "the file is damaged: export it again";

// The JSON of a GLB.
base::Result<std::string_view> glb_json(std::string_view bytes) {
  constexpr std::size_t header = 12;
  constexpr std::size_t json_at = header + 8;
  constexpr std::uint32_t json_type = 0x4e4f534a;
  if (bytes.size() < json_at)
    return at_byte(bytes.size(), "found the end of the file", "the 20 bytes of a GLB header", export_again);
  if (word_at(bytes, 4) != 2) {
    return at_byte(4, "found version " + std::to_string(word_at(bytes, 4)), "2", "convert it to glTF 2.0");
  }
  if (word_at(bytes, 8) != bytes.size()) {
    return at_byte(8, "found a length of " + std::to_string(word_at(bytes, 8)),
                   "the " + std::to_string(bytes.size()) + " bytes that the file has", export_again);
  }
  const std::uint32_t length = word_at(bytes, header);
  if (word_at(bytes, header + 4) != json_type)
    return at_byte(header + 4, "found no JSON", "the chunk \"JSON\" first", export_again);
  if (length > bytes.size() - json_at) {
    return at_byte(header, "found a chunk of " + std::to_string(length) + " bytes",
                   "at most the " + std::to_string(bytes.size() - json_at) + " that are left", export_again);
  }
  return bytes.substr(json_at, length);
}

// Extensions that say how a mesh looks, not where it is, and one that assimp undoes.
bool leaves_geometry(std::string_view extension) {
  for (const std::string_view family :
       {"KHR_materials_", "KHR_texture_", "KHR_lights_", "EXT_texture_", "KHR_draco_mesh_compression"})
    if (extension.starts_with(family)) return true;
  return extension == "KHR_xmp" || extension == "KHR_xmp_json_ld" || extension == "MSFT_texture_dds" ||
         extension == "KHR_technique_webgl";
}

// What of a document would be lost without a word, as notes; an error for what cannot be read.
base::Result<std::vector<std::string>> look_at_gltf(std::string_view text, std::string_view source) {
  const auto document = base::parse_json(text, source);
  if (!document) return document.error();
  if (const base::Json* required = document->find("extensionsRequired")) {
    for (const base::Json& name : required->elements()) {
      if (name.text() == nullptr || leaves_geometry(*name.text())) continue;
      return base::Error{"", "extensionsRequired", "found " + quoted_excerpt(*name.text()), "no such extension of the geometry",
                         "export without it"};
    }
  }
  std::vector<std::string> notes;
  const base::Json* skins = document->find("skins");
  if (skins != nullptr && skins->size() > 0) notes.push_back(std::to_string(skins->size()) + (skins->size() == 1 ? " skin" : " skins"));
  std::size_t morphed = 0;
  if (const base::Json* meshes = document->find("meshes")) {
    for (const base::Json& mesh : meshes->elements()) {
      const base::Json* primitives = mesh.find("primitives");
      if (primitives == nullptr) continue;
      for (const base::Json& primitive : primitives->elements()) morphed += primitive.find("targets") != nullptr ? 1U : 0U;
    }
  }
  if (morphed > 0) notes.push_back("morph targets of " + std::to_string(morphed) + (morphed == 1 ? " mesh" : " meshes"));
  return notes;
}

// --- what assimp reads from: the file itself, and what else is in its folder

class BytesStream final : public Assimp::IOStream {
 public:
  explicit BytesStream(std::string_view bytes) : bytes_(bytes) {}
  explicit BytesStream(std::string owned) : owned_(std::move(owned)), bytes_(owned_) {}

  std::size_t Read(void* buffer, std::size_t size, std::size_t count) override {
    if (size == 0) return 0;
    const std::size_t items = std::min(count, (bytes_.size() - at_) / size);
    if (items > 0) std::memcpy(buffer, bytes_.data() + at_, items * size);
    at_ += items * size;
    return items;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const std::size_t from = origin == aiOrigin_CUR ? at_ : 0;
    const std::size_t to = origin == aiOrigin_END ? bytes_.size() - offset : from + offset;
    if (to > bytes_.size()) return aiReturn_FAILURE;
    at_ = to;
    return aiReturn_SUCCESS;
  }
  [[nodiscard]] std::size_t Tell() const override { return at_; }
  [[nodiscard]] std::size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::string owned_;
  std::string_view bytes_;
  std::size_t at_ = 0;
};

std::string percent_decoded(std::string_view text) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
  };
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0) {
      result += static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2]));
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

class FolderFiles final : public Assimp::IOSystem {
 public:
  FolderFiles(std::string name, std::string_view bytes, std::string folder)
      : name_(std::move(name)), bytes_(bytes), folder_(std::move(folder)) {}

  bool Exists(const char* file) const override { return file == name_ || !place_of(file).empty(); }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char*) override {
    if (file == name_) return new BytesStream(bytes_);
    const std::string place = place_of(file);
    if (place.empty()) return nullptr;
    auto bytes = base::read_file(place);
    if (!bytes) {
      refusal_ = bytes.error().message();
      return nullptr;
    }
    return new BytesStream(std::string(bytes->begin(), bytes->end()));
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }
  bool ComparePaths(const char* one, const char* other) const override { return std::string_view(one) == other; }

  // Why the last file that was asked for was not read.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }

 private:
  // Where a file is that lies in the folder, symbolic links followed; empty: it does not.
  [[nodiscard]] std::string place_of(std::string_view file) const {
    const std::string name = percent_decoded(file);
    const std::string shown = quoted_excerpt(name);
    if (folder_.empty()) {
      refusal_ = shown + " has no folder to be read from: the file came from standard input";
      return {};
    }
    std::error_code failed;
    const std::filesystem::path root = std::filesystem::canonical(folder_, failed);
    const std::filesystem::path place = std::filesystem::weakly_canonical(root / name, failed);
    const auto [end, unused] = std::mismatch(root.begin(), root.end(), place.begin(), place.end());
    if (failed || end != root.end() || name.starts_with('/')) {
      refusal_ = shown + " is outside of the file's folder, and not read";
      return {};
    }
    if (!std::filesystem::is_regular_file(place, failed)) {
      refusal_ = shown + " is not in the file's folder";
      return {};
    }
    return place.string();
  }

  std::string name_;
  std::string_view bytes_;
  std::string folder_;
  mutable std::string refusal_;
};

// Warnings of assimp, once each.
class Warnings final : public Assimp::LogStream {
 public:
  explicit Warnings(std::vector<std::string>& texts) : texts_(texts) {}
  void write(const char* message) override {
    // "Warn,  T0: TEXT\n"
    std::string_view text = message;
    if (const std::size_t colon = text.find(": "); colon != std::string_view::npos) text.remove_prefix(colon + 2);
    while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.remove_suffix(1);
    constexpr std::size_t most = 5;
    std::string warning = printable_name(std::string(text));
    // What an archive has beside its models is not of interest.
    if (texts_.size() < most && !warning.starts_with("Ignored file") &&
        std::find(texts_.begin(), texts_.end(), warning) == texts_.end())
      texts_.push_back(std::move(warning));
  }

 private:
  std::vector<std::string>& texts_;
};

// --- from assimp's scene to a mesh

using Matrix = std::array<std::array<double, 4>, 3>;

Matrix matrix_of(const aiMatrix4x4& m) {
  return {{{m.a1, m.a2, m.a3, m.a4}, {m.b1, m.b2, m.b3, m.b4}, {m.c1, m.c2, m.c3, m.c4}}};
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      result[i][j] = j == 3 ? a[i][3] : 0;
      for (std::size_t k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

std::array<double, 3> moved(const Matrix& m, const std::array<double, 3>& p) {
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * p[0] + m[i][1] * p[1] + m[i][2] * p[2] + m[i][3];
  return result;
}

bool mirrors(const Matrix& m) {
  const double determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                             m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return determinant < 0;
}

class MeshFromAssimp {
 public:
  explicit MeshFromAssimp(const aiScene& scene) : scene_(scene), pool_(mesh_.vertices) {}

  base::Result<PolyMesh> run() {
    if (scene_.mRootNode != nullptr) add(*scene_.mRootNode, matrix_of(aiMatrix4x4()));
    if (error_) return *error_;
    if (mesh_.bodies.empty()) return base::Error{"", "", "found no faces", "a mesh", "points and lines hide nothing"};
    mesh_.grouped = mesh_.bodies.size() > 1;
    if (std::all_of(mesh_.materials.begin(), mesh_.materials.end(), [&](std::uint32_t m) { return m == mesh_.materials[0]; }))
      mesh_.materials.clear();
    mesh_.precision = std::max(local_precision_, float32_precision(mesh_.vertices));
    if (thin_ > 0) mesh_.notes.push_back(std::to_string(thin_) + " points and lines");
    return std::move(mesh_);
  }

 private:
  void add(const aiNode& node, const Matrix& above) {
    const Matrix here = product(above, matrix_of(node.mTransformation));
    PolyBody body;
    body.name = printable_name(node.mName.C_Str());
    for (unsigned i = 0; i < node.mNumMeshes && !error_; ++i) {
      if (node.mMeshes[i] < scene_.mNumMeshes) add(*scene_.mMeshes[node.mMeshes[i]], here, body);
    }
    if (!body.faces.empty()) mesh_.bodies.push_back(std::move(body));
    for (unsigned i = 0; i < node.mNumChildren && !error_; ++i) add(*node.mChildren[i], here);
  }

  void add(const aiMesh& given, const Matrix& here, PolyBody& body) {
    constexpr VertexIndex unknown = std::numeric_limits<VertexIndex>::max();
    std::vector<VertexIndex> number(given.mNumVertices, unknown);
    const std::string place = "mesh \"" + printable_name(given.mName.C_Str()) + "\"";
    const bool turned = mirrors(here);
    double reach = 0;
    for (unsigned f = 0; f < given.mNumFaces; ++f) {
      const aiFace& face = given.mFaces[f];
      if (face.mNumIndices < 3) {
        ++thin_;
        continue;
      }
      corners_ += face.mNumIndices;
      if (corners_ > most_corners) {
        error_ = base::Error{"", place, "more than " + std::to_string(most_corners) + " corners of faces, copies counted"};
        return;
      }
      PolyFace outline;
      outline.outline.reserve(face.mNumIndices);
      for (unsigned c = 0; c < face.mNumIndices; ++c) {
        const unsigned v = face.mIndices[turned ? face.mNumIndices - 1 - c : c];
        if (v >= given.mNumVertices) {
          error_ = base::Error{"", place + ", face " + std::to_string(f), "found vertex " + std::to_string(v),
                               "0 to " + std::to_string(given.mNumVertices - 1)};
          return;
        }
        if (number[v] == unknown) {
          const std::array<double, 3> local{given.mVertices[v].x, given.mVertices[v].y, given.mVertices[v].z};
          const std::array<double, 3> point = moved(here, local);
          for (std::size_t a = 0; a < 3; ++a) {
            reach = std::max(reach, std::abs(local[a]));
            if (std::isfinite(point[a])) continue;
            error_ = base::Error{"", place + ", vertex " + std::to_string(v),
                                 "found a coordinate that is no finite number", "a number"};
            return;
          }
          number[v] = pool_.add(point);
        }
        outline.outline.push_back(number[v]);
      }
      body.faces.push_back(std::move(outline));
      mesh_.materials.push_back(given.mMaterialIndex);
    }
    double scale = 0;
    for (const auto& row : here) scale = std::max(scale, std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]));
    const std::array<std::array<double, 3>, 1> farthest{{{reach, 0, 0}}};
    local_precision_ = std::max(local_precision_, scale * float32_precision(farthest));
  }

  const aiScene& scene_;
  PolyMesh mesh_;
  VertexPool<double> pool_;
  double local_precision_ = 0;
  std::uint64_t corners_ = 0;
  std::size_t thin_ = 0;
  std::optional<base::Error> error_;
};

// --- what a 3MF model says beside its meshes

// The value of an attribute of the element <model>; empty: it has none.
std::string_view attribute(std::string_view model, std::string_view name) {
  for (std::size_t at = model.find(name); at != std::string_view::npos; at = model.find(name, at + 1)) {
    if (at == 0 || (model[at - 1] != ' ' && model[at - 1] != '\n' && model[at - 1] != '\t' && model[at - 1] != '\r')) continue;
    const std::size_t quote = model.find_first_of("\"'", at + name.size());
    if (quote == std::string_view::npos ||
        model.substr(at + name.size(), quote - at - name.size()).find_first_not_of(" =\t\r\n") !=
            std::string_view::npos)
      continue;
    const std::size_t end = model.find(model[quote], quote + 1);
    return end == std::string_view::npos ? std::string_view() : model.substr(quote + 1, end - quote - 1);
  }
  return {};
}

// As other formats name them.
std::string unit_named(std::string_view name) {
  struct Unit {
    std::string_view of_3mf;
    std::string_view here;
  };
  constexpr std::array units{Unit{"micron", "um"}, Unit{"millimeter", "mm"}, Unit{"centimeter", "cm"},
                             Unit{"inch", "inch"}, Unit{"foot", "ft"},       Unit{"meter", "m"}};
  for (const Unit& unit : units)
    if (unit.of_3mf == name) return std::string(unit.here);
  return printable_name(std::string(name));
}

// The first extension that a model requires, beside those of materials: an error.
std::optional<base::Error> why_not_read(std::string_view tag, std::string_view model) {
  std::string_view required = attribute(tag, "requiredextensions");
  while (!required.empty()) {
    const std::string_view prefix = required.substr(0, required.find(' '));
    required.remove_prefix(std::min(prefix.size() + 1, required.size()));
    const std::string_view space = attribute(tag, "xmlns:" + std::string(prefix));
    if (prefix.empty() || space.find("/material/") != std::string_view::npos) continue;
    return base::Error{"", printable_name(std::string(model)),
                       "found that the extension " + quoted_excerpt(prefix) + " is required, " + quoted_excerpt(space),
                       "the core of 3MF", "export without it, or as STL"};
  }
  return std::nullopt;
}

// The first component that lies in another part of the archive, which assimp passes over: an error. Files of slicers have such.
std::optional<base::Error> why_not_whole(std::string_view text, std::string_view model) {
  constexpr std::string_view element = "<component ";
  for (std::size_t at = text.find(element); at != std::string_view::npos; at = text.find(element, at + 1)) {
    const std::string_view tag = text.substr(at, text.find('>', at) - at);
    const std::size_t path = tag.find(":path=");
    if (path == std::string_view::npos || path + 7 > tag.size()) continue;
    const std::string_view value = tag.substr(path + 7);
    return base::Error{"", printable_name(std::string(model)),
                       "found a component in another part, " + quoted_excerpt(value.substr(0, value.find_first_of("\"'"))),
                       "meshes in the model itself, as the core of 3MF has it", "export without the production extension, or as STL"};
  }
  return std::nullopt;
}

// The unit of an archive's models.
base::Result<std::string> unit_of_3mf(std::string_view archive) {
  const auto entries = zip_entries(archive);
  if (!entries) return entries.error();
  constexpr std::uint64_t most_unpacked = std::uint64_t{2} << 30;
  std::uint64_t unpacked = 0;
  std::size_t models = 0;
  std::string unit = "mm";
  for (const ZipEntry& entry : *entries) {
    unpacked += entry.unpacked;
    if (!entry.name.ends_with(".model")) continue;
    ++models;
    constexpr std::size_t beginning = 65'536;
    const std::string text = zip_beginning(archive, entry, beginning);
    const std::size_t element = text.find("<model");
    if (element == std::string::npos) continue;
    if (auto error = why_not_whole(text, entry.name)) return std::move(*error);
    const std::string_view tag = std::string_view(text).substr(element, text.find('>', element) - element);
    if (auto error = why_not_read(tag, entry.name)) return std::move(*error);
    const std::string_view said = attribute(tag, "unit");
    if (!said.empty()) unit = unit_named(said);
  }
  if (models == 0) return at_byte(0, "found a ZIP archive without a file *.model", "3MF");
  if (unpacked > most_unpacked)
    return at_byte(0, "found a ZIP archive of " + std::to_string(unpacked) + " bytes",
                   "at most " + std::to_string(most_unpacked));
  return unit;
}

// --- a mesh as bytes, from one process to the other

class MeshBytes {
 public:
  template <class Number>
  void put(Number number) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof number);
    std::memcpy(bytes_.data() + at, &number, sizeof number);
  }
  void put_text(std::string_view text) {
    put(std::uint64_t{text.size()});
    bytes_ += text;
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

std::string bytes_of(const PolyMesh& mesh) {
  MeshBytes bytes;
  bytes.put(std::uint64_t{mesh.vertices.size()});
  for (const auto& vertex : mesh.vertices)
    for (const double c : vertex) bytes.put(c);
  bytes.put(std::uint64_t{mesh.bodies.size()});
  for (const PolyBody& body : mesh.bodies) {
    bytes.put_text(body.name);
    bytes.put(std::uint64_t{body.faces.size()});
    for (const PolyFace& face : body.faces) {
      bytes.put(static_cast<std::uint32_t>(face.outline.size()));
      for (const VertexIndex v : face.outline) bytes.put(v);
    }
  }
  bytes.put(std::uint64_t{mesh.materials.size()});
  for (const std::uint32_t material : mesh.materials) bytes.put(material);
  bytes.put(mesh.precision);
  bytes.put(std::uint64_t{mesh.notes.size()});
  for (const std::string& note : mesh.notes) bytes.put_text(note);
  return bytes.take();
}

// Of bytes that bytes_of made.
class MeshFromBytes {
 public:
  explicit MeshFromBytes(std::string_view bytes) : bytes_(bytes) {}

  PolyMesh run() {
    PolyMesh mesh;
    mesh.vertices.resize(count());
    for (auto& vertex : mesh.vertices)
      for (double& c : vertex) c = get<double>();
    mesh.bodies.resize(count());
    for (PolyBody& body : mesh.bodies) {
      body.name = text();
      body.faces.resize(count());
      for (PolyFace& face : body.faces) {
        face.outline.resize(get<std::uint32_t>());
        for (VertexIndex& v : face.outline) v = get<VertexIndex>();
      }
    }
    mesh.materials.resize(count());
    for (std::uint32_t& material : mesh.materials) material = get<std::uint32_t>();
    mesh.precision = get<double>();
    mesh.notes.resize(count());
    for (std::string& note : mesh.notes) note = text();
    mesh.grouped = mesh.bodies.size() > 1;
    return mesh;
  }

 private:
  template <class Number>
  Number get() {
    Number number{};
    std::memcpy(&number, bytes_.data(), sizeof number);
    bytes_.remove_prefix(sizeof number);
    return number;
  }
  std::size_t count() { return static_cast<std::size_t>(get<std::uint64_t>()); }
  std::string text() {
    const std::size_t size = count();
    std::string result(bytes_.substr(0, size));
    bytes_.remove_prefix(size);
    return result;
  }

  std::string_view bytes_;
};

// In the process that may be lost.
base::Result<std::string> import(std::string_view bytes, AssimpFormat format, const std::string& folder) {
  const char* const name = format == AssimpFormat::threemf ? "mesh.3mf" : format == AssimpFormat::glb ? "mesh.glb" : "mesh.gltf";
  std::vector<std::string> warnings;
  // assimp deletes its logger and the stream.
  Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
  Assimp::DefaultLogger::get()->attachStream(new Warnings(warnings), Assimp::Logger::Warn);
  Assimp::Importer importer;
  auto* const files = new FolderFiles(name, bytes, folder);  // the importer deletes it
  importer.SetIOHandler(files);
  const aiScene* const scene = importer.ReadFile(name, 0);
  if (scene == nullptr) {
    std::string cause = printable_name(importer.GetErrorString());
    if (!files->refusal().empty()) cause += "; " + files->refusal();
    return base::Error{"", "", "assimp cannot read it: " + cause, "", ""};
  }
  auto mesh = MeshFromAssimp(*scene).run();
  if (!mesh) return std::move(mesh.error());
  for (const std::string& warning : warnings) mesh->notes.push_back("what assimp warns of (\"" + warning + "\")");
  return bytes_of(*mesh);
}

base::Result<PolyMesh> read_apart(std::string_view bytes, std::string_view source, AssimpFormat format,
                                  const std::string& folder) {
  std::vector<std::string> notes;
  std::string unit = "m";
  if (format == AssimpFormat::threemf) {
    auto said = unit_of_3mf(bytes);
    if (!said) return std::move(said.error());
    unit = std::move(*said);
  } else {
    std::string_view text = bytes;
    if (format == AssimpFormat::glb) {
      const auto json = glb_json(bytes);
      if (!json) return json.error();
      text = *json;
      while (text.ends_with('\0')) text.remove_suffix(1);
    }
    auto found = look_at_gltf(text, source);
    if (!found) return std::move(found.error());
    notes = std::move(*found);
  }
  const auto result = base::run_in_child([&] { return import(bytes, format, folder); });
  if (!result) {
    base::Error error = result.error();
    if (error.found.starts_with("crashed") || error.found.starts_with("takes more"))
      error = {"", "", "assimp, which reads this format, " + error.found, "", "export it as OBJ, STL or PLY"};
    return error;
  }
  PolyMesh mesh = MeshFromBytes(*result).run();
  mesh.notes.insert(mesh.notes.end(), notes.begin(), notes.end());
  mesh.unit = std::move(unit);
  mesh.vertical = format == AssimpFormat::threemf ? 2 : 1;
  mesh.source = source;
  return mesh;
}

}  // namespace

base::Result<PolyMesh> read_by_assimp(std::string_view bytes, std::string_view source, AssimpFormat format,
                                      const std::string& folder) {
  auto mesh = read_apart(bytes, source, format, folder);
  if (mesh) return mesh;
  base::Error error = std::move(mesh.error());
  error.file = source;
  return error;
}

}  // namespace sightline::scene

#endif
