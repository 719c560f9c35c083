// Compares two exact line pictures of one view: counts the pieces that only one of them has, and gives the first.
#pragma once

#include <cstddef>
#include <optional>

#include "host/picture/line_picture.hpp"

namespace sightline::compare {

struct PieceDifference {
  std::size_t missing = 0;  // pieces of the correct picture only
  std::size_t extra = 0;    // pieces of the other only
  std::optional<picture::LinePiece> first{};  // in the order of pictures; empty: the pictures are equal
  bool first_is_missing = false;
};

[[nodiscard]] PieceDifference piece_difference(const picture::LinePicture& right, const picture::LinePicture& other);

}  // namespace sightline::compare
