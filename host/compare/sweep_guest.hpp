// One view of a scene of cells by Jones's program on the emulated PDP-7 and by its twin, held against each
// other word for word and against what is truly seen.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/algorithms/oracle/drawn_error.hpp"
#include "host/algorithms/oracle/matter.hpp"
#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::compare {

struct SweepGuestView {
  std::string_view status;
  bool same_as_twin = false;  // status and display words
  std::size_t display_words = 0;
  std::uint64_t pieces = 0;
  std::uint64_t visits = 0;
  std::int64_t emulated_ns = 0;  // the paper's computing time
  // Of the pieces, farther than one point from anything true, or drawn.
  algorithms::oracle::DrawnError error;
};

class SweepGuest {
 public:
  // Nothing if the scene is beyond what the oracle can hold. It outlives this.
  [[nodiscard]] static std::optional<SweepGuest> of(const scene::CellScene& scene, bool eae);

  // An error if the program cannot stand there, or the scene does not fit into core.
  [[nodiscard]] base::Result<SweepGuestView> view(const geometry::Point& eye) const;

 private:
  SweepGuest(const scene::CellScene& scene, bool eae, algorithms::oracle::Matter matter);

  const scene::CellScene* scene_;
  bool eae_;
  algorithms::oracle::Matter matter_;
  std::vector<algorithms::oracle::RealLine> lines_;
};

}  // namespace sightline::compare
