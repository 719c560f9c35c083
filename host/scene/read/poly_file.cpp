// See poly_file.hpp.
#include "host/scene/read/poly_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <set>
#include <type_traits>

#include "host/base/number.hpp"
#include "host/base/result.hpp"
#include "host/base/text.hpp"
#include "host/scene/check/problems.hpp"
#include "host/scene/model/file_units.hpp"
#include "host/scene/read/gltf.hpp"
#include "host/scene/read/obj.hpp"
#include "host/scene/read/off.hpp"
#include "host/scene/read/ply.hpp"
#include "host/scene/read/poly_json.hpp"
#include "host/scene/read/poly_triangulate.hpp"
#include "host/scene/read/stl.hpp"
#include "host/scene/read/three_mf.hpp"

namespace sightline::scene {
namespace {


void append_point(std::string& text, const PolyScene& scene, const PolyPoint& p) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (a > 0) text += ' ';
    text += base::shortest_number(file_coordinate(scene, p, a));
  }
  text += '\n';
}

// The rings to write for a face: its outline, or triangles if it has holes; none if that fails.
std::vector<Ring> rings_of(const PolyScene& scene, const PolyFace& face) {
  if (face.holes.empty()) return {face.outline};
  std::vector<Ring> rings;
  if (const auto triangles = triangulate(scene.vertices, face))
    for (const auto& t : *triangles) rings.push_back({t[0], t[1], t[2]});
  return rings;
}

base::Error cannot_split(std::size_t body, std::size_t face) {
  return {"", "body " + std::to_string(body) + ", face " + std::to_string(face),
          "has holes and cannot be split into triangles; JSON keeps holes"};
}

// Those of all faces, body after body.
base::Result<std::vector<Ring>> rings_of(const PolyScene& scene) {
  std::vector<Ring> all;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    for (std::size_t f = 0; f < scene.bodies[b].faces.size(); ++f) {
      const auto rings = rings_of(scene, scene.bodies[b].faces[f]);
      if (rings.empty()) return cannot_split(b, f);
      all.insert(all.end(), rings.begin(), rings.end());
    }
  }
  return all;
}

base::Result<std::string> write_off(const PolyScene& scene) {
  const auto rings = rings_of(scene);
  if (!rings) return rings.error();
  std::string text = "OFF\n" + std::to_string(scene.vertices.size()) + " " + std::to_string(rings->size()) + " 0\n";
  for (const PolyPoint& p : scene.vertices) append_point(text, scene, p);
  for (const Ring& ring : *rings) {
    text += std::to_string(ring.size());
    for (const VertexIndex v : ring) text += " " + std::to_string(v);
    text += '\n';
  }
  return text;
}

// What reads as the same name: a # would begin a comment, a \ at the end continue on the next line, and words
// are one blank apart. It must not be empty nor another body's, or the two become one.
std::string obj_name(std::string_view name, std::size_t body, std::set<std::string>& taken) {
  std::string text;
  for (const char c : name) {
    if (c != ' ') text += c == '#' || c == '\\' ? '_' : c;
    if (c == ' ' && !text.empty() && text.back() != ' ') text += ' ';
  }
  if (!text.empty() && text.back() == ' ') text.pop_back();
  if (text.empty() || taken.contains(text)) text = "body " + std::to_string(body);
  while (!taken.insert(text).second) text += '_';
  return text;
}

base::Result<std::string> write_obj(const PolyScene& scene) {
  std::string text;
  for (const PolyPoint& p : scene.vertices) {
    text += "v ";
    append_point(text, scene, p);
  }
  std::set<std::string> names;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    text += "o " + obj_name(scene.bodies[b].name, b, names) + '\n';
    for (std::size_t f = 0; f < scene.bodies[b].faces.size(); ++f) {
      const auto rings = rings_of(scene, scene.bodies[b].faces[f]);
      if (rings.empty()) return cannot_split(b, f);
      for (const Ring& ring : rings) {
        text += 'f';
        for (const VertexIndex v : ring) text += " " + std::to_string(v + 1);
        text += '\n';
      }
    }
  }
  for (const PolyWire& wire : scene.wires) text += "l " + std::to_string(wire[0] + 1) + " " + std::to_string(wire[1] + 1) + '\n';
  return text;
}

// --- binary, in little-endian byte order

