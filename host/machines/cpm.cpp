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

constexpr Byte exit_port = 0;
constexpr Byte bdos_port = 1;
constexpr Byte bios_port = Cpm::last_port;
constexpr Byte jump_code = 0xC3, return_code = 0xC9, out_code = 0xD3, call_code = 0xCD;

constexpr Address boot = 0x0000;
constexpr Address bdos = 0x0005;
// Without a console and drives: a RET with SP=0000 goes to the address formed by the bytes at 0000.
constexpr Address returned = 0x00D3;
// With them: the last six bytes before the entry of BDOS are CP/M's serial number; below them is the stack of a program
// that sets none.
constexpr Address bdos_entry = 0xF106;
constexpr Address first_stack = 0xF0FE;
constexpr Address bios_table = 0xF200;
constexpr Address bios_entries = 0xF240;

constexpr std::array<std::string_view, 41> bdos_names{
    "System Reset", "Console Input", "Console Output", "Reader Input", "Punch Output", "List Output", "Direct Console I/O",
    "Get I/O Byte", "Set I/O Byte", "Print String", "Read Console Buffer", "Get Console Status", "Return Version Number",
    "Reset Disk System", "Select Disk", "Open File", "Close File", "Search for First", "Search for Next", "Delete File",
    "Read Sequential", "Write Sequential", "Make File", "Rename File", "Return Login Vector", "Return Current Disk",
    "Set DMA Address", "Get Addr(Alloc)", "Write Protect Disk", "Get Read/Only Vector", "Set File Attributes",
    "Get Addr(Disk Parms)", "Set/Get User Code", "Read Random", "Write Random", "Compute File Size", "Set Random Record",
    "Reset Drive", "38", "39", "Write Random with Zero Fill"};

enum Bios : unsigned { cold_boot, warm_boot, console_status, console_in, console_out, list_out, list_status = 15 };
constexpr std::array<std::string_view, 17> bios_names{"BOOT",   "WBOOT",  "CONST", "CONIN",  "CONOUT", "LIST",
                                                      "PUNCH",  "READER", "HOME",  "SELDSK", "SETTRK", "SETSEC",
                                                      "SETDMA", "READ",   "WRITE", "LISTST", "SECTRAN"};

void put(std::vector<std::pair<Address, Byte>>& entries, unsigned at, std::initializer_list<Byte> bytes) {
  for (const Byte byte : bytes) entries.emplace_back(static_cast<Address>(at++), byte);
}

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

void put_cpm_arguments(std::string_view words, std::span<std::uint8_t> memory) {
  constexpr std::size_t tail = 0x80, most = 126;
  std::string text;
  for (const char c : words) text += static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  if (!text.empty()) text.insert(text.begin(), ' ');
  text.resize(std::min(text.size(), most));
  memory[tail] = static_cast<std::uint8_t>(text.size());
  std::copy(text.begin(), text.end(), memory.begin() + tail + 1);
  memory[tail + 1 + text.size()] = 0;

  std::size_t at = 0;
  for (const std::size_t block : {0x5CU, 0x6CU}) {
    const auto next = [&]() -> std::uint8_t {
      constexpr std::string_view ends = " =_.:;<>";
      return at < text.size() && ends.find(text[at]) == std::string_view::npos ? static_cast<std::uint8_t>(text[at++]) : 0;
    };
    while (at < text.size() && text[at] == ' ') ++at;
    std::fill_n(memory.begin() + static_cast<std::ptrdiff_t>(block), 16, std::uint8_t{0});
    std::fill_n(memory.begin() + static_cast<std::ptrdiff_t>(block) + 1, 11, std::uint8_t{' '});
    if (at + 1 < text.size() && text[at + 1] == ':' && text[at] >= 'A' && text[at] <= 'P') {
      memory[block] = static_cast<std::uint8_t>(text[at] - 'A' + 1);
      at += 2;
    }
    const auto field = [&](std::size_t first, std::size_t last) {
      std::size_t n = first;
      while (const std::uint8_t c = next()) {
        if (c == '*') {
          while (n < last) memory[block + n++] = '?';
        } else if (n < last) {
          memory[block + n++] = c;
        }
      }
    };
    field(1, 9);
    if (at < text.size() && text[at] == '.') {
      ++at;
      field(9, 12);
    }
    while (at < text.size() && text[at] != ' ') ++at;
  }
}

