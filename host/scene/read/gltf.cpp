// See gltf.hpp.
#include "host/scene/read/gltf.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "host/base/json.hpp"
#include "host/scene/read/draco_mesh.hpp"
#include "host/scene/read/gltf_document.hpp"
#include "host/scene/read/placed_meshes.hpp"
#include "host/scene/read/poly_text.hpp"
#include "host/scene/read/precision.hpp"

namespace sightline::scene {
namespace {

// How indices make triangles, lines and points.
enum class GltfMode : std::uint8_t { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

// Extensions that say how a mesh looks, not where it is, and those that are read.
bool is_harmless_extension(std::string_view extension) {
  for (const std::string_view family : {"KHR_materials_", "KHR_texture_", "KHR_lights_", "KHR_animation_", "EXT_texture_", "EXT_lights_"})
    if (extension.starts_with(family)) return true;
  for (const std::string_view name : {"KHR_draco_mesh_compression", "KHR_mesh_quantization", "KHR_xmp", "KHR_xmp_json_ld",
                                      "MSFT_texture_dds", "KHR_technique_webgl", "KHR_techniques_webgl"})
    if (extension == name) return true;
  return false;
}

std::string count_of(std::size_t count, const std::string& one, const std::string& several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

class GltfReader {
 public:
  GltfReader(const base::Json& root, std::string_view binary, const std::string& folder) : document_(root, binary, folder) {}

  base::Result<PolyMesh> run() {
    check_extensions();
    if (!document_.error()) push_scene();
    while (!document_.error() && !pending_.empty()) {
      const Pending next = std::move(pending_.back());
      pending_.pop_back();
      read_node(next);
    }
    if (document_.error()) return *document_.error();
    auto mesh = meshes_.take();
    if (!mesh) return mesh;
    if (thin_ > 0) mesh->notes.push_back(std::to_string(thin_) + " points and lines");
    if (left_over_ > 0) mesh->notes.push_back(count_of(left_over_, "vertex", "vertices") + " beyond the last whole triangle");
    if (beyond_ > 0) mesh->notes.push_back(count_of(beyond_, "face", "faces") + " with a vertex that is not there");
    const base::Json* const skins = document_.root().find("skins");
    if (skins != nullptr && skins->size() > 0) mesh->notes.push_back(count_of(skins->size(), "skin", "skins"));
    if (morphed_ > 0) mesh->notes.push_back("morph targets of " + count_of(morphed_, "mesh", "meshes"));
    if (instanced_ > 0) mesh->notes.push_back("instances of " + count_of(instanced_, "node", "nodes"));
    mesh->unit = "m";
    mesh->vertical = 1;
    return mesh;
  }

 private:
  struct Pending {
    GltfEntry node;
    Transform above;
  };
  using Primitives = std::vector<LocalMesh>;

  void check_extensions() {
    const base::Json* const required = document_.root().find("extensionsRequired");
    if (required == nullptr) return;
    for (const base::Json& name : required->elements()) {
      if (name.text() == nullptr || is_harmless_extension(*name.text())) continue;
      document_.fail("extensionsRequired", "found " + quoted_excerpt(*name.text()), "extensions that this program knows",
                     "export without it");
    }
  }

  // --- nodes

  // The default scene, or else the first one; in a file without scenes, all nodes that are nobody's children.
  void push_scene() {
    const base::Json& root = document_.root();
    const base::Json* const scenes = root.find("scenes");
    const base::Json* const chosen = root.find("scene");
    std::optional<GltfEntry> scene;
    if (chosen != nullptr) {
      scene = document_.entry("scenes", *chosen, "scene");
    } else if (scenes != nullptr && scenes->size() > 0) {
      scene = scenes->is_array() ? GltfEntry{&(*scenes)[0], "scenes[0]"}
                                 : GltfEntry{&scenes->members()[0].value, "scenes." + printable_name(scenes->members()[0].key)};
    } else {
      push_roots();
      return;
    }
    if (scene) push_nodes(*scene, "nodes", no_transform);
  }

  void push_roots() {
    const base::Json* const nodes = document_.root().find("nodes");
    if (nodes == nullptr) return;
    std::set<const base::Json*> children;
    for (std::size_t i = 0; i < nodes->size() && nodes->is_array(); ++i) {
      const base::Json* const below = (*nodes)[i].find("children");
      if (below == nullptr) continue;
      for (const base::Json& child : below->elements())
        if (const auto entry = document_.entry("nodes", child, base::indexed("nodes", i) + ".children"))
          children.insert(entry->json);
    }
    for (std::size_t i = nodes->elements().size(); i-- > 0;)
      if (!children.contains(&(*nodes)[i]) && seen_.insert(&(*nodes)[i]).second)
        pending_.push_back({{&(*nodes)[i], base::indexed("nodes", i)}, no_transform});
  }

  // The nodes that a member lists, so that the first one is read first.
  void push_nodes(const GltfEntry& from, const char* member, const Transform& above) {
    const base::Json* const list = from.json->find(member);
    if (list == nullptr) return;
    const std::string place = from.place + "." + member;
    if (!list->is_array()) {
      document_.fail(place, "found " + base::describe(*list), "an array");
      return;
    }
    for (std::size_t i = list->size(); i-- > 0;) {
      const auto node = document_.entry("nodes", (*list)[i], base::indexed(place, i));
      if (!node) return;
      if (!seen_.insert(node->json).second) {
        document_.fail(node->place, "found a node that is its own descendant or has two parents", "a tree of nodes");
        return;
      }
      pending_.push_back({*node, above});
    }
  }

  void read_node(const Pending& pending) {
    const GltfEntry& node = pending.node;
    const Transform here = product(pending.above, transform_of(node));
    const base::Json* const name = node.json->find("name");
    // A node of glTF 1 has a key instead of a number, and several meshes.
    const std::size_t dot = node.place.find('.');
    const std::string fallback = dot == std::string::npos ? node.place : node.place.substr(dot + 1);
    const base::Json* const several = node.json->find("meshes");
    if (document_.error()) return;
    meshes_.begin_body(name != nullptr && name->text() != nullptr ? *name->text() : fallback);
    if (const base::Json* const one = node.json->find("mesh")) place(*one, node.place + ".mesh", here);
    for (std::size_t i = 0; several != nullptr && i < several->elements().size(); ++i)
      place((*several)[i], base::indexed(node.place + ".meshes", i), here);
    const base::Json* const extensions = node.json->find("extensions");
    instanced_ += extensions != nullptr && extensions->find("EXT_mesh_gpu_instancing") != nullptr ? 1U : 0U;
    push_nodes(node, "children", here);
  }

  // By its matrix, column by column, or by scale, rotation (x, y, z, w of a quaternion) and translation.
  Transform transform_of(const GltfEntry& node) {
    std::array<double, 16> m{};
    Transform result = no_transform;
    if (document_.numbers(node, "matrix", m.size(), m.data())) {
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j) result[i][j] = m[4 * j + i];
      return result;
    }
    std::array<double, 3> move{0, 0, 0};
    std::array<double, 4> q{0, 0, 0, 1};
    std::array<double, 3> scale{1, 1, 1};
    document_.numbers(node, "translation", 3, move.data());
    document_.numbers(node, "rotation", 4, q.data());
    document_.numbers(node, "scale", 3, scale.data());
    const auto [x, y, z, w] = q;
    result = {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), move[0]},
               {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), move[1]},
               {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), move[2]}}};
    for (auto& row : result)
      for (std::size_t j = 0; j < 3; ++j) row[j] *= scale[j];
    return result;
  }

  void place(const base::Json& reference, const std::string& from, const Transform& here) {
    const auto mesh = document_.entry("meshes", reference, from);
    if (!mesh) return;
    const auto [known, is_new] = decoded_.try_emplace(mesh->json);
    if (is_new) known->second = primitives_of(*mesh);
    if (document_.error()) return;
    for (const LocalMesh& primitive : known->second) {
      const auto added = meshes_.add(primitive, here);
      if (!added) document_.fail(added.error().place, added.error().found, added.error().expected, added.error().remedy);
    }
  }

  // --- meshes

  Primitives primitives_of(const GltfEntry& mesh) {
    Primitives result;
    const base::Json* const list = mesh.json->find("primitives");
    if (list == nullptr || !list->is_array()) {
      document_.fail(mesh.place + ".primitives", "found " + (list == nullptr ? "nothing" : base::describe(*list)), "an array");
      return result;
    }
    for (std::size_t i = 0; i < list->size() && !document_.error(); ++i) {
      LocalMesh primitive;
      primitive.place = base::indexed(mesh.place + ".primitives", i);
      const GltfEntry entry{&(*list)[i], primitive.place};
      const base::Json* const material = entry.json->find("material");
      const std::string named = material == nullptr ? "" : material->dump();
      primitive.material = materials_.emplace(named, static_cast<std::uint32_t>(materials_.size())).first->second;
      morphed_ += entry.json->find("targets") != nullptr ? 1U : 0U;
      read_primitive(entry, primitive);
      if (!primitive.corners.empty()) result.push_back(std::move(primitive));
    }
    return result;
  }

  void read_primitive(const GltfEntry& entry, LocalMesh& mesh) {
    const auto mode = document_.whole(entry, "mode", 6, 4);
    const base::Json* const attributes = entry.json->find("attributes");
    if (!mode) return;
    if (attributes == nullptr || attributes->find("POSITION") == nullptr) return;  // nothing to be drawn: 3.7.2.1
    const base::Json* const extensions = entry.json->find("extensions");
    const base::Json* const draco = extensions == nullptr ? nullptr : extensions->find("KHR_draco_mesh_compression");
    if (draco != nullptr) {
      read_compressed({draco, entry.place + ".extensions.KHR_draco_mesh_compression"}, mesh);
      return;
    }
    const auto named = document_.entry_of("accessors", {attributes, entry.place + ".attributes"}, "POSITION");
    const auto position = named ? document_.accessor(*named) : std::nullopt;
    if (!position) return;
    if (position->components != 3) {
      document_.fail(named->place + ".type", "found positions of " + std::to_string(position->components) + " numbers",
                     "\"VEC3\"");
      return;
    }
    std::optional<GltfAccessor> indices;
    if (entry.json->find("indices") != nullptr) {
      const auto whose = document_.entry_of("accessors", entry, "indices");
      indices = whose ? document_.accessor(*whose) : std::nullopt;
      if (!indices) return;
      if (indices->components != 1 || indices->is_float || indices->is_signed) {
        document_.fail(whose->place, "found indices that are no whole numbers from 0",
                       "\"SCALAR\" of component type 5121, 5123 or 5125");
        return;
      }
    }
    add_faces(indices, *position, static_cast<GltfMode>(*mode), mesh);
    if (!document_.error()) add_vertices(*position, mesh);
  }

  // Room for what one primitive has; false after an error.
  bool take_corners(std::uint64_t count, const std::string& place) {
    if (count <= most_placed_corners - corners_) {
      corners_ += count;
      return true;
    }
    document_.fail(place, "found more than " + std::to_string(most_placed_corners) + " corners of faces", "",
                   "export fewer faces");
    return false;
  }

  void add_faces(const std::optional<GltfAccessor>& indices, const GltfAccessor& position, GltfMode mode, LocalMesh& mesh) {
    const std::uint64_t count = indices ? indices->count : position.count;
    if (mode < GltfMode::triangles) {
      thin_ += mode == GltfMode::lines        ? count / 2
               : mode == GltfMode::line_strip ? count - std::min<std::uint64_t>(count, 1)
                                              : count;
      return;
    }
    const std::uint64_t faces = mode == GltfMode::triangles ? count / 3 : count - std::min<std::uint64_t>(count, 2);
    if (mode == GltfMode::triangles) left_over_ += count % 3;
    if (!take_corners(3 * faces, mesh.place)) return;
    const std::size_t beyond_before = beyond_;
    for (std::uint64_t f = 0; f < faces; ++f) {
      std::array<std::uint64_t, 3> face{f, f + 1, f + 2};
      if (mode == GltfMode::triangles) face = {3 * f, 3 * f + 1, 3 * f + 2};
      if (mode == GltfMode::triangle_strip && f % 2 == 1) std::swap(face[0], face[1]);
      if (mode == GltfMode::triangle_fan) face[0] = 0;
      if (indices)
        for (std::uint64_t& v : face) v = indices->whole(v);
      // Strips are joined by such triangles.
      if (mode == GltfMode::triangle_strip && (face[0] == face[1] || face[1] == face[2] || face[2] == face[0])) continue;
      if (std::any_of(face.begin(), face.end(), [&](std::uint64_t v) { return v >= position.count; })) {
        ++beyond_;
        continue;
      }
      for (const std::uint64_t v : face) mesh.corners.push_back(static_cast<std::uint32_t>(v));
    }
    if (mesh.corners.empty() && beyond_ > beyond_before)
      document_.fail(mesh.place + ".indices", "found no face whose vertices are all there",
                     position.count == 0 ? "positions" : "numbers below " + std::to_string(position.count));
  }

  // The vertices of the corners.
  void add_vertices(const GltfAccessor& position, LocalMesh& mesh) {
    std::vector<std::uint32_t> used;
    if (position.count > mesh.corners.size()) used = number_used_vertices(mesh.corners);
    const std::uint64_t count = used.empty() ? position.count : used.size();
    if (mesh.corners.empty()) return;
    mesh.vertices.reserve(count);
    for (std::uint64_t v = 0; v < count; ++v) {
      const std::uint64_t i = used.empty() ? v : used[v];
      mesh.vertices.push_back({position.value(i, 0), position.value(i, 1), position.value(i, 2)});
    }
    for (const std::uint32_t v : mesh.corners) {
      const auto& vertex = mesh.vertices[v];
      if (std::isfinite(vertex[0]) && std::isfinite(vertex[1]) && std::isfinite(vertex[2])) continue;
      document_.fail(mesh.place + ", vertex " + std::to_string(used.empty() ? v : used[v]),
                     "found a coordinate that is no finite number", "a number");
      return;
    }
    // Whole numbers are taken for exact, as in texts.
    mesh.precision = position.is_float ? float32_precision(mesh.vertices) : 0;
  }

  void read_compressed(const GltfEntry& draco, LocalMesh& mesh) {
    const base::Json* const attributes = draco.json->find("attributes");
    const GltfEntry ids{attributes, draco.place + ".attributes"};
    if (attributes == nullptr) {
      document_.fail(draco.place, "found no member \"attributes\"", "the ids of the compressed attributes");
      return;
    }
    const auto id = document_.whole(ids, "POSITION", 0xffffffff);
    const auto whose = id ? document_.entry_of("bufferViews", draco, "bufferView") : std::nullopt;
    const auto bytes = whose ? document_.view(*whose) : std::nullopt;
    if (!bytes) return;
    auto decoded = read_draco(*bytes, static_cast<std::uint32_t>(*id), (most_placed_corners - corners_) / 3);
    if (!decoded) {
      document_.fail(draco.place, decoded.error().found, decoded.error().expected, decoded.error().remedy);
      return;
    }
    if (!take_corners(decoded->corners.size(), mesh.place)) return;
    mesh.vertices = std::move(decoded->vertices);
    mesh.corners = std::move(decoded->corners);
    // The encoder rounded each mesh to steps of its own, of which the largest would be too coarse for the small meshes.
    mesh.precision = float32_precision(mesh.vertices);
  }

  GltfDocument document_;
  PlacedMeshes meshes_;
  std::vector<Pending> pending_;
  std::set<const base::Json*> seen_;
  std::map<const base::Json*, Primitives> decoded_;
  std::map<std::string, std::uint32_t> materials_;
  std::uint64_t corners_ = 0;
  // What is left out.
  std::uint64_t thin_ = 0;
  std::uint64_t left_over_ = 0;
  std::size_t beyond_ = 0;
  std::size_t morphed_ = 0;
  std::size_t instanced_ = 0;
};

