// Families of slices as a rotated grid projects to, with random heights: a slice every `gap` of depth, each shifted by the same
// number of
// columns, and the rims that join their ends.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <vector>

#include "host/algorithms/oracle/column_oracle.hpp"
#include "tests/support/dice.hpp"

namespace sightline::programs::skala {

class SliceFamily {
 public:
  using Chain = algorithms::oracle::Chain;
  using ChainVertex = algorithms::oracle::ChainVertex;
  using SegmentRole = algorithms::oracle::SegmentRole;

  static constexpr int kinds = 8;

  SliceFamily(std::uint32_t seed, int kind) : dice_(seed), kind_(kind) {
    slices_ = dice_(1, 24);
    points_ = dice_(1, 40);
    shift_ = dice_(-4, 4);
    const int room = 255 - (slices_ - 1) * std::abs(shift_);
    spacing_ = points_ > 1 ? dice_(0, room / (points_ - 1)) : 0;
    // The rims are at least two columns apart if they differ: steep segments know their depth to half a column.
    if (points_ > 1 && shift_ != 0) spacing_ = std::max(spacing_, 2);
    const int used = (points_ - 1) * spacing_ + (slices_ - 1) * std::abs(shift_);
    left_ = dice_(0, 255 - used) + (shift_ < 0 ? -shift_ * (slices_ - 1) : 0);
    slope_ = dice_(-gap / 8, gap / 8);
    for (int i = 0; i < slices_ * points_; ++i) heights_.push_back(height(i));
  }

  [[nodiscard]] int slices() const { return slices_; }

  // From the left end to the right end.
  [[nodiscard]] std::vector<ChainVertex> slice(int number, SegmentRole role) const {
    std::vector<ChainVertex> vertices;
    for (int i = 0; i < points_; ++i) vertices.push_back(vertex(number, i, role));
    return begun(vertices);
  }
  // Ends of all slices from left to right: the leading rim is in columns that nearer slices do not reach.
  [[nodiscard]] std::vector<ChainVertex> rim(bool leading, SegmentRole role) const {
    std::vector<ChainVertex> vertices;
    for (int k = 0; k < slices_; ++k)
      vertices.push_back(
          vertex(shift_ < 0 ? slices_ - 1 - k : k, leading == (shift_ >= 0) ? points_ - 1 : 0, role));
    return begun(vertices);
  }
  // The nearest slice with the leading rim, the other slices, the trailing rim; from the foreground to the
  // background.
  [[nodiscard]] std::vector<Chain> chains(SegmentRole slice_role, SegmentRole rim_role) const {
    const auto front = shift_ < 0 ? joined(rim(true, rim_role), slice(0, slice_role))
                                  : joined(slice(0, slice_role), rim(true, rim_role));
    std::vector<Chain> all{{0, front}};
    for (int k = 1; k < slices_; ++k) all.push_back({1, slice(k, slice_role)});
    all.push_back({2, rim(false, slice_role)});
    return all;
  }
  // A short segment on the surface halfway between two consecutive slices, at least a column inside their common columns: beyond
  // these there
  // are only rims, one drawn before all slices and one after them, at any depth. Empty if there is no such column.
  [[nodiscard]] std::optional<Chain> piece(int behind_slice) {
    const int first = left_ + std::max(behind_slice * shift_, (behind_slice + 1) * shift_) + 1;
    const int last =
        left_ + std::min(behind_slice * shift_, (behind_slice + 1) * shift_) + (points_ - 1) * spacing_ - 1;
    if (first > last) return std::nullopt;
    const auto vertex_at = [&](int x, int y, SegmentRole role) {
      return ChainVertex{x, y, std::int64_t{behind_slice} * gap + gap / 2 + std::int64_t{slope_} * x, role};
    };
    const int x = dice_(first, last);
    const int y = dice_(0, 255);
    return Chain{1,
                 {vertex_at(x, y, SegmentRole::none),
                  vertex_at(std::clamp(x + dice_(-6, 6), first, last), std::clamp(y + dice_(-9, 9), 0, 255),
                            SegmentRole::test)}};
  }

 private:
  static constexpr int gap = 4096;

  [[nodiscard]] static std::vector<ChainVertex> begun(std::vector<ChainVertex> vertices) {
    vertices.front().role = SegmentRole::none;
    return vertices;
  }
  // The second begins where the first ends.
  [[nodiscard]] static std::vector<ChainVertex> joined(std::vector<ChainVertex> first,
                                                       const std::vector<ChainVertex>& second) {
    first.insert(first.end(), second.begin() + 1, second.end());
    return first;
  }

  [[nodiscard]] ChainVertex vertex(int slice, int point, SegmentRole role) const {
    const int x = left_ + slice * shift_ + point * spacing_;
    return {x, heights_[static_cast<std::size_t>(slice * points_ + point)],
            std::int64_t{slice} * gap + std::int64_t{slope_} * x, role};
  }

  [[nodiscard]] int height(int index) {
    const int before = index == 0 ? 128 : heights_.back();
    const int nearer = index < points_ ? 128 : heights_[static_cast<std::size_t>(index - points_)];
    switch (kind_) {
      case 0: return dice_(0, 255);                              // cliffs everywhere
      case 1: return 90;                                         // flat
      case 2: return std::clamp(before + dice_(-3, 3), 0, 255);  // gentle
      case 3: return nearer;                                     // equal except for the shift
      case 4: return std::clamp(nearer + dice_(-6, 7), 0, 255);  // rising towards the back
      case 5: return index % 7 == 3 ? 255 : dice_(0, 3);         // spikes of one sample
      case 6: return dice_(0, 1) * 255;                          // at the borders of the screen
      default: return std::clamp(120 + (index / points_) * 2 - (index % points_) * dice_(0, 2), 0, 255);
    }
  }

  programs::jones::Dice dice_;
  int kind_;
  int slices_;
  int points_;
  int shift_;
  int spacing_;
  int left_;
  int slope_;
  std::vector<int> heights_;
};

}  // namespace sightline::programs::skala
