// The list of the report's parts, and what leaves them.
#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

#include "host/report/agreement/matrix.hpp"
#include "host/report/hard_cases/hard_cases.hpp"
#include "host/report/report.hpp"
#include "host/report/scene_needs/scene_needs.hpp"
#include "host/report/speed_error/speed_error.hpp"
#include "host/report/timing/papers.hpp"

namespace sightline::harness::report {

namespace {

constexpr std::array parts{
    Part{1, "Timing against the papers", &timing_against_papers},
    Part{2, "Speed against error", &speed_against_error},
    Part{3, "Hard cases", &hard_cases},
    Part{4, "What the scene needed", &scene_needs},
    Part{5, "All five against each other", &all_against_each_other},
};

void drop_host_times(Table& table) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (!table.columns[i].host_time) kept.push_back(i);
  if (kept.size() == table.columns.size()) return;
  const auto keep = [&kept](auto& values) {
    std::decay_t<decltype(values)> less;
    for (const std::size_t i : kept)
      if (i < values.size()) less.push_back(std::move(values[i]));
    values = std::move(less);
  };
  keep(table.columns);
  for (auto& row : table.rows) keep(row);
}

void drop_host_times(Section& section) {
  const auto measured = [](const Figure& figure) { return figure.host_time; };
  std::erase_if(section.blocks, [&](const Block& block) {
    const auto* const figure = std::get_if<Figure>(&block);
    return figure != nullptr && measured(*figure);
  });
  for (Block& block : section.blocks) {
    if (auto* const table = std::get_if<Table>(&block)) drop_host_times(*table);
    if (auto* const gallery = std::get_if<Gallery>(&block)) std::erase_if(gallery->figures, measured);
  }
}

}  // namespace

std::span<const Part> all_parts() {
  return parts;
}

Outcome<std::vector<Section>> make_sections(std::span<const Part> wanted, const Context& context) {
  std::vector<Section> sections;
  for (const Part& part : wanted) {
    context.progress(part.title);
    auto made = part.make(context);
    if (!made) return std::move(made.error());
    sections.push_back(std::move(*made));
    if (!context.host_times) drop_host_times(sections.back());
  }
  return sections;
}

}  // namespace sightline::harness::report