// --- the frame of a GLB

struct Glb {
  std::string_view json;
  std::string_view binary;
};

std::uint32_t glb_word(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << (8 * i);
  return word;
}

base::Error at_glb_byte(std::size_t byte, std::string found, std::string expected, std::string remedy) {
  return {"", "byte " + std::to_string(byte), std::move(found), std::move(expected), std::move(remedy)};
}

base::Result<Glb> glb_of(std::string_view bytes) {
  constexpr std::size_t header = 12;
  constexpr std::size_t json_at = header + 8;
  constexpr std::uint32_t json_type = 0x4e4f534a;
  constexpr std::uint32_t binary_type = 0x004e4942;
  if (bytes.size() < json_at)
    return at_glb_byte(bytes.size(), "found the end of the file", "the 20 bytes of a GLB header", export_again);
  if (glb_word(bytes, 4) != 2) {
    return at_glb_byte(4, "found version " + std::to_string(glb_word(bytes, 4)), "2", "convert it to glTF 2.0");
  }
  if (glb_word(bytes, 8) != bytes.size()) {
    return at_glb_byte(8, "found a length of " + std::to_string(glb_word(bytes, 8)),
                       "the " + std::to_string(bytes.size()) + " bytes that the file has", export_again);
  }
  if (glb_word(bytes, header + 4) != json_type)
    return at_glb_byte(header + 4, "found no JSON", "the chunk \"JSON\" first", export_again);
  Glb glb;
  for (std::size_t at = header; at + 8 <= bytes.size();) {
    const std::uint32_t length = glb_word(bytes, at);
    const std::size_t left = bytes.size() - at - 8;
    if (length > left)
      return at_glb_byte(at, "found a chunk of " + std::to_string(length) + " bytes",
                         "at most the " + std::to_string(left) + " that are left", export_again);
    const std::string_view chunk = bytes.substr(at + 8, length);
    if (at == header) glb.json = chunk;
    if (at > header && glb_word(bytes, at + 4) == binary_type && glb.binary.empty()) glb.binary = chunk;
    at += 8 + length;
  }
  while (glb.json.ends_with('\0')) glb.json.remove_suffix(1);
  return glb;
}

base::Result<PolyMesh> read_parts(std::string_view json, std::string_view binary, std::string_view source,
                                  const std::string& folder) {
  const auto root = base::parse_json(json, source);
  auto mesh = root ? GltfReader(*root, binary, folder).run() : base::Result<PolyMesh>(root.error());
  if (mesh) {
    mesh->source = source;
    return mesh;
  }
  base::Error error = std::move(mesh.error());
  error.file = source;
  return error;
}

}  // namespace

base::Result<PolyMesh> read_gltf(std::string_view text, std::string_view source, const std::string& folder) {
  return read_parts(text, "", source, folder);
}

base::Result<PolyMesh> read_glb(std::string_view bytes, std::string_view source, const std::string& folder) {
  const auto glb = glb_of(bytes);
  if (glb) return read_parts(glb->json, glb->binary, source, folder);
  base::Error error = glb.error();
  error.file = source;
  return error;
}

}  // namespace sightline::scene
