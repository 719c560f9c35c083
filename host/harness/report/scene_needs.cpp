#include "host/harness/report/scene_needs.hpp"

namespace sightline::harness::report {

Outcome<Section> scene_needs(const Context&) {
  return Section{"needs", "What the scene needed", {}};
}

}  // namespace sightline::harness::report
