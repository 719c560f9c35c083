// See poly_json.hpp.
#include "host/scene/read/poly_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "host/base/result.hpp"
#include "host/scene/check/poly_shells.hpp"
#include "host/scene/read/json_text.hpp"
#include "host/scene/read/poly_import.hpp"
#include "host/scene/read/poly_quantise.hpp"

namespace sightline::scene {
namespace {

using nlohmann::json;

constexpr std::size_t longest_scene_name = 200;
constexpr std::int64_t largest_origin = std::int64_t{1} << 30;

// Remembers the first thing that is not as expected; the rest of the document is then passed over.
class PolyReader {
 public:
  explicit PolyReader(std::string_view source) : source_(source) {}

  base::Result<PolyScene> run(const json& document) {
    if (!document.is_object()) expected("an object", document, "");
    read(document);
    if (error_) return *error_;
    return std::move(scene_);
  }

 private:
  void expected(const std::string& what, const json& found, const std::string& place) {
    if (!error_) error_ = base::Error{source_, place, "expected " + what + ", found " + describe_json(found)};
  }

  // Null if the field is missing; that is an error if it is required.
  const json* field(const json& object, const char* name, const std::string& place, bool required) {
    if (error_) return nullptr;
    if (!object.is_object()) {
      expected("an object", object, place);
      return nullptr;
    }
    const auto found = object.find(name);
    if (found != object.end()) return &*found;
    if (required)
      error_ = base::Error{source_, place, std::string("expected a field \"") + name + "\", found none"};
    return nullptr;
  }

  bool is_array(const json& value, const std::string& place, std::optional<std::size_t> size = std::nullopt) {
    if (error_) return false;
    if (value.is_array() && (!size || value.size() == *size)) return true;
    expected(size ? "an array of " + std::to_string(*size) : "an array", value, place);
    return false;
  }

  std::int64_t integer(const json& value, const std::string& place, std::int64_t low, std::int64_t high) {
    if (error_) return low;
    const bool fits = value.is_number_unsigned()
                          ? value.get<std::uint64_t>() <= static_cast<std::uint64_t>(high)
                          : value.is_number_integer() && value.get<std::int64_t>() <= high;
    if (fits && value.get<std::int64_t>() >= low) return value.get<std::int64_t>();
    expected("an integer " + std::to_string(low) + ".." + std::to_string(high), value, place);
    return low;
  }

  bool boolean(const json& value, const std::string& place) {
    if (!value.is_boolean()) expected("true or false", value, place);
    return value.is_boolean() && value.get<bool>();
  }

  std::string name(const json& value, const std::string& place) {
    const auto* text = value.get_ptr<const std::string*>();
    const auto printable = [](char c) { return c >= ' ' && c <= '~'; };
    if (text != nullptr && text->size() <= longest_scene_name &&
        std::all_of(text->begin(), text->end(), printable))
      return *text;
    expected("a string of up to " + std::to_string(longest_scene_name) + " printable ASCII characters", value,
             place);
    return {};
  }

  PolyPoint point(const json& value, const std::string& place, std::int64_t largest) {
    PolyPoint p{};
    if (!is_array(value, place, 3)) return p;
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = static_cast<std::int32_t>(integer(value[a], indexed(place, a), -largest, largest));
    return p;
  }

  PolyPoint camera_point(const json& camera, const char* which, std::int64_t largest) {
    const json* value = field(camera, which, "camera", true);
    return value != nullptr ? point(*value, std::string("camera.") + which, largest) : PolyPoint{};
  }

  std::vector<VertexIndex> ring(const json& value, const std::string& place) {
    std::vector<VertexIndex> result;
    if (!is_array(value, place)) return result;
    if (value.size() < 3) expected("an array of 3 or more", value, place);
    const auto last = static_cast<std::int64_t>(scene_.vertices.size()) - 1;
    for (std::size_t i = 0; i < value.size() && !error_; ++i)
      result.push_back(static_cast<VertexIndex>(integer(value[i], indexed(place, i), 0, last)));
    return result;
  }

  PolyFace face(const json& value, const std::string& place) {
    PolyFace result;
    if (value.is_array()) {
      result.outline = ring(value, place);
      return result;
    }
    if (const json* outline = field(value, "outline", place, true))
      result.outline = ring(*outline, place + ".outline");
    const json* holes = error_ ? nullptr : field(value, "holes", place, false);
    if (holes == nullptr || !is_array(*holes, place + ".holes")) return result;
    for (std::size_t h = 0; h < holes->size() && !error_; ++h)
      result.holes.push_back(ring((*holes)[h], indexed(place + ".holes", h)));
    return result;
  }

  PolyBody body(const json& value, const std::string& place) {
    PolyBody result;
    const json* faces = field(value, "faces", place, true);
    if (faces == nullptr || !is_array(*faces, place + ".faces")) return result;
    for (std::size_t f = 0; f < faces->size() && !error_; ++f)
      result.faces.push_back(face((*faces)[f], indexed(place + ".faces", f)));
    if (const json* text = field(value, "name", place, false)) result.name = name(*text, place + ".name");
    const json* sheet = field(value, "sheet", place, false);
    result.sheet = sheet != nullptr ? boolean(*sheet, place + ".sheet")
                                    : result.faces.empty() || !is_closed(face_edges(result));
    return result;
  }

  void read(const json& document) {
    constexpr std::int64_t largest = poly_coordinate_limit - 1;
    if (const json* text = field(document, "name", "", false)) scene_.name = name(*text, "name");
    const json* step = field(document, "step", "", false);
    if (step != nullptr) {
      scene_.step = step->is_number() ? step->get<double>() : 0;
      if (!std::isnormal(scene_.step) || scene_.step < 0) expected("a number above 0", *step, "step");
    }
    if (const json* origin = field(document, "origin", "", false))
      scene_.origin = point(*origin, "origin", largest_origin);
    const json* vertices = field(document, "vertices", "", true);
    if (vertices == nullptr || !is_array(*vertices, "vertices")) return;
    for (std::size_t v = 0; v < vertices->size() && !error_; ++v)
      scene_.vertices.push_back(point((*vertices)[v], indexed("vertices", v), largest));
    if (step != nullptr && !finite()) expected("a step that leaves every coordinate finite", *step, "step");
    const json* bodies = field(document, "bodies", "", true);
    if (bodies == nullptr || !is_array(*bodies, "bodies")) return;
    for (std::size_t b = 0; b < bodies->size() && !error_; ++b)
      scene_.bodies.push_back(body((*bodies)[b], indexed("bodies", b)));
    if (error_) return;
    const json* camera = field(document, "camera", "", false);
    if (camera == nullptr) {
      scene_.camera = default_poly_camera(scene_);
      return;
    }
    if (const json* perspective = field(*camera, "perspective", "camera", false))
      scene_.camera.perspective = boolean(*perspective, "camera.perspective");
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

  std::string source_;
  std::optional<base::Error> error_;
  PolyScene scene_;
};

}  // namespace

base::Result<PolyScene> read_poly_json(std::string_view text, std::string_view source) {
  json document;
  try {
    document = json::parse(text);
  } catch (const json::exception& error) {
    return json_syntax_error(source, error.what());
  }
  return PolyReader(source).run(document);
}

bool is_poly_json(std::string_view text) {
  const json document = json::parse(text, nullptr, false);
  return document.is_object() && document.contains("bodies");
}

}  // namespace sightline::scene
