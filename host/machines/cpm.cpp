// See cpm.hpp.
#include "host/machines/cpm.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

#include "host/base/crc32.hpp"

namespace sightline::machines {

namespace {

using i8080::Address;
using i8080::Byte;

constexpr Byte call_code = 0xCD;
constexpr Byte ctrl_c = 3, ctrl_s = 19;
constexpr Byte last_function = 40;
constexpr Byte return_code_function = 108;

constexpr std::array<std::string_view, 41> bdos_names{
    "System Reset", "Console Input", "Console Output", "Reader Input", "Punch Output", "List Output", "Direct Console I/O",
    "Get I/O Byte", "Set I/O Byte", "Print String", "Read Console Buffer", "Get Console Status", "Return Version Number",
    "Reset Disk System", "Select Disk", "Open File", "Close File", "Search for First", "Search for Next", "Delete File",
    "Read Sequential", "Write Sequential", "Make File", "Rename File", "Return Login Vector", "Return Current Disk",
    "Set DMA Address", "Get Addr(Alloc)", "Write Protect Disk", "Get Read/Only Vector", "Set File Attributes",
    "Get Addr(Disk Parms)", "Set/Get User Code", "Read Random", "Write Random", "Compute File Size", "Set Random Record",
    "Reset Drive", "38", "39", "Write Random with Zero Fill"};

enum Bios : unsigned {
  cold_boot, warm_boot_entry, console_status, console_in, console_out, list_out, punch_out, reader_in, home, select_disk, set_track,
  set_sector, set_transfer, read_sector, write_sector, list_status, translate_sector
};
constexpr Byte end_of_tape = 0x1A;

// The address of the CALL whose return address is on the stack; `entry` if the program jumped there instead.
Address caller_of(Address entry, const Cpm::Processor& processor) {
  const auto at = [&processor](int address) { return processor.memory[static_cast<Address>(address)]; };
  const int sp = processor.registers.sp;
  const int from = i8080::joined(at(sp + 1), at(sp)) - 3;
  const bool called = at(from) == call_code && i8080::joined(at(from + 2), at(from + 1)) == entry;
  return called ? static_cast<Address>(from) : entry;
}

// The text up to its $; nullopt without a $.
std::optional<std::string> string_at(Address address, std::span<const Byte> memory) {
  std::string text;
  for (std::size_t n = 0; n < memory.size(); ++n) {
    const Byte byte = memory[address++];
    if (byte == '$') return text;
    text.push_back(static_cast<char>(byte));
  }
  return std::nullopt;
}

}  // namespace

Cpm::Cpm(CpmSetup setup, std::function<void(std::string_view)> print, std::function<void(char)> list)
    : setup_(std::move(setup)),
      print_(std::move(print)),
      list_(std::move(list)),
      whole_(setup_.console || !setup_.drives.empty()),
      entries_(cpm::entries(whole_)),
      files_(setup_.drives, setup_.user) {}

void Cpm::prepare(std::span<Byte> memory) const {
  if (whole_) cpm::fill_system(memory);
}

void Cpm::start(i8080::State& registers, std::span<Byte> memory) const {
  for (const auto& [address, byte] : entries_) memory[address] = byte;
  const std::string blank = setup_.arguments.empty() ? "" : " ";
  if (whole_ || !setup_.arguments.empty()) cpm::put_arguments(blank + setup_.arguments, memory);
  if (!whole_) return;
  memory[cpm::user_and_disk] = files_.user_and_disk();
  // The CCP calls a program, so its RET leads to a warm boot.
  if (registers.sp == 0) registers.sp = cpm::first_stack;
}

Cpm::Outcome Cpm::out(std::uint8_t port, Processor processor) {
  const Address pc = processor.registers.pc;
  if (port == cpm::exit_port && !whole_ && (pc == cpm::boot + 2 || pc == cpm::returned + 2)) return warm_boot(processor);
  if (port == cpm::bdos_port && pc == (whole_ ? cpm::bdos_entry : cpm::bdos) + 2) return call_bdos(processor);
  if (!whole_) return Outcome::no;
  if (port == cpm::bios_port && pc >= cpm::bios_entries) {
    const unsigned place = pc - cpm::bios_entries;
    if (place % 3 == 2 && place / 3 < cpm::bios_functions) return call_bios(place / 3, processor);
  }
  const auto at = static_cast<Address>(pc - 2);
  if (at < cpm::bdos_base || (port != cpm::fill_port && port != cpm::fill_port_at_end)) return Outcome::no;
  return stop_at_call("no_entry", at, processor,
                      fmt::format("found a jump to {:04X}, expected an entry: that of BDOS at {:04X}, or one of the BIOS, every third address from {:04X} "
                                  "(BOOT) to {:04X} (SECTRAN)",
                                  at, cpm::bdos_entry, cpm::bios_table, cpm::bios_table + 3 * translate_sector));
}

// Ends the run at a call; the complaint is prefixed with its address.
Cpm::Outcome Cpm::stop_at_call(std::string_view name, Address entry, Processor processor, std::string_view complaint) {
  caller_ = caller_of(entry, processor);
  return stop_with(name, fmt::format("PC {:04X}: stopped: {}", *caller_, complaint));
}

// Ends the run. A complaint about a command names it, and says how many follow.
Cpm::Outcome Cpm::stop_with(std::string_view name, std::string complaint) {
  if (!complaint.empty() && commands_begun_ != 0) {
    complaint = fmt::format("command {} of {}, \"{}\": {}", commands_begun_, setup_.commands.size(), setup_.commands[commands_begun_ - 1].text, complaint);
    const std::size_t left = setup_.commands.size() - commands_begun_;
    if (left != 0) complaint += left == 1 ? "; the command after it was not run" : fmt::format("; the {} commands after it were not run", left);
  }
  stop_ = {name, std::move(complaint)};
  return Outcome::stopped;
}

// --- Commands ---

// That of the host's command: the low byte of the return code. CP/M 3 takes codes from FF00 on as failures, also FF00.
unsigned Cpm::exit_code() const {
  constexpr unsigned failures = 0xFF00, failed = 3;
  const unsigned code = i8080::low(return_code_);
  return code == 0 && return_code_ >= failures ? failed : code;
}

// The end of a program, and the beginning of the next.
Cpm::Outcome Cpm::warm_boot(Processor processor) {
  if (const unsigned code = exit_code(); code != 0) {
    const Outcome stopped = stop_with("exit", fmt::format("the program set the return code {:04X} by BDOS function 108", return_code_));
    stop_.exit_code = code;
    return stopped;
  }
  if (interrupted_ && commands_begun_ != 0) return stop_with("exit", "ended by ^C");
  if (commands_begun_ == setup_.commands.size()) return stop_with("exit", {});
  return run_next_command(processor);
}

// As the CCP does: the rest of memory stays. User and disk are those of byte 0004.
Cpm::Outcome Cpm::run_next_command(Processor processor) {
  std::span<Byte> memory = processor.memory;
  cpm::fill_system(memory);
  if (commands_begun_ != 0) files_.restart(memory[cpm::user_and_disk]);
  return_code_ = 0;
  while (commands_begun_ < setup_.commands.size()) {
    const CpmCommand& command = setup_.commands[commands_begun_++];
    if (log_.wanted()) {
      log_.write([&](std::string& log) { log += fmt::format("{} command {} {}\n", processor.now, commands_begun_, command.text); });
    }
    if (command.program.empty()) {
      const unsigned user = command.user.value_or(files_.state().user);
      const unsigned disk = command.drive.value_or(files_.state().disk);
      files_.restart(static_cast<Byte>(user << 4U | disk));
      if (files_.state().disk != disk) return stop_with("no_program", fmt::format("found drive {}, expected one given by --cpm-drive", static_cast<char>('A' + disk)));
      continue;
    }
    const auto why = static_cast<CpmFiles::Load>(load(command, processor).hl);
    const std::string file = fmt::format("{}:{}.COM", static_cast<char>('A' + command.drive.value_or(files_.state().disk)), command.program);
    const std::string builtin = is_built_into_ccp(command.program) ? "; it is built into CP/M's CCP, which is not here" : "";
    switch (why) {
      case CpmFiles::Load::no_drive: return stop_with("no_program", fmt::format("found {}, expected a drive given by --cpm-drive", file));
      case CpmFiles::Load::no_file: return stop_with("no_program", fmt::format("found no {} of user {}{}", file, files_.state().user, builtin));
      case CpmFiles::Load::unreadable: return stop_with("no_program", fmt::format("{} cannot be read", file));
      case CpmFiles::Load::too_large:
        return stop_with("no_program", fmt::format("{} is too large, expected {} bytes at most", file, cpm::bdos_base - cpm::program));
      case CpmFiles::Load::done: break;
    }
    for (const auto& [address, byte] : entries_) memory[address] = byte;
    memory[cpm::user_and_disk] = files_.user_and_disk();
    cpm::put_arguments(command.tail, memory);
    processor.registers.sp = cpm::first_stack;
    processor.registers.pc = cpm::program;
    return Outcome::answered;
  }
  return stop_with("exit", {});
}

CpmFiles::Answer Cpm::load(const CpmCommand& command, Processor processor) {
  const auto ask = [&] {
    const unsigned drive = command.drive.value_or(files_.state().disk);
    return CpmFiles::Answer{static_cast<std::uint16_t>(files_.load(drive, command.program, cpm::bdos_base, processor.memory))};
  };
  if (!setup_.journal) return ask();
  return recorded_answer({static_cast<Byte>(commands_begun_), files_.user_and_disk()}, processor, ask);
}

void Cpm::return_value(i8080::State& registers, std::uint16_t value) const {
  registers.a = i8080::low(value);
  registers.hl = value;
  registers.bc = i8080::joined(i8080::high(value), i8080::low(registers.bc));
}

// --- Functions ---

Cpm::Outcome Cpm::call_bdos(Processor processor) {
  function_ = i8080::low(processor.registers.bc);
  if (log_.wanted()) {
    const std::uint16_t de = processor.registers.de;
    call_ = {processor.now, caller_of(cpm::bdos, processor), de, CpmFiles::has_block(function_) && files_.has_drives() ? files_.file_of(de, processor.memory) : ""};
  }
  const Outcome outcome = answer_bdos(processor);
  if (waiting_ == Waiting::no) log_call(processor);
  return outcome;
}

Cpm::Outcome Cpm::answer_bdos(Processor processor) {
  i8080::State& registers = processor.registers;
  const Byte e = i8080::low(registers.de);
  switch (function_) {
    case 0: registers.pc = cpm::boot; return Outcome::answered;
    case 2: print(processor, std::string(1, static_cast<char>(e))); return Outcome::answered;
    case 3: return_value(registers, end_of_tape); return Outcome::answered;
    case 4:
      ++punched_;
      return_value(registers, 0);
      return Outcome::answered;
    case 5: list_(static_cast<char>(e)); return Outcome::answered;
    case 7: return_value(registers, processor.memory[cpm::io_byte]); return Outcome::answered;
    case 8:
      processor.memory[cpm::io_byte] = e;
      return_value(registers, 0);
      return Outcome::answered;
    case 9:
      if (const auto text = string_at(registers.de, processor.memory)) {
        print(processor, *text);
        return Outcome::answered;
      }
      return stop_at_call("endless_string", cpm::bdos, processor, "found no $ in memory for BDOS function 9, expected one at the end of the text");
    case 1:
    case 10:
      if (!setup_.console) break;
      wait_for(function_ == 1 ? Waiting::key : Waiting::line, processor);
      return Outcome::answered;
    case 6: direct_input_output(processor); return Outcome::answered;
    case 11:
      return_value(registers, key_is_there() ? 0xFF : 0x00);
      return Outcome::answered;
    case 27:
    case 31:
      cpm::put_disk_tables(processor.memory);
      return_value(registers, function_ == 27 ? cpm::allocation : cpm::disk_parameters);
      return Outcome::answered;
    case return_code_function:
      if (registers.de == 0xFFFF) {
        return_value(registers, return_code_);
      } else {
        return_code_ = registers.de;
        return_value(registers, 0);
      }
      return Outcome::answered;
    default:
      if (!CpmFiles::answers(function_)) {
        if (function_ > last_function && unknown_.calls++ == 0) {
          unknown_.function = function_;
          unknown_.caller = caller_of(cpm::bdos, processor);
        }
        return_value(registers, 0);
        return Outcome::answered;
      }
      if (files_.has_drives() || !CpmFiles::needs_drive(function_)) return call_files(processor);
      break;
  }
  const std::string_view option = CpmFiles::answers(function_) ? "--cpm-drive A=FOLDER" : "--console MODE";
  return stop_at_call("unknown_bdos", cpm::bdos, processor, fmt::format("found a call of BDOS function {} ({}), which needs {}", function_, bdos_names[function_], option));
}

Cpm::Outcome Cpm::call_bios(unsigned function, Processor processor) {
  constexpr Byte failed = 1, ready = 0xFF;
  i8080::State& registers = processor.registers;
  switch (function) {
    case cold_boot:
    case warm_boot_entry: return warm_boot(processor);
    case console_status: registers.a = key_is_there() ? 0xFF : 0x00; break;
    case console_in:
      if (!setup_.console) {
        return stop_at_call("unknown_bios", static_cast<Address>(cpm::bios_table + 3 * function), processor,
                            "found a call of CONIN of the BIOS, which needs --console MODE");
      }
      wait_for(Waiting::bios_key, processor);
      break;
    case console_out: print_(std::string(1, static_cast<char>(i8080::low(registers.bc)))); break;
    case list_out: list_(static_cast<char>(i8080::low(registers.bc))); break;
    case punch_out: ++punched_; break;
    case reader_in: registers.a = end_of_tape; break;
    case select_disk: registers.hl = 0; break;  // there is no such drive
    case read_sector:
    case write_sector: registers.a = failed; break;
    case list_status: registers.a = ready; break;
    case translate_sector: registers.hl = registers.bc; break;
    default: break;  // HOME and the SETs
  }
  return Outcome::answered;
}

Cpm::Outcome Cpm::call_files(Processor processor) {
  const auto ask = [&] { return files_.call(function_, processor.registers.de, processor.memory); };
  const CpmFiles::Answer answer =
      setup_.journal && CpmFiles::needs_host(function_) ? recorded_answer(question_of_call(processor), processor, ask) : ask();
  if (!answer.fault) {
    return_value(processor.registers, answer.hl);
    return Outcome::answered;
  }
  const std::string text = fmt::format("Bdos Err On {}: {}", answer.fault->drive, answer.fault->why);
  print_at_once("\r\n" + text + "\r\n");
  return stop_at_call("bdos_error", cpm::bdos, processor,
                      fmt::format("found \"{}\" in BDOS function {} ({}), after which CP/M ends a program, expected a drive and a file "
                                  "that the program may use",
                                  text, function_, bdos_names[function_]));
}

// --- The log ---

// A line: T CALLER FUNCTION NAME DE=XXXX [FILE] A=XX HL=XXXX. It has the registers of the answer.
void Cpm::log_call(Processor processor) {
  log_call(fmt::format("A={:02X} HL={:04X}", processor.registers.a, processor.registers.hl));
}

// A call that waits for a key is not in a snapshot: the log of this run has its line.
void Cpm::finish() {
  log_call("waits");
  log_.finish();
}

void Cpm::log_call(std::string_view answer) {
  if (!call_) return;
  const std::string_view name = function_ < bdos_names.size() ? bdos_names[function_] : function_ == return_code_function ? "Program Return Code" : "unknown";
  log_.write([&](std::string& log) {
    log += fmt::format("{} {:04X} {} {} DE={:04X}{}{} {}\n", call_->time, call_->caller, function_, name, call_->de, call_->file.empty() ? "" : " ",
                       call_->file, answer);
  });
  call_.reset();
}

std::vector<EarlyWarning> Cpm::warnings() const {
  std::vector<EarlyWarning> warnings;
  const auto times = [](std::uint64_t count) { return count == 1 ? std::string("once") : fmt::format("{} times", count); };
  if (unknown_.calls != 0) {
    warnings.push_back({fmt::format("PC {:04X}: calls BDOS function {}, expected 0 to 40: CP/M 2.2 answers all above with 0", unknown_.caller, unknown_.function),
                        unknown_.calls == 1 ? "once" : fmt::format("{} such calls", unknown_.calls)});
  }
  for (const CpmFiles::Trouble& each : files_.troubles()) warnings.push_back({each.text, each.times == 1 ? "" : times(each.times)});
  return warnings;
}

std::vector<ReportLine> Cpm::lines() const {
  std::vector<ReportLine> lines;
  if (!setup_.commands.empty()) lines.push_back({"commands", fmt::format("{} of {}", commands_begun_, setup_.commands.size())});
  if (return_code_ != 0) lines.push_back({"return code", fmt::format("{:04X}", return_code_)});
  if (punched_ != 0) lines.push_back({"punch", fmt::format("{} characters, not kept", punched_)});
  return lines;
}

// --- Repeated runs ---

// If the same call is made at the same time with the same data, the answer is the recorded one and the host is not
// accessed. Any other call begins a different run, so later records are invalid.
CpmFiles::Answer Cpm::recorded_answer(std::vector<Byte> question, Processor processor, const std::function<CpmFiles::Answer()>& ask) {
  CpmFiles::State& state = files_.state();
  const std::uint32_t asked = base::crc32(question);
  const auto known = std::lower_bound(journal_.begin(), journal_.end(), processor.now,
                                      [](const HostCall& each, std::int64_t time) { return each.time < time; });
  if (known != journal_.end() && known->time == processor.now && known->asked == asked) {
    state = known->state;
    for (const auto& [address, byte] : known->written) processor.memory[address] = byte;
    return known->answer;
  }
  journal_.erase(known, journal_.end());
  const std::vector<Byte> before(processor.memory.begin(), processor.memory.end());
  HostCall done{processor.now, asked, ask(), state, {}};
  for (std::size_t at = 0; at < before.size(); ++at) {
    if (processor.memory[at] != before[at]) done.written.emplace_back(static_cast<Address>(at), processor.memory[at]);
  }
  journal_.push_back(done);
  return done.answer;
}

// Everything that the answer to a call depends on, except the host.
std::vector<Byte> Cpm::question_of_call(Processor processor) {
  constexpr std::size_t block = 36;
  const std::uint16_t de = processor.registers.de;
  const CpmFiles::State& state = files_.state();
  std::vector<Byte> question{function_, i8080::low(de), i8080::high(de), i8080::low(state.transfer), i8080::high(state.transfer), files_.user_and_disk()};
  const auto add = [&](Address at, std::size_t bytes) {
    for (std::size_t n = 0; n < bytes; ++n) question.push_back(processor.memory[static_cast<Address>(at + n)]);
  };
  add(de, block);
  add(state.transfer, CpmFiles::record);
  return question;
}

std::int64_t Cpm::trim_journal(std::size_t most) {
  if (journal_.size() > most) {
    const auto first = journal_.end() - static_cast<std::ptrdiff_t>(most);
    journal_begins_ = (first - 1)->time + 1;
    journal_.erase(journal_.begin(), first);
  }
  return journal_begins_;
}

// --- The console ---

void Cpm::type(std::uint8_t code) {
  keys_.push_back(code);
  polled_ = false;
}

bool Cpm::key_is_there() {
  if (keys_.empty()) polled_ = polled_now_ = true;
  return !keys_.empty();
}

Byte Cpm::take_key() {
  const Byte key = keys_.front();
  keys_.erase(keys_.begin());
  return key;
}

// Function 6: E is FF to read a key or 0, FE to test for one, otherwise the character to print.
void Cpm::direct_input_output(Processor processor) {
  const Byte e = i8080::low(processor.registers.de);
  if (e < 0xFE) {
    print_(std::string(1, static_cast<char>(e)));
  } else {
    const bool there = key_is_there();
    return_value(processor.registers, !there ? 0 : e == 0xFF ? take_key() : 0xFF);
  }
}

void Cpm::wait_for(Waiting what, Processor processor) {
  waiting_ = what;
  line_.clear();
  static_cast<void>(resume(processor));
}

bool Cpm::resume(Processor processor) {
  while (waiting_ != Waiting::no && !keys_.empty()) {
    const Byte key = take_key();
    switch (waiting_) {
      case Waiting::key:
        waiting_ = Waiting::no;
        echo(key);
        return_value(processor.registers, key);
        break;
      case Waiting::bios_key:
        waiting_ = Waiting::no;
        processor.registers.a = key;
        break;
      case Waiting::paused:
        waiting_ = Waiting::no;
        if ((key & 0x7FU) == ctrl_c) end_by_key(processor);
        else print_unprinted();
        break;
      default: edit_line(key, processor); break;
    }
  }
  if (waiting_ == Waiting::no) log_call(processor);
  return waiting_ == Waiting::no;
}

// Output of functions 2 and 9. As in BDOS, a ^S that has been typed stops it until the next key; ^C then ends the program.
void Cpm::print(Processor processor, std::string_view text) {
  unprinted_.assign(text.begin(), text.end());
  print_unprinted();
  if (waiting_ == Waiting::paused) static_cast<void>(resume(processor));
}

void Cpm::print_unprinted() {
  const bool stops = !keys_.empty() && (keys_.front() & 0x7FU) == ctrl_s && !unprinted_.empty();
  if (stops) {
    static_cast<void>(take_key());
    waiting_ = Waiting::paused;
    return;
  }
  print_at_once({reinterpret_cast<const char*>(unprinted_.data()), unprinted_.size()});
  unprinted_.clear();
}

// A tab becomes blanks up to the next eighth column. As in BDOS, only a line feed ends a line.
void Cpm::print_at_once(std::string_view text) {
  std::string printed;
  for (const char c : text) {
    if (c == '\t') {
      do {
        printed += ' ';
        ++column_;
      } while (column_ % 8 != 0);
      continue;
    }
    printed += c;
    const auto code = static_cast<unsigned char>(c);
    if (code >= ' ' && code != 0x7F) ++column_;
    else if (c == '\b' && column_ != 0) --column_;
    else if (c == '\n') column_ = 0;
  }
  print_(printed);
}

// As CP/M echoes: control characters are not sent, except those that move the carriage.
void Cpm::echo(Byte key) {
  constexpr std::string_view carriage = "\r\n\t\b";
  const char c = static_cast<char>(key & 0x7FU);
  if (c >= ' ' || carriage.find(c) != std::string_view::npos) print_at_once(std::string_view(&c, 1));
}

// Function 10 (Interface Guide, "Read Console Buffer"): DE is the address of the length of the buffer, followed by the
// number of characters read and the characters.
void Cpm::edit_line(Byte key, Processor processor) {
  constexpr Byte backspace = 8, line_feed = 10, carriage_return = 13, ctrl_u = 21, ctrl_x = 24, rubout = 127;
  switch (key & 0x7FU) {
    case ctrl_c:
      if (!line_.empty()) break;
      waiting_ = Waiting::no;
      print_at_once("^C\r\n");
      end_by_key(processor);
      return;
    case backspace:
    case rubout:
      if (line_.empty()) return;
      line_.pop_back();
      print_at_once("\b \b");
      return;
    case ctrl_u:
    case ctrl_x:
      line_.clear();
      print_at_once("#\r\n");
      return;
    case line_feed:
    case carriage_return:
      print_at_once("\r");
      store_line(processor);
      return;
    default: break;
  }
  line_.push_back(key);
  echo(key);
  if (line_.size() >= processor.memory[processor.registers.de]) store_line(processor);
}

// ^C
void Cpm::end_by_key(Processor processor) {
  unprinted_.clear();
  interrupted_ = true;
  processor.registers.pc = cpm::boot;
}

void Cpm::store_line(Processor processor) {
  const Address buffer = processor.registers.de;
  const auto at = [&](std::size_t n) -> Byte& { return processor.memory[static_cast<Address>(buffer + n)]; };
  const std::size_t count = std::min<std::size_t>(line_.size(), at(0));
  at(1) = static_cast<Byte>(count);
  for (std::size_t n = 0; n < count; ++n) at(2 + n) = line_[n];
  waiting_ = Waiting::no;
}

void Cpm::add_details(base::Json& report) const {
  if (caller_) report["bdos"] = base::Json{{"function", function_}, {"caller", fmt::format("{:04X}", *caller_)}};
  if (return_code_ != 0) report["return_code"] = fmt::format("{:04X}", return_code_);
  if (!setup_.commands.empty()) report["commands"] = base::Json{{"begun", commands_begun_}, {"of", setup_.commands.size()}};
}

}  // namespace sightline::machines
