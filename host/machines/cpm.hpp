// CP/M 2.2 for a program on the 8080: the entries of BDOS and BIOS in memory, their console functions, and files
// (cpm_files.hpp).
//
// An entry is an OUT to a port: it takes its T-states; the work of the host takes none. Without a console and drives there
// are only the entries at 0000 and 0005. With one of them there are also the addresses by which programs find the system:
// the top of memory at 0006, and the jump table of the BIOS at 0001.
// Left out: the CCP, so a warm boot ends the run; disks by track and sector.
// Source: Digital Research, "CP/M 2.2 Interface Guide" and "CP/M 2.2 Alteration Guide" (1979).
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

#include "emulators/core/state_visitor.hpp"
#include "emulators/i8080/isa.hpp"
#include "emulators/i8080/state.hpp"
#include "host/machines/cpm_files.hpp"
#include "host/machines/machine.hpp"

namespace sightline::machines {

// Stores the arguments of a program: the tail at 0080, and file control blocks at 005C and 006C.
void put_cpm_arguments(std::string_view words, std::span<std::uint8_t> memory);

struct CpmSetup {
  bool console = false;          // keys can be typed
  std::vector<CpmDrive> drives;  // at most one of each letter
  std::string arguments;         // the words after the program's name
  bool journal = false;          // a run can be repeated from a snapshot without accessing the host again
};

class Cpm {
 public:
  // The entries use ports 0 to this.
  static constexpr std::uint8_t last_port = 2;

  // `print` and `list` receive the output to the console and to the list device.
  Cpm(CpmSetup setup, std::function<void(std::string_view)> print, std::function<void(char)> list);

  // The bytes that must be in memory, and the registers and memory with which the program starts.
  [[nodiscard]] const std::vector<std::pair<i8080::Address, i8080::Byte>>& entries() const { return entries_; }
  void start(i8080::State& registers, std::span<i8080::Byte> memory) const;

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
  // Whether a poll has found no key since the last call.
  [[nodiscard]] bool take_poll() { return std::exchange(polled_now_, false); }
  // Processes the keys typed so far. True: the program continues.
  [[nodiscard]] bool resume(Processor processor);

  // "bdos" of the report, if the last call ended the run.
  void add_details(base::Json& report) const;

  // Drops all but the `most` latest calls of the journal; returns the time from which runs can be repeated.
  [[nodiscard]] std::int64_t trim_journal(std::size_t most);

  void visit_state(core::StateVisitor& visit) {
    visit("function", function_);
    visit.present("caller", caller_, [&visit](i8080::Address& caller) { visit("address", caller); });
    visit.list("keys", keys_, [&visit](i8080::Byte& key) { visit("key", key); });
    visit.list("line", line_, [&visit](i8080::Byte& key) { visit("key", key); });
    visit("waiting", waiting_, Waiting::bios_key);
    visit("asked", polled_);
    visit.require(waiting_ == Waiting::no || setup_.console, "waiting", "0 without a console");
    visit.part("files", files_.state());
  }

 private:
  enum class Waiting : std::uint8_t { no, key, line, bios_key };
  // The host's answer to a call that needed it.
  struct HostCall {
    std::int64_t time;
    std::uint32_t asked;  // a checksum of the call's data
    CpmFiles::Answer answer;
    CpmFiles::State state;
    std::vector<std::pair<i8080::Address, i8080::Byte>> written;
  };

  Outcome call_bdos(Processor processor);
  Outcome call_bios(unsigned function, Processor processor);
  Outcome call_files(Processor processor);
  CpmFiles::Answer recorded_answer(Processor processor);
  Outcome stop_with(std::string_view name, std::string_view complaint);
  void wait_for(Waiting what, Processor processor);
  void return_value(i8080::State& registers, std::uint16_t value) const;
  bool key_is_there();
  i8080::Byte take_key();
  void direct_input_output(Processor processor);
  void echo(i8080::Byte key);
  void edit_line(i8080::Byte key, Processor processor);
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
  // The last BDOS function called, and the address of the call, if it ended the run; 0005 if the address is unknown.
  std::uint8_t function_ = 0;
  std::optional<i8080::Address> caller_;
  std::vector<HostCall> journal_;  // in order of time
  std::int64_t journal_begins_ = 0;
};

}  // namespace sightline::machines
