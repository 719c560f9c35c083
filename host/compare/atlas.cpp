// See atlas.hpp.
#include "host/compare/atlas.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <tuple>
#include <utility>

#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/compare/sweep_views.hpp"
#include "host/compare/jones_precision/precision.hpp"
#include "host/scene/model/poly_from_cells.hpp"

namespace sightline::compare {
namespace {

namespace jones = programs::jones;
namespace oracle = algorithms::oracle;

constexpr double tolerance = 1;  // points; smaller errors are ignored
constexpr double usual_eyes = 4000;

// The centre of step `number` of `steps` from low to high.
std::int32_t middle_of(geometry::Span span, int number, int steps) {
  return static_cast<std::int32_t>(span.low + span.length() * (2 * number + 1) / (2 * std::int64_t{steps}));
}

std::vector<ImagePiece> pieces_of(const std::vector<jones_precision::PrecisePiece>& pieces,
                                  const std::map<std::uint32_t, AxisLine>& lines) {
  std::vector<ImagePiece> result;
  for (const jones_precision::PrecisePiece& piece : pieces) {
    const auto line = lines.find(piece.vector_address);
    if (line != lines.end()) result.push_back({line->second, piece.line});
  }
  return result;
}

AtlasQuantiles quantiles_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&values](std::size_t per_cent) {
    return values[(per_cent * values.size() + 99) / 100 - 1];
  };
  return {at(50), at(90), at(99), values.back()};
}

std::string names_of(const std::array<bool, jones::roundings>& finer) {
  static constexpr std::array<const char*, jones::roundings> names{"of a line", "of a portal", "of a mask"};
  if (std::all_of(finer.begin(), finer.end(), [](bool b) { return b; })) return "of everything";
  std::string text;
  for (std::size_t i = 0; i < finer.size(); ++i)
    if (finer[i]) text += (text.empty() ? "" : " and ") + std::string(names[i]);
  return text;
}

// A union-find structure: each view links to the first view of its cluster.
class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : before_(count) {
    for (std::size_t i = 0; i < count; ++i) before_[i] = i;
  }
  [[nodiscard]] std::size_t first(std::size_t i) const {
    while (before_[i] != i) i = before_[i];
    return i;
  }
  void connect(std::size_t i, std::size_t j) {
    i = first(i);
    j = first(j);
    before_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::size_t> before_;
};

// The line that is wrong in most of the views; of several, the one with the greatest wrong length.
std::optional<AxisLine> line_of(const std::vector<std::size_t>& numbers,
                                const std::vector<AtlasView>& views) {
  struct Wrong {
    std::size_t views = 0;
    double length = 0;
  };
  std::map<AxisLine, Wrong> lines;
  for (const std::size_t number : numbers) {
    std::map<AxisLine, double> of_view;
    for (const ScreenStretch& stretch : views[number].wrong.stretches) of_view[stretch.line] += stretch.length;
    for (const auto& [line, length] : of_view) {
      lines[line].length += length;
      ++lines[line].views;
    }
  }
  std::optional<AxisLine> most;
  Wrong most_wrong;
  for (const auto& [line, wrong] : lines) {
    if (most && std::tuple(wrong.views, wrong.length) <= std::tuple(most_wrong.views, most_wrong.length)) continue;
    most = line;
    most_wrong = wrong;
  }
  return most;
}

std::vector<AtlasCluster> clusters_of(const std::vector<AtlasView>& views) {
  UnionFind connected(views.size());
  std::map<std::tuple<std::string, std::optional<AxisLine>>, std::size_t> seen;
  for (std::size_t number = 0; number < views.size(); ++number) {
    const AtlasView& view = views[number];
    if (!view.is_wrong()) continue;
    const std::string cause = view.cause->name();
    if (view.cause->status != jones::Status::complete)
      connected.connect(number, seen.emplace(std::tuple(cause, std::nullopt), number).first->second);
    else
      for (const ScreenStretch& stretch : view.wrong.stretches)
        connected.connect(number,
                          seen.emplace(std::tuple(cause, stretch.line), number).first->second);
  }
  std::map<std::size_t, AtlasCluster> found;
  for (std::size_t number = 0; number < views.size(); ++number) {
    const AtlasView& view = views[number];
    if (!view.is_wrong()) continue;
    AtlasCluster& cluster = found[connected.first(number)];
    if (cluster.views.empty()) {
      cluster.cause = view.cause->name();
      cluster.worst = number;
      cluster.right_from_bits = 0;
    }
    cluster.views.push_back(number);
    const auto bits = view.cause->right_from_bits;
    if (!bits || !cluster.right_from_bits)
      cluster.right_from_bits.reset();
    else
      cluster.right_from_bits = std::max(*bits, *cluster.right_from_bits);
    if (view.wrong.length() > views[cluster.worst].wrong.length()) cluster.worst = number;
    cluster.most_wrong = views[cluster.worst].wrong.length();
  }
  std::vector<AtlasCluster> clusters;
  for (auto& [first, cluster] : found) {
    if (views[first].cause->status == jones::Status::complete) cluster.line = line_of(cluster.views, views);
    clusters.push_back(std::move(cluster));
  }
  std::stable_sort(clusters.begin(), clusters.end(),
                   [](const AtlasCluster& a, const AtlasCluster& b) { return a.most_wrong > b.most_wrong; });
  return clusters;
}

}  // namespace

