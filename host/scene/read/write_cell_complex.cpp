// See cell_complex_file.hpp.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "host/scene/read/cell_complex_file.hpp"
#include "host/scene/read/poly_file.hpp"

namespace sightline::scene {
namespace {

class ComplexWriter {
 public:
  ComplexWriter(const CellComplex& complex, const std::function<void(std::string_view)>& write)
      : complex_(complex), write_(write) {}

  void write(const PolyScene& scene, std::string_view method) {
    text_ = "{\"schema\": \"sightline/cell-complex/2\",\n\"method\": \"" + std::string(method) +
            "\",\n\"outer\": [";
    numbers(complex_.outer.low);
    text_ += ", ";
    numbers(complex_.outer.high);
    text_ += "],\n";
    rows("edges", complex_.edges, [&](const ComplexEdge& edge) { numbers(std::array{edge.from, edge.to}); });
    rows("planes", complex_.planes, [&](const geometry::Plane& plane) {
      numbers(std::array{plane.normal[0], plane.normal[1], plane.normal[2], plane.offset});
    });
    rows("cells", complex_.cells, [&](const ComplexCell& cell) { add(cell); });
    rows("openings", complex_.openings, [&](const ComplexOpening& opening) { add(opening); });
    // JSON can hold every checked scene.
    text_ += "\"polyhedra\": " + *write_poly(scene, PolyFormat::json) + "}\n";
    flush();
  }

 private:
  void flush() {
    write_(text_);
    text_.clear();
  }
  template <class Values>
  void numbers(const Values& values) {
    list(values, [&](const auto& value) { text_ += std::to_string(value); });
  }
  template <class Values, class Add>
  void list(const Values& values, const Add& add_one) {
    text_ += '[';
    bool first = true;
    for (const auto& value : values) {
      if (!first) text_ += ", ";
      first = false;
      add_one(value);
    }
    text_ += ']';
  }
  // A line each.
  template <class Rows, class Add>
  void rows(std::string_view name, const Rows& all, const Add& add_one) {
    text_ += "\"" + std::string(name) + "\": [";
    bool first = true;
    for (const auto& row : all) {
      text_ += first ? "\n" : ",\n";
      first = false;
      add_one(row);
      if (text_.size() > std::size_t{1} << 20) flush();
    }
    text_ += "],\n";
  }
  void halves(std::string_view name, std::span<const HalfSpace> halves) {
    text_ += "\"" + std::string(name) + "\": ";
    list(halves, [&](const HalfSpace& half) {
      const std::int64_t plane = half.plane;
      text_ += std::to_string(half.turned ? -1 - plane : plane);
    });
  }
  void add(const ComplexCell& cell) {
    text_ += '{';
    halves("bounds", complex_.bounds_of(cell));
    text_ += ", \"lines\": ";
    list(complex_.lines_of(cell), [&](const ComplexLine& line) {
      numbers(std::array{std::int64_t{line.edge}, line.low.numerator(), line.low.denominator(),
                         line.high.numerator(), line.high.denominator()});
    });
    text_ += ", \"openings\": ";
    numbers(complex_.openings_of(cell));
    text_ += '}';
  }
  void add(const ComplexOpening& opening) {
    text_ += "{\"cells\": ";
    list(opening.cells,
         [&](CellNumber cell) { text_ += cell == outside ? std::string("null") : std::to_string(cell); });
    text_ += ", \"plane\": " + std::to_string(opening.plane) + ", ";
    halves("sides", complex_.sides_of(opening));
    text_ += '}';
  }

  const CellComplex& complex_;
  const std::function<void(std::string_view)>& write_;
  std::string text_;
};

}  // namespace

void write_cell_complex(const PolyScene& scene, const Decomposition& decomposition,
                        const std::function<void(std::string_view)>& write) {
  ComplexWriter(decomposition.complex, write)
      .write(scene, decomposition.method == DecompositionMethod::bsp ? "bsp" : "grid");
}

}  // namespace sightline::scene
