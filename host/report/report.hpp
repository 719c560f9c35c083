// Parts of the report that are not experiments yet.
#pragma once

#include <vector>

#include "host/base/file.hpp"
#include "host/report/document.hpp"
#include "host/report/experiment.hpp"

namespace sightline::harness::report {

using namespace sightline::report;

struct Part {
  int number = 0;  // as people ask for it
  std::string_view title;
  Outcome<Section> (*make)(const Context& context) = nullptr;
};

// The parts of this program's report, ascending.
[[nodiscard]] std::span<const Part> all_parts();

// The parts one after the other, and of what they give only what may stay: without host times, the columns
// and figures marked so are gone. The first error ends it.
[[nodiscard]] Outcome<std::vector<Section>> make_sections(std::span<const Part> parts,
                                                          const Context& context);

}  // namespace sightline::harness::report