AtlasLattice default_lattice(const scene::CellScene& scene) {
  const auto across = static_cast<double>(scene.outer.span(0).length());
  const auto along = static_cast<double>(scene.outer.span(2).length());
  const double step = std::max(1.0, std::sqrt(across * along / usual_eyes));
  const auto steps = [step](double length) {
    return std::clamp(static_cast<int>(std::floor(length / step + 0.5)), 1, most_lattice_steps);
  };
  return {steps(across), steps(along), scene.default_view[1]};
}

std::vector<geometry::Point> lattice_eyes(const scene::CellScene& scene, const AtlasLattice& lattice) {
  std::vector<geometry::Point> eyes;
  for (int row = 0; row < lattice.rows; ++row)
    for (int column = 0; column < lattice.columns; ++column)
      eyes.push_back({middle_of(scene.outer.span(0), column, lattice.columns), lattice.height,
                      middle_of(scene.outer.span(2), row, lattice.rows)});
  std::sort(eyes.begin(), eyes.end(), [](const geometry::Point& a, const geometry::Point& b) {
    return std::tie(a[2], a[0]) < std::tie(b[2], b[0]);
  });
  eyes.erase(std::unique(eyes.begin(), eyes.end()), eyes.end());
  return eyes;
}

std::vector<geometry::Point> random_eyes(const scene::CellScene& scene, std::uint64_t count,
                                         std::uint64_t seed) {
  const scene::PolyScene polyhedra = scene::poly_scene_of(scene);
  std::vector<geometry::Point> eyes;
  for (std::uint64_t number = 0; number < count; ++number)
    eyes.push_back(sweep_camera(polyhedra, &scene, false, seed, number).eye);
  return eyes;
}

std::string WrongCause::name() const {
  if (status != jones::Status::complete) return std::string(jones::name(status));
  if (fraction_bits) return "fraction bits";
  if (concave_mask) return "mask corner";
  if (finer.empty()) return "not a rounding";
  std::string text;
  for (const auto& roundings : finer) text += (text.empty() ? "rounding " : " or ") + names_of(roundings);
  return text;
}

base::Result<ErrorAtlas> ErrorAtlas::of(const scene::CellScene& scene, std::vector<geometry::Point> eyes,
                                        const AtlasOptions& options) {
  const auto free = std::find_if(eyes.begin(), eyes.end(), [&](const geometry::Point& eye) {
    return jones::viewpoint(scene, eye).has_value();
  });
  if (free == eyes.end()) return base::bad_input("found no eye in free space at least one unit from every wall");
  auto matter = oracle::Matter::of(scene);
  if (!matter) return base::bad_input("found too many grid units for the oracle");
  auto program = jones::Prepared::of(scene, {options.eae, static_cast<std::uint32_t>(options.fraction_bits), false});
  if (!program) return program.error();
  return ErrorAtlas(std::move(eyes), options, std::move(*program), std::move(*matter));
}

ErrorAtlas::ErrorAtlas(std::vector<geometry::Point> eyes, const AtlasOptions& options, jones::Prepared program,
                       oracle::Matter matter)
    : eyes_(std::move(eyes)),
      options_(options),
      program_(std::move(program)),
      lines_of_words_(axis_lines_of_vectors(program_.program().scene)),
      matter_(std::move(matter)),
      lines_(matter_.real_lines()) {}

