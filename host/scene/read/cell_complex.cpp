// See cell_complex_file.hpp.
#include "host/scene/check/cell_complex.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/base/json_reader.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/read/cell_complex_file.hpp"
#include "host/scene/read/json_documents.hpp"
#include "host/scene/read/poly_json.hpp"

namespace sightline::scene {
namespace {

using base::Json;

constexpr std::string_view schema = "sightline/cell-complex/2";
constexpr std::string_view any_schema = "sightline/cell-complex/";
// What planes of a scene have (poly_coordinate_limit): products of differences, and a coordinate more.
constexpr std::int64_t largest_normal = std::int64_t{1} << 39;
constexpr std::int64_t largest_offset = std::int64_t{1} << 59;
constexpr std::int64_t largest_part = std::int64_t{1} << 60;  // of a place on an edge

bool is_text(const Json& value, std::string_view expected) {
  return value.text() != nullptr && *value.text() == expected;
}

// Reads the parts of a file one after the other; nothing more once there are errors.
class ComplexReader {
 public:
  explicit ComplexReader(std::string_view source) : source_(source), json_(source_) {}

  CheckedCellComplex run(const Json& document) {
    if (!document.is_object()) json_.expected("an object", document, "");
    check_schema(document);
    read_scene(document);
    read(document);
    if (!failed()) fail(check_complex(file_.decomposition.complex, file_.scene));
    if (json_.failed()) errors_.insert(errors_.begin(), json_.error());
    if (failed()) return std::move(errors_);
    return std::move(file_);
  }

 private:
  [[nodiscard]] bool failed() const { return json_.failed() || !errors_.empty(); }
  // What follows from the first error is none of the file's.
  void fail(std::vector<base::Error> errors) {
    if (failed()) return;
    errors_ = std::move(errors);
    for (base::Error& error : errors_) error.file = source_;
  }
  // Null if it is missing, which is an error.
  const Json* field(const Json& object, const char* name, const std::string& place) {
    return failed() ? nullptr : json_.field(object, name, place);
  }
  bool is_array(const Json& value, const std::string& place, std::optional<std::size_t> size = std::nullopt) {
    return !failed() && json_.array(value, place, size);
  }
  std::int64_t integer(const Json& value, const std::string& place, std::int64_t low, std::int64_t high) {
    return failed() ? low : json_.integer(value, place, low, high);
  }
  std::uint32_t index(const Json& value, const std::string& place, std::size_t size) {
    return static_cast<std::uint32_t>(integer(value, place, 0, static_cast<std::int64_t>(size) - 1));
  }
  // Of every element of an array that is a field of `object`.
  template <class Each>
  void each(const Json& object, const char* name, const std::string& place, const Each& each_one) {
    const Json* const list = field(object, name, place);
    const std::string path = place.empty() ? std::string(name) : place + "." + name;
    if (list == nullptr || !is_array(*list, path)) return;
    for (std::size_t i = 0; i < list->size() && !failed(); ++i) each_one((*list)[i], base::indexed(path, i));
  }

  void check_schema(const Json& document) {
    const Json* const found = field(document, "schema", "");
    if (found != nullptr && !is_text(*found, schema))
      json_.expected('"' + std::string(schema) + '"', *found, "schema");
  }

  void read_scene(const Json& document) {
    const Json* const polyhedra = field(document, "polyhedra", "");
    if (polyhedra == nullptr) return;
    auto scene = poly_scene_of(*polyhedra, source_);
    if (!scene) return fail({in_polyhedra(std::move(scene.error()))});
    file_.scene = std::move(*scene);
    auto errors = check_poly_scene(file_.scene);
    for (base::Error& error : errors) error = in_polyhedra(std::move(error));
    fail(std::move(errors));
  }
  static base::Error in_polyhedra(base::Error error) {
    error.place = error.place.empty() ? "polyhedra" : "polyhedra: " + error.place;
    return error;
  }

  void read(const Json& document) {
    CellComplex& complex = file_.decomposition.complex;
    complex.vertices = file_.scene.vertices;
    if (const Json* const method = field(document, "method", "")) {
      const bool bsp = is_text(*method, "bsp");
      if (!bsp && !is_text(*method, "grid")) json_.expected("\"grid\" or \"bsp\"", *method, "method");
      file_.decomposition.method = bsp ? DecompositionMethod::bsp : DecompositionMethod::grid;
    }
    const Json* const outer = field(document, "outer", "");
    if (outer == nullptr || !is_array(*outer, "outer", 2)) return;
    complex.outer = {point((*outer)[0], "outer[0]"), point((*outer)[1], "outer[1]")};
    for (std::size_t a = 0; a < 3; ++a)
      if (!failed() && complex.outer.low[a] >= complex.outer.high[a])
        json_.fail("outer", "expected a box with an inside");
    each(document, "edges", "", [&](const Json& value, const std::string& place) {
      if (!is_array(value, place, 2)) return;
      complex.edges.push_back({index(value[0], base::indexed(place, 0), complex.vertices.size()),
                               index(value[1], base::indexed(place, 1), complex.vertices.size())});
    });
    each(document, "planes", "",
         [&](const Json& value, const std::string& place) { read_plane(value, place); });
    const Json* const openings = field(document, "openings", "");
    if (openings == nullptr || !is_array(*openings, "openings")) return;
    each(document, "cells", "",
         [&](const Json& value, const std::string& place) { read_cell(value, place, openings->size()); });
    each(document, "openings", "",
         [&](const Json& value, const std::string& place) { read_opening(value, place); });
  }

