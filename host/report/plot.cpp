#include "host/report/plot.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <system_error>

#include "host/base/file.hpp"

namespace sightline::report {

namespace {

namespace files = std::filesystem;

constexpr std::string_view missing = "gnuplot is not installed; the plots need it (Debian: gnuplot-nox)";

// In single quotes only the quote itself is special; it is doubled. In double quotes gnuplot would execute text
// between back quotes.
std::string in_quotes(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += '\'';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + "'";
}

// A data block has no escapes, so quotation marks are replaced.
std::string label_in_data(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return c == '"' || c == '\\' || static_cast<unsigned char>(c) < 0x20; }, '\'');
  return "\"" + text + "\"";
}

// The position of 0 on a logarithmic axis; empty if no point has the value 0.
std::optional<double> place_of_zero(const Plot& plot, const Axis& axis, double PlotPoint::*value) {
  if (!axis.logarithmic) return std::nullopt;
  bool found = false;
  double least = std::numeric_limits<double>::infinity();
  for (const Curve& curve : plot.curves) {
    for (const PlotPoint& point : curve.points) {
      found = found || point.*value == 0;
      if (point.*value > 0) least = std::min(least, point.*value);
    }
  }
  if (!found) return std::nullopt;
  return std::isfinite(least) ? std::pow(10.0, std::floor(std::log10(least)) - 1) : 1.0;
}

std::string axis_commands(const Axis& axis, char name, std::optional<double> zero) {
  const std::string title = axis.unit.empty() ? axis.title : fmt::format("{} [{}]", axis.title, axis.unit);
  std::string text = fmt::format("set {}label {}\n", name, in_quotes(title));
  if (axis.logarithmic) text += fmt::format("set logscale {0}\nset format {0} \"%h\"\n", name);
  if (zero) text += fmt::format("set {}tics add (\"0\" {:.17g})\n", name, *zero);
  return text;
}

std::optional<double> drawn_value(double value, const Axis& axis, std::optional<double> zero) {
  if (!std::isfinite(value)) return std::nullopt;
  if (!axis.logarithmic || value > 0) return value;
  return value == 0 ? zero : std::nullopt;
}

// Okabe and Ito's colours (2008). gnuplot's own are hard to distinguish for some readers and faint on white.
constexpr std::array<std::string_view, 7> colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                  "#000000", "#E69F00", "#56B4E9"};

// Curves also differ in dashes, of which gnuplot has five, and in point types.
constexpr std::size_t dash_types = 5;
constexpr std::size_t point_types = 13;
constexpr std::size_t first_point_type = 4;

std::string marks_of(std::size_t curve, std::string_view with) {
  std::string text;
  if (with != "points") text += fmt::format("dt {} ", curve % dash_types + 1);
  if (with != "lines") text += fmt::format("pt {} ps 0.7 ", curve % point_types + first_point_type);
  return text;
}

// Beside the plot; below it if names are too long; above a small plot.
std::string_view legend_place(const Plot& plot) {
  constexpr std::size_t long_name = 30;
  constexpr int small_plot = 600;
  if (plot.width < small_plot) return "outside top center horizontal font ',11'";
  const bool is_long = std::any_of(plot.curves.begin(), plot.curves.end(),
                                   [](const Curve& curve) { return curve.name.size() > long_name; });
  return is_long ? "outside bottom center horizontal font ',11'" : "outside right top vertical";
}

struct Temporary {
  files::path path;
  Temporary() = default;
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    std::error_code ignored;
    if (!path.empty()) files::remove_all(path, ignored);
  }
};

std::optional<base::Error> make_temporary(Temporary& folder) {
  std::error_code error;
  std::string name = (files::temp_directory_path(error) / "sightline-plot-XXXXXX").string();
  if (error || ::mkdtemp(name.data()) == nullptr) {
    const std::string why = error ? error.message() : std::generic_category().message(errno);
    return base::io_error(fmt::format("{}: cannot make a folder for a plot: {}", name, why));
  }
  folder.path = name;
  return std::nullopt;
}

