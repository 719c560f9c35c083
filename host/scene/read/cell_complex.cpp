// See cell_complex_file.hpp.
#include "host/scene/check/cell_complex.hpp"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/check/poly_scene.hpp"
#include "host/scene/read/cell_complex_file.hpp"
#include "host/scene/read/json_text.hpp"
#include "host/scene/read/poly_json.hpp"

namespace sightline::scene {
namespace {

using nlohmann::json;

constexpr std::string_view schema = "sightline/cell-complex/2";
constexpr std::string_view any_schema = "sightline/cell-complex/";
// What planes of a scene have (poly_coordinate_limit): products of differences, and a coordinate more.
constexpr std::int64_t largest_normal = std::int64_t{1} << 39;
constexpr std::int64_t largest_offset = std::int64_t{1} << 59;
constexpr int deepest_polyhedra = 16;                         // holes, the deepest, are nested 6 levels
constexpr std::int64_t largest_part = std::int64_t{1} << 60;  // of a place on an edge

// Writing a document goes down as deep as it is nested, on the stack.
bool nested_within(const json& value, int levels) {
  return !value.is_structured() ||
         (levels > 0 && std::all_of(value.begin(), value.end(), [levels](const json& inner) {
            return nested_within(inner, levels - 1);
          }));
}

// Remembers the first thing that is not as expected; the rest of the document is then passed over.
class ComplexReader {
 public:
  explicit ComplexReader(std::string_view source) : source_(source) {}

  CheckedCellComplex run(const json& document) {
    if (!document.is_object()) expected("an object", document, "");
    check_schema(document);
    read_scene(document);
    read(document);
    check();
    if (failed()) return std::move(errors_);
    return std::move(file_);
  }

 private:
  [[nodiscard]] bool failed() const { return !errors_.empty(); }
  // What follows from the first error is none of the file's.
  void fail(std::vector<base::Error> errors) {
    if (failed()) return;
    errors_ = std::move(errors);
    for (base::Error& error : errors_) error.file = source_;
  }
  void fail(base::Error error) { fail(std::vector{std::move(error)}); }
  void expected(const std::string& what, const json& found, const std::string& place) {
    fail({"", place, "expected " + what + ", found " + describe_json(found)});
  }

  // Null if it is missing, which is an error.
  const json* field(const json& object, const char* name, const std::string& place) {
    if (failed()) return nullptr;
    if (!object.is_object()) {
      expected("an object", object, place);
      return nullptr;
    }
    const auto found = object.find(name);
    if (found != object.end()) return &*found;
    fail({"", place, std::string("expected a field \"") + name + "\", found none"});
    return nullptr;
  }
  bool is_array(const json& value, const std::string& place, std::optional<std::size_t> size = std::nullopt) {
    if (failed()) return false;
    if (value.is_array() && (!size || value.size() == *size)) return true;
    expected(size ? "an array of " + std::to_string(*size) : "an array", value, place);
    return false;
  }
  std::int64_t integer(const json& value, const std::string& place, std::int64_t low, std::int64_t high) {
    if (failed()) return low;
    const bool fits =
        value.is_number_unsigned()
            ? value.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::max<std::int64_t>(high, 0))
            : value.is_number_integer() && value.get<std::int64_t>() <= high;
    if (fits && value.get<std::int64_t>() >= low && value.get<std::int64_t>() <= high)
      return value.get<std::int64_t>();
    expected("an integer " + std::to_string(low) + ".." + std::to_string(high), value, place);
    return low;
  }
  std::uint32_t index(const json& value, const std::string& place, std::size_t size) {
    return static_cast<std::uint32_t>(integer(value, place, 0, static_cast<std::int64_t>(size) - 1));
  }
  // Of every element of an array that is a field of `object`.
  template <class Each>
  void each(const json& object, const char* name, const std::string& place, const Each& each_one) {
    const json* const list = field(object, name, place);
    const std::string path = place.empty() ? std::string(name) : place + "." + name;
    if (list == nullptr || !is_array(*list, path)) return;
    for (std::size_t i = 0; i < list->size() && !failed(); ++i) each_one((*list)[i], indexed(path, i));
  }

  void check_schema(const json& document) {
    const json* const found = field(document, "schema", "");
    if (found != nullptr && *found != schema)
      fail({"", "schema", "expected \"" + std::string(schema) + "\", found " + describe_json(*found)});
  }

  void read_scene(const json& document) {
    const json* const polyhedra = field(document, "polyhedra", "");
    if (polyhedra == nullptr) return;
    if (!nested_within(*polyhedra, deepest_polyhedra))
      return fail({"", "polyhedra", "is nested deeper than any scene of polyhedra"});
    auto scene = read_poly_json(polyhedra->dump(-1, ' ', false, json::error_handler_t::replace), source_);
    if (!scene) return fail(in_polyhedra(std::move(scene.error())));
    file_.scene = std::move(*scene);
    auto errors = check_poly_scene(file_.scene);
    for (base::Error& error : errors) error = in_polyhedra(std::move(error));
    fail(std::move(errors));
  }
  static base::Error in_polyhedra(base::Error error) {
    error.place = error.place.empty() ? "polyhedra" : "polyhedra: " + error.place;
    return error;
  }

