// Faces whose boxes meet: looked up in cells of about the size of a few usual faces.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "host/base/radix_sort.hpp"
#include "host/base/threads.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::scene {

// Around a face: each end is three numbers of 19 bits with a guard above each, so that one subtraction compares all three.
struct FaceBox {
  std::uint64_t low = 0;
  std::uint64_t high = 0;

  static constexpr unsigned step = 20;
  static constexpr std::uint64_t guards = std::uint64_t{1} << 19 | std::uint64_t{1} << 39 | std::uint64_t{1} << 59;

  FaceBox() = default;
  FaceBox(const std::vector<PolyPoint>& vertices, const Ring& ring) {
    PolyPoint least = vertices[ring[0]];
    PolyPoint most = least;
    for (const VertexIndex v : ring) {
      for (std::size_t k = 0; k < 3; ++k) {
        least[k] = std::min(least[k], vertices[v][k]);
        most[k] = std::max(most[k], vertices[v][k]);
      }
    }
    low = packed(least);
    high = packed(most);
  }

  [[nodiscard]] bool meets(const FaceBox& other) const {
    return (((high | guards) - other.low) & ((other.high | guards) - low) & guards) == guards;
  }
  [[nodiscard]] static std::int32_t coordinate(std::uint64_t end, std::size_t axis) {
    return static_cast<std::int32_t>(end >> (step * axis) & ((1U << 19) - 1)) - poly_coordinate_limit;
  }

 private:
  [[nodiscard]] static std::uint64_t packed(const PolyPoint& p) {
    std::uint64_t number = 0;
    for (std::size_t k = 3; k-- > 0;) number = number << step | static_cast<std::uint64_t>(p[k] + poly_coordinate_limit);
    return number;
  }
};

class FaceCells {
 public:
  // A face in a cell.
  class Entry {
   public:
    Entry(std::uint64_t cell, std::uint32_t face, unsigned begins)
        : bits_(std::uint64_t{begins} << begins_at | cell << 32 | face) {}
    Entry() = default;

    [[nodiscard]] std::uint32_t face() const { return static_cast<std::uint32_t>(bits_); }
    [[nodiscard]] std::uint64_t bits() const { return bits_; }
    [[nodiscard]] bool same_cell(Entry other) const { return ((bits_ ^ other.bits_) & cell_bits) == 0; }
    // Whether the cell is the first that both faces are in: along each axis one of them begins there.
    [[nodiscard]] bool first_of_both(Entry other) const { return (bits_ | other.bits_) >> begins_at == 7; }

   private:
    static constexpr unsigned begins_at = 32 + 27;  // there are at most 2^27 cells
    static constexpr std::uint64_t cell_bits = ((std::uint64_t{1} << 27) - 1) << 32;

    std::uint64_t bits_ = 0;
  };

  // Cells `times` as wide as a usual box. With `jobs` threads; the result is the same.
  FaceCells(std::span<const FaceBox> boxes, double times, unsigned jobs) : boxes_(boxes), jobs_(jobs) {
    choose_grid(times);
    struct Part {
      std::vector<Entry> entries;
      std::vector<std::uint32_t> large;
    };
    std::vector<Part> parts(jobs);
    base::for_parts(jobs, boxes.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
      parts[part].entries.reserve(2 * (begin == 0 ? boxes.size() : end - begin));  // the first part gets the entries of all
      for (std::size_t f = begin; f < end; ++f) add(static_cast<std::uint32_t>(f), parts[part].entries, parts[part].large);
    });
    entries_ = std::move(parts[0].entries);
    large_ = std::move(parts[0].large);
    for (std::size_t p = 1; p < parts.size(); ++p) {
      entries_.insert(entries_.end(), parts[p].entries.begin(), parts[p].entries.end());
      large_.insert(large_.end(), parts[p].large.begin(), parts[p].large.end());
    }
    base::radix_sort(entries_, 32, 32 + 27, [](Entry entry) { return entry.bits(); }, jobs);
  }

  // Faces in very many cells, ascending; they have no entries.
  [[nodiscard]] const std::vector<std::uint32_t>& large() const { return large_; }

  // For each thread, calls `make_visit` and then the result with the entries of each cell, ascending by faces, and a list, to which it
  // may add. Returns the lists in the order of the cells. A thread ends early when its list has `most` items.
  template <class Item, class MakeVisit>
  [[nodiscard]] std::vector<Item> visit(std::size_t most, MakeVisit make_visit) const {
    std::vector<std::vector<Item>> lists(jobs_);
    base::for_parts(jobs_, entries_.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
      auto visit = make_visit();
      std::size_t first = begin;  // of a cell that begins in this part
      while (first > 0 && first < end && entries_[first].same_cell(entries_[first - 1])) ++first;
      while (first < end && lists[part].size() < most) {
        std::size_t last = first;
        while (last < entries_.size() && entries_[last].same_cell(entries_[first])) ++last;
        visit(std::span(entries_).subspan(first, last - first), lists[part]);
        first = last;
      }
    });
    std::vector<Item> all = std::move(lists[0]);
    for (std::size_t p = 1; p < lists.size(); ++p) all.insert(all.end(), lists[p].begin(), lists[p].end());
    return all;
  }

 private:
  void choose_grid(double times) {
    PolyPoint high{};
    std::array<double, 3> sum{};
    for (std::size_t f = 0; f < boxes_.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t least = FaceBox::coordinate(boxes_[f].low, k);
        const std::int32_t most = FaceBox::coordinate(boxes_[f].high, k);
        low_[k] = f == 0 ? least : std::min(low_[k], least);
        high[k] = f == 0 ? most : std::max(high[k], most);
        sum[k] += most - least + 1;
      }
    }
    constexpr std::int64_t most_a_side = 512;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t extent = std::int64_t{high[k]} - low_[k] + 1;
      const auto width = static_cast<std::int64_t>(times * sum[k] / static_cast<double>(std::max<std::size_t>(boxes_.size(), 1))) + 1;
      size_[k] = std::max(width, extent / most_a_side + 1);
      count_[k] = extent / size_[k] + 1;
    }
  }

  void add(std::uint32_t face, std::vector<Entry>& entries, std::vector<std::uint32_t>& large) const {
    constexpr std::int64_t most_cells = 512;
    const auto place = [this](std::uint64_t end, std::size_t k) { return (std::int64_t{FaceBox::coordinate(end, k)} - low_[k]) / size_[k]; };
    std::array<std::int64_t, 3> from{};
    std::array<std::int64_t, 3> to{};
    std::int64_t covered = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      from[k] = place(boxes_[face].low, k);
      to[k] = place(boxes_[face].high, k);
      covered *= to[k] - from[k] + 1;
    }
    if (covered > most_cells) return large.push_back(face);
    for (std::int64_t x = from[0]; x <= to[0]; ++x)
      for (std::int64_t y = from[1]; y <= to[1]; ++y)
        for (std::int64_t z = from[2]; z <= to[2]; ++z)
          entries.emplace_back(static_cast<std::uint64_t>((x * count_[1] + y) * count_[2] + z), face,
                               (x == from[0] ? 1U : 0U) | (y == from[1] ? 2U : 0U) | (z == from[2] ? 4U : 0U));
  }

  std::span<const FaceBox> boxes_;
  unsigned jobs_;
  PolyPoint low_{};
  std::array<std::int64_t, 3> size_{1, 1, 1};
  std::array<std::int64_t, 3> count_{1, 1, 1};
  std::vector<Entry> entries_;  // in the order of cells and faces
  std::vector<std::uint32_t> large_;
};

}  // namespace sightline::scene