template <class Number>
void append_bytes(std::string& bytes, Number number) {
  if constexpr (std::is_same_v<Number, float>) {
    append_bytes(bytes, std::bit_cast<std::uint32_t>(number));
  } else if constexpr (std::is_same_v<Number, double>) {
    append_bytes(bytes, std::bit_cast<std::uint64_t>(number));
  } else {
    for (std::size_t i = 0; i < sizeof number; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
  }
}

// Numbers are float32 there: what is finer is lost.
base::Result<std::string> write_stl(const PolyScene& scene) {
  std::string triangles;
  std::uint32_t count = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    for (std::size_t f = 0; f < scene.bodies[b].faces.size(); ++f) {
      const auto split = triangulate(scene.vertices, scene.bodies[b].faces[f]);
      if (!split) return cannot_split(b, f);
      for (const auto& triangle : *split) {
        for (int i = 0; i < 3; ++i) append_bytes(triangles, 0.0F);  // readers take the normal from the vertices
        for (const VertexIndex v : triangle)
          for (std::size_t a = 0; a < 3; ++a)
            append_bytes(triangles, static_cast<float>(file_coordinate(scene, scene.vertices[v], a)));
        append_bytes(triangles, std::uint16_t{0});
        ++count;
      }
    }
  }
  std::string bytes(80, ' ');
  append_bytes(bytes, count);
  return bytes + triangles;
}

base::Result<std::string> write_ply(const PolyScene& scene) {
  const auto rings = rings_of(scene);
  if (!rings) return rings.error();
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(scene.vertices.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " + std::to_string(rings->size()) +
                      "\nproperty list uint uint vertex_indices\nend_header\n";
  for (const PolyPoint& p : scene.vertices)
    for (std::size_t a = 0; a < 3; ++a) append_bytes(bytes, file_coordinate(scene, p, a));
  for (const Ring& ring : *rings) {
    append_bytes(bytes, static_cast<std::uint32_t>(ring.size()));
    for (const VertexIndex v : ring) append_bytes(bytes, v);
  }
  return bytes;
}

std::string json_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c >= ' ' && c <= '~' ? c : '?';
  }
  return result + '"';
}

template <class Numbers>
std::string json_array(const Numbers& numbers) {
  std::string text;
  for (const auto n : numbers) text += (text.empty() ? "[" : ",") + std::to_string(n);
  return text.empty() ? "[]" : text + "]";
}

std::string json_face(const PolyFace& face) {
  if (face.holes.empty()) return json_array(face.outline);
  std::string text = "{\"outline\":" + json_array(face.outline) + ",\"holes\":[";
  for (std::size_t h = 0; h < face.holes.size(); ++h) text += (h > 0 ? "," : "") + json_array(face.holes[h]);
  return text + "]}";
}

// Which faces of a mesh are one surface, and their materials.
void append_surfaces(std::string& text, const PolyScene& scene) {
  if (!scene.surfaces.empty()) {
    text += ",\n\"surfaces\":[";
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
      text += s > 0 ? ",\n" : "\n";
      for (std::size_t a = 0; a < 3; ++a) {
        text += a > 0 ? ',' : '[';
        text += base::shortest_number(scene.surfaces[s].normal[a]);
      }
      text += ']';
    }
    text += "],\n\"surface_of\":" + json_array(scene.surface_of);
  }
  if (!scene.material_of.empty()) text += ",\n\"material_of\":" + json_array(scene.material_of);
  if (scene.materials_are_colours) text += ",\n\"materials_are_colours\":true";
}

void append_pairs(std::string& text, const std::string& name, const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  for (std::size_t p = 0; p < pairs.size(); ++p)
    text += (p > 0 ? std::string(",\n") : ",\n\"" + name + "\":[\n") + json_array(pairs[p]);
  if (!pairs.empty()) text += ']';
}

// One vertex or face a line, so that versions can be compared.
std::string write_json(const PolyScene& scene) {
  std::string text = "{\"name\":" + json_string(scene.name) + ",\"step\":";
  text += base::shortest_number(scene.step);
  text += ",\"origin\":" + json_array(scene.origin) + ",\n\"vertices\":[";
  for (std::size_t v = 0; v < scene.vertices.size(); ++v)
    text += (v > 0 ? ",\n" : "\n") + json_array(scene.vertices[v]);
  text += "],\n\"bodies\":[";
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const PolyBody& body = scene.bodies[b];
    text += std::string(b > 0 ? ",\n" : "\n") + "{\"name\":" + json_string(body.name) +
            ",\"sheet\":" + (body.sheet ? "true" : "false") + ",\"faces\":[";
    for (std::size_t f = 0; f < body.faces.size(); ++f)
      text += (f > 0 ? ",\n" : "\n") + json_face(body.faces[f]);
    text += "]}";
  }
  text += ']';
  append_surfaces(text, scene);
  append_pairs(text, "wires", scene.wires);
  append_pairs(text, "wires_on", scene.wires_on);
  const PolyCamera& camera = scene.camera;
  return text + ",\n\"camera\":{\"perspective\":" + (camera.perspective ? "true" : "false") +
         ",\"eye\":" + json_array(camera.eye) + ",\"forward\":" + json_array(camera.forward) +
         ",\"right\":" + json_array(camera.right) + ",\"up\":" + json_array(camera.up) + "}}\n";
}

// --- which format

