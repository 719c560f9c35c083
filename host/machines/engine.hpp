// Runs any program on any described machine: loads, sets registers, runs to a stop, dumps, reports.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "host/machines/machine.hpp"

namespace sightline::machines {

// FILE[@ADDRESS], split at the last @ if only digits follow it.
struct FileArgument {
  std::string path;
  std::optional<std::uint32_t> address;
};
[[nodiscard]] Result<FileArgument> file_argument(const MachineDescription& machine, std::string_view option,
                                                 const std::string& text);

[[nodiscard]] std::vector<std::string_view> format_names(const MachineDescription& machine);
// Whether a file's name can determine its format.
[[nodiscard]] bool has_endings(const MachineDescription& machine);
// The format for the ending of a file's name, in lower or upper case; null for any other name.
[[nodiscard]] const Format* format_by_name(const MachineDescription& machine, std::string_view path);
// `file` without a format: the ending decides; for an unknown ending the content decides: a dump of the machine, or the
// format that recognises it. `arguments`: those of a run, which can change the meaning of a format; null for a
// disassembler.
[[nodiscard]] Result<Program> read_program(const MachineDescription& machine, const FileArgument& file,
                                           const Input& input, std::string_view format,
                                           const Arguments* arguments);

// A machine built, loaded and started as the options say.
struct Prepared {
  std::unique_ptr<Machine> machine;
  Limits limits;
  std::vector<std::string> warnings = {};
};
// Restores a machine from the file of --restore.
using Restorer = std::function<Result<Done>(Machine& machine, const Input& snapshot)>;
// With --restore, which needs a restorer, the limits count from the snapshot.
[[nodiscard]] Result<Prepared> prepare(const MachineDescription& machine, const Arguments& arguments,
                                       const FileReader& read, const Restorer& restore = {});

// Whether the ending is that of an assembler source; no program format has such an ending.
[[nodiscard]] bool named_as_source(std::string_view path);

struct Progress {
  std::uint64_t instructions = 0;
  core::Instant now;
};
// Called every few million instructions; false ends the run. Empty: never called.
using KeepRunning = std::function<bool(const Progress&)>;
inline constexpr std::string_view interrupted = "interrupted";

[[nodiscard]] Stop run_to_stop(Machine& machine, const Limits& limits, const KeepRunning& keep_running = {});

// A number of `bits` bits in the machine's radix, with leading zeros.
[[nodiscard]] std::string digits(const MachineDescription& machine, std::uint32_t value, unsigned bits);
// A dump: the registers on the first line, then all of memory, words_per_line words per line, all in the machine's radix with
// leading zeros. A dump can be loaded as a program with its memory and registers.
[[nodiscard]] std::string dump_text(const MachineDescription& description, const Machine& machine);
// Whether a text begins like a dump of this machine: with a line of registers and a line of words.
[[nodiscard]] bool is_dump(const MachineDescription& description, std::span<const std::uint8_t> bytes);
[[nodiscard]] Result<Program> read_dump(const MachineDescription& description, const Input& input);
// A text of a few lines; a JSON document of schema sightline/run-NAME/1. Addresses, words and registers are strings in the
// machine's radix, counts are numbers.
[[nodiscard]] std::string table_report(const MachineDescription& description, const Machine& machine,
                                       const Stop& stop);
[[nodiscard]] base::Json json_report(const MachineDescription& description, const Machine& machine,
                                     const Stop& stop);

}  // namespace sightline::machines
