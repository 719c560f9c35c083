// Cross-check: all algorithms compared with each other on the common scenes (host/compare/cross_check.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/compare/cross_check.hpp"
#include "host/report/experiment.hpp"

namespace sightline::report {

// A pair of methods on a scene: how they agree, or that they differ.
struct PairVerdict {
  std::string scene;
  std::string pair;
  Cell verdict;  // a text if the pair is not applicable
};

struct PairFailure {
  std::string scene;
  std::string pair;
  std::string first;  // the first difference, or why the pair could not be run
};

struct CheckedScene {
  std::string scene;
  std::string what;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t parallel = 0;  // views
  std::size_t perspective = 0;
  std::size_t listed = 0;  // cells to run
  std::size_t run = 0;
  bool good = false;
};

// The first view of a scene by a method.
struct MethodPicture {
  std::string id;
  std::string scene;
  std::string title;
  std::string method;
  Picture picture;
};

// Of all views of a scene, the one with the greatest ratio of a machine picture's distance from another picture to
// its bound. In points of its device.
struct MachineFarthest {
  std::string scene;
  std::string title;
  std::string machine;
  std::string other;
  std::string what;
  double found = 0;
  double bound = 0;

  [[nodiscard]] double part() const { return found / bound; }
  [[nodiscard]] int places() const { return bound < 0.5 ? 4 : 2; }  // enough decimals for both numbers
};

struct CrossCheck {
  std::vector<PairVerdict> cells;
  std::vector<PairFailure> failures;
  std::vector<CheckedScene> scenes;
  std::vector<MethodPicture> pictures;
  std::vector<MachineFarthest> machines;

  // Whether all pairs that are listed to run were run and agree.
  [[nodiscard]] bool agrees() const;
  [[nodiscard]] std::size_t run() const;  // cells
  void add(const compare::CommonScene& scene, const compare::SceneCrossCheck& agreement);
};

[[nodiscard]] CrossCheck cross_check(const Context& context);

class Page;
void cross_check_chapter(Page& page, const CrossCheck& checked);

}  // namespace sightline::report
