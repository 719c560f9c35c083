// The monitor: examines, changes and runs an emulated machine by lines of text.
//
// Verbs and abbreviations are those of SIMH; `help` lists them from the table in monitor.cpp. Addresses and words are in the
// radix of the machine. The monitor does not use a terminal: the caller reads lines and supplies the functions of RunHost.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/machines/engine.hpp"
#include "host/live/debugger.hpp"
#include "host/live/symbols.hpp"

namespace sightline::live {

// The functions of the caller that the monitor needs.
struct MonitorHost {
  RunHost running;
  std::function<base::Result<machines::Input>(const std::string& path)> read;
  // Writes the whole file or nothing.
  std::function<base::Result<base::Done>(const std::string& path, std::span<const std::uint8_t>)> write;
  // Sets the speed: "real", "max" or a number.
  std::function<base::Result<base::Done>(const std::string&)> speed;
  // A person is at the prompt: commands without output print one line about what they have done, except commands from a file.
  bool person = false;
};

struct Answer {
  enum class Kind : std::uint8_t {
    done,
    wrong,   // the line was not understood, or a file could not be read
    failed,  // an assert or expect failed
    quit,
  };
  Kind kind = Kind::done;
  std::string text;  // complete lines, or empty
};

class Monitor {
 public:
  // All must outlive the monitor; the machine was made with --monitor.
  Monitor(const machines::MachineDescription& description, machines::Machine& machine,
          const machines::Limits& limits, Symbols symbols, MonitorHost host);
  // A monitor for an existing debugger; `host.running` is not used.
  Monitor(Debugger& debugger, MonitorHost host);
  ~Monitor();
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

  // 8, 10 or 16, for numbers that are typed and shown; the default is that of the machine.
  void set_radix(int radix);
  // The language of instructions that are typed, a value of the assembler's option --dialect; empty: its default.
  void set_dialect(std::string dialect);
  // See Debugger.
  void set_key_codes(KeyCodes codes);
  // All verbs, unabbreviated.
  [[nodiscard]] static std::vector<std::string_view> verbs();
  // Whether a line begins with a verb.
  [[nodiscard]] static bool is_command(std::string_view line);
  // Executes a line, with commands separated by `;`.
  [[nodiscard]] Answer execute(std::string_view line);
  // Called at the end of a session: writes a current trace.
  [[nodiscard]] Answer finish();
  // See Debugger.
  [[nodiscard]] std::string status() const;
  // Completions of the word before the cursor: verbs at the beginning of a line, otherwise names.
  [[nodiscard]] std::vector<std::string> completions(std::string_view line, std::string_view word) const;
  // The last stop that the machine itself caused, for a report.
  [[nodiscard]] const machines::Stop& last_stop() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace sightline::live
