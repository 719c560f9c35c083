// Shows a stopped machine to a client and changes it: stack, registers, devices, expressions, memory and disassembly. Each request
// takes its arguments and returns the body of its answer, or throws base::Error.
#pragma once

#include <cstdint>
#include <string>

#include "host/base/json.hpp"
#include "host/live/dap/places.hpp"
#include "host/live/debugger.hpp"

namespace sightline::live::dap {

class View {
 public:
  // Both must outlive the view.
  View(Debugger& debugger, const Numbering& numbering) : debugger_(debugger), numbering_(numbering) {}

  [[nodiscard]] base::Json threads(const base::Json& arguments);
  [[nodiscard]] base::Json stack_trace(const base::Json& arguments);
  [[nodiscard]] base::Json scopes(const base::Json& arguments);
  [[nodiscard]] base::Json variables(const base::Json& arguments);
  [[nodiscard]] base::Json set_variable(const base::Json& arguments);
  // A register by its name, or a word of memory as [address].
  [[nodiscard]] base::Json set_expression(const base::Json& arguments);
  // Names that begin with the text before the cursor; at the beginning of a line also the monitor's verbs.
  [[nodiscard]] base::Json completions(const base::Json& arguments);
  [[nodiscard]] base::Json read_memory(const base::Json& arguments);
  [[nodiscard]] base::Json write_memory(const base::Json& arguments);
  [[nodiscard]] base::Json disassemble(const base::Json& arguments);
  // The lines of a source at which a breakpoint can be set.
  [[nodiscard]] base::Json breakpoint_locations(const base::Json& arguments);
  [[nodiscard]] base::Json loaded_sources(const base::Json& arguments);
  // Where `goto` can continue for a line of a source: at that line, or the next one with code. The number of a target is its address.
  [[nodiscard]] base::Json goto_targets(const base::Json& arguments);

  // The value of an expression, as the body of `evaluate`.
  [[nodiscard]] base::Json value_of(const std::string& expression) const;
  // All of memory, as the body of the event `memory`.
  [[nodiscard]] base::Json whole_memory() const;

 private:
  void add_place(base::Json& object, std::uint32_t at) const;

  Debugger& debugger_;
  const Numbering& numbering_;
};

}  // namespace sightline::live::dap
