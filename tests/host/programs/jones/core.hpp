// Core images for tests of Jones's program: data elements composed by hand, word by word.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "emulators/core/word.hpp"

namespace sightline::programs::jones {

// A vector word: F, A, magnitude.
struct TestVector {
  bool actual;
  std::uint32_t axis;  // 1, 2, 3; 0 makes a bad element
  std::int32_t magnitude;
};
struct TestChain {
  std::int32_t x = 0, y = 0, z = 0;
  std::vector<TestVector> vectors;
};
struct TestOpening {
  std::size_t low = 0, high = 0;  // cells
  TestChain ring;
};

// A rectangle normal to z at z, from (x0, y0) to (x1, y1), with the given F on all sides.
inline TestChain doorway(std::int32_t z, std::int32_t x0, std::int32_t x1, std::int32_t y0, std::int32_t y1,
                         bool actual = false) {
  return {
      x0, y0, z, {{actual, 1, x1 - x0}, {actual, 2, y1 - y0}, {actual, 1, x0 - x1}, {actual, 2, y0 - y1}}};
}

class TestCore {
 public:
  static constexpr std::uint32_t header = 04000;

  // The eye at the origin, in cell 0; it cannot move.
  TestCore(const std::vector<TestChain>& cells, const std::vector<TestOpening>& openings) {
    std::vector<std::uint32_t> cell_at, opening_at;
    std::uint32_t next = header + 11;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      cell_at.push_back(next);
      next += 4 + static_cast<std::uint32_t>(cells[k].vectors.size());
      std::uint32_t entries = 0;
      for (const TestOpening& o : openings) entries += o.low == k || o.high == k;
      next += entries == 0 ? 1 : entries;
    }
    for (const TestOpening& o : openings) {
      opening_at.push_back(next);
      next += 6 + static_cast<std::uint32_t>(o.ring.vectors.size());
    }
    for (std::size_t k = 0; k < cells.size(); ++k) {
      std::uint32_t at = put_chain(cell_at[k], cells[k]);
      const std::uint32_t list = at;
      for (std::size_t j = 0; j < openings.size(); ++j) {
        if (openings[j].low == k) put(at++, opening_at[j] + 1);
        if (openings[j].high == k) put(at++, opening_at[j]);
      }
      if (at == list) put(at++, 0);
      words[at - 1] = words[at - 1] | core::Word18(0400000);
    }
    for (std::size_t j = 0; j < openings.size(); ++j) {
      put(opening_at[j], 0400000 | cell_at[openings[j].low]);
      put(opening_at[j] + 1, cell_at[openings[j].high]);
      put_chain(opening_at[j] + 2, openings[j].ring);
    }
    put(header, cell_at[0]);
    put(header + 1, static_cast<std::uint32_t>(cells.size()));
  }

  std::vector<core::Word18> words = std::vector<core::Word18>(8192);

  void put(std::uint32_t address, std::uint32_t value) { words[address] = core::Word18(value); }

 private:
  std::uint32_t put_chain(std::uint32_t at, const TestChain& chain) {
    for (const std::int32_t c : {chain.x, chain.y, chain.z}) put(at++, static_cast<std::uint32_t>(c));
    put(at++, static_cast<std::uint32_t>(chain.vectors.size()));
    for (const TestVector& v : chain.vectors) {
      put(at++,
          (v.actual ? 0400000U : 0U) | v.axis << 15 | (static_cast<std::uint32_t>(v.magnitude) & 077777));
    }
    return at;
  }
};

// A row of doorways whose left sides lie on one ray through the eye.
inline TestCore grazing_doorways(std::int32_t count) {
  std::vector<TestChain> cells(static_cast<std::size_t>(count) + 1);
  std::vector<TestOpening> openings;
  for (std::int32_t i = 1; i <= count; ++i) {
    openings.push_back(
        {static_cast<std::size_t>(i) - 1, static_cast<std::size_t>(i), doorway(100 * i, i, 80, -20, 20)});
  }
  return {cells, openings};
}

}  // namespace sightline::programs::jones
