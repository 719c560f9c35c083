// See poly_json.hpp.
#include "host/scene/read/poly_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "host/base/json_reader.hpp"
#include "host/scene/check/poly_shells.hpp"
#include "host/scene/model/file_units.hpp"
#include "host/scene/read/json_documents.hpp"
#include "host/scene/read/poly_import.hpp"
#include "host/scene/read/poly_quantise.hpp"

namespace sightline::scene {
namespace {

using base::Json;

constexpr std::size_t longest_scene_name = 200;
constexpr std::int64_t largest_origin = std::int64_t{1} << 53;

class PolyReader {
 public:
  explicit PolyReader(std::string_view source) : json_(std::string(source)) {}

  base::Result<PolyScene> run(const Json& document) {
    if (!document.is_object()) json_.expected("an object", document, "");
    read(document);
    if (json_.failed()) return json_.error();
    return std::move(scene_);
  }

 private:
  PolyPoint point(const Json& value, const std::string& place, std::int64_t largest) {
    PolyPoint p{};
    if (!json_.array(value, place, 3)) return p;
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = static_cast<std::int32_t>(json_.integer(value[a], base::indexed(place, a), -largest, largest));
    return p;
  }

  PolyPoint camera_point(const Json& camera, const char* which, std::int64_t largest) {
    const Json* value = json_.field(camera, which, "camera");
    return value != nullptr ? point(*value, std::string("camera.") + which, largest) : PolyPoint{};
  }

  Ring ring(const Json& value, const std::string& place) {
    Ring result;
    if (!json_.array(value, place)) return result;
    if (value.size() < 3) json_.expected("an array of 3 or more", value, place);
    const auto last = static_cast<std::int64_t>(scene_.vertices.size()) - 1;
    for (std::size_t i = 0; i < value.size() && !json_.failed(); ++i)
      result.push_back(static_cast<VertexIndex>(json_.integer(value[i], base::indexed(place, i), 0, last)));
    return result;
  }

  PolyFace face(const Json& value, const std::string& place) {
    PolyFace result;
    if (value.is_array()) {
      result.outline = ring(value, place);
      return result;
    }
    if (const Json* outline = json_.field(value, "outline", place))
      result.outline = ring(*outline, place + ".outline");
    const Json* holes = json_.failed() ? nullptr : json_.optional_field(value, "holes", place);
    if (holes == nullptr || !json_.array(*holes, place + ".holes")) return result;
    for (std::size_t h = 0; h < holes->size() && !json_.failed(); ++h)
      result.holes.push_back(ring((*holes)[h], base::indexed(place + ".holes", h)));
    return result;
  }

  PolyBody body(const Json& value, const std::string& place) {
    PolyBody result;
    const Json* faces = json_.field(value, "faces", place);
    if (faces == nullptr || !json_.array(*faces, place + ".faces")) return result;
    for (std::size_t f = 0; f < faces->size() && !json_.failed(); ++f)
      result.faces.push_back(face((*faces)[f], base::indexed(place + ".faces", f)));
    if (const Json* text = json_.optional_field(value, "name", place))
      result.name = json_.name(*text, place + ".name", 0, longest_scene_name);
    const Json* sheet = json_.optional_field(value, "sheet", place);
    result.sheet = sheet != nullptr ? json_.boolean(*sheet, place + ".sheet")
                                    : result.faces.empty() || !is_closed(face_edges(result));
    return result;
  }

  // Numbers of something, one for each face of the scene.
  void of_faces(const Json& document, const char* name, std::int64_t last, std::vector<std::uint32_t>& numbers) {
    const Json* value = json_.optional_field(document, name, "");
    if (value == nullptr || !json_.array(*value, name, face_count(scene_))) return;
    numbers.reserve(value->size());
    for (std::size_t f = 0; f < value->size() && !json_.failed(); ++f)
      numbers.push_back(static_cast<std::uint32_t>(json_.integer((*value)[f], base::indexed(name, f), 0, last)));
  }

  PolySurface surface(const Json& value, const std::string& place) {
    PolySurface result;
    if (!json_.array(value, place, 3)) return result;
    for (std::size_t a = 0; a < 3 && !json_.failed(); ++a) {
      const auto number = value[a].number();
      if (number && std::abs(*number) <= 1) {
        result.normal[a] = *number;
      } else {
        json_.expected("a number from -1 to 1", value[a], base::indexed(place, a));
      }
    }
    return result;
  }

  void read_surfaces(const Json& document) {
    const Json* surfaces = json_.optional_field(document, "surfaces", "");
    if (surfaces != nullptr && json_.array(*surfaces, "surfaces") && surfaces->size() > 0) {
      for (std::size_t s = 0; s < surfaces->size() && !json_.failed(); ++s)
        scene_.surfaces.push_back(surface((*surfaces)[s], base::indexed("surfaces", s)));
      if (json_.field(document, "surface_of", "") == nullptr) return;
      of_faces(document, "surface_of", static_cast<std::int64_t>(scene_.surfaces.size()) - 1, scene_.surface_of);
    }
    of_faces(document, "material_of", std::numeric_limits<std::uint32_t>::max(), scene_.material_of);
    if (const Json* colours = json_.optional_field(document, "materials_are_colours", ""))
      scene_.materials_are_colours = json_.boolean(*colours, "materials_are_colours");
  }

