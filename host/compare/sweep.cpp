// See sweep.hpp.
#include "host/compare/sweep.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "host/algorithms/oracle/drawn_error.hpp"
#include "host/algorithms/oracle/matter.hpp"
#include "host/algorithms/oracle/visible_lines.hpp"
#include "host/base/json.hpp"
#include "host/base/result.hpp"
#include "host/compare/sweep_views.hpp"
#include "host/guests/jones/session.hpp"
#include "host/picture/line_picture_image.hpp"
#include "host/scene/model/cell_scene.hpp"

namespace sightline::compare {

namespace {

namespace oracle = algorithms::oracle;

// From coordinates of the program, about the middle of the screen, to points.
std::vector<oracle::ScreenSegment> in_points(const std::vector<guests::jones::Piece>& pieces) {
  constexpr double centre = 512;
  std::vector<oracle::ScreenSegment> segments;
  segments.reserve(pieces.size());
  const guests::jones::ShortWords number;
  const auto point = [&number](std::int32_t coordinate) { return number.points(coordinate) + centre; };
  for (const guests::jones::Piece& piece : pieces)
    segments.push_back({point(piece.line.a.x), point(piece.line.a.y), point(piece.line.b.x), point(piece.line.b.y)});
  return segments;
}

}  // namespace

// One view of a scene of cells by Jones's program on the emulated PDP-7 and by its twin, compared with each
// other word for word and with what is truly seen.
struct GuestResult {
  std::string_view status;
  bool same_as_twin = false;  // status and display words
  std::size_t display_words = 0;
  std::uint64_t pieces = 0;
  std::uint64_t visits = 0;
  std::int64_t emulated_ns = 0;  // the paper's computing time
  // Of the pieces, farther than one point from anything true, or drawn.
  algorithms::oracle::DrawnError error;
};

class Sweep::Guest {
 public:
  // Empty if the scene is beyond what the oracle can hold. It outlives this.
  [[nodiscard]] static std::optional<Guest> of(const scene::CellScene& scene, bool eae);

  // An error if the program does not accept that eye, or the scene does not fit into core.
  [[nodiscard]] base::Result<GuestResult> view(const geometry::Point& eye) const;

 private:
  Guest(const scene::CellScene& scene, bool eae, algorithms::oracle::Matter matter);
  [[nodiscard]] GuestResult view(const guests::jones::Session& session, std::span<const core::Word18> core,
                                 const geometry::Point& eye) const;

  const scene::CellScene* scene_;
  guests::jones::ProgramOptions options_;
  // Empty if the program does not accept the scene's own view: it is assembled for every view then.
  std::optional<guests::jones::Session> session_;
  algorithms::oracle::Matter matter_;
  std::vector<algorithms::oracle::RealLine> lines_;
};

Sweep::Guest::Guest(const scene::CellScene& scene, bool eae, oracle::Matter matter)
    : scene_(&scene), matter_(std::move(matter)), lines_(matter_.real_lines()) {
  options_.eae = eae;
  auto session = guests::jones::Session::of(scene, options_);
  if (session) session_ = std::move(*session);
}

std::optional<Sweep::Guest> Sweep::Guest::of(const scene::CellScene& scene, bool eae) {
  auto matter = oracle::Matter::of(scene);
  if (!matter) return std::nullopt;
  return Guest(scene, eae, std::move(*matter));
}

base::Result<GuestResult> Sweep::Guest::view(const geometry::Point& eye) const {
  if (session_) {
    const auto core = session_->core_at(eye);
    if (!core) return core.error();
    return view(*session_, *core, eye);
  }
  guests::jones::ProgramOptions options = options_;
  options.tape.view = eye;
  const auto session = guests::jones::Session::of(*scene_, options);
  if (!session) return session.error();
  return view(*session, session->program().core, eye);
}

GuestResult Sweep::Guest::view(const guests::jones::Session& session, std::span<const core::Word18> core,
                               const geometry::Point& eye) const {
  guests::jones::GuestOptions options;
  options.views = 1;
  options.display = false;
  const guests::jones::CheckedRun run = session.run(core, options);
  GuestResult result;
  result.status = guests::jones::name(run.twin.status);
  if (!run.guest.views.empty()) {
    const guests::jones::GuestView& guest = run.guest.views.front();
    result.status = guests::jones::name(guest.status);
    result.same_as_twin = run.difference.empty();
    result.display_words = guest.display_file.size();
    result.pieces = guest.pieces;
    result.visits = guest.visits;
    result.emulated_ns = guest.time.count();
  }
  oracle::Window window;
  window.near = guests::jones::near_z;
  result.error =
      oracle::drawn_error(oracle::on_screen(oracle::visible_lines(matter_, lines_, eye, window), eye, window),
                          in_points(run.twin.pieces), 1.0);
  return result;
}

namespace {

using base::Json;

// FNV-1a over all that an algorithm is given of the scene: a file that has changed is noticed.
std::string fingerprint_of(const scene::PolyScene& scene) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&hash](std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte, value >>= 8) hash = (hash ^ (value & 0xffU)) * 0x100000001b3U;
  };
  const auto add_ring = [&add](const std::vector<scene::VertexIndex>& ring) {
    add(ring.size());
    for (const scene::VertexIndex v : ring) add(v);
  };
  add(scene.vertices.size());
  for (const scene::PolyPoint& p : scene.vertices)
    for (const std::int32_t c : p) add(static_cast<std::uint32_t>(c));
  for (const scene::PolyBody& body : scene.bodies) {
    add(body.faces.size());
    add(body.sheet ? 1 : 0);
    for (const scene::PolyFace& face : body.faces) {
      add_ring(face.outline);
      add(face.holes.size());
      for (const auto& hole : face.holes) add_ring(hole);
    }
  }
  char digits[17];
  static_cast<void>(std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash)));
  return digits;
}

