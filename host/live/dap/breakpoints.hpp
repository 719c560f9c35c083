// The breakpoints of a client: by source lines, names, addresses and words of memory. They have the numbers of the debugger's
// breakpoints, which console commands may remove; after a restart of the machine they are set again. Each request takes its
// arguments and returns the body of its answer, or throws base::Error.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host/base/json.hpp"
#include "host/live/dap/places.hpp"
#include "host/live/debugger.hpp"

namespace sightline::live::dap {

class ClientBreakpoints {
 public:
  // `numbering` must outlive this object.
  explicit ClientBreakpoints(const Numbering& numbering) : numbering_(numbering) {}
  // Sets the debugger to which all further requests refer. Called before any request. The debugger must exist until the next call.
  void set_debugger(Debugger& debugger) { debugger_ = &debugger; }

  [[nodiscard]] base::Json set_in_source(const base::Json& arguments);
  [[nodiscard]] base::Json set_at_functions(const base::Json& arguments);
  [[nodiscard]] base::Json set_at_instructions(const base::Json& arguments);
  [[nodiscard]] base::Json set_on_data(const base::Json& arguments);
  // The words of memory that a name, [ADDRESS] or an expression stands for. Registers cannot be watched.
  [[nodiscard]] base::Json data_info(const base::Json& arguments);

  // Finds the places again after the sources have been assembled again. Returns the bodies of the events `breakpoint`.
  [[nodiscard]] std::vector<base::Json> find_places_again();
  // Removes those that a command has removed from the debugger. Returns the bodies of the events `breakpoint`.
  [[nodiscard]] std::vector<base::Json> forget_removed();

 private:
  // The place that a client requested, in a source or at a function.
  struct Wanted {
    std::string file;
    std::int64_t line = 0;  // from 1
    std::string name;       // of a function; `file` is then empty
  };
  void forget(std::vector<int>& numbers);
  [[nodiscard]] base::Json add(Breakpoint breakpoint, const base::Json& request, std::vector<int>& numbers);
  [[nodiscard]] base::Json add_at(const Wanted& wanted, const base::Json& request, std::vector<int>& numbers);
  template <class Make>
  [[nodiscard]] base::Json set_all(const base::Json& list, std::vector<int>& numbers, Make make);
  // The first line from the wanted one on that assembles to a word, or the value of the name, with line 0.
  [[nodiscard]] CodeLine place_for(const Wanted& wanted) const;
  void add_place(base::Json& breakpoint, const CodeLine& found) const;

  const Numbering& numbering_;
  Debugger* debugger_ = nullptr;
  std::map<int, Wanted> wanted_;  // by the numbers of breakpoints
  std::map<std::string, std::vector<int>> in_files_;
  std::vector<int> at_functions_;
  std::vector<int> at_instructions_;
  std::vector<int> on_data_;
};

}  // namespace sightline::live::dap
