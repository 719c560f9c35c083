// Sends the oracle's chains as command streams, and compares the twin's picture with the oracle's.
#pragma once

#include <gtest/gtest.h>

#include <bitset>
#include <string>
#include <vector>

#include "host/algorithms/oracle/column_oracle.hpp"
#include "tests/host/programs/skala/twin/support.hpp"

namespace sightline::programs::skala {

using algorithms::oracle::Chain;
using algorithms::oracle::ChainVertex;
using algorithms::oracle::ColumnPicture;
using algorithms::oracle::SegmentRole;

// A level from 1 to 7, determined by the vertex.
[[nodiscard]] inline int level_of(const ChainVertex& vertex) {
  return 1 + (3 * vertex.x + 5 * vertex.y) % 7;
}

// Sends chains one after the other, each with COMMIT.
class ChainSender {
 public:
  explicit ChainSender(SkalaBytes& bytes) : bytes_(bytes) {}

  void send(const Chain& chain) {
    for (std::size_t i = 0; i < chain.vertices.size(); ++i) {
      const ChainVertex& vertex = chain.vertices[i];
      if (vertex.role == SegmentRole::none) {
        begin_at(vertex);
        pending_level_ = true;
      } else {
        segment(chain.vertices[i - 1], vertex);
      }
    }
    bytes_.commit();
  }

 private:
  // If a chain began where the last ended, its first point would not be stepped: the pen moves away and back.
  void begin_at(const ChainVertex& vertex) { bytes_.move(vertex.x ^ 1, vertex.y).move(vertex.x, vertex.y); }

  void segment(const ChainVertex& from, const ChainVertex& to) {
    switch (to.role) {
      case SegmentRole::draw: bytes_.draw(to.x, to.y); break;
      case SegmentRole::test: bytes_.test(to.x, to.y); break;
      case SegmentRole::mask: bytes_.mask(to.x, to.y); break;
      case SegmentRole::shade:
        bytes_.surface({{from.x, from.y, level_of(from)}, {to.x, to.y, level_of(to)}});
        break;
      case SegmentRole::rim:
        if (pending_level_) bytes_.send(Command::rim, {from.x, from.y, level_of(from)});
        bytes_.send(Command::rim, {to.x, to.y, level_of(to)});
        break;
      case SegmentRole::none: break;
    }
    pending_level_ = false;
  }

  SkalaBytes& bytes_;
  bool pending_level_ = true;
};

// The first differences, for messages; empty if exactly the dots of `expected` are lit in the raster.
[[nodiscard]] inline std::string lit_differences(
    const core::Raster& raster,
    const std::array<std::bitset<algorithms::oracle::raster_columns>, algorithms::oracle::raster_columns>&
        expected) {
  std::string text;
  int count = 0;
  for (int x = 0; x < 256; ++x) {
    for (int y = 0; y < 256; ++y) {
      const bool lit = raster.at(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y)) != 0;
      const bool wanted = expected[static_cast<std::size_t>(x)].test(static_cast<std::size_t>(y));
      if (lit == wanted) continue;
      if (++count <= 8)
        text += "(" + std::to_string(x) + ", " + std::to_string(y) + ") " + (lit ? "lit" : "not lit") + "; ";
    }
  }
  return count == 0 ? text : std::to_string(count) + " dots: " + text;
}

inline void expect_same_masks(const Columns& columns, const ColumnPicture& expected) {
  for (std::size_t x = 0; x < 256; ++x) {
    const int high = expected.hull[x] ? expected.hull[x]->high : 0;
    const int low = expected.hull[x] ? expected.hull[x]->low : 255;
    ASSERT_EQ(columns.mask_top[x], high) << "column " << x;
    ASSERT_EQ(columns.mask_bottom[x], low) << "column " << x;
  }
}

}  // namespace sightline::programs::skala
