#include "host/scene/read/cell_scene.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "host/base/file.hpp"
#include "host/base/json_reader.hpp"
#include "host/scene/check/cell_scene.hpp"
#include "host/scene/read/builtin.hpp"
#include "host/scene/read/json_documents.hpp"

namespace sightline::scene {
namespace {

using base::Json;
using geometry::Box;
using geometry::Point;
using geometry::Rectangle;
using geometry::Span;

constexpr std::size_t longest_name = 40;
constexpr std::uintmax_t largest_file = std::uintmax_t{64} << 20;

// What a scene of cells is made of, read with its place in the document.
class Reader : public base::JsonReader {
 public:
  using JsonReader::JsonReader;

  // A null value stands for a member that is missing.
  const Json& member(const Json& object, const char* name, const std::string& place) {
    static const Json nothing;
    const Json* const found = field(object, name, place);
    return found != nullptr ? *found : nothing;
  }

  std::int32_t coordinate(const Json& value, const std::string& place) {
    constexpr std::int64_t largest = geometry::coordinate_limit - 1;
    return static_cast<std::int32_t>(integer(value, place, -largest, largest));
  }

  Point point(const Json& value, const std::string& place) {
    Point result{};
    if (!array(value, place, 3)) return result;
    for (std::size_t a = 0; a < 3; ++a) result[a] = coordinate(value[a], base::indexed(place, a));
    return result;
  }

  Box box(const Json& value, const std::string& place) {
    if (!array(value, place, 2)) return {};
    return {point(value[0], base::indexed(place, 0)), point(value[1], base::indexed(place, 1))};
  }

  std::array<Span, 2> sides(const Json& value, const std::string& place) {
    std::array<Span, 2> result{};
    if (!array(value, place, 2)) return result;
    for (std::size_t s = 0; s < 2; ++s) {
      const std::string here = base::indexed(place, s);
      if (!array(value[s], here, 2)) return result;
      result[s] = {coordinate(value[s][0], base::indexed(here, 0)),
                   coordinate(value[s][1], base::indexed(here, 1))};
    }
    return result;
  }

  std::size_t axis(const Json& value, const std::string& place) {
    return static_cast<std::size_t>(integer(value, place, 0, 2));
  }

  Rectangle wall(const Json& value, const std::string& place) {
    if (!array(value, place, 3)) return {};
    return {axis(value[0], base::indexed(place, 0)), coordinate(value[1], base::indexed(place, 1)),
            sides(value[2], base::indexed(place, 2))};
  }

  RingVector ring_vector(const Json& value, const std::string& place) {
    RingVector result;
    if (!array(value, place, 3)) return result;
    result.actual = integer(value[0], base::indexed(place, 0), 0, 1) == 1;
    result.axis = ring_axis(value[1], base::indexed(place, 1));
    constexpr std::int64_t widest = 2 * geometry::coordinate_limit;
    result.magnitude = static_cast<std::int32_t>(integer(value[2], base::indexed(place, 2), -widest, widest));
    return result;
  }

  Opening opening(const Json& value, const std::string& place) {
    Opening result;
    const Json& cells = member(value, "cells", place);
    if (!array(cells, place + ".cells", 2)) return result;
    for (std::size_t s = 0; s < 2; ++s) {
      constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
      result.cells[s] =
          static_cast<std::size_t>(integer(cells[s], base::indexed(place + ".cells", s), 0, most));
    }
    result.place = {axis(member(value, "axis", place), place + ".axis"),
                    coordinate(member(value, "c", place), place + ".c"),
                    sides(member(value, "rect", place), place + ".rect")};
    result.ring = list<Point>(member(value, "ring", place), place + ".ring", &Reader::point);
    result.vectors =
        list<RingVector>(member(value, "vectors", place), place + ".vectors", &Reader::ring_vector);
    return result;
  }

  Line line(const Json& value, const std::string& place) {
    const Box ends = box(value, place);
    return {ends.low, ends.high};
  }

