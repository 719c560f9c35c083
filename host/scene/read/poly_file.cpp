// See poly_file.hpp.
#include "host/scene/read/poly_file.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "host/base/result.hpp"
#include "host/scene/model/file_units.hpp"
#include "host/scene/read/obj.hpp"
#include "host/scene/read/off.hpp"
#include "host/scene/read/poly_json.hpp"
#include "host/scene/read/poly_triangulate.hpp"

namespace sightline::scene {
namespace {

using Ring = std::vector<VertexIndex>;

// The shortest text that reads as the same number.
void append(std::string& text, double value) {
  char digits[32];
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  text.append(digits, end);
}

void append_point(std::string& text, const PolyScene& scene, const PolyPoint& p) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (a > 0) text += ' ';
    append(text, file_coordinate(scene, p, a));
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

base::Result<std::string> write_off(const PolyScene& scene) {
  std::string faces;
  std::size_t count = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    for (std::size_t f = 0; f < scene.bodies[b].faces.size(); ++f) {
      const auto rings = rings_of(scene, scene.bodies[b].faces[f]);
      if (rings.empty()) return cannot_split(b, f);
      count += rings.size();
      for (const Ring& ring : rings) {
        faces += std::to_string(ring.size());
        for (const VertexIndex v : ring) faces += " " + std::to_string(v);
        faces += '\n';
      }
    }
  }
  std::string text = "OFF\n" + std::to_string(scene.vertices.size()) + " " + std::to_string(count) + " 0\n";
  for (const PolyPoint& p : scene.vertices) append_point(text, scene, p);
  return text + faces;
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
  return text;
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
        append(text, scene.surfaces[s].normal[a]);
      }
      text += ']';
    }
    text += "],\n\"surface_of\":" + json_array(scene.surface_of);
  }
  if (!scene.material_of.empty()) text += ",\n\"material_of\":" + json_array(scene.material_of);
}

// One vertex or face a line, so that versions can be compared.
std::string write_json(const PolyScene& scene) {
  std::string text = "{\"name\":" + json_string(scene.name) + ",\"step\":";
  append(text, scene.step);
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
  const PolyCamera& camera = scene.camera;
  return text + ",\n\"camera\":{\"perspective\":" + (camera.perspective ? "true" : "false") +
         ",\"eye\":" + json_array(camera.eye) + ",\"forward\":" + json_array(camera.forward) +
         ",\"right\":" + json_array(camera.right) + ",\"up\":" + json_array(camera.up) + "}}\n";
}

}  // namespace

std::optional<PolyFormat> poly_format_of(std::string_view file) {
  const std::size_t dot = file.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  std::string end(file.substr(dot + 1));
  std::transform(end.begin(), end.end(), end.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (end == "off") return PolyFormat::off;
  if (end == "obj") return PolyFormat::obj;
  if (end == "json") return PolyFormat::json;
  return std::nullopt;
}

PolyFormat poly_format_of(std::string_view file, std::string_view text) {
  if (const auto named = poly_format_of(file)) return *named;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t word = line.find_first_not_of(" \t\r");
    if (word != std::string_view::npos && line[word] != '#') {
      const std::string_view begins = line.substr(word);
      if (begins.starts_with("OFF")) return PolyFormat::off;
      for (const std::string_view obj : {"v ", "o ", "g ", "vn ", "vt ", "mtllib "})
        if (begins.starts_with(obj)) return PolyFormat::obj;
      return PolyFormat::json;
    }
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return PolyFormat::json;
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
  auto mesh = format == PolyFormat::off ? read_off(text, source) : read_obj(text, source);
  if (!mesh) return std::move(mesh.error());
  return import_poly(std::move(*mesh), options);
}

base::Result<std::string> write_poly(const PolyScene& scene, PolyFormat format) {
  switch (format) {
    case PolyFormat::off: return write_off(scene);
    case PolyFormat::obj: return write_obj(scene);
    case PolyFormat::json: break;
  }
  return write_json(scene);
}

}  // namespace sightline::scene
