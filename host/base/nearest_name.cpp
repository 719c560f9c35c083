#include "host/base/nearest_name.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace sightline::base {

std::size_t edit_distance(std::string_view from, std::string_view to) {
  // Three rows of the table of distances between prefixes: a transposition needs the row before the last one.
  std::vector<std::size_t> before;
  std::vector<std::size_t> last(to.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::vector<std::size_t> row(to.size() + 1, i);
    for (std::size_t j = 1; j <= to.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = std::exchange(last, std::move(row));
  }
  return last.back();
}

std::string nearest_name(std::string_view written, std::span<const std::string> names) {
  constexpr std::size_t shortest_beginning = 2;
  constexpr std::size_t longest_compared = 100;  // no name is longer; the table stays small for any input
  if (written.empty() || written.size() > longest_compared) return {};
  std::size_t least = 2 + written.size() / 4;  // the first distance that is too far
  const std::string* nearest = nullptr;
  for (const std::string& name : names) {
    const bool begins = written.size() >= shortest_beginning && name.starts_with(written);
    const std::size_t distance = begins ? 1 : edit_distance(written, name);
    // A text in which every character changes resembles every name.
    if (distance >= least || distance >= written.size()) continue;
    least = distance;
    nearest = &name;
  }
  return nearest == nullptr ? std::string() : *nearest;
}

std::string did_you_mean(std::string_view written, std::span<const std::string> names) {
  const std::string name = nearest_name(written, names);
  return name.empty() ? std::string() : "did you mean \"" + name + "\"?";
}

}  // namespace sightline::base