Cpm::Cpm(CpmSetup setup, std::function<void(std::string_view)> print, std::function<void(char)> list)
    : setup_(std::move(setup)),
      print_(std::move(print)),
      list_(std::move(list)),
      whole_(setup_.console || !setup_.drives.empty()),
      files_(setup_.drives) {
  if (!whole_) {
    put(entries_, boot, {out_code, exit_port});
    put(entries_, bdos, {out_code, bdos_port, return_code});
    put(entries_, returned, {out_code, exit_port});
    return;
  }
  const auto jump_to = [this](unsigned at, unsigned to) {
    put(entries_, at, {jump_code, i8080::low(static_cast<Address>(to)), i8080::high(static_cast<Address>(to))});
  };
  jump_to(boot, bios_table + 3 * warm_boot);
  jump_to(bdos, bdos_entry);
  put(entries_, bdos_entry, {out_code, bdos_port, return_code});
  for (unsigned n = 0; n < bios_names.size(); ++n) {
    jump_to(bios_table + 3 * n, bios_entries + 3 * n);
    put(entries_, bios_entries + 3 * n, {out_code, bios_port, return_code});
  }
}

void Cpm::start(i8080::State& registers, std::span<Byte> memory) const {
  for (const auto& [address, byte] : entries_) memory[address] = byte;
  if (whole_ || !setup_.arguments.empty()) put_cpm_arguments(setup_.arguments, memory);
  if (!whole_) return;
  constexpr std::size_t user_and_disk = 4;
  memory[user_and_disk] = files_.user_and_disk();
  // The CCP calls a program, so its RET leads to a warm boot.
  if (registers.sp == 0) registers.sp = first_stack;
}

Cpm::Outcome Cpm::out(std::uint8_t port, Processor processor) {
  const Address pc = processor.registers.pc;
  if (port == exit_port && !whole_ && (pc == boot + 2 || pc == returned + 2)) return stop_with("exit", {});
  if (port == bdos_port && pc == (whole_ ? bdos_entry : bdos) + 2) return call_bdos(processor);
  if (port == bios_port && whole_ && pc >= bios_entries) {
    const unsigned place = pc - bios_entries;
    if (place % 3 == 2 && place / 3 < bios_names.size()) return call_bios(place / 3, processor);
  }
  return Outcome::no;
}

// Ends the run; a complaint is prefixed with the address of the call.
Cpm::Outcome Cpm::stop_with(std::string_view name, std::string_view complaint) {
  stop_ = {name, complaint.empty() ? std::string() : fmt::format("PC {:04X}: stopped: {}", *caller_, complaint)};
  return Outcome::stopped;
}

void Cpm::return_value(i8080::State& registers, std::uint16_t value) const {
  registers.a = i8080::low(value);
  registers.hl = value;
  registers.bc = i8080::joined(i8080::high(value), i8080::low(registers.bc));
}

// --- Functions ---

Cpm::Outcome Cpm::call_bdos(Processor processor) {
  i8080::State& registers = processor.registers;
  function_ = i8080::low(registers.bc);
  switch (function_) {
    case 0: registers.pc = boot; return Outcome::answered;
    case 2: print_(std::string(1, static_cast<char>(i8080::low(registers.de)))); return Outcome::answered;
    case 5: list_(static_cast<char>(i8080::low(registers.de))); return Outcome::answered;
    case 9:
      if (const auto text = string_at(registers.de, processor.memory)) {
        print_(*text);
        return Outcome::answered;
      }
      caller_ = caller_of(bdos, processor);
      return stop_with("endless_string", "found no $ in memory for BDOS function 9, expected one at the end of the text");
    case 1:
    case 10:
      if (!setup_.console) break;
      wait_for(function_ == 1 ? Waiting::key : Waiting::line, processor);
      return Outcome::answered;
    case 6:
      if (!setup_.console) break;
      direct_input_output(processor);
      return Outcome::answered;
    case 11:
      if (!setup_.console) break;
      return_value(registers, key_is_there() ? 0xFF : 0x00);
      return Outcome::answered;
    default:
      if (CpmFiles::answers(function_) && files_.has_drives()) return call_files(processor);
      break;
  }
  caller_ = caller_of(bdos, processor);
  const std::string name =
      function_ < bdos_names.size() ? fmt::format(" ({})", bdos_names[function_]) : std::string();
  std::string expected = setup_.console ? "0, 1, 2, 5, 6, 9, 10, 11" : "0, 2, 5, 9";
  if (files_.has_drives()) expected += ", 12 to 26, 28 to 30, 32 to 37, 40";
  if (!setup_.console) expected += "; 1, 6, 10, 11 with --console MODE";
  if (!files_.has_drives()) expected += "; 12 to 37 and 40 with --cpm-drive A=FOLDER";
  return stop_with("unknown_bdos", fmt::format("found a call of BDOS function {}{}, expected {}", function_, name, expected));
}