  void read(const json& document) {
    CellComplex& complex = file_.compartments.complex;
    complex.vertices = file_.scene.vertices;
    if (const json* const method = field(document, "method", "")) {
      if (*method != "grid" && *method != "bsp") expected("\"grid\" or \"bsp\"", *method, "method");
      file_.compartments.method = *method == "bsp" ? CompartmentMethod::bsp : CompartmentMethod::grid;
    }
    const json* const outer = field(document, "outer", "");
    if (outer == nullptr || !is_array(*outer, "outer", 2)) return;
    complex.outer = {point((*outer)[0], "outer[0]"), point((*outer)[1], "outer[1]")};
    for (std::size_t a = 0; a < 3; ++a)
      if (!failed() && complex.outer.low[a] >= complex.outer.high[a])
        fail({"", "outer", "expected a box with an inside"});
    each(document, "edges", "", [&](const json& value, const std::string& place) {
      if (!is_array(value, place, 2)) return;
      complex.edges.push_back({index(value[0], indexed(place, 0), complex.vertices.size()),
                               index(value[1], indexed(place, 1), complex.vertices.size())});
    });
    each(document, "planes", "",
         [&](const json& value, const std::string& place) { read_plane(value, place); });
    const json* const openings = field(document, "openings", "");
    if (openings == nullptr || !is_array(*openings, "openings")) return;
    each(document, "cells", "",
         [&](const json& value, const std::string& place) { read_cell(value, place, openings->size()); });
    each(document, "openings", "",
         [&](const json& value, const std::string& place) { read_opening(value, place); });
  }

  geometry::Point point(const json& value, const std::string& place) {
    geometry::Point p{};
    if (!is_array(value, place, 3)) return p;
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = static_cast<std::int32_t>(
          integer(value[a], indexed(place, a), -poly_coordinate_limit, poly_coordinate_limit));
    return p;
  }
  void read_plane(const json& value, const std::string& place) {
    if (!is_array(value, place, 4)) return;
    geometry::Plane plane;
    for (std::size_t a = 0; a < 3; ++a)
      plane.normal[a] = integer(value[a], indexed(place, a), -largest_normal, largest_normal);
    plane.offset = integer(value[3], indexed(place, 3), -largest_offset, largest_offset);
    file_.compartments.complex.planes.push_back(plane);
  }
  // Appends to `halves`; returns how many.
  std::uint32_t read_halves(const json& object, const char* name, const std::string& place,
                            std::vector<HalfSpace>& halves) {
    const std::size_t before = halves.size();
    const auto planes = static_cast<std::int64_t>(file_.compartments.complex.planes.size());
    each(object, name, place, [&](const json& value, const std::string& where) {
      const std::int64_t half = integer(value, where, -planes, planes - 1);
      halves.push_back({static_cast<std::uint32_t>(half < 0 ? -1 - half : half), half < 0});
    });
    return static_cast<std::uint32_t>(halves.size() - before);
  }
  geometry::Rational place_on_edge(const json& value, std::size_t first, const std::string& place) {
    const std::int64_t numerator = integer(value[first], indexed(place, first), 0, largest_part);
    return {numerator, integer(value[first + 1], indexed(place, first + 1), 1, largest_part)};
  }
  void read_cell(const json& value, const std::string& place, std::size_t openings) {
    CellComplex& complex = file_.compartments.complex;
    ComplexCell cell;
    cell.first_bound = static_cast<std::uint32_t>(complex.bounds.size());
    cell.first_line = static_cast<std::uint32_t>(complex.lines.size());
    cell.first_opening = static_cast<std::uint32_t>(complex.opening_numbers.size());
    cell.bound_count = read_halves(value, "bounds", place, complex.bounds);
    each(value, "lines", place, [&](const json& line, const std::string& where) {
      if (!is_array(line, where, 5)) return;
      const std::uint32_t edge = index(line[0], indexed(where, 0), complex.edges.size());
      const geometry::Rational low = place_on_edge(line, 1, where);
      complex.lines.push_back({edge, low, place_on_edge(line, 3, where)});
    });
    each(value, "openings", place, [&](const json& number, const std::string& where) {
      complex.opening_numbers.push_back(index(number, where, openings));
    });
    cell.line_count = static_cast<std::uint32_t>(complex.lines.size()) - cell.first_line;
    cell.opening_count = static_cast<std::uint32_t>(complex.opening_numbers.size()) - cell.first_opening;
    complex.cells.push_back(cell);
  }
  void read_opening(const json& value, const std::string& place) {
    CellComplex& complex = file_.compartments.complex;
    ComplexOpening opening;
    const json* const cells = field(value, "cells", place);
    if (cells == nullptr || !is_array(*cells, place + ".cells", 2)) return;
    for (std::size_t side = 0; side < 2; ++side)
      opening.cells[side] = (*cells)[side].is_null() ? outside
                                                     : index((*cells)[side], indexed(place + ".cells", side),
                                                             complex.cells.size());
    if (const json* const plane = field(value, "plane", place))
      opening.plane = index(*plane, place + ".plane", complex.planes.size());
    opening.first_side = static_cast<std::uint32_t>(complex.sides.size());
    opening.side_count = read_halves(value, "sides", place, complex.sides);
    complex.openings.push_back(opening);
  }

  void check() {
    if (!failed()) fail(check_complex(file_.compartments.complex, file_.scene));
  }

  std::string source_;
  std::vector<base::Error> errors_;
  CellComplexFile file_;
};

}  // namespace

CheckedCellComplex check_cell_complex(std::string_view text, std::string_view source) {
  json document;
  try {
    document = json::parse(text);
  } catch (const json::exception& error) {
    return std::vector{json_syntax_error(source, error.what())};
  }
  return ComplexReader(source).run(document);
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
