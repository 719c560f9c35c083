// The Debug Adapter Protocol (microsoft.github.io/debug-adapter-protocol, version 1.65) for both machines: an editor sets
// breakpoints in a source, steps forward and back, and shows registers, memory and devices.
//
// Addresses in messages are hexadecimal ("0x40"), as the protocol requires; values are shown in the radix of the machine.
// Memory is a sequence of bytes; a word of the PDP-7 has four, the least significant first.
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
  int radix = 0;  // of values; 0: the radix of the machine
  std::optional<KeyCodes> keys = std::nullopt;  // value of the option `console`; empty: the default of Debugger
  std::string dialect = {};  // for instructions that are typed; empty: that of the machine's assembler
};

struct DapHost {
  // Returns what the client has sent, after waiting up to `milliseconds` for it (-1: no limit). Empty: nothing yet. nullopt: the
  // input has ended.
  std::function<std::optional<std::string>(int milliseconds)> read;
  // Returns false if nobody reads the output any more.
  std::function<bool(std::string_view)> write;
  // Makes a machine from the arguments of `launch`: machine, program (one or several paths) and options, an object of the options
  // of `sightline run` without their dashes. A value is a text, a number, true, or an array of texts.
  std::function<base::Result<Launched>(const base::Json& arguments)> launch;
  // Called when the session of a machine ends; an error is shown to the person.
  std::function<base::Result<base::Done>(const machines::Machine&)> finish = {};
  // Reads and writes files for console commands; its `running` is not used.
  MonitorHost commands = {};
};

// Runs until the client disconnects. An error: the client violated the protocol, and the session cannot continue.
[[nodiscard]] base::Result<base::Done> serve_debug_adapter(const DapHost& host);

}  // namespace sightline::live
