// `sightline sweep`: compares methods over many random views of a scene.
#include "host/compare/sweep.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/commands/random_views.hpp"
#include "host/app/commands/skala_options.hpp"
#include "host/app/commands/sweep_table.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/nearest_name.hpp"
#include "host/base/number.hpp"
#include "host/base/parallel.hpp"
#include "host/base/progress.hpp"
#include "host/base/text.hpp"

namespace sightline::app {

namespace {

constexpr std::uint64_t most_views = 1'000'000'000;

struct SweepArguments {
  std::string scene;
  MeshArguments mesh;
  std::uint64_t views = 0;
  RandomViewOptions random;
  std::string shard = "1/1";
  std::vector<std::string> algorithms;
  bool guest = false;
  bool faces = false;
  bool no_eae = false;
  bool time = false;
  unsigned jobs = 0;
  std::string output = "-";
};

constexpr std::string_view edge_oracle = "oracle";

// The values of --algorithm.
std::vector<std::string> known_methods() {
  std::vector<std::string> names = compare::method_names();
  names.emplace_back(edge_oracle);
  return names;
}

compare::SweepShard shard_argument(const SweepArguments& arguments) {
  const auto parts = base::whole_numbers<std::uint64_t, 2>(arguments.shard, '/', 1, most_views);
  if (!parts || (*parts)[0] > (*parts)[1]) {
    throw base::usage_error(fmt::format("--shard: found \"{}\", expected I/N, I from 1 to N", arguments.shard));
  }
  return compare::sweep_shard(arguments.views, (*parts)[0], (*parts)[1]);
}

bool is_asked(const SweepArguments& arguments, std::string_view method) {
  return std::find(arguments.algorithms.begin(), arguments.algorithms.end(), method) != arguments.algorithms.end();
}

// The methods that --algorithm and --guest name, in the order of tables. For a scene, `exact` is always one of them.
std::vector<std::string> methods_of(const SweepArguments& arguments, bool function) {
  const std::vector<std::string> known = known_methods();
  for (const std::string& name : arguments.algorithms) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string meant = base::did_you_mean(name, known);
    throw base::usage_error(fmt::format("--algorithm: found \"{}\", expected some of {}{}", name, base::joined(known, ", "),
                                               meant.empty() ? "" : "; " + meant));
  }
  std::vector<std::string> methods;
  for (const std::string& name : compare::method_names()) {
    const bool of_guest = name == compare::jones_pdp7_name || name == compare::jones_twin_name;
    const bool exact = name == "exact" && !function;
    if (exact || is_asked(arguments, name) || (of_guest && arguments.guest)) methods.push_back(name);
  }
  return methods;
}

compare::SweepOptions options_of(const SweepArguments& arguments) {
  compare::SweepOptions options;
  options.seed = arguments.random.seed;
  options.oracle = is_asked(arguments, edge_oracle);
  options.eae = !arguments.no_eae;
  options.time = arguments.time;
  options.all_lines = arguments.algorithms.empty();
  options.faces = arguments.faces;
  return options;
}

// Error usage: a requested method does not apply. Error bad_input: a default method cannot be prepared.
compare::Sweep value_of(base::Result<compare::Sweep> sweep, const SweepArguments& arguments) {
  if (sweep) return std::move(*sweep);
  throw base::error_of(arguments.algorithms.empty() && !arguments.guest ? base::ErrorKind::bad_input : base::ErrorKind::usage, sweep.error().message());
}

compare::Sweep sweep_of(const SweepArguments& arguments, const scene::LoadedScene& source) {
  if (source.scene.vertices.empty())
    throw base::bad_input(fmt::format("{}: nothing in it can be seen", source.name));
  if (arguments.guest && !source.cells)
    throw base::usage_error(fmt::format("--guest: found {}, expected a scene of cells, the input of Jones's program", source.name));
  compare::SweepOptions options = options_of(arguments);
  options.directions = directions_of(arguments.random, source);
  options.methods = methods_of(arguments, false);
  return value_of(compare::Sweep::of(source.name, source.scene, source.cells ? &*source.cells : nullptr, options), arguments);
}

compare::Sweep sweep_of(const SweepArguments& arguments, const SkalaFunction& function) {
  for (const auto& [given, option] : {std::pair{arguments.guest, "--guest"}, std::pair{arguments.faces, "--faces"},
                                      std::pair{arguments.random.turn, "--turn"}, std::pair{arguments.random.level, "--level"}})
    if (given) throw base::usage_error(fmt::format("{}: found {}, expected a scene", option, arguments.scene));
  algorithms::skala::View view;
  view.family = family_of({});
  if (const auto reason = compare::why_not_comparable(function.grid, view))
    throw base::bad_input(fmt::format("{}: {}", arguments.scene, *reason));
  compare::SweepOptions options = options_of(arguments);
  options.methods = methods_of(arguments, true);
  return value_of(compare::Sweep::of(arguments.scene, function.grid, view, options), arguments);
}

// --- the output: a file of lines that grows during the sweep and is resumed after an interruption
//
// It is written in place, not renamed at the end like other outputs, because every complete line is a result. An incomplete last
// line, which an interruption may leave, is removed.

class SweepFile {
 public:
  // "-" is standard output. Error io: the file cannot be read or written, or another process is writing it.
  explicit SweepFile(const std::string& path);
  ~SweepFile();
  SweepFile(const SweepFile&) = delete;
  SweepFile& operator=(const SweepFile&) = delete;

