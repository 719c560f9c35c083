#include "host/programs/turn/tape.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "host/algorithms/plantinga/edge_structure_graph.hpp"
#include "host/algorithms/plantinga/turning_scene.hpp"
#include "host/programs/turn/twin/twin.hpp"
#include "host/scene/model/file_units.hpp"

namespace sightline::programs::turn {

namespace {

namespace plantinga = algorithms::plantinga;
using plantinga::EdgeIndex;
using plantinga::End;
using plantinga::EndKind;
using core::Word18;

constexpr std::uint32_t header_words = 17;
constexpr std::uint32_t most_slots = 512;
constexpr std::size_t most_partners = 62;
constexpr std::uint32_t most_file_words = 2048;
constexpr double largest_form = 65535;

// The word A' of a coefficient A.
std::uint32_t form_word(double value) {
  return static_cast<std::uint32_t>(std::clamp(std::lround(value + form_word_middle), 0L, 131071L));
}

// A function A cos + B sin, not yet scaled.
struct Form {
  double a = 0;
  double b = 0;
};
// u = x cos - z sin of a vector.
Form form_of(double x, double z) { return {x, -z}; }

struct Vector {
  double x, y, z;
};
Vector difference(const plantinga::Vector3& to, const plantinga::Vector3& from) {
  return {static_cast<double>(to[0] - from[0]), static_cast<double>(to[1] - from[1]),
          static_cast<double>(to[2] - from[2])};
}

class Encoder {
 public:
  Encoder(const plantinga::RotationModel& model, const plantinga::EventList& list, Memory memory)
      : model_(model), list_(list) {
    tape_.memory = memory;
  }

  base::Result<Tape> encode() {
    if (const auto error = find_structures()) return *error;
    order_edges();
    if (const auto error = number_slots()) return *error;
    lay_out();
    if (const auto error = divide_core()) return *error;
    return std::move(tape_);
  }

 private:
  std::optional<base::Error> find_structures();
  std::uint32_t code_of(EdgeIndex edge, const End& end);
  void order_edges();
  std::optional<base::Error> number_slots();
  std::uint32_t state_of(std::uint32_t slot, const std::vector<plantinga::EdgeStructure>& structure);
  void lay_out();
  void put_vertices();
  void put_slots();
  void put_junctions();
  void put_events();
  std::optional<base::Error> divide_core();
  std::array<Form, 2> junction_of(const Tape::Slot& slot, const End& end) const;

  std::uint32_t here() const { return model_base(tape_.memory) + static_cast<std::uint32_t>(tape_.words.size()); }
  void put(std::uint32_t word) { tape_.words.emplace_back(word); }
  Word18& header(std::uint32_t at) { return tape_.words[at]; }