  template <class T>
  std::vector<T> list(const Json& value, const std::string& place,
                      T (Reader::*read)(const Json&, const std::string&)) {
    std::vector<T> result;
    if (!array(value, place)) return result;
    result.reserve(value.size());
    for (std::size_t i = 0; i < value.size() && !failed(); ++i) {
      result.push_back((this->*read)(value[i], base::indexed(place, i)));
    }
    return result;
  }

 private:
  std::size_t ring_axis(const Json& value, const std::string& place) {
    if (failed()) return 0;
    const std::string* const text = value.text();
    if (text != nullptr && text->size() == 1 && (*text)[0] >= 'i' && (*text)[0] <= 'k') {
      return static_cast<std::size_t>((*text)[0] - 'i');
    }
    expected(R"("i", "j" or "k")", value, place);
    return 0;
  }
};

CellScene read_fields(const Json& document, Reader& reader) {
  CellScene scene;
  scene.name = reader.name(reader.member(document, "name", ""), "name", 1, longest_name);
  scene.outer = reader.box(reader.member(document, "outer", ""), "outer");
  scene.solids = reader.list<Box>(reader.member(document, "solids", ""), "solids", &Reader::box);
  scene.walls = reader.list<Rectangle>(reader.member(document, "walls", ""), "walls", &Reader::wall);
  scene.default_view = reader.point(reader.member(document, "default_view", ""), "default_view");
  const auto boxes = reader.list<Box>(reader.member(document, "cells", ""), "cells", &Reader::box);
  scene.openings =
      reader.list<Opening>(reader.member(document, "openings", ""), "openings", &Reader::opening);
  const Json& lines = reader.member(document, "cell_lines", "");
  if (!reader.array(lines, "cell_lines", boxes.size())) return scene;
  for (std::size_t c = 0; c < boxes.size() && !reader.failed(); ++c) {
    scene.cells.push_back(
        {boxes[c], reader.list<Line>(lines[c], base::indexed("cell_lines", c), &Reader::line)});
  }
  return scene;
}

base::Result<std::string> file_text(const std::string& file) {
  const auto cannot = [&](const std::string& why) { return base::Error{file, "", why}; };
  const base::FileStatus status = base::file_status(file);
  if (status.kind == base::FileStatus::Kind::none) {
    std::string names;
    for (const std::string_view name : builtin_scene_names())
      names += (names.empty() ? "" : ", ") + std::string(name);
    return cannot("no such file, and not a built-in scene (" + names + ")");
  }
  if (status.kind == base::FileStatus::Kind::other)
    return cannot("expected a file, found something else, such as a directory");
  if (!status.error.empty() || status.size > largest_file)
    return cannot(!status.error.empty() ? status.error : "expected at most 64 MiB");
  const auto bytes = base::read_file(file);
  if (!bytes) return cannot("cannot be read");
  return std::string(bytes->begin(), bytes->end());
}

}  // namespace

base::Result<CellScene> cell_scene_of(const Json& document, std::string_view source) {
  Reader reader{std::string(source)};
  CellScene scene = read_fields(document, reader);
  if (reader.failed()) return reader.error();
  return scene;
}

base::Result<CellScene> read_cell_scene(std::string_view json, std::string_view source) {
  const auto document = base::parse_json(json, source);
  if (!document) return document.error();
  return cell_scene_of(*document, source);
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
  if (const auto builtin = builtin_scene_text(name_or_file)) {
    const auto models = builtin_model_names();
    if (std::find(models.begin(), models.end(), name_or_file) != models.end())
      return base::Error{name_or_file, "", "found a model of polyhedra, expected a scene of cells"};
    return read_possible_cell_scene(*builtin, name_or_file);
  }
  const auto text = file_text(name_or_file);
  if (!text) return text.error();
  return read_possible_cell_scene(*text, name_or_file);
}

}  // namespace sightline::scene