  // Pairs of numbers of things of which there are so many.
  void pairs(const Json& document, const char* name, const std::array<std::size_t, 2>& counts,
             std::vector<std::array<std::uint32_t, 2>>& numbers) {
    const Json* value = json_.optional_field(document, name, "");
    if (value == nullptr || !json_.array(*value, name)) return;
    for (std::size_t p = 0; p < value->size() && !json_.failed(); ++p) {
      const std::string place = base::indexed(name, p);
      if (!json_.array((*value)[p], place, 2)) return;
      auto& pair = numbers.emplace_back();
      for (std::size_t i = 0; i < 2; ++i) {
        const auto last = static_cast<std::int64_t>(counts[i]) - 1;
        pair[i] = static_cast<std::uint32_t>(json_.integer((*value)[p][i], base::indexed(place, i), 0, last));
      }
    }
  }

  void read(const Json& document) {
    constexpr std::int64_t largest = poly_coordinate_limit - 1;
    if (const Json* text = json_.optional_field(document, "name", ""))
      scene_.name = json_.name(*text, "name", 0, longest_scene_name);
    const Json* step = json_.optional_field(document, "step", "");
    if (step != nullptr) {
      scene_.step = step->number().value_or(0);
      if (!std::isnormal(scene_.step) || scene_.step < 0) json_.expected("a number above 0", *step, "step");
    }
    const Json* origin = json_.optional_field(document, "origin", "");
    if (origin != nullptr && json_.array(*origin, "origin", 3)) {
      for (std::size_t a = 0; a < 3; ++a)
        scene_.origin[a] = json_.integer((*origin)[a], base::indexed("origin", a), -largest_origin, largest_origin);
    }
    const Json* vertices = json_.field(document, "vertices", "");
    if (vertices == nullptr || !json_.array(*vertices, "vertices")) return;
    for (std::size_t v = 0; v < vertices->size() && !json_.failed(); ++v)
      scene_.vertices.push_back(point((*vertices)[v], base::indexed("vertices", v), largest));
    if (step != nullptr && !finite())
      json_.expected("a step that leaves every coordinate finite", *step, "step");
    const Json* bodies = json_.field(document, "bodies", "");
    if (bodies == nullptr || !json_.array(*bodies, "bodies")) return;
    for (std::size_t b = 0; b < bodies->size() && !json_.failed(); ++b)
      scene_.bodies.push_back(body((*bodies)[b], base::indexed("bodies", b)));
    if (json_.failed()) return;
    read_surfaces(document);
    if (json_.failed()) return;
    pairs(document, "wires", {scene_.vertices.size(), scene_.vertices.size()}, scene_.wires);
    if (json_.failed()) return;
    pairs(document, "wires_on", {scene_.wires.size(), scene_.surfaces.size()}, scene_.wires_on);
    if (json_.failed()) return;
    const Json* camera = json_.optional_field(document, "camera", "");
    if (camera == nullptr) {
      scene_.camera = default_poly_camera(scene_);
      return;
    }
    if (const Json* perspective = json_.optional_field(*camera, "perspective", "camera"))
      scene_.camera.perspective = json_.boolean(*perspective, "camera.perspective");
    constexpr std::int64_t largest_direction = (1 << 15) - 1;
    scene_.camera.eye = camera_point(*camera, "eye", largest);
    scene_.camera.forward = camera_point(*camera, "forward", largest_direction);
    scene_.camera.right = camera_point(*camera, "right", largest_direction);
    scene_.camera.up = camera_point(*camera, "up", largest_direction);
  }

  [[nodiscard]] bool finite() const {
    return std::all_of(scene_.vertices.begin(), scene_.vertices.end(), [&](const PolyPoint& p) {
      return std::isfinite(file_coordinate(scene_, p, 0)) && std::isfinite(file_coordinate(scene_, p, 1)) &&
             std::isfinite(file_coordinate(scene_, p, 2));
    });
  }

  base::JsonReader json_;
  PolyScene scene_;
};

}  // namespace

base::Result<PolyScene> poly_scene_of(const Json& document, std::string_view source) {
  return PolyReader(source).run(document);
}

base::Result<PolyScene> read_poly_json(std::string_view json, std::string_view source) {
  const auto document = base::parse_json(json, source);
  if (!document) return document.error();
  return poly_scene_of(*document, source);
}

bool is_poly_document(const Json& document) {
  return document.find("bodies") != nullptr;
}

bool is_poly_json(std::string_view text) {
  const auto document = base::parse_json(text, "");
  return document && is_poly_document(*document);
}

}  // namespace sightline::scene
