#include "host/harness/report/timing_papers.hpp"

namespace sightline::harness::report {

Outcome<Section> timing_against_papers(const Context&) {
  return Section{"timing", "Timing against the papers", {}};
}

}  // namespace sightline::harness::report
