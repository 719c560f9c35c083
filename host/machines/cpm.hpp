// CP/M 2.2 for programs on the 8080: the functions of BDOS and BIOS at their entries in memory (cpm_memory.hpp), the console,
// and files (cpm_files.hpp).
//
// An entry is an OUT to a port: it takes its T-states; the work of the host takes none. A warm boot runs the next of the
// commands (cpm_commands.hpp), or ends the run. The reader of paper tape is at its end, the punch and the list device accept
// everything, and there are no disks by track and sector: SELDSK finds no drive, READ and WRITE fail.
// Left out: the CCP; editing of a line by ^E, ^R and ^P.
// Sources: Digital Research, "CP/M 2.2 Interface Guide" and "CP/M 2.2 Alteration Guide" (1979); for function 108 "CP/M 3
// Programmer's Guide" (1983).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/core/port_device.hpp"
#include "emulators/core/state_visitor.hpp"
#include "emulators/i8080/isa.hpp"
#include "emulators/i8080/state.hpp"
#include "host/machines/cpm_commands.hpp"
#include "host/machines/cpm_files.hpp"
#include "host/machines/cpm_memory.hpp"
#include "host/machines/machine.hpp"

namespace sightline::machines {

struct CpmSetup {
  bool console = false;          // keys can be typed
  std::vector<CpmDrive> drives;  // at most one of each letter
  std::uint8_t user = 0;         // at the start
  std::string arguments;         // the words after the program's name
  std::vector<CpmCommand> commands;  // to run one after the other, instead of a program in memory
  bool journal = false;          // a run can be repeated from a snapshot without accessing the host again
};

class Cpm {
 public:
  // The ports of the entries.
  static constexpr core::PortRange ports[]{{cpm::exit_port, cpm::bios_port}, {cpm::fill_port, cpm::fill_port}, {cpm::fill_port_at_end, cpm::fill_port_at_end}};

  // `print` and `list` receive the output to the console and to the list device.
  Cpm(CpmSetup setup, std::function<void(std::string_view)> print, std::function<void(char)> list);

  // The bytes that must be in memory, and the registers and memory with which the program starts.
  [[nodiscard]] const std::vector<std::pair<i8080::Address, i8080::Byte>>& entries() const { return entries_; }
  // Before a program is loaded; and afterwards.
  void prepare(std::span<i8080::Byte> memory) const;
  void start(i8080::State& registers, std::span<i8080::Byte> memory) const;
  // The address where the run begins: with commands the warm boot, which loads the first.
  [[nodiscard]] i8080::Address start_address() const { return setup_.commands.empty() ? cpm::program : cpm::boot; }

  // The machine after an OUT to one of the ports; `now` in T-states.
  struct Processor {
    i8080::State& registers;
    std::span<i8080::Byte> memory;
    std::int64_t now;
  };
  enum class Outcome : std::uint8_t { no, answered, stopped };
  // no: the OUT does not belong to an entry. stopped: stop() tells why.
  [[nodiscard]] Outcome out(std::uint8_t port, Processor processor);
  [[nodiscard]] const Stop& stop() const { return stop_; }

  void type(std::uint8_t code);
  [[nodiscard]] bool wants_key() const { return keys_.empty() && (waiting_ != Waiting::no || polled_); }
  [[nodiscard]] bool waits_for_key() const { return keys_.empty() && waiting_ != Waiting::no; }
  // Output looks for a ^S.
  [[nodiscard]] bool pauses_at_key() const { return setup_.console && keys_.empty() && waiting_ == Waiting::no; }
  // Whether a poll has found no key since the last call.
  [[nodiscard]] bool take_poll() { return std::exchange(polled_now_, false); }
  // Processes the keys typed so far. True: the program continues.
  [[nodiscard]] bool resume(Processor processor);

  // Receives a line for each call of BDOS.
  void take_log(TextTaker taker) { log_.take(std::move(taker)); }
  void finish();

  // Members of the report: "bdos", if the last call ended the run, "return_code" and "commands".
  void add_details(base::Json& report) const;
  [[nodiscard]] std::vector<ReportLine> lines() const;
  [[nodiscard]] std::vector<EarlyWarning> warnings() const;

  // Drops all but the `most` latest calls of the journal; returns the time from which runs can be repeated.
  [[nodiscard]] std::int64_t trim_journal(std::size_t most);