  const plantinga::RotationModel& model_;
  const plantinga::EventList& list_;
  Tape tape_;
  std::vector<plantinga::EdgeStructure> start_;   // at angle 0
  std::vector<std::uint32_t> most_pieces_;        // by edge
  std::vector<std::pair<EdgeIndex, bool>> trail_;  // edges in the order of slots, and whether each is reversed
  std::vector<std::uint32_t> places_;             // by vertex: its place minus 1
  std::vector<std::uint32_t> junctions_;          // by edge: forms of its first junction
};

// Goes through the whole turn: finds the ends of every edge, and its greatest number of pieces.
std::optional<base::Error> Encoder::find_structures() {
  const std::size_t edges = model_.edges().size();
  tape_.partners.resize(edges);
  most_pieces_.assign(edges, 1);
  const auto note = [this](EdgeIndex edge, std::span<const plantinga::Piece> pieces) {
    most_pieces_[edge] = std::max(most_pieces_[edge], static_cast<std::uint32_t>(pieces.size()));
    for (const plantinga::Piece& piece : pieces) {
      static_cast<void>(code_of(edge, piece.low));
      static_cast<void>(code_of(edge, piece.high));
    }
  };
  start_ = list_.first;
  std::vector<plantinga::EdgeStructure> now = list_.first;
  for (EdgeIndex e = 0; e < edges; ++e) note(e, now[e]);
  for (const plantinga::Event& event : list_.events) {
    const bool passed = event.direction.angle <= 0;
    for (const plantinga::Change& change : list_.changes_of(event)) {
      const auto added = list_.added_by(change);
      note(change.edge, added);
      now[change.edge].assign(added.begin(), added.end());
      if (passed) start_[change.edge] = now[change.edge];
    }
  }
  for (EdgeIndex e = 0; e < edges; ++e) {
    if (tape_.partners[e].size() > most_partners)
      return base::bad_input(fmt::format("edge {} meets {} others in the turn, expected at most {}", e,
                                    tape_.partners[e].size(), most_partners));
    for (const std::uint32_t bits : tape_.partners[e])
      if (End{bits}.kind() == EndKind::passage)
        return base::bad_input(fmt::format(
            "edge {} ends in the plane of a face, as solids do that touch; the program has no such ends: move the solids "
            "apart", e));
  }
  return std::nullopt;
}

// 1 means a vertex of the edge itself.
std::uint32_t Encoder::code_of(EdgeIndex edge, const End& end) {
  if (end.kind() == EndKind::vertex) return 1;
  auto& partners = tape_.partners[edge];
  const auto found = std::find(partners.begin(), partners.end(), end.bits);
  if (found != partners.end()) return static_cast<std::uint32_t>(found - partners.begin()) + 2;
  partners.push_back(end.bits);
  return static_cast<std::uint32_t>(partners.size()) + 1;
}

// Orders edges in trails, so that each begins where the one before it ends and the beam need not be set again. Trails begin
// at vertices with an odd number of remaining edges, if there are any.
void Encoder::order_edges() {
  const auto& edges = model_.edges();
  std::vector<bool> used(edges.size(), false);
  std::vector<std::uint32_t> left(model_.vertices().size(), 0);
  for (const auto& edge : edges) {
    ++left[edge.from];
    ++left[edge.to];
  }
  while (trail_.size() < edges.size()) {
    std::uint32_t at = 0;
    for (std::uint32_t v = 0; v < left.size(); ++v)
      if (left[v] != 0 && (left[at] == 0 || (left[v] % 2 == 1 && left[at] % 2 == 0))) at = v;
    for (;;) {
      std::optional<EdgeIndex> best;
      for (const EdgeIndex e : model_.edges_at(at)) {
        if (used[e]) continue;
        const auto other = [&](EdgeIndex edge) { return edges[edge].from == at ? edges[edge].to : edges[edge].from; };
        if (!best || left[other(e)] > left[other(*best)]) best = e;
      }
      if (!best) break;
      const bool reversed = edges[*best].from != at;
      used[*best] = true;
      --left[edges[*best].from];
      --left[edges[*best].to];
      trail_.emplace_back(*best, reversed);
      at = reversed ? edges[*best].from : edges[*best].to;
    }
  }
}

std::optional<base::Error> Encoder::number_slots() {
  for (const auto& [edge, reversed] : trail_) tape_.slot_of.push_back({edge, 0, reversed});
  for (const auto& [edge, reversed] : trail_)
    for (std::uint32_t piece = 1; piece < most_pieces_[edge]; ++piece) tape_.slot_of.push_back({edge, piece, reversed});
  tape_.slots = static_cast<std::uint32_t>(tape_.slot_of.size());
  if (tape_.slots <= most_slots) return std::nullopt;
  return base::bad_input(fmt::format("the edges need {} slots, expected at most {}: {} too many; the edges themselves are {}",
                                tape_.slots, most_slots, tape_.slots - most_slots, trail_.size()));
}

std::uint32_t Encoder::state_of(std::uint32_t slot, const std::vector<plantinga::EdgeStructure>& structure) {
  const Tape::Slot& of = tape_.slot_of[slot];
  const plantinga::EdgeStructure& pieces = structure[of.edge];
  if (of.piece >= pieces.size()) return 0;
  std::uint32_t first = code_of(of.edge, pieces[of.piece].low);
  std::uint32_t second = code_of(of.edge, pieces[of.piece].high);
  if (of.reversed) std::swap(first, second);
  return first << 12U | second << 6U;
}

void Encoder::put_vertices() {
  const double scale = points_per_unit(model_);
  const double middle = static_cast<double>(twice_middle(model_)) / 2;
  header(4) = Word18(here() - 1);
  for (const plantinga::Vector3& v : model_.vertices()) {
    const Form form = form_of(static_cast<double>(v[0]) * scale * points_form_unit, static_cast<double>(v[2]) * scale * points_form_unit);
    put(form_word(form.a));
    put(form_word(form.b));
  }
  header(5) = Word18(here() - 1);
  for (const plantinga::Vector3& v : model_.vertices()) {
    places_.push_back(here() - 1);
    put(0220000U + static_cast<std::uint32_t>(std::lround(512 + (static_cast<double>(v[1]) - middle) * scale)));
    put(0);
  }
  tape_.vertices = static_cast<std::uint32_t>(model_.vertices().size());
  tape_.layout.vertices = 4 * tape_.vertices;
}

void Encoder::put_slots() {
  std::uint32_t next = here() + 4 * tape_.slots;
  for (const auto& partners : tape_.partners) {
    junctions_.push_back(next);
    next += 4 * static_cast<std::uint32_t>(partners.size());
  }
  header(6) = Word18(here());
  for (std::uint32_t k = 0; k < tape_.slots; ++k) {
    const Tape::Slot& slot = tape_.slot_of[k];
    const auto& edge = model_.edges()[slot.edge];
    put(state_of(k, start_));
    put(places_[slot.reversed ? edge.to : edge.from]);
    put(places_[slot.reversed ? edge.from : edge.to]);
    put(junctions_[slot.edge] - 9);
  }
  tape_.layout.edges = 4 * tape_.slots;
}

// N and D of equation 5a, from the slot's first vertex; the same for a vertex at the height of a level edge.
std::array<Form, 2> Encoder::junction_of(const Tape::Slot& slot, const End& end) const {
  const auto& edge = model_.edges()[slot.edge];
  const auto& p = model_.vertices()[slot.reversed ? edge.to : edge.from];
  const auto& q = model_.vertices()[slot.reversed ? edge.from : edge.to];
  const Vector along = difference(q, p);
  if (end.kind() == EndKind::contact) {
    const Vector to = difference(model_.vertices()[end.index()], p);
    return {form_of(to.x, to.z), form_of(along.x, along.z)};
  }
  const auto& other = model_.edges()[end.index()];
  const Vector across = difference(model_.vertices()[other.to], model_.vertices()[other.from]);
  const Vector to = difference(model_.vertices()[other.from], p);
  const auto cross = [&across](const Vector& v) {
    return form_of(v.x * across.y - v.y * across.x, v.z * across.y - v.y * across.z);
  };
  return {cross(to), cross(along)};
}

void Encoder::put_junctions() {
  for (EdgeIndex e = 0; e < tape_.partners.size(); ++e) {
    const auto slot = std::find_if(tape_.slot_of.begin(), tape_.slot_of.end(),
                                   [e](const Tape::Slot& s) { return s.edge == e; });
    for (const std::uint32_t bits : tape_.partners[e]) {
      const auto [n, d] = junction_of(*slot, End{bits});
      const double most = std::max({std::abs(n.a), std::abs(n.b), std::abs(d.a), std::abs(d.b)});
      const double scale = most == 0 ? 0 : largest_form / most;
      for (const double value : {n.a, n.b, d.a, d.b}) put(form_word(value * scale));
      ++tape_.junctions;
    }
  }
  tape_.layout.junctions = 4 * tape_.junctions;
}

void Encoder::put_events() {
  std::vector<plantinga::EdgeStructure> now = list_.first;
  std::vector<std::vector<std::uint32_t>> slots_of(now.size());
  for (std::uint32_t k = 0; k < tape_.slots; ++k) slots_of[tape_.slot_of[k].edge].push_back(k);
  const std::uint32_t begun = here();
  header(7) = Word18(begun);
  std::optional<std::uint32_t> next;
  for (std::size_t i = 0; i < list_.events.size();) {
    const std::uint32_t word = event_word(list_.events[i].direction);
    std::map<std::uint32_t, std::uint32_t> before;  // slot -> state
    for (; i < list_.events.size() && event_word(list_.events[i].direction) == word; ++i) {
      for (const plantinga::Change& change : list_.changes_of(list_.events[i])) {
        for (const std::uint32_t k : slots_of[change.edge]) before.emplace(k, state_of(k, now));
        const auto added = list_.added_by(change);
        now[change.edge].assign(added.begin(), added.end());
      }
    }
    std::vector<std::uint32_t> words;
    for (const auto& [k, state] : before) {
      const std::uint32_t mask = state ^ state_of(k, now);
      if ((mask & 0770000U) != 0) words.push_back((mask & 0770000U) | 4 * k);
      if ((mask & 0007700U) != 0) words.push_back((mask & 0007700U) << 6U | 04000U | 4 * k);
    }
    if (words.empty()) continue;
    words.front() |= 2U;
    words.back() |= 1U;
    // Angles ascend from just after minus half a turn; words above 2^17 are negative.
    if (!next && word != 0 && word <= (1U << 17U)) next = here();
    put(word);
    for (const std::uint32_t w : words) put(w);
    ++tape_.events;
    tape_.changes += static_cast<std::uint32_t>(words.size());
  }
  if (tape_.events == 0) {  // the program needs at least one event; this one changes nothing
    put(1U << 17U);
    put(3);
    next = begun;
  }
  header(8) = Word18(here());
  header(9) = Word18(next.value_or(begun));
  tape_.layout.events = here() - begun;
}

void Encoder::lay_out() {
  tape_.words.assign(header_words, Word18(0));
  tape_.layout.header = header_words;
  tape_.edges = static_cast<std::uint32_t>(model_.edges().size());
  put_vertices();
  put_slots();
  put_junctions();
  put_events();
  const auto less = [](std::uint32_t n) { return Word18(0U - n); };
  header(0) = Word18(tape_.memory == Memory::words_8k ? 0401U : 0402U);
  header(1) = less(tape_.vertices);
  header(2) = less(tape_.slots);
  header(3) = less(tape_.edges);
}

// Sizes the display files for the pictures of a whole turn; three of them if there is space, otherwise two.
std::optional<base::Error> Encoder::divide_core() {
  header(11) = Word18(most_file_words);
  Twin twin(tape_.words, model_base(tape_.memory));
  TwinPicture picture;
  std::size_t most = 0;
  constexpr std::uint32_t looks = 2048;
  for (std::uint32_t i = 0; i < looks; ++i) {
    static_cast<void>(twin.next((1U << 18U) / looks, picture));
    most = std::max(most, picture.display_file.size());
  }
  static_cast<void>(twin.next(wire_switch | 1U, picture));
  most = std::max(most, picture.display_file.size());
  // Between the examined angles a picture may have a few lines more.
  constexpr std::uint32_t spare = 24;
  tape_.file_words = std::min(static_cast<std::uint32_t>(most) + spare, most_file_words);

  const bool small = tape_.memory == Memory::words_8k;
  const std::uint32_t base = small ? here() + 1 : model_base(Memory::words_8k);  // the sum is after the model
  const std::uint32_t end = model_end(Memory::words_8k);
  const std::uint32_t free = base < end ? end - base : 0;
  tape_.files = free >= 3 * tape_.file_words ? 3 : 2;
  tape_.layout.display_files = tape_.files * tape_.file_words;
  const std::uint32_t used = here() + 1 + (small ? tape_.layout.display_files : 0);
  const std::uint32_t limit = model_end(tape_.memory);
  const bool files_fit = free >= tape_.layout.display_files;
  if (used > limit || !files_fit) {
    const std::uint32_t over = used > limit ? used - limit : tape_.layout.display_files - free;
    const Layout& l = tape_.layout;
    return base::Error{
        .found = fmt::format("{} words too many for {} of core beside the program: {} for vertices, {} for edges, {} for "
                             "T-junctions, {} for {} events{}",
                             over, small ? "8K" : "32K", l.vertices, l.edges, l.junctions, l.events, tape_.events,
                             small ? fmt::format(", {} for display files", l.display_files) : std::string()),
        .expected = fmt::format("at most {} in all", limit - model_base(tape_.memory)),
        .remedy = small ? "give --memory 32k, or a model with fewer edges" : "take a model with fewer edges"};
  }
  header(11) = Word18(tape_.file_words);
  header(12) = Word18(tape_.files);
  for (std::uint32_t i = 0; i < tape_.files; ++i) header(13 + i) = Word18(end - (i + 1) * tape_.file_words);
  return std::nullopt;
}

}  // namespace

std::uint32_t model_base(Memory memory) { return memory == Memory::words_8k ? 02500 : 020000; }
std::uint32_t model_end(Memory memory) { return memory == Memory::words_8k ? 020000 : 0100000; }

base::Result<scene::PolyScene> stand_on_axis(const scene::PolyScene& scene, bool tilted) {
  scene::PolyScene standing = scene;
  const scene::PolyPoint middle = scene::bounds_of(scene).middle();
  for (scene::PolyPoint& vertex : standing.vertices) {
    const std::array<std::int64_t, 3> p{std::int64_t{vertex[0]} - middle[0], std::int64_t{vertex[1]} - middle[1],
                                        std::int64_t{vertex[2]} - middle[2]};
    const std::array<std::int64_t, 3> q =
        tilted ? std::array<std::int64_t, 3>{13 * p[0], 12 * p[1] - 5 * p[2], 5 * p[1] + 12 * p[2]} : p;
    for (std::size_t a = 0; a < 3; ++a) {
      if (std::abs(q[a]) >= scene::poly_coordinate_limit) {
        // In the unit of the file: tilting multiplied the coordinates by 13.
        const double unit = scene.step / (tilted ? 13 : 1);
        return base::bad_input(fmt::format("vertex {} is {:.6g} from the middle of the model along {}{}, expected less than {:.6g}{}",
                                      scene::file_point_text(scene, vertex), std::abs(static_cast<double>(q[a])) * unit, "xyz"[a],
                                      tilted ? ", tilted" : "", scene::poly_coordinate_limit * unit,
                                      tilted ? "; `sightline turn --level` leaves the model upright" : ""));
      }
      vertex[a] = static_cast<std::int32_t>(q[a]);
    }
  }
  return standing;
}

std::int64_t twice_middle(const plantinga::RotationModel& model) {
  std::int64_t low = std::numeric_limits<std::int64_t>::max();
  std::int64_t high = std::numeric_limits<std::int64_t>::min();
  for (const auto& v : model.vertices()) {
    low = std::min<std::int64_t>(low, v[1]);
    high = std::max<std::int64_t>(high, v[1]);
  }
  return low + high;
}

double points_per_unit(const plantinga::RotationModel& model) {
  const double middle = static_cast<double>(twice_middle(model)) / 2;
  double most = 1;
  for (const auto& v : model.vertices()) {
    most = std::max(most, std::hypot(static_cast<double>(v[0]), static_cast<double>(v[2])));
    most = std::max(most, std::abs(static_cast<double>(v[1]) - middle));
  }
  return points_to_rim / most;
}

std::uint32_t event_word(const plantinga::Direction& direction) {
  const double turns = direction.angle / (2 * std::numbers::pi) * (1 << 18);
  // A direction of degree one or two is a whole word only at multiples of 22.5 degrees.
  constexpr double eighth = 1 << 14;
  const double near = std::round(turns / eighth) * eighth;
  const double word = std::abs(turns - near) < 0x1p-24 ? near : std::ceil(turns);
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(word)) & Word18::mask;
}

