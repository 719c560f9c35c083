#include "host/app/command.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <limits>

#include "host/base/file.hpp"
#include "host/base/number.hpp"
#include "host/base/terminal.hpp"

namespace sightline::app {

namespace {

constexpr std::size_t largest_input = std::size_t{1} << 30;

base::Bytes read_stdin() {
  base::Bytes bytes;
  std::vector<std::uint8_t> block(65536);
  while (true) {
    const std::size_t n = std::fread(block.data(), 1, block.size(), stdin);
    bytes.insert(bytes.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(n));
    if (bytes.size() > largest_input) throw base::io_error("standard input: more than 1 GiB");
    if (n == block.size()) continue;
    if (std::ferror(stdin) != 0) throw base::io_error("standard input: cannot read");
    return bytes;
  }
}

}  // namespace

ExitCode exit_code_of(base::ErrorKind kind) {
  switch (kind) {
    case base::ErrorKind::usage: return ExitCode::usage;
    case base::ErrorKind::program_failed: return ExitCode::guest_failed;
    case base::ErrorKind::differs: return ExitCode::differs;
    case base::ErrorKind::io: return ExitCode::io;
    case base::ErrorKind::cancelled: return ExitCode::interrupted;
    case base::ErrorKind::bad_input: break;
  }
  return ExitCode::bad_input;
}

// A failure to write is ignored: after the terminal is closed, the command must still commit its files.
void print_message(std::string_view text) {
  static_cast<void>(std::fputs(fmt::format("sightline: {}\n", text).c_str(), stderr));
}
void warn(std::string_view text) {
  print_message("warning: " + std::string(text));
}
void report_written(const std::string& file, std::string_view what) {
  if (!file.empty() && file != "-" && base::stderr_is_terminal()) print_message(fmt::format("{}: {}", file, what));
}

std::string count_text(std::uint64_t count, std::string_view unit, std::string_view units) {
  if (count == 1) return fmt::format("1 {}", unit);
  return units.empty() ? fmt::format("{} {}s", count, unit) : fmt::format("{} {}", count, units);
}

std::string display_name(const std::string& path) {
  return path == "-" ? "standard input" : path;
}

base::Bytes read_input(const std::string& path) {
  if (path == "-") return read_stdin();
  auto bytes = base::read_file(path, largest_input);
  if (!bytes) throw bytes.error();
  return std::move(*bytes);
}

std::string read_input_text(const std::string& path) {
  const base::Bytes bytes = read_input(path);
  return {bytes.begin(), bytes.end()};
}

void write_stdout(std::string_view text) {
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stdout));
}

void check_stdout() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    const int code = errno != 0 ? errno : EIO;
    throw base::io_error("standard output: cannot write: " + std::generic_category().message(code));
  }
}

void print_json(const base::Json& document) {
  write_stdout(document.dump(2) + "\n");
}

Output::Output(const std::string& path) {
  if (path == "-") return;
  auto file = base::AtomicFile::create(path);
  if (!file) throw file.error();
  file_ = std::make_unique<base::AtomicFile>(std::move(*file));
}

void Output::write(std::string_view text) {
  if (file_) {
    file_->write(text);
  } else {
    write_stdout(text);
  }
}

void Output::write(std::span<const std::uint8_t> bytes) {
  if (file_) {
    file_->write(bytes);
  } else {
    static_cast<void>(std::fwrite(bytes.data(), 1, bytes.size(), stdout));
  }
}

void Output::commit() {
  if (!file_) return check_stdout();
  const auto done = file_->commit();
  if (!done) throw done.error();
}

std::string whole_number_error(const std::string& text) {
  if (base::unsigned_number(text)) return {};
  return fmt::format("found \"{}\", expected a whole number from 0 to {}", text,
                     std::numeric_limits<std::uint64_t>::max());
}

void require_finite(const char* option, double value) {
  if (!std::isfinite(value))
    throw base::usage_error(fmt::format("{}: found {}, expected a finite number", option, value));
}

}  // namespace sightline::app
