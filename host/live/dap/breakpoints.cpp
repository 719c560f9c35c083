#include "host/live/dap/breakpoints.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "host/live/dap/messages.hpp"

namespace sightline::live::dap {

using base::Json;
using machines::Probe;

void ClientBreakpoints::forget(std::vector<int>& numbers) {
  for (const int number : std::exchange(numbers, {})) {
    static_cast<void>(debugger_->breakpoints().remove(number));
    wanted_.erase(number);
  }
}

// Adds a breakpoint with the condition and the count of the request; the answer has its number.
Json ClientBreakpoints::add(Breakpoint breakpoint, const Json& request, std::vector<int>& numbers) {
  const std::string condition = text_in(request, "condition");
  const std::string count = text_in(request, "hitCondition");
  if (!condition.empty()) {
    const auto value = debugger_->evaluate(condition);
    if (!value) return Json{{"verified", false}, {"message", value.error().message()}};
    breakpoint.condition = condition;
  }
  if (!count.empty()) breakpoint.count = base::value_of(read_hit_count(count));
  breakpoint.log = text_in(request, "logMessage");
  static_cast<void>(base::value_of(debugger_->log_text(breakpoint.log)));
  const int number = debugger_->breakpoints().add(std::move(breakpoint));
  numbers.push_back(number);
  return Json{{"id", number}, {"verified", true}};
}

// Replaces all breakpoints of `numbers` by one for each element of `list`. `make` throws base::Error if it cannot set one.
template <class Make>
Json ClientBreakpoints::set_all(const Json& list, std::vector<int>& numbers, Make make) {
  forget(numbers);
  Json answers = Json::array();
  for (const Json& each : list.elements()) {
    try {
      answers.push_back(make(each));
    } catch (const base::Error& refused) {
      answers.push_back(Json{{"verified", false}, {"message", refused.message()}});
    }
  }
  return Json{{"breakpoints", std::move(answers)}};
}

CodeLine ClientBreakpoints::place_for(const Wanted& wanted) const {
  if (!wanted.name.empty()) return {0, base::value_of(debugger_->address_of(wanted.name))};
  const auto lines = code_lines(debugger_->symbols(), wanted.file, wanted.line, std::numeric_limits<std::int64_t>::max());
  if (lines.empty()) throw base::usage_error("neither this line nor a later one assembles to a word");
  return lines.front();
}

Json ClientBreakpoints::add_at(const Wanted& wanted, const Json& request, std::vector<int>& numbers) {
  const CodeLine found = place_for(wanted);
  Breakpoint breakpoint;
  breakpoint.first = breakpoint.last = found.at;
  Json answer = add(breakpoint, request, numbers);
  if (!flag_in(answer, "verified")) return answer;
  wanted_[numbers.back()] = wanted;
  add_place(answer, found);
  return answer;
}

void ClientBreakpoints::add_place(Json& breakpoint, const CodeLine& found) const {
  if (found.line == 0) return;
  breakpoint["line"] = numbering_.line(found.line);
  breakpoint["instructionReference"] = reference(found.at);
}

Json ClientBreakpoints::set_in_source(const Json& arguments) {
  const std::string path = text_in(member(arguments, "source"), "path");
  std::vector<int>& numbers = in_files_[path];
  return set_all(member(arguments, "breakpoints"), numbers, [&](const Json& each) {
    constexpr std::int64_t last = std::int64_t{1} << 40;  // outside every file; the sum does not overflow
    const std::int64_t line = std::clamp<std::int64_t>(integer_in(each, "line", 0), 0, last);
    return add_at({path, line + 1 - numbering_.first_line, {}}, each, numbers);
  });
}

Json ClientBreakpoints::set_at_functions(const Json& arguments) {
  return set_all(member(arguments, "breakpoints"), at_functions_, [&](const Json& each) {
    const std::string name = text_in(each, "name");
    if (name.empty()) throw base::usage_error("found no name, expected a symbol or an expression");
    return add_at({{}, 0, name}, each, at_functions_);
  });
}

std::vector<Json> ClientBreakpoints::find_places_again() {
  std::vector<Json> changed;
  std::erase_if(wanted_, [&](const auto& each) {
    const auto& [number, wanted] = each;
    Json breakpoint{{"id", number}, {"verified", false}};
    try {
      const CodeLine found = place_for(wanted);
      if (!debugger_->breakpoints().move(number, found.at)) return true;
      breakpoint["verified"] = true;
      add_place(breakpoint, found);
    } catch (const base::Error& refused) {
      static_cast<void>(debugger_->breakpoints().remove(number));
      breakpoint["message"] = refused.message();
    }
    const bool lost = !flag_in(breakpoint, "verified");
    changed.push_back(Json{{"reason", "changed"}, {"breakpoint", std::move(breakpoint)}});
    return lost;
  });
  return changed;
}

Json ClientBreakpoints::set_at_instructions(const Json& arguments) {
  return set_all(member(arguments, "breakpoints"), at_instructions_, [&](const Json& each) {
    Breakpoint breakpoint;
    breakpoint.first = breakpoint.last = place_of(*debugger_, text_in(each, "instructionReference"), integer_in(each, "offset", 0));
    return add(breakpoint, each, at_instructions_);
  });
}

Json ClientBreakpoints::data_info(const Json& arguments) {
  const std::string name = text_in(arguments, "name");
  const auto none = [](const std::string& why) { return Json{{"dataId", Json()}, {"description", why}}; };
  // With asAddress the value of any expression is the address, also that of [ADDRESS] or a register.
  const bool as_address = flag_in(arguments, "asAddress");
  if (!as_address && (debugger_->register_named(name) || debugger_->pair_named(name))) return none("a register cannot be watched");
  if (!as_address && debugger_->is_state(name)) return none(name + " is no word of memory");
  const std::string_view word = as_address ? std::string_view() : word_in_brackets(name);
  const auto at = debugger_->address_of(word.empty() ? std::string_view(name) : word);
  if (!at) return none(at.error().message());
  const std::int64_t a_word = bytes_a_word(*debugger_);
  const std::int64_t bytes = std::clamp<std::int64_t>(integer_in(arguments, "bytes", 1), 1, std::int64_t{debugger_->machine().words() - *at} * a_word);
  const std::uint32_t last = *at + static_cast<std::uint32_t>((bytes - 1) / a_word);
  const std::string near = debugger_->symbols().near(*at);
  const std::string place = last == *at ? "word at " + debugger_->address(*at)
                                        : fmt::format("words at {}-{}", debugger_->address(*at), debugger_->address(last));
  return Json{{"dataId", reference(*at) + (last == *at ? std::string() : "-" + reference(last))},
              {"description", near.empty() ? place : place + " " + near},
              {"accessTypes", Json::array({Json("read"), Json("write"), Json("readWrite")})}};
}

Json ClientBreakpoints::set_on_data(const Json& arguments) {
  return set_all(member(arguments, "breakpoints"), on_data_, [&](const Json& each) {
    const std::string access = text_in(each, "accessType");
    Breakpoint breakpoint;
    breakpoint.kind = Breakpoint::Kind::memory;
    const std::string id = text_in(each, "dataId");
    const std::size_t dash = id.find('-');
    breakpoint.first = place_of(*debugger_, id.substr(0, dash), 0);
    breakpoint.last = dash == std::string::npos ? breakpoint.first : place_of(*debugger_, id.substr(dash + 1), 0);
    if (breakpoint.last < breakpoint.first) throw base::usage_error(fmt::format("found dataId {}, expected one of dataBreakpointInfo", id));
    breakpoint.access = static_cast<std::uint8_t>(access == "read"        ? Probe::is_read
                                                  : access == "readWrite" ? Probe::is_read | Probe::is_written
                                                                          : Probe::is_written);
    return add(breakpoint, each, on_data_);
  });
}

std::vector<Json> ClientBreakpoints::forget_removed() {
  std::vector<Json> removed;
  const auto& all = debugger_->breakpoints().all();
  const auto gone = [&](int number) {
    if (std::any_of(all.begin(), all.end(), [number](const Breakpoint& each) { return each.number == number; })) return false;
    removed.push_back(Json{{"reason", "removed"}, {"breakpoint", Json{{"id", number}, {"verified", false}}}});
    wanted_.erase(number);
    return true;
  };
  for (auto& [path, numbers] : in_files_) std::erase_if(numbers, gone);
  for (std::vector<int>* const numbers : {&at_functions_, &at_instructions_, &on_data_}) std::erase_if(*numbers, gone);
  return removed;
}

}  // namespace sightline::live::dap
