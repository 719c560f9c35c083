// Many random views of one scene or function, each by several methods, compared as `compare` compares one view: one line of JSON a
// view, and a table of all lines.
//
// A line depends on the scene, the seed, its number and what was asked for, never on which lines were made before it, by which thread,
// or when; so sweeps can be divided among machines and continued after an interruption, and give the same bytes. Host times, asked for,
// are the exception. The table is made from the lines alone, so it is the same wherever these come from.
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
  std::vector<std::string> methods;  // of method_names(), each once: they must apply
  bool all_lines = false;            // also every native method of lines that applies; for functions, the methods of lines
  bool faces = false;                // also every native method of faces that applies
  bool oracle = false;  // of polyhedra: the oracle of edges is the truth instead of `exact`, which is faster for large scenes
  bool eae = true;      // of Jones's program
  Directions directions = Directions::usual;
  bool time = false;    // with host times: of lines, one run each
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
  // `source` is what the lines name the scene by. The scene is a checked one with a vertex, and outlives the sweep, as do the cells,
  // which may be null. Errors: a method applies to no view of the scene, with the reason; a method cannot prepare the scene.
  [[nodiscard]] static base::Result<Sweep> of(const std::string& source, const scene::PolyScene& scene, const scene::CellScene* cells,
                                              const SweepOptions& options);
  // A function, drawn as the view says but from random angles. The grid can be compared (why_not_comparable finds nothing:
  // precondition). Error: a method does not draw functions.
  [[nodiscard]] static base::Result<Sweep> of(const std::string& source, scene::HeightGrid grid, const algorithms::skala::View& view,
                                              const SweepOptions& options);

  // The line of a view, with its line feed. Several threads may ask at once.
  [[nodiscard]] std::string line(std::uint64_t number) const;
  // Whether a line of text is that of this view: it begins as the view's line does and ends as lines do.
  [[nodiscard]] bool is_line(std::uint64_t number, std::string_view text) const;

 private:
  Sweep() = default;
  // Whether faces are compared.
  [[nodiscard]] bool with_faces() const;
  [[nodiscard]] std::string head(std::uint64_t number) const;
  [[nodiscard]] scene::PolyCamera camera(std::uint64_t number) const;
  [[nodiscard]] algorithms::skala::View height_view(std::uint64_t number) const;
  [[nodiscard]] base::Json scene_results(std::uint64_t number) const;
  [[nodiscard]] base::Json height_results(std::uint64_t number) const;

  std::string source_;
  std::string fingerprint_;
  std::string truth_;  // what methods are compared with
  const scene::PolyScene* scene_ = nullptr;
  const scene::CellScene* cells_ = nullptr;
  std::shared_ptr<const scene::HeightGrid> grid_;  // of a function, which has no scene
  algorithms::skala::View view_;                       // of a function
  SweepOptions options_;
  std::shared_ptr<const SceneMethods> methods_;
};

// What lines of one sweep say together, in their order.
class SweepTable {
 public:
  // False if it is no line of a sweep, which changes nothing.
  bool add(std::string_view line);

  [[nodiscard]] std::vector<AnswerRow> rows() const { return answer_.rows(); }
  // Views in which an exact method is not exact, a program is not its twin, or there is no comparison.
  [[nodiscard]] std::uint64_t differing() const { return differing_; }
  // Views left out, of a method or, under the name of no method, of all, and why the first was.
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
