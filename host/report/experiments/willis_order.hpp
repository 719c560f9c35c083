// Willis's models cut to every depth, by both boundaries, with and without the 90-degree rule: the errors in the
// order of their surfaces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"

namespace sightline::report {

// A model: the sight lines that meet two or more surfaces, and those where the nearest does not have the highest
// priority; the points of pictures that show another face than the nearest. Each piece is represented by a random
// corner.
struct WillisModel {
  std::string scene;
  std::string boundary;  // "ball", "oval"
  bool rule90 = false;
  int depth = 0;  // limit of cuts
  std::size_t tests = 0;
  std::size_t clusters = 0;
  std::size_t pieces = 0;
  std::size_t left_over = 0;
  std::uint64_t points = 0;
  std::uint64_t points_wrong = 0;
  double pmr_inside_percent = 0;
  std::uint64_t lines = 0;
  std::uint64_t lines_wrong = 0;
  double lines_wrong_percent = 0;

  [[nodiscard]] const char* rule() const { return rule90 ? "on" : "off"; }
};

// Pairs of surfaces of which one can obscure the other, and the angles between their normals.
struct WillisNormals {
  std::string scene;
  std::uint64_t pairs = 0;
  std::uint64_t pairs_over_90 = 0;
  double greatest_degrees = 0;
};

// A boundary of a wall of length 1 in plan: its area by formula and by counting.
struct WillisArea {
  std::string boundary;
  double area = 0;
  double counted = 0;
  double smaller_percent = 0;  // than the oval
};

// A town in space, cut up to `depth` times.
struct WillisPicture {
  std::string scene;
  int depth = 0;
  std::size_t pieces = 0;
  std::size_t left_over = 0;
  std::uint64_t wrong_inside = 0;  // points
  std::uint64_t wrong_at_edges = 0;
  Picture picture;
};

struct WillisOrder {
  static constexpr std::size_t eyes = 160;  // of the pictures whose points are counted
  static constexpr int points_a_side = 24;

  std::vector<WillisArea> areas;
  std::vector<WillisNormals> normals;  // one per scene
  std::vector<WillisModel> models;
  std::vector<WillisPicture> pictures;  // without cuts, with one, and with as many as needed
};

[[nodiscard]] WillisOrder willis_order(const Context& context);

class Page;
struct WillisTimes;
void willis_accuracy(Page& page, const WillisOrder& order, const WillisTimes& times);

}  // namespace sightline::report
