// The expressions of data/*.json: what is taken from records, and small sums over it.
//
//   second_view_s                          of the row at hand
//   views.second_view_s.max                of all rows: min max mean sum first last distinct
//   views[scene = 'house' and eae = 'yes'].second_view_s   of the one row that is left
//   views[second_view_s >= 1].rows         how many rows
//   printed[y = outer.y].sides             outer: the row at hand, seen from within the brackets
//   1 / pair.view_s   a - b   abs(x)   min(a, b)   max(a, b)   = != < <= > >=   and or not   x is missing
//
// What is computed of a missing value is missing, and no comparison with it holds. Names are in snake_case;
// texts stand in single quotes. A name is first a key of the row at hand, then a single value, then a set.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "host/report/records.hpp"

namespace sightline::report {

// Where names are looked up.
struct Scope {
  const RowSet* set = nullptr;  // the row at hand; none: no row
  std::size_t row = 0;
  const Scope* outer = nullptr;
  std::function<const RowSet*(std::string_view)> set_named = {};  // nullptr: no such set
  std::map<std::string, Value, std::less<>> values = {};          // "here.min"
};

// What is wrong with an expression or text, in words; the caller knows file and place.
class Wrong : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What the work throws, with the place before it.
template <class Work>
auto with_place(const std::string& place, Work&& work) {
  try {
    return work();
  } catch (const Wrong& wrong) {
    if (place.empty()) throw;
    throw Wrong(place + ": " + wrong.what());
  }
}

// A key of a set that an expression reads; `set` is empty for the row at hand.
struct Reference {
  std::string set;
  std::string key;
};

class Expression {
 public:
  struct Node;

  // Throws Wrong, whose words begin with the place if there is one.
  explicit Expression(std::string_view text, std::string place = {});

  // Throws Wrong for names that are not there, several rows where one is needed, texts in sums.
  [[nodiscard]] Value value(const Scope& scope) const;
  [[nodiscard]] bool holds(const Scope& scope) const;
  // The values of what is compared, for a message: "views.second_view_s.max is 3.2".
  [[nodiscard]] std::string explain(const Scope& scope) const;
  void collect(std::vector<Reference>& references, std::string_view row_set) const;
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  std::string place_;
  std::shared_ptr<const Node> root_;
};

}  // namespace sightline::report