Cpm::Outcome Cpm::call_bios(unsigned function, Processor processor) {
  i8080::State& registers = processor.registers;
  switch (function) {
    case cold_boot:
    case warm_boot: return stop_with("exit", {});
    case console_status: registers.a = setup_.console && key_is_there() ? 0xFF : 0x00; return Outcome::answered;
    case console_in:
      if (!setup_.console) break;
      wait_for(Waiting::bios_key, processor);
      return Outcome::answered;
    case console_out: print_(std::string(1, static_cast<char>(i8080::low(registers.bc)))); return Outcome::answered;
    case list_out: list_(static_cast<char>(i8080::low(registers.bc))); return Outcome::answered;
    case list_status: registers.a = 0xFF; return Outcome::answered;
    default: break;
  }
  caller_ = caller_of(static_cast<Address>(bios_table + 3 * function), processor);
  return stop_with("unknown_bios", fmt::format("found a call of {} of the BIOS, expected BOOT, WBOOT, CONST, CONIN (with --console MODE), CONOUT, LIST "
                             "or LISTST: drives are folders and have no sectors",
                             bios_names[function]));
}

Cpm::Outcome Cpm::call_files(Processor processor) {
  const std::uint16_t de = processor.registers.de;
  const CpmFiles::Answer answer = setup_.journal && CpmFiles::needs_host(function_)
                                      ? recorded_answer(processor)
                                      : files_.call(function_, de, processor.memory);
  if (!answer.fault) {
    return_value(processor.registers, answer.hl);
    return Outcome::answered;
  }
  const std::string text = fmt::format("Bdos Err On {}: {}", answer.fault->drive, answer.fault->why);
  print_("\r\n" + text + "\r\n");
  caller_ = caller_of(bdos, processor);
  return stop_with("bdos_error", fmt::format("found \"{}\" in BDOS function {} ({}), after which CP/M ends a program, expected a drive and a file "
                             "that the program may use",
                             text, function_, bdos_names[function_]));
}

// --- Repeated runs ---

// If the same call is made at the same time with the same data, the answer is the recorded one and the host is not
// accessed. Any other call begins a different run, so later records are invalid.
CpmFiles::Answer Cpm::recorded_answer(Processor processor) {
  constexpr std::size_t block = 36;
  const std::uint16_t de = processor.registers.de;
  CpmFiles::State& state = files_.state();
  std::vector<Byte> question{function_, i8080::low(de), i8080::high(de), i8080::low(state.transfer),
                             i8080::high(state.transfer), state.disk};
  const auto add = [&](Address at, std::size_t bytes) {
    for (std::size_t n = 0; n < bytes; ++n) question.push_back(processor.memory[static_cast<Address>(at + n)]);
  };
  add(de, block);
  add(state.transfer, CpmFiles::record);
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
  HostCall done{processor.now, asked, files_.call(function_, de, processor.memory), state, {}};
  for (std::size_t at = 0; at < before.size(); ++at) {
    if (processor.memory[at] != before[at]) done.written.emplace_back(static_cast<Address>(at), processor.memory[at]);
  }
  journal_.push_back(done);
  return done.answer;
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
      default: edit_line(key, processor); break;
    }
  }
  return waiting_ == Waiting::no;
}

// As CP/M echoes: control characters are not sent, except those that move the carriage.
void Cpm::echo(Byte key) {
  constexpr std::string_view carriage = "\r\n\t\b";
  const char c = static_cast<char>(key & 0x7FU);
  if (c >= ' ' || carriage.find(c) != std::string_view::npos) print_(std::string(1, c));
}

// Function 10 (Interface Guide, "Read Console Buffer"): DE is the address of the length of the buffer, followed by the
// number of characters read and the characters.
void Cpm::edit_line(Byte key, Processor processor) {
  constexpr Byte ctrl_c = 3, backspace = 8, line_feed = 10, carriage_return = 13, ctrl_u = 21, ctrl_x = 24, rubout = 127;
  switch (key & 0x7FU) {
    case ctrl_c:
      if (!line_.empty()) break;
      waiting_ = Waiting::no;
      print_("^C\r\n");
      processor.registers.pc = boot;
      return;
    case backspace:
    case rubout:
      if (line_.empty()) return;
      line_.pop_back();
      print_("\b \b");
      return;
    case ctrl_u:
    case ctrl_x:
      line_.clear();
      print_("#\r\n");
      return;
    case line_feed:
    case carriage_return:
      print_("\r");
      store_line(processor);
      return;
    default: break;
  }
  line_.push_back(key);
  echo(key);
  if (line_.size() >= processor.memory[processor.registers.de]) store_line(processor);
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
}

}  // namespace sightline::machines
