// All that the page has of machines: files that were dropped on it, machines made of them, a debugger for each, and the
// assemblers. The page asks by requests in JSON (host/manual/page.md lists them); what it needs in every picture it
// asks for by number, without a text.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/json.hpp"
#include "host/machines/engine.hpp"
#include "host/live/debugger.hpp"

namespace sightline::live::web {

using base::Json;
using machines::Bytes;

// A machine on the page with its debugger.
class MachineSession {
 public:
  MachineSession(const machines::MachineDescription& description, machines::Prepared prepared, Symbols symbols);

  [[nodiscard]] machines::Machine& machine() { return *prepared_.machine; }
  [[nodiscard]] Debugger& debugger() { return debugger_; }
  [[nodiscard]] const machines::MachineDescription& description() const { return description_; }
  // A request begins: what it runs counts from here, and ends when it has run too long.
  void begin();
  // What has been printed since the last call.
  [[nodiscard]] std::string take_printed();

  void type(char key);

  // To that time in the machine's unit; at most so many instructions.
  [[nodiscard]] Halted run(std::int64_t until, std::uint64_t instructions);

  // What has been drawn since the last call. The page reads it as it lies in memory (module.cpp).
  [[nodiscard]] std::span<const core::Stroke> take_flashes();

 private:
  const machines::MachineDescription& description_;
  machines::Prepared prepared_;
  [[nodiscard]] bool spent() const;

  std::string printed_;
  int slices_ = 0;
  std::uint64_t begun_at_ = 0;  // instructions
  Debugger debugger_;
};

class Workbench {
 public:
  // A file of the page under a name; another of that name is replaced.
  void put_file(const std::string& name, Bytes bytes) { files_[name] = std::move(bytes); }
  [[nodiscard]] const Bytes* file(const std::string& name) const;

  // Null if there is none of that number.
  [[nodiscard]] MachineSession* session(int number);
  int add(std::unique_ptr<MachineSession> session);

  // An object with what was asked for, or with `error`, a text for a person. Never anything else, whatever the request.
  [[nodiscard]] Json answer(const Json& request);
  // What a request has made that is no text: a snapshot, an assembled program.
  [[nodiscard]] const Bytes& made() const { return made_; }

 private:
  [[nodiscard]] Json make(const Json& request);
  [[nodiscard]] Json assemble(const Json& request);
  [[nodiscard]] Json of_session(MachineSession& session, std::string_view what, const Json& request);

  std::map<std::string, Bytes> files_;
  std::map<int, std::unique_ptr<MachineSession>> sessions_;
  int last_ = 0;
  Bytes made_;
};

[[nodiscard]] Json refusal(std::string_view complaint);
// Why a machine stands still, for a person.
[[nodiscard]] std::string reason_text(const Halted& halted);

}  // namespace sightline::live::web