std::string text_of(const Json& document) {
  return document.dump();
}

Json json_of(const std::vector<registry::AlgorithmCount>& counts) {
  Json document = Json::object();
  for (const registry::AlgorithmCount& count : counts) document[std::string(count.name)] = count.value;
  return document;
}

std::string text_of(const geometry::Rational& r) {
  return std::to_string(r.numerator()) + "/" + std::to_string(r.denominator());
}

bool before(const picture::LinePiece& a, const picture::LinePiece& b) {
  if (a.edge != b.edge) return a.edge < b.edge;
  if (a.low != b.low) return a.low < b.low;
  return a.high < b.high;
}

// How many pieces are in one picture only, and the first of them.
Json difference_of(const picture::LinePicture& exact, const picture::LinePicture& other) {
  std::vector<picture::LinePiece> missing;
  std::vector<picture::LinePiece> extra;
  std::set_difference(exact.pieces.begin(), exact.pieces.end(), other.pieces.begin(), other.pieces.end(),
                      std::back_inserter(missing), before);
  std::set_difference(other.pieces.begin(), other.pieces.end(), exact.pieces.begin(), exact.pieces.end(),
                      std::back_inserter(extra), before);
  const bool is_missing = !missing.empty() && (extra.empty() || before(missing.front(), extra.front()));
  Json document{{"missing_pieces", missing.size()}, {"extra_pieces", extra.size()}};
  if (missing.empty() && extra.empty()) return document;
  const picture::LinePiece& first = is_missing ? missing.front() : extra.front();
  document["first"] = {{"edge", Json::array({first.edge.from, first.edge.to})},
                       {"low", text_of(first.low)},
                       {"high", text_of(first.high)},
                       {"is", is_missing ? "missing" : "extra"}};
  return document;
}

Json json_of(const base::Result<GuestResult>& result) {
  if (!result) return {{"error", result.error().message()}};
  const auto& view = *result;
  return {{"status", view.status},
          {"same_as_twin", view.same_as_twin},
          {"display_words", view.display_words},
          {"pieces", view.pieces},
          {"visits", view.visits},
          {"emulated_ns", view.emulated_ns},
          {"true_length", view.error.true_length},
          {"drawn_length", view.error.drawn_length},
          {"missing", view.error.missing},
          {"extra", view.error.extra}};
}

}  // namespace

SweepShard sweep_shard(std::uint64_t views, std::uint64_t number, std::uint64_t count) {
  // views and count are below 2^32: no product overflows.
  return {views * (number - 1) / count, views * number / count};
}

