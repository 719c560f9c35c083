#include "host/scene/read/cell_scene.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "host/base/result.hpp"
#include "host/scene/check/cell_scene.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/json_text.hpp"

namespace sightline::scene {
namespace {

using geometry::Box;
using geometry::Point;
using geometry::Rectangle;
using geometry::Span;
using nlohmann::json;

constexpr std::size_t longest_name = 40;
constexpr std::uintmax_t largest_file = std::uintmax_t{64} << 20;

// Reads values at places ("openings[3].rect"), remembering the first thing that is not as expected. After an
// error every reader returns a default and the rest of the document is passed over.
class Reader {
 public:
  explicit Reader(std::string_view source) : source_(source) {}

  [[nodiscard]] bool failed() const { return error_.has_value(); }
  [[nodiscard]] const base::Error& error() const { return *error_; }

  void expected(const std::string& what, const json& found, const std::string& place) {
    fail(place, "expected " + what + ", found " + describe_json(found));
  }

  // Field of an object; a null value stands for one that is missing.
  const json& field(const json& object, const char* name, const std::string& place) {
    static const json nothing;
    if (failed()) return nothing;
    if (!object.is_object()) {
      expected("an object", object, place);
      return nothing;
    }
    const auto found = object.find(name);
    if (found != object.end()) return *found;
    fail(place, std::string("expected a field \"") + name + "\", found none");
    return nothing;
  }

  std::int64_t integer(const json& value, const std::string& place, std::int64_t low, std::int64_t high) {
    if (failed()) return low;
    const bool fits = value.is_number_unsigned()
                          ? value.get<std::uint64_t>() <= static_cast<std::uint64_t>(high)
                          : value.is_number_integer() && value.get<std::int64_t>() <= high;
    if (fits && value.get<std::int64_t>() >= low) return value.get<std::int64_t>();
    expected("an integer " + std::to_string(low) + ".." + std::to_string(high), value, place);
    return low;
  }

  std::int32_t coordinate(const json& value, const std::string& place) {
    constexpr std::int64_t largest = geometry::coordinate_limit - 1;
    return static_cast<std::int32_t>(integer(value, place, -largest, largest));
  }

  // An array, of `size` elements if given.
  bool array(const json& value, const std::string& place, std::optional<std::size_t> size = std::nullopt) {
    if (failed()) return false;
    if (value.is_array() && (!size || value.size() == *size)) return true;
    expected(size ? "an array of " + std::to_string(*size) : "an array", value, place);
    return false;
  }

  Point point(const json& value, const std::string& place) {
    Point result{};
    if (!array(value, place, 3)) return result;
    for (std::size_t a = 0; a < 3; ++a) result[a] = coordinate(value[a], indexed(place, a));
    return result;
  }

  Box box(const json& value, const std::string& place) {
    if (!array(value, place, 2)) return {};
    return {point(value[0], indexed(place, 0)), point(value[1], indexed(place, 1))};
  }

  std::array<Span, 2> sides(const json& value, const std::string& place) {
    std::array<Span, 2> result{};
    if (!array(value, place, 2)) return result;
    for (std::size_t s = 0; s < 2; ++s) {
      const std::string here = indexed(place, s);
      if (!array(value[s], here, 2)) return result;
      result[s] = {coordinate(value[s][0], indexed(here, 0)), coordinate(value[s][1], indexed(here, 1))};
    }
    return result;
  }

  std::size_t axis(const json& value, const std::string& place) {
    return static_cast<std::size_t>(integer(value, place, 0, 2));
  }

  std::string name(const json& value, const std::string& place) {
    if (failed()) return {};
    const auto* text = value.get_ptr<const std::string*>();
    const auto printable = [](char c) { return c >= ' ' && c <= '~'; };
    if (text && !text->empty() && text->size() <= longest_name &&
        std::all_of(text->begin(), text->end(), printable)) {
      return *text;
    }
    expected("a string of 1 to " + std::to_string(longest_name) + " printable ASCII characters", value,
             place);
    return {};
  }

  Rectangle wall(const json& value, const std::string& place) {
    if (!array(value, place, 3)) return {};
    return {axis(value[0], indexed(place, 0)), coordinate(value[1], indexed(place, 1)),
            sides(value[2], indexed(place, 2))};
  }

  RingVector ring_vector(const json& value, const std::string& place) {
    RingVector result;
    if (!array(value, place, 3)) return result;
    result.actual = integer(value[0], indexed(place, 0), 0, 1) == 1;
    result.axis = ring_axis(value[1], indexed(place, 1));
    constexpr std::int64_t widest = 2 * geometry::coordinate_limit;
    result.magnitude = static_cast<std::int32_t>(integer(value[2], indexed(place, 2), -widest, widest));
    return result;
  }

