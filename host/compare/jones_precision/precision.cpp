#include "host/compare/jones_precision/precision.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "host/base/result.hpp"
#include "host/programs/jones/twin/elements.hpp"
#include "host/programs/jones/twin/search.hpp"

namespace sightline::compare::jones_precision {

using namespace programs::jones;

namespace {

constexpr int longest_short_word = 30;

template <class Number>
PreciseView view_of(std::span<const core::Word18> core, std::uint32_t header, const Parameters& parameters,
                    const Number& number) {
  auto view = Search<Number>(core, header, parameters, number).run();
  PreciseView precise;
  precise.status = view.status;
  precise.counts = view.counts;
  precise.display_words = view.display_file.size();
  for (const auto& piece : view.clipped) {
    const Window window = window_of(piece.pass, parameters.scale);
    const auto x = [&](auto coordinate) { return number.points(coordinate) + window.centre_x; };
    const auto y = [&](auto coordinate) { return number.points(coordinate) + window.centre_y; };
    const auto& line = piece.line;
    precise.pieces.push_back(
        {piece.vector_address, piece.pass, {x(line.a.x), y(line.a.y), x(line.b.x), y(line.b.y)}});
  }
  return precise;
}

// element: address of X.
void add_chain(const CoreImage& core, std::uint32_t element, std::vector<std::optional<SceneLine>>& lines) {
  geometry::Point at{core.number(element), core.number(element + 1), core.number(element + 2)};
  const std::uint32_t count = std::min<std::uint32_t>(core[element + 3].value(), core_words);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t address = (element + 4 + i) & address_mask;
    const Vector vector(core[address]);
    if (vector.axis_code == 0) return;
    const std::size_t axis = vector.axis_code - 1;
    SceneLine line{axis, at, at};
    at[axis] = wrapped(std::int64_t{at[axis]} + vector.magnitude);
    line.to = at;
    if (line.to[axis] < line.from[axis]) std::swap(line.from, line.to);
    lines[address] = line;
  }
}

}  // namespace

bool is_possible(const Precision& precision) {
  if (precision.kind != NumberKind::fixed_point) return true;
  return precision.word_bits >= shortest_word && precision.word_bits <= longest_word &&
         precision.fraction_bits >= 0 && precision.fraction_bits <= most_fraction_bits;
}

std::string name(const Precision& precision) {
  if (precision.kind == NumberKind::single_float) return "float";
  if (precision.kind == NumberKind::double_float) return "double";
  return fmt::format("{} bits, f={}{}", precision.word_bits, precision.fraction_bits,
                     precision.truncate ? ", truncated" : "");
}

PreciseView run_precisely(std::span<const core::Word18> core, std::uint32_t scene_header,
                          const Parameters& parameters, const Precision& precision) {
  assert(is_possible(precision));
  const auto run_in = [&](const auto& number) { return view_of(core, scene_header, parameters, number); };
  if (precision.kind == NumberKind::single_float) return run_in(SingleFloat());
  if (precision.kind == NumberKind::double_float) return run_in(DoubleFloat());
  if (precision.word_bits <= longest_short_word)
    return run_in(ShortWords(precision.word_bits, precision.fraction_bits, precision.truncate));
  return run_in(LongWords(precision.word_bits, precision.fraction_bits, precision.truncate));
}

PreciseView run_mixed(std::span<const core::Word18> core, std::uint32_t scene_header, const Parameters& parameters,
                      const std::array<bool, roundings>& of_machine, bool convex_masks) {
  return view_of(core, scene_header, parameters,
                 MixedWords(parameters.fraction_bits, parameters.truncate, of_machine, convex_masks));
}

std::vector<std::optional<SceneLine>> lines_by_address(const EncodedScene& scene,
                                                       std::span<const core::Word18> core) {
  std::vector<std::optional<SceneLine>> lines(core_words);
  const CoreImage image(core);
  for (const std::uint32_t cell : scene.cell_addresses) add_chain(image, cell, lines);
  for (const std::uint32_t opening : scene.opening_addresses) add_chain(image, opening + 2, lines);
  return lines;
}

base::Result<SceneInCore> scene_in_core(const scene::CellScene& scene, const geometry::Point& eye) {
  auto encoded = encode(scene, eye);
  if (!encoded) return std::move(encoded.error());
  const auto& image = *encoded;
  SceneInCore result;
  result.core.resize(core_words);
  for (std::size_t i = 0; i < image.words.size(); ++i) result.core.at(i) = core::Word18(image.words[i].value);
  result.lines = lines_by_address(image, result.core);
  return result;
}

}  // namespace sightline::compare::jones_precision