base::Result<Sweep> Sweep::of(const std::string& source, const scene::PolyScene& scene,
                              const scene::CellScene* cells, const SweepOptions& options) {
  Sweep sweep;
  sweep.source_ = source;
  sweep.fingerprint_ = fingerprint_of(scene);
  sweep.scene_ = &scene;
  sweep.cells_ = cells;
  sweep.options_ = options;
  std::vector<const registry::LineAlgorithm*> algorithms{&registry::line_algorithms().front()};
  for (const registry::LineAlgorithm* algorithm : options.algorithms)
    if (std::find(algorithms.begin(), algorithms.end(), algorithm) == algorithms.end())
      algorithms.push_back(algorithm);
  for (const registry::LineAlgorithm* algorithm : algorithms) {
    auto prepared = algorithm->prepare(scene);
    if (!prepared) return base::Error{source, prepared.error().place, prepared.error().found};
    sweep.entries_.push_back({algorithm, std::move(*prepared)});
  }
  if (options.guest && cells != nullptr) {
    auto guest = Guest::of(*cells, options.eae);
    if (!guest)
      return base::Error{source, "", "too many grid coordinates for the oracle that checks the guest"};
    sweep.guest_ = std::make_shared<const Guest>(std::move(*guest));
  }
  return sweep;
}

std::string Sweep::head(std::uint64_t number, const scene::PolyCamera& camera) const {
  Json algorithms = Json::array();
  for (const Entry& entry : entries_) algorithms.push_back(entry.algorithm->name);
  Json document{{"schema", "sightline/sweep/1"}, {"scene", source_}, {"fingerprint", fingerprint_},
                {"seed", options_.seed},         {"view", number},   {"algorithms", algorithms}};
  if (guest_) document["guest"] = options_.eae ? "with EAE" : "without EAE";
  if (options_.turned) document["directions"] = "all";
  document["camera"] = {{"perspective", camera.perspective},
                        {"eye", camera.eye},
                        {"forward", camera.forward},
                        {"right", camera.right},
                        {"up", camera.up}};
  std::string text = text_of(document);
  text.pop_back();
  return text + ",\"results\":";
}

std::string Sweep::line(std::uint64_t number) const {
  const scene::PolyCamera camera = sweep_camera(*scene_, cells_, options_.turned, options_.seed, number);
  Json results;
  picture::LinePicture exact;
  for (const Entry& entry : entries_) {
    Json& result = results[std::string(entry.algorithm->name)];
    if (const auto reason = entry.algorithm->why_not_seen(*scene_, camera)) {
      result["not_applicable"] = *reason;
      continue;
    }
    const auto start = std::chrono::steady_clock::now();
    auto seen = entry.prepared.view(camera);
    const auto time = std::chrono::steady_clock::now() - start;
    if (!seen) {
      result["error"] = seen.error().message();
      continue;
    }
    auto& view = *seen;
    result["pieces"] = view.picture.pieces.size();
    result["visible_length"] = picture::image_length(view.picture, *scene_, camera);
    if (&entry != &entries_.front()) {
      const bool same = registry::agrees(*entry.algorithm, view.picture, exact, *scene_, camera);
      result["agrees"] = same;
      if (!same) result["difference"] = difference_of(exact, view.picture);
    }
    if (!view.counts.empty()) result["counts"] = json_of(view.counts);
    if (options_.time) result["ns"] = std::chrono::duration_cast<std::chrono::nanoseconds>(time).count();
    if (&entry == &entries_.front()) exact = std::move(view.picture);
  }
  if (guest_ && looks_along_z(camera)) results["guest"] = json_of(guest_->view(camera.eye));
  if (guest_ && !looks_along_z(camera))
    results["guest"]["not_applicable"] = "the program looks along +z only";
  return head(number, camera) + text_of(results) + "}\n";
}

bool Sweep::is_line(std::uint64_t number, std::string_view text) const {
  return text.starts_with(
             head(number, sweep_camera(*scene_, cells_, options_.turned, options_.seed, number))) &&
         text.ends_with("}}\n");
}

bool Sweep::agrees(std::string_view line) {
  // In a string a quotation mark has a backslash before it: none of these can be part of a name.
  return line.find(",\"agrees\":false") == std::string_view::npos &&
         line.find(",\"same_as_twin\":false") == std::string_view::npos &&
         line.find("{\"error\":") == std::string_view::npos;
}

}  // namespace sightline::compare
