// The monitor: an emulated machine stopped, looked into, changed, and run on, one line of text at a time.
//
// Verbs and abbreviations are those that users of SIMH have in their fingers; `help` lists them from the one table in
// monitor.cpp. Addresses and words are in the radix of the machine. Nothing here knows of terminals: the caller reads
// lines, and hands in how a run waits for the operator.
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

// What the monitor cannot do by itself.
struct MonitorHost {
  RunHost running;
  std::function<base::Result<machines::Input>(const std::string& path)> read;
  // All of the file or nothing.
  std::function<base::Result<base::Done>(const std::string& path, std::span<const std::uint8_t>)> write;
  // "real", "max" or a number; a complaint if it is none.
  std::function<base::Result<base::Done>(const std::string&)> speed;
  // A person at a prompt: commands that else print nothing say in one line what they have done. Those of a file never do.
  bool person = false;
};

struct Answer {
  enum class Kind : std::uint8_t {
    done,
    wrong,   // the line was not understood, or a file could not be read
    failed,  // assert or expect: what was claimed is not so
    quit,
  };
  Kind kind = Kind::done;
  std::string text;  // whole lines, or empty
};

class Monitor {
 public:
  // All must outlive the monitor; the machine was made with --monitor.
  Monitor(const machines::MachineDescription& description, machines::Machine& machine,
          const machines::Limits& limits, Symbols symbols, MonitorHost host);
  // Commands for a machine that is under control already; `host.running` is not used.
  Monitor(Debugger& debugger, MonitorHost host);
  ~Monitor();
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

  // 8, 10 or 16, for numbers that are typed and shown; that of the machine unless it is set.
  void set_radix(int radix);
  // The language of instructions that are typed, a value of the assembler's option --dialect; empty: its default.
  void set_dialect(std::string dialect);
  // What `send` types; see Debugger.
  void set_key_codes(KeyCodes codes);
  // All verbs, whole.
  [[nodiscard]] static std::vector<std::string_view> verbs();
  // Whether a line begins with a verb.
  [[nodiscard]] static bool is_command(std::string_view line);
  // One line as typed; several commands between `;`.
  [[nodiscard]] Answer execute(std::string_view line);
  // At the end of a session: what is under way is written.
  [[nodiscard]] Answer finish();
  // Where the machine is and what it does next.
  [[nodiscard]] std::string status() const;
  // What the word under the cursor may become: verbs at the beginning of a line, else names.
  [[nodiscard]] std::vector<std::string> completions(std::string_view line, std::string_view word) const;
  // The last stop of the machine by itself, for a report.
  [[nodiscard]] const machines::Stop& last_stop() const;

 private:
  class Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace sightline::live
