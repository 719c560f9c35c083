// `sightline sweep`: algorithms compared with each other over many random views of a scene.
#include "host/compare/sweep.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "host/app/commands/commands.hpp"
#include "host/app/scene_argument.hpp"
#include "host/base/number.hpp"
#include "host/base/parallel.hpp"
#include "host/base/progress.hpp"

namespace sightline::app {

namespace {

constexpr std::uint64_t most_views = 1'000'000'000;

struct SweepArguments {
  std::string scene;
  MeshArguments mesh;
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
  for (const registry::LineAlgorithm& algorithm : registry::line_algorithms())
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
std::vector<const registry::LineAlgorithm*> algorithms_of(const SweepArguments& arguments,
                                                         const scene::LoadedScene& source) {
  std::vector<const registry::LineAlgorithm*> result;
  for (const std::string& name : arguments.algorithms) {
    const registry::LineAlgorithm* const algorithm = registry::find_line_algorithm(name);
    if (algorithm == nullptr) {
      throw Failure(ExitCode::usage,
                    fmt::format("--algorithm: found \"{}\", expected some of {}", name, known_algorithms()));
    }
    if (const auto reason = algorithm->why_not(source.scene))
      throw Failure(ExitCode::usage, fmt::format("{}: {} does not apply: {}", source.name, name, *reason));
    result.push_back(algorithm);
  }
  if (!arguments.algorithms.empty()) return result;
  for (const registry::LineAlgorithm& algorithm : registry::line_algorithms())
    if (algorithm.name != "oracle" && !algorithm.why_not(source.scene)) result.push_back(&algorithm);
  return result;
}

compare::Sweep sweep_of(const SweepArguments& arguments, const scene::LoadedScene& source) {
  if (source.scene.vertices.empty())
    throw Failure(ExitCode::bad_input, fmt::format("{}: nothing in it can be seen", source.name));
  if (arguments.guest && !source.cells) {
    throw Failure(ExitCode::usage, fmt::format("--guest: found {}, expected a scene of cells, which Jones's "
                                               "program can be given",
                                               source.name));
  }
  if (arguments.turn && !source.cells)
    throw Failure(ExitCode::usage, fmt::format("--turn: found {}, expected a scene of cells; all others are "
                                               "viewed in all directions in any case",
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

// --- the output: a file of lines that grows while it is made and is continued after an interruption
//
// Not written beside its place and renamed, as other outputs are: every whole line counts. A last line
// without its end, which an interruption may leave, is dropped.

class SweepFile {
 public:
  // "-" is standard output. Failure io: it cannot be read or written, or is just being written by another.
  explicit SweepFile(const std::string& path);
  ~SweepFile();
  SweepFile(const SweepFile&) = delete;
  SweepFile& operator=(const SweepFile&) = delete;

  // Passes every whole line, with its line feed, to `keep` until that says no; cuts the file off there if
  // what follows is a line without end, or nothing. Returns how many were kept; -1 - that if a whole line was
  // refused, and the file is as it was.
  [[nodiscard]] std::int64_t keep_lines(const std::function<bool(std::string_view)>& keep);

  // Failure io.
  void append(std::string_view line);

 private:
  std::string path_;
  int file_ = -1;
  bool regular_ = false;
};

[[noreturn]] void fail_with_errno(const std::string& path, const char* doing = "cannot write") {
  throw Failure(ExitCode::io, path + ": " + doing + ": " + std::strerror(errno));
}

SweepFile::SweepFile(const std::string& path) : path_(path) {
  if (path == "-") {
    path_ = "standard output";
    file_ = STDOUT_FILENO;
    return;
  }
  // A pipe is opened for writing only: reading and writing it would not fail when nobody reads.
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
    if (why == EWOULDBLOCK) throw Failure(ExitCode::io, path + ": is being written by another sweep");
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
      // A full disk leaves whole lines. What is left of this one if even that fails, the next sweep takes
      // off.
      if (regular_) static_cast<void>(ftruncate(file_, start) == 0);
      errno = why;
      fail_with_errno(path_);
    }
    line.remove_prefix(static_cast<std::size_t>(count));
  }
}

// --- the sweep

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
                  "expected a file that this sweep can resume, or none",
                  arguments.output, -kept,
                  next < shard.last ? fmt::format("view {}", next) : std::string("a view")));
}

ExitCode run_sweep(const SweepArguments& arguments) {
  const compare::SweepShard shard = shard_argument(arguments);
  const scene::LoadedScene source = load_scene(arguments.scene, arguments.mesh);
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
  const Command command = program.add_command("sweep", help_page("sweep"));
  const auto arguments = std::make_shared<SweepArguments>();
  command.option("SCENE", arguments->scene, scene_help).required();
  add_mesh_options(command, arguments->mesh);
  command.option("--views", arguments->views, "How many views there are in all")
      .required()
      .range(std::uint64_t{1}, most_views)
      .value("N");
  command.option("--seed", arguments->seed, "Seed of the random numbers: another seed gives other views")
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
               "Add Jones's program on the emulated PDP-7 and its twin (scenes of cells)");
  add_eae_options(command, arguments->no_eae);
  command.flag("--turn", arguments->turn,
               "A scene of cells in all directions, where Jones's program does not apply; without it "
               "along +z, as that program looks");
  command.flag("--time", arguments->time, "Print the time of each view in nanoseconds of this computer");
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
