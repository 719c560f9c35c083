// Many random views of one scene, each by several algorithms, and whether these agree: one line of JSON a
// view.
//
// A line depends on the scene, the seed, its number and what was asked for, never on which lines were made
// before it, by which thread, or when; so sweeps can be divided among machines and continued after an
// interruption, and give the same bytes. Host times, asked for, are the exception.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/algorithms/registry/lines.hpp"
#include "host/base/result.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

struct SweepOptions {
  std::uint64_t seed = 1;
  std::vector<const registry::LineAlgorithm*> algorithms;  // that apply to the scene, beside `exact`
  bool guest = false;   // of a scene of cells: Jones's program and its twin, too
  bool eae = true;      // of the guest
  bool turned = false;  // a scene of cells is looked at in all directions
  bool time = false;    // with host nanoseconds
};

// Views `first` to `last`, excluded, of those that shard `number` (from 1) of `count` has of `views`: shards
// one after the other are the whole.
struct SweepShard {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};
[[nodiscard]] SweepShard sweep_shard(std::uint64_t views, std::uint64_t number, std::uint64_t count);

class Sweep {
 public:
  // `source` is what the lines name the scene by. The scene is a checked one with a vertex, and outlives the
  // sweep, as do the cells, which may be null.
  [[nodiscard]] static base::Result<Sweep> of(const std::string& source, const scene::PolyScene& scene,
                                              const scene::CellScene* cells, const SweepOptions& options);

  // The line of a view, with its line feed. Several threads may ask at once.
  [[nodiscard]] std::string line(std::uint64_t number) const;
  // Whether a line of text is that of this view: it begins as the view's line does and ends as lines do.
  [[nodiscard]] bool is_line(std::uint64_t number, std::string_view text) const;
  // Whether in a line everything agreed: every algorithm with `exact`, the guest with its twin.
  [[nodiscard]] static bool agrees(std::string_view line);

 private:
  class Guest;
  struct Entry {
    const registry::LineAlgorithm* algorithm = nullptr;
    registry::PreparedScene prepared;
  };

  Sweep() = default;
  [[nodiscard]] std::string head(std::uint64_t number, const scene::PolyCamera& camera) const;

  std::string source_;
  std::string fingerprint_;
  const scene::PolyScene* scene_ = nullptr;
  const scene::CellScene* cells_ = nullptr;
  SweepOptions options_;
  std::vector<Entry> entries_;  // `exact` first
  std::shared_ptr<const Guest> guest_;
};

}  // namespace sightline::compare