  geometry::Point point(const Json& value, const std::string& place) {
    geometry::Point p{};
    if (!is_array(value, place, 3)) return p;
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = static_cast<std::int32_t>(
          integer(value[a], base::indexed(place, a), -poly_coordinate_limit, poly_coordinate_limit));
    return p;
  }
  void read_plane(const Json& value, const std::string& place) {
    if (!is_array(value, place, 4)) return;
    geometry::Plane plane;
    for (std::size_t a = 0; a < 3; ++a)
      plane.normal[a] = integer(value[a], base::indexed(place, a), -largest_normal, largest_normal);
    plane.offset = integer(value[3], base::indexed(place, 3), -largest_offset, largest_offset);
    file_.decomposition.complex.planes.push_back(plane);
  }
  // Appends to `halves`; returns how many.
  std::uint32_t read_halves(const Json& object, const char* name, const std::string& place,
                            std::vector<HalfSpace>& halves) {
    const std::size_t before = halves.size();
    const auto planes = static_cast<std::int64_t>(file_.decomposition.complex.planes.size());
    each(object, name, place, [&](const Json& value, const std::string& where) {
      const std::int64_t half = integer(value, where, -planes, planes - 1);
      halves.push_back({static_cast<std::uint32_t>(half < 0 ? -1 - half : half), half < 0});
    });
    return static_cast<std::uint32_t>(halves.size() - before);
  }
  geometry::Rational place_on_edge(const Json& value, std::size_t first, const std::string& place) {
    const std::int64_t numerator = integer(value[first], base::indexed(place, first), 0, largest_part);
    return {numerator, integer(value[first + 1], base::indexed(place, first + 1), 1, largest_part)};
  }
  void read_cell(const Json& value, const std::string& place, std::size_t openings) {
    CellComplex& complex = file_.decomposition.complex;
    ComplexCell cell;
    cell.first_bound = static_cast<std::uint32_t>(complex.bounds.size());
    cell.first_line = static_cast<std::uint32_t>(complex.lines.size());
    cell.first_opening = static_cast<std::uint32_t>(complex.opening_numbers.size());
    cell.bound_count = read_halves(value, "bounds", place, complex.bounds);
    each(value, "lines", place, [&](const Json& line, const std::string& where) {
      if (!is_array(line, where, 5)) return;
      const std::uint32_t edge = index(line[0], base::indexed(where, 0), complex.edges.size());
      const geometry::Rational low = place_on_edge(line, 1, where);
      complex.lines.push_back({edge, low, place_on_edge(line, 3, where)});
    });
    each(value, "openings", place, [&](const Json& number, const std::string& where) {
      complex.opening_numbers.push_back(index(number, where, openings));
    });
    cell.line_count = static_cast<std::uint32_t>(complex.lines.size()) - cell.first_line;
    cell.opening_count = static_cast<std::uint32_t>(complex.opening_numbers.size()) - cell.first_opening;
    complex.cells.push_back(cell);
  }
  void read_opening(const Json& value, const std::string& place) {
    CellComplex& complex = file_.decomposition.complex;
    ComplexOpening opening;
    const Json* const cells = field(value, "cells", place);
    if (cells == nullptr || !is_array(*cells, place + ".cells", 2)) return;
    for (std::size_t side = 0; side < 2; ++side)
      opening.cells[side] =
          (*cells)[side].is_null()
              ? outside
              : index((*cells)[side], base::indexed(place + ".cells", side), complex.cells.size());
    if (const Json* const plane = field(value, "plane", place))
      opening.plane = index(*plane, place + ".plane", complex.planes.size());
    opening.first_side = static_cast<std::uint32_t>(complex.sides.size());
    opening.side_count = read_halves(value, "sides", place, complex.sides);
    complex.openings.push_back(opening);
  }

  std::string source_;
  base::JsonReader json_;
  std::vector<base::Error> errors_;
  CellComplexFile file_;
};

}  // namespace

CheckedCellComplex cell_complex_of(const Json& document, std::string_view source) {
  return ComplexReader(source).run(document);
}

CheckedCellComplex check_cell_complex(std::string_view json, std::string_view source) {
  const auto document = base::parse_json(json, source);
  if (!document) return std::vector{document.error()};
  return cell_complex_of(*document, source);
}

base::Result<CellComplexFile> read_cell_complex(std::string_view text, std::string_view source) {
  auto checked = check_cell_complex(text, source);
  if (!checked) return std::move(checked.error().front());
  return std::move(*checked);
}

bool is_cell_complex(std::string_view text) {
  constexpr std::size_t beginning = 100;
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  return start != std::string_view::npos && text[start] == '{' &&
         text.substr(start, beginning).find(any_schema) != std::string_view::npos;
}

}  // namespace sightline::scene
