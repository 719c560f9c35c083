#include "host/report/hard_cases/hard_cases.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "host/report/hard_cases/jones.hpp"
#include "host/report/hard_cases/montani_re.hpp"
#include "host/report/hard_cases/plantinga.hpp"
#include "host/report/hard_cases/skala.hpp"
#include "host/report/hard_cases/willis.hpp"
#include "host/scene/read/builtin.hpp"

namespace sightline::harness::report {

namespace {

// "J5-strip.json" is "input-j5-strip-json".
std::string listing_id(std::string_view file) {
  std::string id = "input-";
  for (const char c : file)
    id += c == '.' ? '-' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return id;
}

// Of a grid: as the command's options.
std::string view_text(const SkalaHardCase& hard) {
  if (hard.file.empty() || hard.file.ends_with(".txt")) return "commands";
  constexpr std::array families{"x", "z", "both", "auto"};
  std::string text = fmt::format("rotation {}, elevation {}", hard.view.rotation, hard.view.elevation);
  if (hard.view.picture == guests::skala::PictureKind::contours)
    return fmt::format("{} contours, {}", hard.view.levels, text);
  if (hard.view.zoom != 1) text += fmt::format(", zoom {}", hard.view.zoom);
  return fmt::format("family {}, {}", families[static_cast<std::size_t>(hard.view.family)], text);
}

Table jones_table(const Context& context) {
  Table table;
  table.id = "hard-cases-jones";
  table.title = "Jones: cells and openings, J1 to J17";
  table.columns = {{"case", "Case", "", false},
                   {"input", "Input", "", false},
                   {"what", "What it is", "", false},
                   {"expected", "Expected", "", false},
                   {"expected_value", "Checked", "", false},
                   {"guest", "Program", "on the PDP-7", false},
                   {"twin", "Twin", "", false},
                   {"native", "Native Jones", "", false},
                   {"exact", "exact", "", false},
                   {"oracle", "Oracle", "", false}};
  for (const JonesHardCase& hard : jones_hard_cases()) {
    context.progress(fmt::format("hard case {}", hard.file));
    JonesHardResult result = run_hard_case(hard);
    table.rows.push_back({std::string(hard.id), std::string(hard.file), std::string(hard.what),
                          std::string(hard.expected), expected_value(hard), std::move(result.guest),
                          std::move(result.twin), std::move(result.native), std::move(result.exact),
                          std::move(result.oracle)});
  }
  table.notes = {
      "Program and twin are held against the oracle of cells on the screen: farther than a point from what "
      "is seen is wrong. Native Jones has the cells of the file and must give the oracle's picture, piece "
      "for piece; where the eye is not in free space there is none (J3), and the lines named must be seen or "
      "hidden whole."};
  return table;
}

Table skala_table(const Context& context) {
  Table table;
  table.id = "hard-cases-skala";
  table.title = "Skala: slices on a raster, S1 to S16";
  table.columns = {{"case", "Case", "", false},
                   {"input", "Input", "", false},
                   {"what", "What it is", "", false},
                   {"view", "View", "", false},
                   {"expected", "Expected", "", false},
                   {"expected_value", "Checked", "", false},
                   {"guest", "Program", "on the 8080", false},
                   {"twin", "Twin", "", false},
                   {"native", "Native Skala", "", false},
                   {"oracle", "Oracle", "", false}};
  for (const SkalaHardCase& hard : skala_hard_cases()) {
    context.progress(fmt::format("hard case {}", hard.file.empty() ? hard.id : hard.file));
    SkalaHardResult result = run_hard_case(hard);
    table.rows.push_back({std::string(hard.id), std::string(hard.file.empty() ? "as described" : hard.file),
                          std::string(hard.what), view_text(hard), std::string(hard.expected),
                          std::string(hard.value), std::move(result.guest), std::move(result.twin),
                          std::move(result.native), std::move(result.oracle)});
  }
  table.notes = {
      "The oracle decides each column by depth alone. Program and twin must have its dots, native Skala be "
      "within a dot of them; of a view straight on, the first and the last column are left out, where the "
      "program's order hides one of the two rims and vectors show both."};
  return table;
}

// Every input once, in the order of the tables.
void add_inputs(Section& section) {
  section.blocks.emplace_back(Heading{"Inputs of the hard cases"});
  section.blocks.emplace_back(
      Paragraph{"Saved, a scene (.json) is drawn by `sightline draw jones FILE -o picture.svg`, and a scene "
                "of cells compared by `sightline compare FILE`; a grid (.csv, .dat) is drawn by `sightline "
                "draw skala FILE -o picture.svg` and compared by `sightline compare FILE`, with the options "
                "that stand in the table. Commands (.txt) are those of the program on the 8080, by name, "
                "arguments in decimal; of P, edges and vertices, and its scenes turn by `sightline spin FILE "
                "-o turn.apng`."});
  std::vector<std::string_view> files;
  for (const JonesHardCase& hard : jones_hard_cases()) files.push_back(hard.file);
  for (const SkalaHardCase& hard : skala_hard_cases()) files.push_back(hard.file);
  for (const WillisHardCase& hard : willis_hard_cases()) files.push_back(hard.file);
  for (const MontaniReHardCase& hard : montani_re_hard_cases()) files.push_back(hard.file);
  for (const PlantingaHardCase& hard : plantinga_hard_cases()) files.push_back(hard.file);
  std::vector<std::string_view> listed;
  for (const std::string_view file : files) {
    if (file.empty() || std::find(listed.begin(), listed.end(), file) != listed.end()) continue;
    listed.push_back(file);
    section.blocks.emplace_back(
        Listing{listing_id(file), std::string(file), std::string(hard_case_text(file))});
  }
}

}  // namespace

std::string_view hard_case_text(std::string_view file) {
  for (const auto& [name, text] : hard_case_files()) {
    if (name == file) return text;
  }
  const std::string_view name = file.substr(0, file.rfind('.'));
  return scene::builtin_scene_text(name).value_or(std::string_view());
}

Outcome<Section> hard_cases(const Context& context) {
  Section section{"hard-cases", "Hard cases", {}};
  section.blocks.emplace_back(
      Paragraph{"Inputs that break programs of this kind, each with what must come out. Every build has run "
                "them just now. Right: all that is checked is so. Where a program for a small machine "
                "differs, that is what the machine cost; an exact build must be right everywhere."});
  section.blocks.emplace_back(jones_table(context));
  auto jones = jones_families(context);
  if (!jones) return std::move(jones.error());
  section.blocks.emplace_back(std::move(*jones));
  section.blocks.emplace_back(skala_table(context));
  auto skala = skala_families(context);
  if (!skala) return std::move(skala.error());
  section.blocks.emplace_back(std::move(*skala));
  section.blocks.emplace_back(willis_table(context));
  section.blocks.emplace_back(willis_lengths(context));
  section.blocks.emplace_back(montani_re_cases(context));
  section.blocks.emplace_back(montani_re_families(context));
  auto plantinga = plantinga_cases(context);
  if (!plantinga) return std::move(plantinga.error());
  section.blocks.emplace_back(std::move(*plantinga));
  section.blocks.emplace_back(plantinga_families(context));
  add_inputs(section);
  return section;
}

}  // namespace sightline::harness::report
