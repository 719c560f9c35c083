
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <thread>
#include <utility>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/sweep_file.hpp"
#include "host/app/eae_option.hpp"
#include "host/app/scene_source.hpp"
#include "host/base/number.hpp"
#include "host/base/parallel.hpp"
#include "host/base/progress.hpp"
#include "host/compare/sweep.hpp"

namespace sightline::app {

namespace {

constexpr const char* sweep_examples =
    "Examples:\n"
    "  sightline sweep boxes-30 --views 1000 -o boxes.jsonl\n"
    "      a thousand random views; the same command again goes on where an interruption stopped it\n"
    "  sightline sweep street4 --views 200 --guest\n"
    "      Jones's program on the emulated PDP-7, too: against its twin word for word, and how wrong it is\n"
    "  sightline sweep house --turn --views 500\n"
    "      the native algorithms on a scene of cells, in all directions\n"
    "  sightline sweep part.off --views 5000 --seed 7 --algorithm jones,oracle --shard 2/10 -o 2.jsonl\n"
    "      the second tenth of five thousand views, for one machine of ten\n\n"
    "One line of JSON a view, in order: the camera, and for each algorithm the pieces of edges it sees, "
    "their "
    "length\nin the image (null where they run out to infinity), whether it agrees with `exact` piece for "
    "piece, "
    "and what it did.\nView k depends on the scene, the seed and k alone. Shards are stretches of views: one "
    "after the other they are the\nfile that one run would have made, byte for byte (but for --time).\n\n"
    "On several machines with GNU parallel, which keeps the order:\n"
    "  parallel -k sightline sweep part.off --views 5000 --jobs 1 --shard {}/10 ::: $(seq 10) > p.jsonl\n"
    "  parallel -k --sshlogin one,two --transferfile part.off ...      the same on two machines\n"
    "With Slurm, an array of ten jobs, then cat:\n"
    "  sbatch --array=1-10 --wrap 'sightline sweep part.off --views 5000 \\\n"
    "    --shard $SLURM_ARRAY_TASK_ID/10 -o part-$(printf %03d $SLURM_ARRAY_TASK_ID).jsonl'\n"
    "  cat part-*.jsonl > part.jsonl\n"
    "A job that was stopped is started again with the same command.\n";

constexpr std::uint64_t most_views = 1'000'000'000;

struct SweepArguments {
  std::string scene;
  std::uint64_t views = 0;
  std::uint64_t seed = 1;
  std::string shard = "1/1";
  std::vector<std::string> algorithms;
  bool guest = false;
  bool no_eae = false;
  bool time = false;
  bool turn = false;
  unsigned jobs = 0;
  std::string output = "-";
};

std::string known_algorithms() {
  std::string names;
  for (const harness::LineAlgorithm& algorithm : harness::line_algorithms())
    names += fmt::format("{}{}", names.empty() ? "" : ", ", algorithm.name);
  return names;
}

compare::SweepShard shard_argument(const SweepArguments& arguments) {
  const auto parts = base::whole_numbers<std::uint64_t, 2>(arguments.shard, '/', 1, most_views);
  if (!parts || (*parts)[0] > (*parts)[1]) {
    throw Failure(ExitCode::usage,
                  fmt::format("--shard: found \"{}\", expected I/N, I from 1 to N", arguments.shard));
  }
  return compare::sweep_shard(arguments.views, (*parts)[0], (*parts)[1]);
}

// Unless asked for: all that apply but the oracle, which is slow.
std::vector<const harness::LineAlgorithm*> algorithms_of(const SweepArguments& arguments,
                                                         const SceneSource& source) {
  std::vector<const harness::LineAlgorithm*> result;
  for (const std::string& name : arguments.algorithms) {
    const harness::LineAlgorithm* const algorithm = harness::find_line_algorithm(name);
    if (algorithm == nullptr) {
      throw Failure(ExitCode::usage,
                    fmt::format("--algorithm: found \"{}\", expected some of {}", name, known_algorithms()));
    }
    if (const auto reason = algorithm->why_not(source.scene))
      throw Failure(ExitCode::usage, fmt::format("{}: {} does not apply: {}", source.name, name, *reason));
    result.push_back(algorithm);
  }
  if (!arguments.algorithms.empty()) return result;
  for (const harness::LineAlgorithm& algorithm : harness::line_algorithms())
    if (algorithm.name != "oracle" && !algorithm.why_not(source.scene)) result.push_back(&algorithm);
  return result;
}

compare::Sweep sweep_of(const SweepArguments& arguments, const SceneSource& source) {
  if (source.scene.vertices.empty())
    throw Failure(ExitCode::bad_input, fmt::format("{}: nothing in it can be seen", source.name));
  if (arguments.guest && !source.cells) {
    throw Failure(ExitCode::usage, fmt::format("--guest: found {}, expected a scene of cells, which Jones's "
                                               "program can be given",
                                               source.name));
  }
  if (arguments.turn && !source.cells)
    throw Failure(ExitCode::usage, fmt::format("--turn: found {}, expected a scene of cells; all others are "
                                               "looked at in all directions anyhow",
                                               source.name));
  compare::SweepOptions options;
  options.seed = arguments.seed;
  options.algorithms = algorithms_of(arguments, source);
  options.guest = arguments.guest;
  options.eae = !arguments.no_eae;
  options.time = arguments.time;
  options.turned = arguments.turn;
  auto sweep =
      compare::Sweep::of(source.name, source.scene, source.cells ? &*source.cells : nullptr, options);
  if (!sweep) throw Failure(ExitCode::bad_input, sweep.error().message());
  return std::move(*sweep);
}

// How many views of the shard the file has already.
std::uint64_t kept_views(SweepFile& file, const SweepArguments& arguments, const compare::Sweep& sweep,
                         const compare::SweepShard& shard, std::uint64_t& differing) {
  std::uint64_t next = shard.first;
  const std::int64_t kept = file.keep_lines([&](std::string_view line) {
    if (next >= shard.last || !sweep.is_line(next, line)) return false;
    differing += compare::Sweep::agrees(line) ? 0 : 1;
    ++next;
    return true;
  });
  if (kept >= 0) return static_cast<std::uint64_t>(kept);
  throw Failure(
      ExitCode::bad_input,
      fmt::format("{}: line {} is not {} of this sweep: found another scene, seed, choice or order; "
                  "expected a file to go on with, or none",
                  arguments.output, -kept,
                  next < shard.last ? fmt::format("view {}", next) : std::string("a view")));
}

ExitCode run_sweep(const SweepArguments& arguments) {
  const compare::SweepShard shard = shard_argument(arguments);
  const SceneSource source = load_scene_source(arguments.scene);
  const compare::Sweep sweep = sweep_of(arguments, source);
  SweepFile file(arguments.output);
  std::uint64_t differing = 0;
  const std::uint64_t kept = kept_views(file, arguments, sweep, shard, differing);
  const base::InterruptKey interrupt;
  std::uint64_t done = kept;
  {
    base::ProgressLine progress;
    base::OrderedWork<std::string> work;
    work.first = shard.first + kept;
    work.last = shard.last;
    work.jobs = arguments.jobs != 0 ? arguments.jobs : std::max(1U, std::thread::hardware_concurrency());
    work.make = [&sweep](std::uint64_t number) { return sweep.line(number); };
    work.take = [&](std::uint64_t, const std::string& line) {
      file.append(line);
      differing += compare::Sweep::agrees(line) ? 0 : 1;
      ++done;
    };
    work.go_on = [&] {
      progress.show(fmt::format("{} of {} views, {} differ", done, shard.last - shard.first, differing));
      return !base::InterruptKey::pressed();
    };
    base::run_in_order(work);
  }
  if (done < shard.last - shard.first) {
    complain(fmt::format("stopped after {} of {} views{}", done, shard.last - shard.first,
                         arguments.output == "-" ? "" : "; the same command goes on from there"));
    return ExitCode::interrupted;
  }
  if (differing == 0) return ExitCode::ok;
  complain(fmt::format("{}: {} of {} views differ", source.name, differing, done));
  return ExitCode::differs;
}

}  // namespace

void add_sweep_command(const Command& program) {
  const Command command =
      program.add_command("sweep", "Hold algorithms against each other over many random views of a scene");
  const auto arguments = std::make_shared<SweepArguments>();
  command.option("SCENE", arguments->scene, scene_source_help).required();
  command.option("--views", arguments->views, "How many views there are in all")
      .required()
      .range(std::uint64_t{1}, most_views)
      .value("N");
  command.option("--seed", arguments->seed, "Another seed, other views")
      .check(why_no_whole_number)
      .default_value()
      .value("N");
  command.option("--shard", arguments->shard, "Only the I-th of N parts of the views")
      .default_value()
      .value("I/N");
  command
      .option("--algorithm", arguments->algorithms,
              fmt::format("Which of: {}; exact always runs", known_algorithms()))
      .default_value("all but the oracle")
      .separated_by(',')
      .value("NAME,...");
  command.flag("--guest", arguments->guest,
               "Of a scene of cells: Jones's program on the emulated PDP-7 and its twin, too");
  add_eae_options(command, arguments->no_eae);
  command.flag("--turn", arguments->turn,
               "A scene of cells in all directions, where Jones's program does not apply; without it "
               "along +z, as that program looks");
  command.flag("--time", arguments->time, "Say how many host nanoseconds each view took");
  command.option("--jobs", arguments->jobs, "Threads")
      .default_value("as many as there are cores")
      .range(1U, 1024U);
  command
      .option("-o,--output", arguments->output,
              "Where the lines go; a file that is there already is gone on with; - is standard output")
      .default_value()
      .value("FILE");
  command.footer(sweep_examples);
  command.run([arguments] { return run_sweep(*arguments); });
}

}  // namespace sightline::app
