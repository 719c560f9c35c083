// The walk that Jones left out (1971, "ideally there would be complete freedom of movement of the viewpoint"): the program
// finds the cell of the eye by the planes of the cells and follows it through portals. Measures the time of each view on a walk
// beside that of the program without the walk from the same eye, the words of the planes, and how far the lines are from the exact
// ones.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/report/experiment.hpp"
#include "host/report/page.hpp"

namespace sightline::report {

// A view on the way; times are those with the EAE and without, while the display shows the view before.
struct JonesStep {
  std::string scene;
  std::size_t view = 0;
  std::string eye;
  std::size_t cell = 0;
  std::string stopped;  // axes
  double walking_s = 0;
  double standing_s = 0;  // the program without the walk
  double walking_without_eae_s = 0;
  double standing_without_eae_s = 0;
  double farthest = 0;  // of the drawn lines from the exact ones, points
  double bound = 0;     // from the lengths of words
};

struct JonesWalkWords {
  std::string scene;
  bool eae = true;
  std::size_t cells = 0;
  std::size_t plane_words = 0;  // beyond the origins of the cells
  std::size_t program_words = 0;
  std::size_t used_words = 0;
  std::size_t used_words_standing = 0;
  std::size_t used_words_turning = 0;  // may be more than the machine has
};

// A view on a way on which the view turns.
struct JonesTurnedStep {
  std::string scene;
  std::size_t view = 0;
  std::string eye;
  std::int32_t angle = 0;  // degrees
  double turned_s = 0;
  double turned_without_eae_s = 0;
  double farthest = 0;  // points
  double bound = 0;
};

struct JonesWalks {
  std::vector<JonesStep> steps;
  std::vector<JonesTurnedStep> turned;
  std::vector<JonesWalkWords> words;
  std::vector<std::pair<std::string, Picture>> last;  // the last picture of each walk, photographed
};

[[nodiscard]] JonesWalks jones_walks(const Context& context);

void jones_walk_chapter(Page& page, const JonesWalks& walks);

}  // namespace sightline::report
