// Every kind of damage to a cell complex is found and named.
#include "host/scene/check/cell_complex.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "host/base/result.hpp"
#include "host/scene/cells/bsp/decompose.hpp"
#include "host/scene/cells/grid/decompose.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/model/poly_from_cells.hpp"
#include "tests/host/scene/scene_support.hpp"

namespace sightline::scene {
namespace {

class CheckComplex : public ::testing::Test {
 protected:
  const PolyScene scene_ = poly_scene_of(builtin_scene("roberts"));
  const CellComplex good_ = *decompose_grid(scene_);

  // The first opening between two cells.
  [[nodiscard]] std::size_t inner_opening() const {
    std::size_t o = 0;
    while (good_.openings[o].cells[0] == outside || good_.openings[o].cells[1] == outside) ++o;
    return o;
  }

  void expect(const std::string& place, const std::string& cause,
              const std::function<void(CellComplex&)>& damage) const {
    CellComplex complex = good_;
    damage(complex);
    const auto errors = check_complex(complex, scene_);
    const bool found = std::any_of(errors.begin(), errors.end(), [&](const base::Error& error) {
      return error.place.find(place) == 0 && error.found.find(cause) != std::string::npos;
    });
    EXPECT_TRUE(found) << place << ": " << cause << "\nfound "
                       << (errors.empty() ? "nothing" : errors.front().message());
  }
};

TEST_F(CheckComplex, TheUnchangedComplexHasNoErrors) {
  EXPECT_TRUE(check_complex(good_, scene_).empty());
}

TEST_F(CheckComplex, Numbers) {
  const std::size_t o = inner_opening();
  const std::string opening = "opening " + std::to_string(o);
  expect(opening, "which is not there", [&](CellComplex& c) { c.openings[o].cells[0] = 9999; });
  expect(opening, "same cell", [&](CellComplex& c) { c.openings[o].cells[0] = c.openings[o].cells[1]; });
  expect(opening, "beyond the end", [&](CellComplex& c) { c.openings[o].plane = 0xFFFFFFFF; });
  expect(opening, "beyond the end", [&](CellComplex& c) { c.openings[o].side_count = 0xFFFFFFFF; });
  expect("cell 2", "beyond the end", [](CellComplex& c) { c.cells[2].first_line = 0xFFFFFFFF; });
  expect("bounds", "not there", [](CellComplex& c) { c.bounds[0].plane = 9999; });
  expect("sides", "not there", [](CellComplex& c) { c.sides[0].plane = 9999; });
  expect("lines", "not there", [](CellComplex& c) { c.lines.set(0, {9999, 0, 1}); });
  expect("opening_numbers", "not there", [](CellComplex& c) { c.opening_numbers[0] = 9999; });
  expect("plane 0", "no normal", [](CellComplex& c) { c.planes[0].normal = {}; });
  expect("vertices", "not those", [](CellComplex& c) { ++c.vertices[0][0]; });
  expect("edges", "not those", [](CellComplex& c) { c.edges.pop_back(); });
  expect("cell 0", "of other cells",
         [](CellComplex& c) { c.opening_numbers[0] = static_cast<std::uint32_t>(c.openings.size() - 1); });
  expect("openings", "by cell", [](CellComplex& c) { --c.cells[3].opening_count; });
}

TEST_F(CheckComplex, Openings) {
  const std::size_t o = inner_opening();
  const std::string opening = "opening " + std::to_string(o);
  const std::size_t side = good_.openings[o].first_side;
  expect(opening, "sides", [&](CellComplex& c) { c.openings[o].side_count = 2; });
  expect(opening, "convex polygon", [&](CellComplex& c) { std::swap(c.sides[side], c.sides[side + 1]); });
  expect(opening, "convex polygon", [&](CellComplex& c) { c.sides[side].turned = !c.sides[side].turned; });
  expect(opening, "convex polygon", [&](CellComplex& c) {
    c.sides[side] = {c.sides[side + 2].plane, c.sides[side].turned};
  });
  expect(opening, "on that side",
         [&](CellComplex& c) { std::swap(c.openings[o].cells[0], c.openings[o].cells[1]); });
  // Moves a side beyond the outer box.
  expect(opening, "goes beyond cell", [&](CellComplex& c) {
    geometry::Plane far = c.planes[c.sides[side].plane];
    far.offset += c.sides[side].turned ? -5000 : 5000;
    c.planes.push_back(far);
    c.sides[side].plane = static_cast<std::uint32_t>(c.planes.size() - 1);
  });
}

TEST_F(CheckComplex, AnOpeningOutsideIsOnTheOuterBox) {
  for (std::size_t o = 0; o < good_.openings.size(); ++o) {
    const auto& cells = good_.openings[o].cells;
    if (cells[0] == outside || cells[1] == outside) continue;
    CellComplex complex = good_;
    ComplexCell& far = complex.cells[cells[1]];
    const auto begin = complex.opening_numbers.begin() + far.first_opening;
    std::rotate(std::find(begin, begin + far.opening_count, o),
                std::find(begin, begin + far.opening_count, o) + 1, begin + far.opening_count);
    --far.opening_count;
    complex.openings[o].cells[1] = outside;
    const auto errors = check_complex(complex, scene_);
    ASSERT_FALSE(errors.empty());
    EXPECT_EQ(errors.front().place, "opening " + std::to_string(o));
    EXPECT_EQ(errors.front().found, "leads outside within the outer box");
    return;
  }
  FAIL() << "no opening";
}

TEST_F(CheckComplex, CellsAndLines) {
  expect("cell 1", "no inside", [](CellComplex& c) {
    const std::uint32_t bound = c.cells[1].first_bound;
    c.bounds[bound].plane = c.bounds[bound + 1].plane;
  });
  const auto with_lines =
      static_cast<std::size_t>(std::find_if(good_.cells.begin(), good_.cells.end(),
                                            [](const ComplexCell& c) { return c.line_count > 0; }) -
                               good_.cells.begin());
  const std::string cell = "cell " + std::to_string(with_lines);
  const std::uint32_t line = good_.cells[with_lines].first_line;
  expect(cell, "no part of the edge", [&](CellComplex& c) { c.lines.set(line, {0, 1, 1}); });
  expect(cell, "no part of the edge", [&](CellComplex& c) { c.lines.set(line, {0, -1, 1}); });
  expect("cell", "leaves the cell", [](CellComplex& c) {
    for (std::size_t i = 0; i < c.lines.size(); ++i) c.lines.set(i, {0, c.lines[i].low, c.lines[i].high});
  });
}

// Builds the list of openings by cell again.
void list_openings(CellComplex& complex) {
  complex.opening_numbers.clear();
  for (std::size_t c = 0; c < complex.cells.size(); ++c) {
    ComplexCell& cell = complex.cells[c];
    cell.first_opening = static_cast<std::uint32_t>(complex.opening_numbers.size());
    for (std::uint32_t o = 0; o < complex.openings.size(); ++o) {
      const auto& cells = complex.openings[o].cells;
      if (cells[0] == c || cells[1] == c) complex.opening_numbers.push_back(o);
    }
    cell.opening_count = static_cast<std::uint32_t>(complex.opening_numbers.size()) - cell.first_opening;
  }
}

// Openings or a whole cell removed, or duplicated: shapes are correct, positions are not.
TEST_F(CheckComplex, Places) {
  expect("opening", "as has opening", [](CellComplex& c) {
    const auto openings = c.openings;
    c.openings.insert(c.openings.end(), openings.begin(), openings.end());
    list_openings(c);
  });
  expect("cell", "neither an opening nor a face", [](CellComplex& c) {
    c.openings.clear();
    list_openings(c);
  });
  const auto without_first_cell = [](CellComplex& c) {
    std::erase_if(c.openings, [](const ComplexOpening& o) { return o.cells[0] == 0 || o.cells[1] == 0; });
    c.cells.erase(c.cells.begin());
    for (ComplexOpening& o : c.openings)
      for (CellNumber& cell : o.cells) cell -= cell != outside ? 1U : 0U;
    list_openings(c);
  };
  expect("cells", "expected the outer box's", without_first_cell);
  expect("cells", "none has the free point", without_first_cell);
  CellComplex twice = good_;
  twice.cells.push_back(twice.cells[0]);
  list_openings(twice);
  const auto errors = check_complex(twice, scene_);
  EXPECT_TRUE(std::any_of(errors.begin(), errors.end(), [](const base::Error& error) {
    return error.found.find("as has cell 0") != std::string::npos;
  }));
}

// The complex of one scene does not fit the same scene with another box in it.
TEST(CheckComplexScenes, MatterInACellIsFound) {
  const PolyScene scene = generate_boxes(8, 2);
  PolyScene fewer = scene;
  fewer.bodies.pop_back();
  CellComplex complex = *decompose_grid(fewer);
  complex.edges = decompose_grid(scene)->edges;
  const auto errors = check_complex(complex, scene);
  ASSERT_FALSE(errors.empty());
  EXPECT_TRUE(std::any_of(errors.begin(), errors.end(), [](const base::Error& error) {
    return error.found.find("of a solid") != std::string::npos || error.place == "cells";
  }));
}

TEST(CheckComplexScenes, SlantedCells) {
  const PolyScene scene = generate_triangles(6, 4);
  CellComplex complex = *decompose_bsp(scene);
  for (const base::Error& error : check_complex(complex, scene)) ADD_FAILURE() << error.message();
  const ComplexCell& cell = complex.cells[0];
  complex.bounds[cell.first_bound] = complex.bounds[cell.first_bound + 1];
  complex.bounds[cell.first_bound].turned = !complex.bounds[cell.first_bound].turned;
  EXPECT_FALSE(check_complex(complex, scene).empty());
}

}  // namespace
}  // namespace sightline::scene
