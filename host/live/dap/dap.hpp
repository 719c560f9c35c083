// The Debug Adapter Protocol (microsoft.github.io/debug-adapter-protocol, version 1.65) for both machines: an editor sets
// breakpoints in a source of ours, steps forward and back, and looks at registers, memory and devices.
//
// Addresses on the wire are hexadecimal ("0x40"), as the protocol wants them; values are shown in the radix of the
// machine. Memory is a row of bytes: of the 8080 its own, of the PDP-7 four a word, the lowest first.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/json.hpp"
#include "host/base/result.hpp"
#include "host/machines/engine.hpp"
#include "host/live/monitor/monitor.hpp"
#include "host/live/symbols.hpp"

namespace sightline::live {

// A machine made for `launch`, with --monitor.
struct Launched {
  const machines::MachineDescription* description = nullptr;
  machines::Prepared prepared;
  Symbols symbols{8};
  std::vector<std::string> warnings = {};
  int radix = 0;  // of values; 0: that of the machine
  std::optional<KeyCodes> keys = std::nullopt;  // what the option `console` says; empty: as Debugger has it
  std::string dialect = {};  // of instructions that are typed; empty: that of the machine's assembler
};

struct DapHost {
  // What the client has sent, waiting so many milliseconds for it (-1: as long as it takes). Empty: nothing yet; nullopt: there
  // will be no more.
  std::function<std::optional<std::string>(int milliseconds)> read;
  // False: nobody reads it any more.
  std::function<bool(std::string_view)> write;
  // The arguments of `launch`: machine, program (a path or several) and options, an object of the options of `sightline run`
  // without their dashes; a value is text, a number, true, or an array of texts.
  std::function<base::Result<Launched>(const base::Json& arguments)> launch;
  // The session of a machine is over; an error is shown to the person.
  std::function<base::Result<base::Done>(const machines::Machine&)> finish = {};
  // How commands of the console read and write files; its `running` is not used.
  MonitorHost commands = {};
};

// Until the client disconnects. An error: what it sent is not the protocol, and the session cannot go on.
[[nodiscard]] base::Result<base::Done> serve_debug_adapter(const DapHost& host);

}  // namespace sightline::live