  // Passes every complete line, with its line feed, to `keep` until it returns false. Truncates the file after the last kept line if
  // only an incomplete line follows. Returns the number n of kept lines; or -1 - n if a complete line was rejected, and the file is
  // unchanged.
  [[nodiscard]] std::int64_t keep_lines(const std::function<bool(std::string_view)>& keep);

  // Error io.
  void append(std::string_view line);

 private:
  std::string path_;
  int file_ = -1;
  bool regular_ = false;
};

[[noreturn]] void fail_with_errno(const std::string& path, const char* doing = "cannot write") {
  throw base::io_error(path + ": " + doing + ": " + std::strerror(errno));
}

SweepFile::SweepFile(const std::string& path) : path_(path) {
  if (path == "-") {
    path_ = "standard output";
    file_ = STDOUT_FILENO;
    return;
  }
  // A pipe is opened for writing only; opened for both, writing would succeed even if nobody reads.
  struct stat about {};
  const bool exists = stat(path.c_str(), &about) == 0;
  regular_ = !exists || S_ISREG(about.st_mode);
  file_ = open(path.c_str(), (regular_ ? O_RDWR | O_CREAT : O_WRONLY) | O_CLOEXEC, 0666);
  if (file_ < 0) fail_with_errno(path);
  if (regular_ && flock(file_, LOCK_EX | LOCK_NB) != 0) {
    const int why = errno;
    close(file_);
    file_ = -1;
    errno = why;
    if (why == EWOULDBLOCK) throw base::io_error(path + ": is being written by another sweep");
    fail_with_errno(path);
  }
}

SweepFile::~SweepFile() {
  if (file_ > STDERR_FILENO) close(file_);
}

std::int64_t SweepFile::keep_lines(const std::function<bool(std::string_view)>& keep) {
  if (!regular_) return 0;
  std::string held;
  std::vector<char> block(std::size_t{1} << 16);
  std::int64_t kept = 0;
  off_t length = 0;
  while (true) {
    const ssize_t count = read(file_, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_with_errno(path_, "cannot read");
    if (count == 0) break;
    held.append(block.data(), static_cast<std::size_t>(count));
    std::size_t from = 0;
    for (std::size_t end = held.find('\n'); end != std::string::npos; end = held.find('\n', from)) {
      if (!keep(std::string_view(held).substr(from, end + 1 - from))) return -1 - kept;
      ++kept;
      length += static_cast<off_t>(end + 1 - from);
      from = end + 1;
    }
    held.erase(0, from);
  }
  if (ftruncate(file_, length) != 0 || lseek(file_, length, SEEK_SET) < 0) fail_with_errno(path_);
  return kept;
}

void SweepFile::append(std::string_view line) {
  const off_t start = regular_ ? lseek(file_, 0, SEEK_CUR) : 0;
  while (!line.empty()) {
    const ssize_t count = write(file_, line.data(), line.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const int why = errno;
      // If the disk is full, only complete lines remain. If this fails, too, the next sweep removes the incomplete line.
      if (regular_) static_cast<void>(ftruncate(file_, start) == 0);
      errno = why;
      fail_with_errno(path_);
    }
    line.remove_prefix(static_cast<std::size_t>(count));
  }
}

// --- the sweep

// The number of views of the shard that the file already has.
std::uint64_t kept_views(SweepFile& file, const SweepArguments& arguments, const compare::Sweep& sweep,
                         const compare::SweepShard& shard, compare::SweepTable& table) {
  std::uint64_t next = shard.first;
  const std::int64_t kept = file.keep_lines([&](std::string_view line) {
    if (next >= shard.last || !sweep.is_line(next, line) || !table.add(line)) return false;
    ++next;
    return true;
  });
  if (kept >= 0) return static_cast<std::uint64_t>(kept);
  throw base::bad_input(fmt::format("{}: line {} is not {} of this sweep: found another scene, seed, choice or order; "
                  "expected a file that this sweep can resume, or none",
                  arguments.output, -kept,
                  next < shard.last ? fmt::format("view {}", next) : std::string("a view")));
}

std::string compare_command(const SweepArguments& arguments, std::string_view method, std::uint64_t view) {
  std::string text = fmt::format("sightline compare {} --only-view {} --seed {} --methods {}", base::shell_word(arguments.scene), view,
                                 arguments.random.seed, method);
  if (arguments.random.turn) text += " --turn";
  if (arguments.random.level) text += " --level";
  if (arguments.no_eae && method.starts_with("jones-")) text += " --no-eae";
  const MeshArguments& mesh = arguments.mesh;
  if (mesh.strict) text += " --strict";
  if (mesh.weld != 0) base::append(text, " --weld {}", mesh.weld);
  if (mesh.planar_tolerance) base::append(text, " --planar-tolerance {}", *mesh.planar_tolerance);
  if (!mesh.unit.empty()) base::append(text, " --unit {}", mesh.unit);
  return text;
}

ExitCode run_sweep(const SweepArguments& arguments, const compare::Sweep& sweep) {
  const compare::SweepShard shard = shard_argument(arguments);
  SweepFile file(arguments.output);
  compare::SweepTable table;
  const std::uint64_t kept = kept_views(file, arguments, sweep, shard, table);
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
      static_cast<void>(table.add(line));
      ++done;
    };
    work.go_on = [&] {
      progress.show(fmt::format("{} of {} views, {} differ", done, shard.last - shard.first, table.differing()));
      return !base::InterruptKey::pressed();
    };
    base::run_in_order(work);
  }
  if (done < shard.last - shard.first) {
    print_message(fmt::format("stopped after {} of {} views{}", done, shard.last - shard.first,
                         arguments.output == "-" ? "" : "; the same command resumes there"));
    return ExitCode::interrupted;
  }
  const std::string text = sweep_text(
      table, [&](std::string_view method, std::uint64_t view) { return compare_command(arguments, method, view); });
  // If the lines go to standard output, nothing else is printed there.
  if (arguments.output == "-")
    std::fputs(text.c_str(), stderr);
  else
    write_stdout(text);
  report_written(arguments.output, count_text(done, "view") + (kept > 0 ? fmt::format(", {} of them already there", kept) : ""));
  if (table.differing() == 0) return ExitCode::ok;
  print_message(fmt::format("{}: {} of {} views differ", arguments.scene, table.differing(), done));
  return ExitCode::differs;
}

