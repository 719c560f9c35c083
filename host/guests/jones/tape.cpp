#include "host/guests/jones/tape.hpp"

#include <algorithm>

#include "host/base/result.hpp"

namespace sightline::guests::jones {
namespace {

constexpr std::size_t expression_column = 8;
constexpr std::size_t comment_column = 28;

std::string line_of(const EncodedWord& word) {
  std::string line = word.tag.empty() ? "" : word.tag + ",";
  line.resize(std::max(expression_column, line.size() + 1), ' ');
  line += word.expression;
  line.resize(std::max(comment_column, line.size() + 1), ' ');
  return line + "/ " + word.comment + "\n";
}

}  // namespace

base::Result<std::string> write_tape(const scene::CellScene& scene, const TapeOptions& options) {
  const auto encoded = encode(scene, options);
  if (!encoded) return encoded.error();
  const auto& result = *encoded;
  std::string text = "/ scene " + scene.name + ": " + std::to_string(scene.cells.size()) + " cells in " +
                     std::to_string(result.cell_words) + " words, " + std::to_string(scene.openings.size()) +
                     " openings in " + std::to_string(result.opening_words) + ", header " +
                     std::to_string(scene_header_words) + "\n";
  for (const EncodedWord& word : result.words) text += line_of(word);
  return text;
}

}  // namespace sightline::guests::jones
