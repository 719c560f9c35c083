// Records and layout become blocks of a page: the one place that makes tables, plots, galleries and captions.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "host/report/document.hpp"
#include "host/report/layout.hpp"
#include "host/report/plot.hpp"

namespace sightline::report {

// Of experiments, by name.
using OldResults = std::map<std::string, Records, std::less<>>;

struct Rendering {
  bool host_times = true;  // false: blocks, columns, rows and notes of host times are left out
  std::function<Figure(const Plot&)> draw;
};

// A plot whose points are fewer than three different ones is left out. Throws Failure (bad_input), with file and
// place, for a set, key or claim that is not there, and for an expression that has no value of the kind needed.
[[nodiscard]] std::vector<Block> render(const OldChapter& chapter, const Layout& layout, const OldResults& results,
                                        const Rendering& rendering);

// What data files and records say of each other: keys that a chapter reads and no experiment gives, and keys that
// are given and nothing reads. One line each; none is what must be.
[[nodiscard]] std::vector<std::string> mismatches(const Layout& layout, const OldResults& results);

}  // namespace sightline::report
