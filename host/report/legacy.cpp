#include "host/report/legacy.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <type_traits>
#include <utility>

#include "host/report/speed_error/montani_re.hpp"
#include "host/report/speed_error/willis.hpp"
#include "host/report/timing/montani_re.hpp"
#include "host/report/timing/willis.hpp"

namespace sightline::report {

namespace {

using Blocks = Outcome<std::vector<Block>>;

Blocks with_text(const char* heading, const char* text, Blocks blocks) {
  if (!blocks) return blocks;
  std::vector<Block> all;
  all.emplace_back(Heading{heading});
  if (*text != 0) all.emplace_back(Paragraph{text});
  all.insert(all.end(), std::make_move_iterator(blocks->begin()), std::make_move_iterator(blocks->end()));
  return all;
}

Blocks montani_re_accuracy(const Context& context) {
  return with_text("Montani and Re", "", harness::report::montani_re_error_part(context));
}

Blocks willis_accuracy(const Context& context) {
  return with_text("Willis",
                   "Surfaces in the order of their distances, each cut as often as the limit allows until no two are in "
                   "each other's boundary, compared with the nearest face on every sight line.",
                   harness::report::willis_error_blocks(harness::report::measure_willis(context)));
}

constexpr std::array chapters{
    LegacyChapter{"montani-re-timing", &harness::report::timing_of_montani_re},
    LegacyChapter{"willis-timing", &harness::report::timing_of_willis},
    LegacyChapter{"montani-re-accuracy", &montani_re_accuracy},
    LegacyChapter{"willis-accuracy", &willis_accuracy},
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

void drop_host_times(std::vector<Block>& blocks) {
  const auto measured = [](const Figure& figure) { return figure.host_time; };
  std::erase_if(blocks, [&](const Block& block) {
    const auto* const figure = std::get_if<Figure>(&block);
    return figure != nullptr && measured(*figure);
  });
  for (Block& block : blocks) {
    if (auto* const table = std::get_if<Table>(&block)) drop_host_times(*table);
    if (auto* const gallery = std::get_if<Gallery>(&block)) std::erase_if(gallery->figures, measured);
  }
}

}  // namespace

const LegacyChapter* legacy_chapter(std::string_view name) {
  const auto found = std::find_if(chapters.begin(), chapters.end(), [&](const auto& known) { return known.name == name; });
  return found == chapters.end() ? nullptr : &*found;
}

Outcome<std::vector<Block>> make_legacy(const LegacyChapter& chapter, const Context& context) {
  auto blocks = chapter.make(context);
  if (blocks && !context.host_times) drop_host_times(*blocks);
  return blocks;
}

}  // namespace sightline::report