base::Result<Tape> encode(const plantinga::RotationModel& model, const plantinga::EventList& list, Memory memory) {
  return Encoder(model, list, memory).encode();
}

Word18 checksum(const std::vector<Word18>& words) {
  Word18 sum(static_cast<std::uint32_t>(words.size()));
  for (const Word18 word : words) sum = sum + word;
  return Word18(0) - sum;
}

base::Bytes punch(const Tape& tape) {
  base::Bytes lines;
  const auto word = [&lines](Word18 w) {
    for (unsigned i = 0; i < 3; ++i)
      lines.push_back(static_cast<base::Bytes::value_type>(0200U | w.field(6 * i, 6 * i + 5)));
  };
  word(Word18(static_cast<std::uint32_t>(tape.words.size())));
  for (const Word18 w : tape.words) word(w);
  word(checksum(tape.words));
  return lines;
}

base::Result<Tape> make_tape(const scene::PolyScene& scene, Memory memory, bool tilted) {
  namespace plantinga = algorithms::plantinga;
  const auto standing = stand_on_axis(scene, tilted);
  if (!standing) return standing.error();
  const plantinga::RotationModel model(*standing);
  if (model.edges().size() > plantinga::most_turned_edges) {
    return base::Error{.found = fmt::format("{} edges", model.edges().size()),
                       .expected = fmt::format("at most {}", plantinga::most_turned_edges)};
  }
  const auto list = plantinga::build_event_list(model);
  if (!list) return list.error();
  return encode(model, *list, memory);
}

}  // namespace sightline::programs::turn
