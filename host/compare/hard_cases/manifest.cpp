#include "host/compare/hard_cases/manifest.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

#include "host/base/json_reader.hpp"
#include "host/base/text.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::compare {

namespace {

using base::Json;
using base::JsonReader;

constexpr std::size_t longest_text = 400;

// Reads the members of an object by name, each once, and rejects unknown ones.
class Members {
 public:
  Members(JsonReader& reader, const Json& object, std::string place)
      : reader_(reader), object_(object), place_(std::move(place)) {}
  ~Members() {
    for (const base::JsonMember& member : object_.members()) {
      const bool known =
          std::any_of(known_.begin(), known_.end(), [&](const char* name) { return member.key == name; });
      if (!known)
        reader_.fail(place_, fmt::format("found \"{}\", expected {}", member.key, base::joined(known_, ", ")));
    }
  }
  Members(const Members&) = delete;
  Members& operator=(const Members&) = delete;

  template <class T>
  Members& need(const char* name, T& value) {
    known_.push_back(name);
    if (const Json* const found = reader_.field(object_, name, place_)) read(*found, at(name), value);
    return *this;
  }
  template <class T>
  Members& may(const char* name, T& value) {
    known_.push_back(name);
    if (const Json* const found = reader_.optional_field(object_, name, place_))
      read(*found, at(name), value);
    return *this;
  }

 private:
  [[nodiscard]] std::string at(const char* name) const {
    return place_.empty() ? std::string(name) : place_ + "." + name;
  }

  void read(const Json& json, const std::string& place, bool& value) { value = reader_.boolean(json, place); }
  void read(const Json& json, const std::string& place, std::string& value) {
    value = reader_.name(json, place, 0, longest_text);
  }
  void read(const Json& json, const std::string& place, double& value) {
    if (reader_.failed()) return;
    const auto number = json.number();
    if (!number) reader_.expected("a number", json, place);
    value = number.value_or(0);
  }
  template <class Integer>
  requires std::is_integral_v<Integer>
  void read(const Json& json, const std::string& place, Integer& value) {
    constexpr auto most = std::numeric_limits<std::int32_t>::max();
    value = static_cast<Integer>(reader_.integer(json, place, std::is_signed_v<Integer> ? -most : 0, most));
  }
  template <class T>
  void read(const Json& json, const std::string& place, std::optional<T>& value) {
    read(json, place, value.emplace());
  }
  template <class T>
  void read(const Json& json, const std::string& place, std::vector<T>& values) {
    values.clear();
    reader_.each(json, place, [&](const Json& element, const std::string& there) {
      read(element, there, values.emplace_back());
    });
  }
  template <class T, std::size_t size>
  void read(const Json& json, const std::string& place, std::array<T, size>& values) {
    if (!reader_.array(json, place, size)) return;
    for (std::size_t i = 0; i < size; ++i) read(json[i], base::indexed(place, i), values[i]);
  }
  template <class T>
  void read(const Json& json, const std::string& place, std::map<std::string, T>& values) {
    if (!json.is_object()) reader_.expected("an object", json, place);
    for (const base::JsonMember& member : json.members())
      read(member.value, place + "." + member.key, values[member.key]);
  }
  template <class Choice, std::size_t size>
  void read(const Json& json, const std::string& place,
            std::pair<Choice*, const std::array<const char*, size>*>& choice) {
    const std::string name = reader_.name(json, place, 1, longest_text);
    const auto& names = *choice.second;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end() && !reader_.failed())
      reader_.expected(fmt::format("one of {}", base::joined(names, ", ")), json, place);
    *choice.first = static_cast<Choice>(found - names.begin());
  }
  void read(const Json& json, const std::string& place, scene::PolyCamera& camera) {
    camera = {true, {0, 0, 0}, {}, {}, {}};
    Members(reader_, json, place)
        .need("forward", camera.forward)
        .need("right", camera.right)
        .need("up", camera.up);
  }
  void read(const Json& json, const std::string& place, LitDots& lit) {
    Members(reader_, json, place)
        .may("slices", lit.slices)
        .may("points", lit.points)
        .may("columns", lit.columns)
        .may("row", lit.row)
        .may("alone", lit.alone);
  }
  void read(const Json& json, const std::string& place, Expectation& expect) {
    Members(reader_, json, place)
        .may("refused", expect.refused)
        .may("program_refuses", expect.program_refuses)
        .may("eye_refused", expect.eye_refused)
        .may("left_over", expect.left_over)
        .may("counts", expect.counts)
        .may("seen", expect.seen)
        .may("hidden", expect.hidden)
        .may("areas", expect.areas)
        .may("through", expect.through)
        .may("dots", expect.dots)
        .may("lit", expect.lit);
  }
  void read(const Json& json, const std::string& place, algorithms::skala::View& view) {
    static constexpr std::array families{"x", "z", "both", "auto"};
    static constexpr std::array subjects{"lines", "surface", "contours"};
    std::pair family{&view.family, &families};
    std::pair subject{&view.subject, &subjects};
    Members(reader_, json, place)
        .may("picture", subject)
        .may("family", family)
        .may("rotation", view.rotation)
        .may("elevation", view.elevation)
        .may("zoom", view.zoom)
        .may("levels", view.levels)
        .may("columns", view.columns);
  }
  void read(const Json& json, const std::string& place, MethodOptions& options) {
    Members members(reader_, json, place);
    members.read_options(options);
  }
  // Points at one depth, in pieces with gaps between them.
  void read(const Json& json, const std::string& place, algorithms::oracle::Chain& chain) {
    using algorithms::oracle::SegmentRole;
    std::vector<std::vector<std::array<int, 2>>> pieces;
    read(json, place, pieces);
    for (const auto& piece : pieces) {
      for (std::size_t i = 0; i < piece.size(); ++i)
        chain.vertices.push_back(
            {piece[i][0], piece[i][1], 0, i == 0 ? SegmentRole::none : SegmentRole::draw});
    }
  }

