// `sightline atlas`: maps at which camera positions Jones's program draws wrong pictures, why, and how long it takes.
#include "host/compare/atlas.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/outputs.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/number.hpp"
#include "host/base/parallel.hpp"
#include "host/base/progress.hpp"
#include "host/base/text.hpp"
#include "host/base/text_table.hpp"
#include "host/compare/atlas_picture.hpp"

namespace sightline::app {

namespace {

using base::Json;
using compare::AtlasView;

constexpr std::uint64_t most_eyes = 1'000'000;

constexpr std::size_t most_listed = 25;

struct AtlasArguments {
  std::string scene;
  std::string lattice;
  std::optional<int> height;
  std::optional<std::uint64_t> views;
  std::uint64_t seed = 1;
  bool no_eae = false;
  int fraction = programs::jones::machine_fraction_bits;
  unsigned jobs = 0;
  std::string directory = "out";
  bool json = false;
};

// The camera positions, and their description for the subtitle of the picture.
struct Eyes {
  std::optional<compare::AtlasLattice> lattice;
  std::vector<geometry::Point> points;
  std::string what;  // "a lattice of 46 x 87 at y = 160"
};

Eyes eyes_of(const AtlasArguments& arguments, const scene::CellScene& scene) {
  Eyes eyes;
  if (arguments.views) {
    eyes.points = compare::random_eyes(scene, *arguments.views, arguments.seed);
    eyes.what = fmt::format("{} at random, seed {}", *arguments.views, arguments.seed);
    return eyes;
  }
  compare::AtlasLattice lattice = compare::default_lattice(scene);
  if (!arguments.lattice.empty()) {
    const auto steps = base::whole_numbers<int, 2>(arguments.lattice, ',', 1, compare::most_lattice_steps);
    if (!steps)
      throw base::usage_error(fmt::format("--lattice: found \"{}\", expected NX,NZ, two whole numbers from 1 to {}",
                                arguments.lattice, compare::most_lattice_steps));
    lattice.columns = (*steps)[0];
    lattice.rows = (*steps)[1];
  }
  if (arguments.height) lattice.height = *arguments.height;
  eyes.points = compare::lattice_eyes(scene, lattice);
  eyes.what = fmt::format("a lattice of {} x {} at y = {}", lattice.columns, lattice.rows, lattice.height);
  eyes.lattice = lattice;
  return eyes;
}

// Empty if interrupted.
std::vector<AtlasView> views_of(const compare::ErrorAtlas& atlas, const AtlasArguments& arguments) {
  std::vector<AtlasView> views;
  const base::InterruptKey interrupt;
  base::ProgressLine progress;
  std::size_t wrong = 0;
  base::OrderedWork<AtlasView> work;
  work.last = atlas.eyes().size();
  work.jobs = arguments.jobs != 0 ? arguments.jobs : std::max(1U, std::thread::hardware_concurrency());
  work.make = [&atlas](std::uint64_t number) { return atlas.view(number); };
  work.take = [&](std::uint64_t, AtlasView view) {
    wrong += view.is_wrong() ? 1 : 0;
    views.push_back(std::move(view));
  };
  work.go_on = [&] {
    progress.show(fmt::format("{} of {} eyes, {} views wrong", views.size(), work.last, wrong));
    return !base::InterruptKey::pressed();
  };
  base::run_in_order(work);
  if (views.size() == work.last) return views;
  print_message(fmt::format("stopped after {} of {} eyes; no picture is written", views.size(), work.last));
  return {};
}

std::string options_of(const AtlasArguments& arguments) {
  std::string text;
  if (arguments.no_eae) text += " --no-eae";
  if (arguments.fraction != programs::jones::machine_fraction_bits)
    text += fmt::format(" --fraction {}", arguments.fraction);
  return text;
}

std::string atlas_eye_text(const AtlasView& view) {
  return fmt::format("{},{},{}", view.eye[0], view.eye[1], view.eye[2]);
}

std::string jones_command(const AtlasArguments& arguments, const AtlasView& view) {
  return fmt::format("sightline jones {} --eye {}{}", base::shell_word(arguments.scene), atlas_eye_text(view),
                     options_of(arguments));
}
std::string summary_text(const AtlasArguments& arguments, const Eyes& eyes,
                         const std::vector<AtlasView>& views, const compare::AtlasSummary& summary) {
  std::string text = fmt::format("{}, PDP-7 {} EAE, {} fraction bits; eyes: {}\n", arguments.scene,
                                 arguments.no_eae ? "without" : "with", arguments.fraction, eyes.what);
  text +=
      fmt::format("eyes in free space {}, in a solid or at a wall {}; views wrong by more than a point {}\n",
                  summary.free, views.size() - summary.free, summary.wrong);
  base::TextTable table({-24, 10, 10, 10, 10});
  table.row({"", "median", "90 %", "99 %", "greatest"});
  const auto row = [&table](const char* name, const char* format, const compare::AtlasQuantiles& of) {
    const auto number = [&](double value) { return fmt::format(fmt::runtime(format), value); };
    table.row({name, number(of.median), number(of.of_90), number(of.of_99), number(of.greatest)});
  };
  row("wrong length, points", "{:.1f}", summary.wrong_length);
  row("time, emulated seconds", "{:.3f}", summary.time);
  const AtlasView& worst = views[summary.worst];
  text += table.text() + fmt::format("slowest view  {}\n", jones_command(arguments, views[summary.slowest]));
  if (summary.wrong == 0) return text;
  text += fmt::format("worst view    {}: {:.1f} of {:.1f} points\n", atlas_eye_text(worst),
                      worst.wrong.length(), worst.wrong.true_length);
  text += fmt::format("              {}\n", jones_command(arguments, worst));
  text += fmt::format("              sightline compare {} --eye {}{}\n",
                      base::shell_word(arguments.scene), atlas_eye_text(worst), options_of(arguments));
  text +=
      "clusters of wrong views, with one cause and wrong lines in common (columns and causes: `sightline atlas "
      "--help`)\n";
  base::TextTable clusters({3, 6, 8, 11, -16, -39, 0});
  clusters.row({"no", "views", "points", "right from", "  worst eye", "  line", "  cause"});
  for (std::size_t n = 0; n < std::min(summary.clusters.size(), most_listed); ++n) {
    const compare::AtlasCluster& cluster = summary.clusters[n];
    clusters.row({std::to_string(n + 1), std::to_string(cluster.views.size()),
                  fmt::format("{:.1f}", cluster.most_wrong),
                  cluster.right_from_bits ? fmt::format("{} bits", *cluster.right_from_bits) : "-",
                  "  " + atlas_eye_text(views[cluster.worst]),
                  "  " + (cluster.line ? compare::text_of(*cluster.line) : std::string("-")),
                  "  " + cluster.cause});
  }
  if (summary.clusters.size() > most_listed)
    clusters.line(fmt::format("and {} more; --json has them all", summary.clusters.size() - most_listed));
  return text + clusters.text();
}

Json json_of(const compare::AtlasQuantiles& of) {
  return {{"median", of.median}, {"p90", of.of_90}, {"p99", of.of_99}, {"greatest", of.greatest}};
}

Json line_json(const std::optional<compare::AxisLine>& line) {
  if (!line) return nullptr;
  return compare::text_of(*line);
}

Json document_of(const AtlasArguments& arguments, const Eyes& eyes, const std::vector<AtlasView>& views,
                 const compare::AtlasSummary& summary, const std::string& picture) {
  Json document{{"schema", "sightline/atlas/1"},
                {"scene", arguments.scene},
                {"eae", !arguments.no_eae},
                {"fraction_bits", arguments.fraction}};
  if (eyes.lattice)
    document["lattice"] = {
        {"columns", eyes.lattice->columns}, {"rows", eyes.lattice->rows}, {"height", eyes.lattice->height}};
  else
    document["seed"] = arguments.seed;
  document["eyes"] = views.size();
  document["free"] = summary.free;
  document["wrong"] = summary.wrong;
  document["wrong_points"] = json_of(summary.wrong_length);
  document["emulated_seconds"] = json_of(summary.time);
  const auto named = [&](std::size_t number) {
    return Json{
        {"view", number}, {"eye", views[number].eye}, {"command", jones_command(arguments, views[number])}};
  };
  document["worst"] = summary.wrong == 0 ? Json() : named(summary.worst);
  document["slowest"] = named(summary.slowest);
  document["clusters"] = Json::array();
  for (const compare::AtlasCluster& cluster : summary.clusters)
    document["clusters"].push_back({{"cause", cluster.cause},
                                    {"line", line_json(cluster.line)},
                                    {"right_from_fraction_bits", cluster.right_from_bits},
                                    {"wrong_points", cluster.most_wrong},
                                    {"worst", cluster.worst},
                                    {"views", cluster.views}});
  document["views"] = Json::array();
  for (const AtlasView& view : views) {
    Json each{{"eye", view.eye}, {"free", view.free}};
    if (view.free) {
      each["emulated_ns"] = view.emulated_ns;
      each["true_length"] = view.wrong.true_length;
      each["missing"] = view.wrong.missing;
      each["extra"] = view.wrong.extra;
    }
    if (view.is_wrong()) {
      each["cause"] = view.cause->name();
      each["status"] = programs::jones::name(view.cause->status);
      each["right_from_fraction_bits"] = view.cause->right_from_bits;
      if (view.cause->word_bits) each["completes_with_word_bits"] = view.cause->word_bits;
      each["stretches"] = Json::array();
      for (const compare::ScreenStretch& stretch : view.wrong.stretches)
        each["stretches"].push_back({{"line", compare::text_of(stretch.line)},
                                     {"is", stretch.extra ? "extra" : "missing"},
                                     {"length", stretch.length},
                                     {"from", Json::array({stretch.at.x0, stretch.at.y0})},
                                     {"to", Json::array({stretch.at.x1, stretch.at.y1})}});
    }
    document["views"].push_back(std::move(each));
  }
  document["picture"] = picture;
  return document;
}

void write_picture(const AtlasArguments& arguments, const scene::CellScene& scene, const Eyes& eyes,
                   const std::vector<AtlasView>& views, const compare::AtlasSummary& summary,
                   Output& output) {
  compare::AtlasCaption caption;
  caption.title = fmt::format(
      "{}: Jones's program (1971) on the emulated PDP-7 {} EAE, {} fraction bits, against the oracle",
      arguments.scene, arguments.no_eae ? "without" : "with", arguments.fraction);
  caption.eyes =
      fmt::format("Plan with x to the right; every eye looks along +z, upwards. Eyes: {}.", eyes.what);
  write_png(output, compare::atlas_picture(scene, views, summary, eyes.lattice, caption),
            {{"Title", caption.title}});
}

ExitCode run_atlas(const AtlasArguments& arguments) {
  const scene::CellScene scene = load_cells(arguments.scene);
  const Eyes eyes = eyes_of(arguments, scene);
  compare::AtlasOptions options;
  options.eae = !arguments.no_eae;
  options.fraction_bits = arguments.fraction;
  const auto atlas = value_of(compare::ErrorAtlas::of(scene, eyes.points, options), arguments.scene);
  make_directory(arguments.directory);
  const std::string path =
      (std::filesystem::path(arguments.directory) / (file_stem(scene.name) + "-atlas.png")).string();
  Output output(path);
  const std::vector<AtlasView> views = views_of(atlas, arguments);
  if (views.empty()) return ExitCode::interrupted;
  const compare::AtlasSummary summary = compare::summary_of(views);
  write_picture(arguments, scene, eyes, views, summary, output);
  output.commit();
  if (arguments.json) {
    print_json(document_of(arguments, eyes, views, summary, path));
  } else {
    write_stdout(summary_text(arguments, eyes, views, summary));
    write_stdout(fmt::format("picture {}\n", path));
  }
  if (!summary.differs_from_twin) return ExitCode::ok;
  const AtlasView& view = views[*summary.differs_from_twin];
  print_message(fmt::format("{}: the program on the machine and the same program in C++ differ, a defect of this program: {}; see {}",
                       arguments.scene, view.difference, jones_command(arguments, view)));
  return ExitCode::differs;
}

}  // namespace

void add_atlas_command(const Command& program) {
  const Command command = program.add_command("atlas", help_page("atlas"));
  const auto arguments = std::make_shared<AtlasArguments>();
  command.option("SCENE", arguments->scene, cells_help).required();
  const Option lattice =
      command
          .option("--lattice", arguments->lattice, "Camera positions in the middles of NX by NZ rectangles of the plan")
          .default_value("about 4000 in squares")
          .value("NX,NZ");
  const Option height = command.option("--height", arguments->height, "The y coordinate of the positions of --lattice")
                            .default_value("that of the scene's own view")
                            .range(-32767, 32767)
                            .value("Y");
  const Option views =
      command.option("--views", arguments->views, "Random camera positions, those of `sweep`, instead of a lattice")
          .range(std::uint64_t{1}, most_eyes)
          .value("N");
  static_cast<void>(views.excludes(lattice).excludes(height));
  command.option("--seed", arguments->seed, "Seed of the random camera positions")
      .check(whole_number_error)
      .default_value()
      .value("N")
      .needs(views);
  add_eae_options(command, arguments->no_eae);
  command.option("--fraction", arguments->fraction, "Fraction bits of the program's screen coordinates")
      .default_value()
      .range(0, 3);
  command.option("--jobs", arguments->jobs, "Threads; the result is the same for any number")
      .default_value("as many as there are cores")
      .range(1U, 1024U);
  command.option("-o,--output", arguments->directory, "Folder for the picture").default_value().value("DIR");
  command.flag("--json", arguments->json, "One JSON document with every view instead of the summary");
  command.run([arguments] { return run_atlas(*arguments); });
}

}  // namespace sightline::app