ExitCode run_sweep(const SweepArguments& arguments) {
  static_cast<void>(shard_argument(arguments));  // before the scene is read
  if (is_height_function(arguments.scene)) {
    SkalaSource source;
    source.name_or_file = arguments.scene;
    return run_sweep(arguments, sweep_of(arguments, load_skala_function(source, usual_grid_size(algorithms::skala::Subject::lines))));
  }
  const scene::LoadedScene source = load_scene(arguments.scene, arguments.mesh);
  return run_sweep(arguments, sweep_of(arguments, source));
}

}  // namespace

void add_sweep_command(const Command& program) {
  const Command command = program.add_command("sweep", help_page("sweep"));
  const auto arguments = std::make_shared<SweepArguments>();
  command.option("SCENE", arguments->scene, fmt::format("{}; or a function of two variables, by name or from a grid file", scene_help))
      .required();
  add_mesh_options(command, arguments->mesh);
  command.option("--views", arguments->views, "Number of all views")
      .required()
      .range(std::uint64_t{1}, most_views)
      .value("N");
  add_random_view_options(command, arguments->random);
  command.option("--shard", arguments->shard, "Only the I-th of N parts of the views")
      .default_value()
      .value("I/N");
  command
      .option("--algorithm", arguments->algorithms,
              fmt::format("Some of: {}. For scenes exact always runs, and is the reference for polyhedra unless oracle, the slow oracle of "
                          "edges, is named",
                          base::joined(known_methods(), ", ")))
      .default_value("the native line methods that apply, or those of functions")
      .separated_by(',')
      .value("NAME,...");
  command.flag("--guest", arguments->guest,
               "Add jones-pdp7 and jones-twin, Jones's program on the emulated PDP-7 and the same program in C++ (scenes of cells)");
  command.flag("--faces", arguments->faces, "Add the native methods of faces, compared point by point, which takes longer");
  add_eae_options(command, arguments->no_eae);
  command.flag("--time", arguments->time, "Measure the time of each view on this computer, once for a picture of lines");
  command.option("--jobs", arguments->jobs, "Threads")
      .default_value("as many as there are cores")
      .range(1U, 1024U);
  command
      .option("-o,--output", arguments->output,
              "The output file; an existing one is resumed; - is standard output")
      .default_value()
      .value("FILE");
  command.run([arguments] { return run_sweep(*arguments); });
}

}  // namespace sightline::app