 public:
  Members& read_options(MethodOptions& options) {
    std::optional<int> bits;
    int fraction = 1;
    bool truncate = false;
    bool single_float = false;
    bool double_float = false;
    std::optional<double> stripe;
    may("plan", options.faces.plan)
        .may("oval", options.faces.oval)
        .may("order_cells", options.faces.order_cells)
        .may("rule90", options.faces.rule90)
        .may("one_silhouette", options.faces.one_silhouette)
        .may("stripes", options.stripes)
        .may("stripe", stripe)
        .may("columns", options.view.columns)
        .may("bits", bits)
        .may("fraction", fraction)
        .may("truncate", truncate)
        .may("float", single_float)
        .may("double", double_float);
    if (stripe) options.stripes = {*stripe};
    using jones_precision::NumberKind;
    if (bits) options.precision = {NumberKind::fixed_point, *bits, fraction, truncate};
    if (single_float) options.precision = {NumberKind::single_float, 0, 0, false};
    if (double_float) options.precision = {NumberKind::double_float, 0, 0, false};
    return *this;
  }
  void read(const Json& json, const std::string& place, FamilyBuild& build) {
    Members members(reader_, json, place);
    members.need("method", build.method).may("to", build.to).may("first", build.first);
    members.read_options(build.options);
  }
  void read(const Json& json, const std::string& place, Family& family) {
    static constexpr std::array searches{"each", "bisect"};
    std::pair search{&family.bisect, &searches};
    Members(reader_, json, place)
        .need("id", family.id)
        .need("parameter", family.parameter)
        .need("input", family.input)
        .need("generator", family.generator)
        .need("values", family.values)
        .need("search", search)
        .need("builds", family.builds);
  }
  // A case inherits the members of its group.
  void read(const Json& json, const std::string& place, HardCaseGroup& group) {
    HardCase common;
    std::vector<const Json*> cases;
    Members members(reader_, json, place);
    members.need("id", group.id)
        .need("run", common.run)
        .may("options", common.options)
        .may("turn", common.turn);
    members.known_.push_back("cases");
    const Json* const listed = reader_.field(json, "cases", place);
    if (listed == nullptr) return;
    reader_.each(*listed, members.at("cases"), [&](const Json& element, const std::string& there) {
      HardCase& hard = group.cases.emplace_back(common);
      Members(reader_, element, there)
          .need("id", hard.id)
          .may("input", hard.input)
          .need("section", hard.section)
          .need("what", hard.what)
          .need("expected", hard.expected)
          .may("run", hard.run)
          .may("options", hard.options)
          .may("scale", hard.options.scale)
          .may("view", hard.options.view)
          .may("cameras", hard.cameras)
          .may("baseline", hard.baseline)
          .may("chains", hard.chains)
          .may("expect", hard.expect)
          .may("found", hard.found)
          .may("tests", hard.tests);
      for (std::size_t i = 0; i < hard.chains.size(); ++i) {
        hard.chains[i].rank = static_cast<int>(i);
        for (auto& vertex : hard.chains[i].vertices) vertex.depth = static_cast<std::int64_t>(1000 * i);
      }
      if (hard.run.empty() && hard.tests.empty())
        reader_.fail(there, "has neither methods to run nor tests, expected one of them");
    });
  }
  void read_manifest(Manifest& manifest) {
    need("groups", manifest.groups).need("families", manifest.families);
  }

