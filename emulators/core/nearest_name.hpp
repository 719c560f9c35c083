// Of several names the one that was probably meant, for the error messages of machines.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sightline::core {

// Characters to insert, remove or replace (Levenshtein 1965).
[[nodiscard]] inline std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> last(to.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::vector<std::size_t> row(to.size() + 1, i);
    for (std::size_t j = 1; j <= to.size(); ++j)
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1)});
    last = std::move(row);
  }
  return last.back();
}

// ` Did you mean "ef9365"?` if one of the names is near, else the list of them: ` Known: ef9365, alt256.`
[[nodiscard]] inline std::string suggest_name(std::string_view written, const std::vector<std::string_view>& names) {
  constexpr std::size_t longest_compared = 100;
  std::size_t least = 3 + written.size() / 4;  // the first distance that is too far
  std::string_view nearest;
  for (const std::string_view name : names) {
    if (written.empty() || written.size() > longest_compared) break;
    const std::size_t distance = name.starts_with(written) ? 1 : edit_distance(written, name);
    if (distance >= least || distance >= written.size()) continue;
    least = distance;
    nearest = name;
  }
  if (!nearest.empty()) return std::string(" Did you mean \"").append(nearest).append("\"?");
  if (names.empty()) return {};
  std::string list = " Known:";
  for (const std::string_view name : names) list.append(list.back() == ':' ? " " : ", ").append(name);
  return list + '.';
}

}  // namespace sightline::core
