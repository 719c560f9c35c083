// Where a client wants the program to stop: by lines of sources, names, addresses and words of memory. The debugger's breakpoints
// have these numbers, and commands at the console may remove them; what the client asked for stays when the machine is made again.
// Each request takes its arguments and gives the body of its answer; one that cannot be done throws base::Error.
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
  // `numbering` outlives this.
  explicit ClientBreakpoints(const Numbering& numbering) : numbering_(numbering) {}
  // Whose breakpoints they are from here on; before any request. It outlives this, or the next one takes its place.
  void follow(Debugger& debugger) { debugger_ = &debugger; }

  [[nodiscard]] base::Json set_in_source(const base::Json& arguments);
  [[nodiscard]] base::Json set_at_functions(const base::Json& arguments);
  [[nodiscard]] base::Json set_at_instructions(const base::Json& arguments);
  [[nodiscard]] base::Json set_on_data(const base::Json& arguments);
  // Registers are no places; a name or an expression is the word at its value.
  [[nodiscard]] base::Json data_info(const base::Json& arguments);

  // After the sources have been read again: lines and names may be elsewhere. The bodies of the events `breakpoint`.
  [[nodiscard]] std::vector<base::Json> find_places_again();
  // Forgets those that a command has removed. The bodies of the events `breakpoint`.
  [[nodiscard]] std::vector<base::Json> forget_removed();

 private:
  // Where a breakpoint of a source or a function was asked for.
  struct Wanted {
    std::string file;
    std::int64_t line = 0;  // from 1
    std::string name;       // of a function; then there is no file
  };
  struct Found {
    std::uint32_t at = 0;
    std::size_t line = 0;  // from 1; 0: of a name
  };

  void forget(std::vector<int>& numbers);
  [[nodiscard]] base::Json add(Breakpoint breakpoint, const base::Json& request, std::vector<int>& numbers);
  [[nodiscard]] base::Json add_at(const Wanted& wanted, const base::Json& request, std::vector<int>& numbers);
  template <class Make>
  [[nodiscard]] base::Json set_all(const base::Json& list, std::vector<int>& numbers, Make make);
  [[nodiscard]] Found place_for(const Wanted& wanted) const;
  void tell_place(base::Json& breakpoint, const Found& found) const;

  const Numbering& numbering_;
  Debugger* debugger_ = nullptr;
  std::map<int, Wanted> wanted_;  // by the numbers of breakpoints
  std::map<std::string, std::vector<int>> in_files_;
  std::vector<int> at_functions_;
  std::vector<int> at_instructions_;
  std::vector<int> on_data_;
};

}  // namespace sightline::live::dap
