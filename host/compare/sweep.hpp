// Compares many random views of one scene or function, each by several methods, as `compare` compares one view: one
// line of JSON per view, and a table of all lines.
//
// A line depends on the scene, the seed, its number and the options only, not on the lines made before, the thread or
// the time. So sweeps can be divided among machines and resumed after an interruption, and give the same bytes; only
// host times differ. The table is made from the lines alone.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/json.hpp"
#include "host/base/result.hpp"
#include "host/compare/answer.hpp"
#include "host/compare/heights.hpp"
#include "host/compare/scenes.hpp"
#include "host/compare/sweep_views.hpp"
#include "host/scene/heights/grid.hpp"
#include "host/scene/model/cell_scene.hpp"
#include "host/scene/model/poly_scene.hpp"

namespace sightline::compare {

struct SweepOptions {
  std::uint64_t seed = 1;
  std::vector<std::string> methods;  // of method_names(), each once; they must apply
  bool all_lines = false;            // also every native line method that applies; for functions, the line methods
  bool faces = false;                // also every native face method that applies
  bool oracle = false;  // for polyhedra: the reference is the oracle of edges instead of `exact`, which is faster for large scenes
  bool eae = true;      // for Jones's program
  Directions directions = Directions::usual;
  bool time = false;    // with host times of line methods, one run each
};

// Views first..last - 1 of shard `number` (from 1) of `count`, for a sweep of `views` views. The shards in order make
// up the sweep.
struct SweepShard {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
};
[[nodiscard]] SweepShard sweep_shard(std::uint64_t views, std::uint64_t number, std::uint64_t count);

class Sweep {
 public:
  // `source` is the name of the scene in the lines. The scene is a checked one with a vertex and outlives the sweep,
  // as do the cells, which may be null. Errors: a method applies to no view of the scene, with the reason; a method
  // cannot prepare the scene.
  [[nodiscard]] static base::Result<Sweep> of(const std::string& source, const scene::PolyScene& scene, const scene::CellScene* cells,
                                              const SweepOptions& options);
  // A function, drawn as in the view but from random angles. The grid can be compared (why_not_comparable is empty:
  // precondition). Error: a method does not draw functions.
  [[nodiscard]] static base::Result<Sweep> of(const std::string& source, scene::HeightGrid grid, const algorithms::skala::View& view,
                                              const SweepOptions& options);

  // The line of a view, with its line feed. Thread-safe.
  [[nodiscard]] std::string line(std::uint64_t number) const;
  // Whether a text is the line of this view: it begins as the view's line does and ends as lines do.
  [[nodiscard]] bool is_line(std::uint64_t number, std::string_view text) const;

 private:
  Sweep() = default;
  // Whether faces are compared.
  [[nodiscard]] bool compares_faces() const;
  [[nodiscard]] std::string head(std::uint64_t number) const;
  [[nodiscard]] scene::PolyCamera camera(std::uint64_t number) const;
  [[nodiscard]] algorithms::skala::View height_view(std::uint64_t number) const;
  [[nodiscard]] base::Json scene_results(std::uint64_t number) const;
  [[nodiscard]] base::Json height_results(std::uint64_t number) const;

  std::string source_;
  std::string fingerprint_;
  std::string truth_;  // the reference
  const scene::PolyScene* scene_ = nullptr;
  const scene::CellScene* cells_ = nullptr;
  std::shared_ptr<const scene::HeightGrid> grid_;  // for a function, which has no scene
  algorithms::skala::View view_;                       // for a function
  SweepOptions options_;
  std::shared_ptr<const SceneMethods> methods_;
};

// Accumulates lines of one sweep in their order.
class SweepTable {
 public:
  // Returns false, and changes nothing, if the text is not a line of a sweep.
  bool add(std::string_view line);

  [[nodiscard]] std::vector<AnswerRow> rows() const { return answer_.rows(); }
  // Views in which an exact method is not exact, a program differs from its twin, or there is no comparison.
  [[nodiscard]] std::uint64_t differing() const { return differing_; }
  // The number of views left out by a method or, if `method` is empty, by all, and the reason of the first.
  struct LeftOut {
    std::string method;
    std::uint64_t views = 0;
    std::string reason;
  };
  [[nodiscard]] const std::vector<LeftOut>& left_out() const { return left_out_; }

 private:
  void leave_out(const std::string& method, const std::string& reason);

  Answer answer_;
  std::uint64_t differing_ = 0;
  std::vector<LeftOut> left_out_;
};

}  // namespace sightline::compare