  void visit_state(core::StateVisitor& visit) {
    visit("function", function_);
    visit.present("caller", caller_, [&visit](i8080::Address& caller) { visit("address", caller); });
    visit.list("keys", keys_, [&visit](i8080::Byte& key) { visit("key", key); });
    visit.list("line", line_, [&visit](i8080::Byte& key) { visit("key", key); });
    visit("waiting", waiting_, Waiting::paused);
    visit("asked", polled_);
    visit.require(waiting_ == Waiting::no || setup_.console, "waiting", "0 without a console");
    visit.list("unprinted", unprinted_, [&visit](i8080::Byte& character) { visit("character", character); });
    visit("column", column_);
    visit("return_code", return_code_);
    visit.count("commands_begun", commands_begun_, setup_.commands.size());
    visit("interrupted", interrupted_);
    visit("punched", punched_);
    visit("unknown_calls", unknown_.calls);
    visit("unknown_function", unknown_.function);
    visit("unknown_caller", unknown_.caller);
    visit.part("files", files_.state());
  }

 private:
  enum class Waiting : std::uint8_t { no, key, line, bios_key, paused };
  // A call of which the log has no line yet.
  struct Call {
    std::int64_t time;
    i8080::Address caller;
    std::uint16_t de;
    std::string file;  // of a file control block
  };
  // The host's answer to a call that needed it.
  struct HostCall {
    std::int64_t time;
    std::uint32_t asked;  // a checksum of the call's data
    CpmFiles::Answer answer;
    CpmFiles::State state;
    std::vector<std::pair<i8080::Address, i8080::Byte>> written;
  };

  Outcome call_bdos(Processor processor);
  Outcome answer_bdos(Processor processor);
  Outcome call_bios(unsigned function, Processor processor);
  Outcome call_files(Processor processor);
  [[nodiscard]] unsigned exit_code() const;
  Outcome warm_boot(Processor processor);
  Outcome run_next_command(Processor processor);
  CpmFiles::Answer load(const CpmCommand& command, Processor processor);
  CpmFiles::Answer recorded_answer(std::vector<i8080::Byte> question, Processor processor, const std::function<CpmFiles::Answer()>& ask);
  std::vector<i8080::Byte> question_of_call(Processor processor);
  Outcome stop_at_call(std::string_view name, i8080::Address entry, Processor processor, std::string_view complaint);
  Outcome stop_with(std::string_view name, std::string complaint);
  void log_call(Processor processor);
  void log_call(std::string_view answer);
  void wait_for(Waiting what, Processor processor);
  void return_value(i8080::State& registers, std::uint16_t value) const;
  bool key_is_there();
  i8080::Byte take_key();
  void direct_input_output(Processor processor);
  void print(Processor processor, std::string_view text);
  void print_unprinted();
  void print_at_once(std::string_view text);
  void echo(i8080::Byte key);
  void edit_line(i8080::Byte key, Processor processor);
  void end_by_key(Processor processor);
  void store_line(Processor processor);

  CpmSetup setup_;
  std::function<void(std::string_view)> print_;
  std::function<void(char)> list_;
  bool whole_;  // all entries are in memory
  std::vector<std::pair<i8080::Address, i8080::Byte>> entries_;
  CpmFiles files_;
  Stop stop_;
  std::vector<i8080::Byte> keys_;
  std::vector<i8080::Byte> line_;  // the unfinished line of function 10
  Waiting waiting_ = Waiting::no;
  bool polled_ = false;  // the program has polled for a key since the last was typed
  bool polled_now_ = false;  // the same, since take_poll()
  std::vector<i8080::Byte> unprinted_;  // by functions 2 and 9, while ^S stops the output
  std::uint8_t column_ = 0;             // of the console
  std::uint16_t return_code_ = 0;       // of function 108
  std::size_t commands_begun_ = 0;
  bool interrupted_ = false;   // ^C ended the program
  std::uint64_t punched_ = 0;  // characters, which nobody keeps
  // Calls of functions that CP/M 2.2 does not have, and the first of them.
  struct {
    std::uint64_t calls = 0;
    std::uint8_t function = 0;
    i8080::Address caller = 0;
  } unknown_;
  TextBlocks log_;
  std::optional<Call> call_;  // with a log
  // The last BDOS function called, and the address of the call, if it ended the run; 0005 if the address is unknown.
  std::uint8_t function_ = 0;
  std::optional<i8080::Address> caller_;
  std::vector<HostCall> journal_;  // in order of time
  std::int64_t journal_begins_ = 0;
};

}  // namespace sightline::machines