 private:
  JsonReader& reader_;
  const Json& object_;
  std::string place_;
  std::vector<const char*> known_;
};

std::string count_text(std::size_t number, const char* what) {
  return fmt::format("{} {}", what, number);
}

}  // namespace

base::Result<Manifest> read_manifest(std::string_view text, std::string_view file) {
  const auto json = base::parse_json(text, file);
  if (!json) return json.error();
  JsonReader reader{std::string(file)};
  Manifest manifest;
  Members(reader, *json, "").read_manifest(manifest);
  if (reader.failed()) return reader.error();
  return manifest;
}

std::string checks_of(const HardCase& hard) {
  const Expectation& expect = hard.expect;
  std::vector<std::string> parts;
  if (expect.refused) parts.emplace_back("refused");
  if (expect.program_refuses) parts.emplace_back("the program refuses");
  if (expect.eye_refused) parts.emplace_back("the eye is refused");
  if (expect.left_over) parts.emplace_back("pairs left over are named");
  if (!hard.run.empty() && !expect.refused) parts.emplace_back("the baseline's picture");
  for (const auto& [name, number] : expect.counts) {
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    parts.push_back(fmt::format("{} {}", words, number));
  }
  if (!expect.seen.empty()) parts.push_back(count_text(expect.seen.size(), "lines seen whole"));
  if (!expect.hidden.empty()) parts.push_back(count_text(expect.hidden.size(), "lines hidden whole"));
  if (!expect.areas.empty()) parts.push_back(fmt::format("seen areas {}", base::joined(expect.areas, ", ")));
  if (expect.through) parts.push_back(fmt::format("bodies {} named", base::joined(*expect.through, " and ")));
  if (expect.dots) parts.push_back(count_text(*expect.dots, "dots"));
  if (const auto& lit = expect.lit) {
    if (lit->slices) parts.push_back(fmt::format("slices {} lit", base::joined(*lit->slices, " to ")));
    if (lit->points) parts.push_back(fmt::format("lines across {} lit", base::joined(*lit->points, " to ")));
    if (lit->columns) parts.push_back(fmt::format("in columns {}", base::joined(*lit->columns, " to ")));
    if (lit->alone) parts.emplace_back("no other dot");
    if (lit->row) parts.push_back(fmt::format("dots in row {}", *lit->row));
  }
  return base::joined(parts, "; ");
}

std::string_view hard_case_text(std::string_view file) {
  for (const auto& [name, text] : hard_case_files()) {
    if (name == file) return text;
  }
  const std::string_view name = file.substr(0, file.rfind('.'));
  return scene::builtin_scene_text(name).value_or(std::string_view());
}

}  // namespace sightline::compare