AtlasView ErrorAtlas::view(std::size_t number) const {
  AtlasView view;
  view.eye = eyes_[number];
  const auto core = program_.core_at(view.eye);
  if (!core) return view;
  view.free = true;
  jones::Order order;
  order.eye = view.eye;
  order.views = 1;
  order.display = false;
  const jones::TwinView twin = *program_.twin(order);
  const auto outcome = program_.run(order);
  view.difference = outcome ? jones::difference_of(outcome->view(), twin) : outcome.error().message();
  if (outcome) view.emulated_ns = outcome->view().time.count();

  const oracle::Window window = type340_window();
  const auto truth = image_pieces(oracle::visible_lines(matter_, lines_, view.eye, window), view.eye, window);
  const jones::ShortWords words(jones::machine_word_bits, options_.fraction_bits);
  std::vector<ImagePiece> drawn;
  for (const jones::Piece& piece : twin.pieces) {
    const auto line = lines_of_words_.find(piece.vector_address);
    const auto x = [&](std::int32_t at) { return words.points(at) + window.centre[0]; };
    const auto y = [&](std::int32_t at) { return words.points(at) + window.centre[1]; };
    const jones::ScreenSegment& at = piece.line;
    if (line != lines_of_words_.end())
      drawn.push_back({line->second, {x(at.a.x), y(at.a.y), x(at.b.x), y(at.b.y)}});
  }
  view.wrong = wrong_stretches(truth, drawn, tolerance, view.eye, window);
  if (twin.status != jones::Status::complete || view.wrong.length() > 0)
    view.cause = cause_of(twin.status, *core, truth, view.eye);
  return view;
}

WrongCause ErrorAtlas::cause_of(jones::Status status, const std::vector<core::Word18>& core,
                                const std::vector<ImagePiece>& truth, const geometry::Point& eye) const {
  WrongCause cause;
  cause.status = status;
  const std::uint32_t header = program_.program().labels.scene;
  jones::Parameters parameters = jones::default_parameters(core, header);
  parameters.fraction_bits = options_.fraction_bits;
  const auto in_words = [&](int bits, int fraction_bits) {
    return jones_precision::run_precisely(core, header, parameters,
                                {jones_precision::NumberKind::fixed_point, bits, fraction_bits, false});
  };
  if (status == jones::Status::arithmetic_overflow) {
    for (int bits = jones::machine_word_bits + 1; bits <= jones_precision::longest_word && !cause.word_bits; ++bits)
      if (in_words(bits, options_.fraction_bits).status == jones::Status::complete) cause.word_bits = bits;
  }
  if (status != jones::Status::complete) return cause;

  const auto is_right = [&](const jones_precision::PreciseView& view) {
    return view.status == jones::Status::complete &&
           wrong_stretches(truth, pieces_of(view.pieces, lines_of_words_), tolerance, eye, type340_window())
                   .length() == 0;
  };
  cause.fraction_bits = options_.fraction_bits < jones::machine_fraction_bits &&
                        is_right(in_words(jones::machine_word_bits, jones::machine_fraction_bits));
  cause.concave_mask =
      !cause.fraction_bits && is_right(jones_precision::run_mixed(core, header, parameters, {true, true, true}, true));
  for (std::size_t count = cause.fraction_bits || cause.concave_mask ? jones::roundings + 1 : 1;
       count <= jones::roundings && cause.finer.empty(); ++count)
    for (unsigned chosen = 1; chosen < 1U << jones::roundings; ++chosen) {
      std::array<bool, jones::roundings> finer{};
      std::array<bool, jones::roundings> of_machine{};
      for (std::size_t i = 0; i < finer.size(); ++i) {
        finer[i] = (chosen >> i & 1U) != 0;
        of_machine[i] = !finer[i];
      }
      if (static_cast<std::size_t>(std::count(finer.begin(), finer.end(), true)) != count) continue;
      if (is_right(jones_precision::run_mixed(core, header, parameters, of_machine))) cause.finer.push_back(finer);
    }
  for (int bits = jones_precision::most_fraction_bits; bits >= 0; --bits) {
    if (!is_right(in_words(jones_precision::longest_word, bits))) break;
    cause.right_from_bits = bits;
  }
  return cause;
}

AtlasSummary summary_of(const std::vector<AtlasView>& views) {
  AtlasSummary summary;
  std::vector<double> lengths;
  std::vector<double> times;
  for (std::size_t number = 0; number < views.size(); ++number) {
    const AtlasView& view = views[number];
    if (!view.free) continue;
    const auto longer = [&](std::size_t than) {
      return std::tuple(view.wrong.length(), view.emulated_ns) >
             std::tuple(views[than].wrong.length(), views[than].emulated_ns);
    };
    if (summary.free == 0 || longer(summary.worst)) summary.worst = number;
    if (summary.free == 0 || view.emulated_ns > views[summary.slowest].emulated_ns) summary.slowest = number;
    ++summary.free;
    summary.wrong += view.is_wrong() ? 1 : 0;
    lengths.push_back(view.wrong.length());
    times.push_back(static_cast<double>(view.emulated_ns) / 1e9);
    if (!view.difference.empty() && !summary.differs_from_twin) summary.differs_from_twin = number;
  }
  summary.wrong_length = quantiles_of(std::move(lengths));
  summary.time = quantiles_of(std::move(times));
  summary.clusters = clusters_of(views);
  return summary;
}

}  // namespace sightline::compare