// The exit status of gnuplot, or -1 and errno if there is no such program. Both outputs go to the file `said`.
int run_gnuplot(const std::string& argument, const std::string& said) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::string program = "gnuplot";
  std::string script = argument;
  std::array<char*, 3> arguments{program.data(), script.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) {
    errno = failed;
    return -1;
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

base::Error not_run(int code) {
  if (code == ENOENT) return base::io_error(missing);
  return base::io_error("gnuplot cannot be run: " + std::generic_category().message(code));
}

std::string text_of(const files::path& path) {
  const auto bytes = base::read_file(path.string());
  if (!bytes) return {};
  std::string text(bytes->begin(), bytes->end());
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

std::string gnuplot_script(const Plot& plot) {
  const auto zero_x = place_of_zero(plot, plot.x, &PlotPoint::x);
  const auto zero_y = place_of_zero(plot, plot.y, &PlotPoint::y);
  std::string text;
  std::string curves;
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const Curve& curve = plot.curves[i];
    bool labels = false;
    bool empty = true;
    text += fmt::format("$curve{} << END_OF_CURVE\n", i);
    for (const PlotPoint& point : curve.points) {
      const auto x = drawn_value(point.x, plot.x, zero_x);
      const auto y = drawn_value(point.y, plot.y, zero_y);
      if (!x || !y) continue;
      empty = false;
      labels = labels || !point.label.empty();
      text += fmt::format("{:.17g} {:.17g} {}\n", *x, *y, label_in_data(point.label));
    }
    text += "END_OF_CURVE\n";
    if (empty) continue;
    const std::string_view with = !curve.line ? "points" : curve.points_marked ? "linespoints" : "lines";
    const std::string_view colour = colours[i % colours.size()];
    curves +=
        fmt::format("{} $curve{} using 1:2 with {} lt rgb \"{}\" lw 1.6 {}title {}",
                    curves.empty() ? "plot" : ",", i, with, colour, marks_of(i, with), in_quotes(curve.name));
    if (labels)
      curves += fmt::format(
          ", $curve{} using 1:2:3 with labels left offset 0.6,0.5 font \",10\" tc rgb \"{}\" notitle", i,
          colour);
  }
  text += fmt::format(
      "set terminal svg size {},{} noenhanced font \"DejaVu Sans,13\" background rgb \"white\"\n"
      "set encoding utf8\nset key {} Left reverse samplen 4\n"
      "set grid xtics ytics lc rgb \"#dddddd\"\nset border 3\nset tics nomirror\n",
      plot.width, plot.height, legend_place(plot));
  text += axis_commands(plot.x, 'x', zero_x) + axis_commands(plot.y, 'y', zero_y);
  return text + curves + "\n";
}

base::Result<Figure> draw_plot(const Plot& plot) {
  Temporary folder;
  if (const auto error = make_temporary(folder)) return *error;
  const files::path script = folder.path / "plot.gnuplot";
  const files::path drawing = folder.path / "plot.svg";
  const files::path said = folder.path / "said.txt";
  const auto written = base::write_file_atomically(
      script.string(), fmt::format("set output {}\n", in_quotes(drawing.string())) + gnuplot_script(plot));
  if (!written) return written.error();
  const int status = run_gnuplot(script.string(), said.string());
  if (status < 0) return not_run(errno);
  auto bytes = base::read_file(drawing.string());
  if (status != 0 || !bytes || bytes->empty())
    return base::io_error(fmt::format("{}: gnuplot drew nothing: {}", plot.id, text_of(said)));
  return Figure{plot.id, plot.title, plot.caption, plot.alternative, "image/svg+xml", std::move(*bytes)};
}

std::optional<base::Error> gnuplot_missing() {
  const int status = run_gnuplot("--version", "/dev/null");
  if (status < 0) return not_run(errno);
  if (status != 0) return base::io_error(missing);
  return std::nullopt;
}

}  // namespace sightline::report
