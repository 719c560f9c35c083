// The machines of the page: files that were dropped on it, machines made from them, a debugger for each, and the assemblers.
// The page sends requests in JSON (host/manual/page.md lists them). Values that it needs for every frame have functions in
// module.cpp.
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
  // Called at the beginning of a request: limits how long it may run the machine.
  void begin();
  // The text printed since the last call.
  [[nodiscard]] std::string take_printed();

  void type(char key);

  // Runs to a time in the machine's unit, for at most so many instructions.
  [[nodiscard]] Halted run(std::int64_t until, std::uint64_t instructions);

  // The flashes since the last call. The page reads them directly from memory (module.cpp).
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
  // Stores a file of the page; it replaces a file of the same name.
  void put_file(const std::string& name, Bytes bytes) { files_[name] = std::move(bytes); }
  [[nodiscard]] const Bytes* file(const std::string& name) const;

  // Null if the number is unknown.
  [[nodiscard]] MachineSession* session(int number);
  int add(std::unique_ptr<MachineSession> session);

  // An object with the requested members, or with `error`, a text for a person; for every request, valid or not.
  [[nodiscard]] Json answer(const Json& request);
  // The binary result of the last request: a snapshot or an assembled program.
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

[[nodiscard]] Json error_answer(std::string_view complaint);
// The reason why a machine has stopped, as a text for a person.
[[nodiscard]] std::string reason_text(const Halted& halted);

}  // namespace sightline::live::web