  Opening opening(const json& value, const std::string& place) {
    Opening result;
    const json& cells = field(value, "cells", place);
    if (!array(cells, place + ".cells", 2)) return result;
    for (std::size_t s = 0; s < 2; ++s) {
      constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
      result.cells[s] = static_cast<std::size_t>(integer(cells[s], indexed(place + ".cells", s), 0, most));
    }
    result.place = {axis(field(value, "axis", place), place + ".axis"),
                    coordinate(field(value, "c", place), place + ".c"),
                    sides(field(value, "rect", place), place + ".rect")};
    result.ring = list<Point>(field(value, "ring", place), place + ".ring", &Reader::point);
    result.vectors =
        list<RingVector>(field(value, "vectors", place), place + ".vectors", &Reader::ring_vector);
    return result;
  }

  Line line(const json& value, const std::string& place) {
    const Box ends = box(value, place);
    return {ends.low, ends.high};
  }

  template <class T>
  std::vector<T> list(const json& value, const std::string& place,
                      T (Reader::*read)(const json&, const std::string&)) {
    std::vector<T> result;
    if (!array(value, place)) return result;
    result.reserve(value.size());
    for (std::size_t i = 0; i < value.size() && !failed(); ++i) {
      result.push_back((this->*read)(value[i], indexed(place, i)));
    }
    return result;
  }

 private:
  void fail(const std::string& place, const std::string& cause) {
    if (!error_) error_ = base::Error{source_, place, cause};
  }

  std::size_t ring_axis(const json& value, const std::string& place) {
    if (failed()) return 0;
    const auto* text = value.get_ptr<const std::string*>();
    if (text && text->size() == 1 && (*text)[0] >= 'i' && (*text)[0] <= 'k') {
      return static_cast<std::size_t>((*text)[0] - 'i');
    }
    expected(R"("i", "j" or "k")", value, place);
    return 0;
  }

  std::string source_;
  std::optional<base::Error> error_;
};

CellScene read_fields(const json& document, Reader& reader) {
  CellScene scene;
  scene.name = reader.name(reader.field(document, "name", ""), "name");
  scene.outer = reader.box(reader.field(document, "outer", ""), "outer");
  scene.solids = reader.list<Box>(reader.field(document, "solids", ""), "solids", &Reader::box);
  scene.walls = reader.list<Rectangle>(reader.field(document, "walls", ""), "walls", &Reader::wall);
  scene.default_view = reader.point(reader.field(document, "default_view", ""), "default_view");
  const auto boxes = reader.list<Box>(reader.field(document, "cells", ""), "cells", &Reader::box);
  scene.openings = reader.list<Opening>(reader.field(document, "openings", ""), "openings", &Reader::opening);
  const json& lines = reader.field(document, "cell_lines", "");
  if (!reader.array(lines, "cell_lines", boxes.size())) return scene;
  for (std::size_t c = 0; c < boxes.size() && !reader.failed(); ++c) {
    scene.cells.push_back({boxes[c], reader.list<Line>(lines[c], indexed("cell_lines", c), &Reader::line)});
  }
  return scene;
}

base::Result<std::string> file_text(const std::string& file) {
  const auto cannot = [&](const std::string& why) { return base::Error{file, "", why}; };
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) {
    std::string names;
    for (const std::string_view name : builtin_scene_names())
      names += (names.empty() ? "" : ", ") + std::string(name);
    return cannot("no such file, and not a built-in scene (" + names + ")");
  }
  if (!std::filesystem::is_regular_file(status))
    return cannot("expected a file, found something else, such as a directory");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error || size > largest_file) return cannot(error ? error.message() : "expected at most 64 MiB");
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) return cannot("cannot be read");
  return text;
}

}  // namespace

base::Result<CellScene> read_cell_scene(std::string_view json_text, std::string_view source) {
  json document;
  try {
    document = json::parse(json_text);
  } catch (const json::exception& error) {
    return json_syntax_error(source, error.what());
  }
  Reader reader(source);
  CellScene scene = read_fields(document, reader);
  if (reader.failed()) return reader.error();
  return scene;
}

base::Result<CellScene> read_possible_cell_scene(std::string_view json_text, const std::string& source) {
  auto result = read_cell_scene(json_text, source);
  if (result) {
    auto errors = check_scene(*result);
    if (!errors.empty()) {
      base::Error first = std::move(errors.front());
      first.file = source;
      if (errors.size() > 1) first.found += " (the first of " + std::to_string(errors.size()) + " errors)";
      return first;
    }
  }
  return result;
}

base::Result<CellScene> load_cell_scene(const std::string& name_or_file) {
  if (const auto builtin = builtin_scene_text(name_or_file))
    return read_possible_cell_scene(*builtin, name_or_file);
  const auto text = file_text(name_or_file);
  if (!text) return text.error();
  return read_possible_cell_scene(*text, name_or_file);
}

}  // namespace sightline::scene
