// See piece_difference.hpp.
#include "host/compare/piece_difference.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace sightline::compare {
namespace {

bool before(const picture::LinePiece& a, const picture::LinePiece& b) {
  if (a.edge != b.edge) return a.edge < b.edge;
  if (a.low != b.low) return a.low < b.low;
  return a.high < b.high;
}

std::vector<picture::LinePiece> only_in(const picture::LinePicture& a, const picture::LinePicture& b) {
  std::vector<picture::LinePiece> pieces;
  std::set_difference(a.pieces.begin(), a.pieces.end(), b.pieces.begin(), b.pieces.end(), std::back_inserter(pieces), before);
  return pieces;
}

}  // namespace

PieceDifference piece_difference(const picture::LinePicture& right, const picture::LinePicture& other) {
  const std::vector<picture::LinePiece> missing = only_in(right, other);
  const std::vector<picture::LinePiece> extra = only_in(other, right);
  PieceDifference difference{missing.size(), extra.size()};
  if (missing.empty() && extra.empty()) return difference;
  difference.first_is_missing = !missing.empty() && (extra.empty() || before(missing.front(), extra.front()));
  difference.first = difference.first_is_missing ? missing.front() : extra.front();
  return difference;
}

}  // namespace sightline::compare