struct FormatName {
  std::string_view ending;
  PolyFormat format;
};
constexpr std::array format_names{
    FormatName{"off", PolyFormat::off}, FormatName{"obj", PolyFormat::obj},   FormatName{"stl", PolyFormat::stl},
    FormatName{"ply", PolyFormat::ply}, FormatName{"json", PolyFormat::json}, FormatName{"gltf", PolyFormat::gltf},
    FormatName{"glb", PolyFormat::glb}, FormatName{"3mf", PolyFormat::threemf},
};

// Whether an outermost object of JSON has the key "asset", as glTF has. Nothing is parsed.
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

// As the first line says that is neither empty nor a comment; empty if it says nothing.
std::optional<PolyFormat> format_by_content(const std::string_view whole) {
  std::string_view text = whole;
  if (text.starts_with("ply") && text.find_first_of(" \t\r\n") == 3) return PolyFormat::ply;
  if (text.starts_with("glTF")) return PolyFormat::glb;
  if (text.starts_with("PK\3\4")) return PolyFormat::threemf;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string_view::npos || line[first] == '#') continue;
    const std::string_view begins = line.substr(first);
    const std::string_view word = begins.substr(0, begins.find_first_of(" \t\r"));
    constexpr std::size_t longest_off = 8;  // STCNnOFF, perhaps with the first count right behind it
    const std::string_view keyword = word.substr(0, word.find_last_not_of("0123456789") + 1);
    if (keyword == "off" || (keyword.ends_with("OFF") && keyword.size() <= longest_off)) return PolyFormat::off;
    if (begins.starts_with("{"))
      return is_gltf(whole.substr(static_cast<std::size_t>(begins.data() - whole.data()))) ? PolyFormat::gltf
                                                                                           : PolyFormat::json;
    if (base::lower_case(word) == "solid") return PolyFormat::stl;
    for (const std::string_view obj : {"v", "o", "g", "vn", "vt", "f", "usemtl", "mtllib"})
      if (word == obj && word.size() < begins.size()) return PolyFormat::obj;
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<PolyFormat> poly_format_of(std::string_view file) {
  const std::size_t dot = file.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const std::string end = base::lower_case(file.substr(dot + 1));
  for (const FormatName& format : format_names)
    if (end == format.ending) return format.format;
  return std::nullopt;
}

PolyFormat poly_format_of(std::string_view file, std::string_view text) {
  const auto named = poly_format_of(file);
  // A count that is less than the length allows may be chance, in a file that is no STL.
  const bool stl = begins_as_binary_stl(text);
  if (is_binary_stl(text) || (stl && named == PolyFormat::stl)) return PolyFormat::stl;
  if (const auto told = format_by_content(text)) return *told;
  return named.value_or(stl ? PolyFormat::stl : PolyFormat::json);
}

base::Result<PolyMesh> read_mesh(std::string_view text, std::string_view source, PolyFormat format, const std::string& folder,
                                 unsigned jobs) {
  switch (format) {
    case PolyFormat::off: return read_off(text, source, jobs);
    case PolyFormat::stl: return read_stl(text, source, jobs);
    case PolyFormat::ply: return read_ply(text, source);
    case PolyFormat::gltf: return read_gltf(text, source, folder);
    case PolyFormat::glb: return read_glb(text, source, folder);
    case PolyFormat::threemf: return read_three_mf(text, source);
    default: return read_obj(text, source);
  }
}

PolyImport import_unchanged(PolyScene scene) {
  PolyImport result{std::move(scene), {}};
  result.report.step = result.scene.step;
  for (const PolyBody& body : result.scene.bodies) result.report.faces.sheets += body.sheet ? 1U : 0U;
  return result;
}

base::Result<PolyImport> read_poly(std::string_view text, std::string_view source, PolyFormat format,
                                   const PolyImportOptions& options) {
  if (format == PolyFormat::json) {
    auto scene = read_poly_json(text, source);
    if (!scene) return std::move(scene.error());
    return import_unchanged(std::move(*scene));
  }
  auto mesh = read_mesh(text, source, format, options.folder, options.jobs);
  if (!mesh) return std::move(mesh.error());
  auto import = import_poly(std::move(*mesh), options);
  if (import && !import->faults.empty()) return first_of(import->faults);
  return import;
}

base::Result<std::string> write_poly(const PolyScene& scene, PolyFormat format) {
  if (!scene.wires.empty() && format != PolyFormat::obj && format != PolyFormat::json) {
    const std::string count = std::to_string(scene.wires.size());
    return base::Error{"", "", "has " + count + (scene.wires.size() == 1 ? " line" : " lines") + " without faces, for which this format has no place",
                       "a scene of faces alone", "JSON and OBJ keep the lines"};
  }
  switch (format) {
    case PolyFormat::off: return write_off(scene);
    case PolyFormat::obj: return write_obj(scene);
    case PolyFormat::stl: return write_stl(scene);
    case PolyFormat::ply: return write_ply(scene);
    default: break;
  }
  return write_json(scene);
}

}  // namespace sightline::scene
