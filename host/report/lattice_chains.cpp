#include "host/report/lattice_chains.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "host/base/number.hpp"
#include "host/scene/read/poly_text.hpp"

namespace sightline::harness::report {

namespace {

constexpr std::int64_t farthest = 1 << 20;  // of a starting point; and as many links

}  // namespace

base::Result<LatticeRegions> read_chains(std::string_view text, std::string_view source) {
  LatticeRegions regions;
  scene::PolyLines lines(text, source);
  while (lines.next()) {
    const auto& fields = lines.fields();
    if (fields.size() != 4)
      return lines.error(fmt::format("found {} fields, expected name, x, y and links", fields.size()));
    std::array<std::int32_t, 2> start{};
    for (std::size_t a = 0; a < 2; ++a) {
      const auto number = base::signed_number(fields[1 + a]);
      if (!number || *number < 0 || *number > farthest)
        return lines.unexpected(fields[1 + a], fmt::format("an integer from 0 to {}", farthest));
      start[a] = static_cast<std::int32_t>(*number);
    }
    const std::string_view links = fields[3];
    if (links.size() > farthest || links.find_first_not_of("01234567") != std::string_view::npos)
      return lines.unexpected(links, fmt::format("up to {} digits from 0 to 7", farthest));
    regions[std::string(fields[0])].push_back({{start[0], start[1]}, links});
  }
  return regions;
}

}  // namespace sightline::harness::report
