// What experiments give: rows of plain values, each under a key. Records know no titles, units, captions or
// HTML; data/*.json say what becomes of them.
//
// A key is in snake_case and carries its unit where it has one: "drawing_s", "host_ns", "pmr_percent".
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "host/report/document.hpp"

namespace sightline::report {

// Nothing (not measured, does not apply), words, a count, a number, a judgement, a picture.
class Value {
 public:
  using Kind = std::variant<std::monostate, std::string, std::int64_t, double, Verdict, Picture>;

  Value() = default;
  Value(bool yes) : kind_(std::string(yes ? "yes" : "no")) {}
  Value(std::integral auto count) : kind_(static_cast<std::int64_t>(count)) {}
  Value(std::floating_point auto number) : kind_(static_cast<double>(number)) {}
  Value(const char* text) : kind_(std::string(text)) {}
  Value(std::string_view text) : kind_(std::string(text)) {}
  Value(std::string text) : kind_(std::move(text)) {}
  Value(Verdict verdict) : kind_(std::move(verdict)) {}
  Value(Picture picture) : kind_(std::move(picture)) {}
  template <class T>
  Value(const std::optional<T>& value) {
    if (value) *this = Value(*value);
  }

  [[nodiscard]] const Kind& kind() const { return kind_; }
  [[nodiscard]] bool missing() const { return std::holds_alternative<std::monostate>(kind_); }
  // A count or a number; nothing for other kinds.
  [[nodiscard]] std::optional<double> number() const;
  // Words, or those of a judgement; nothing for other kinds.
  [[nodiscard]] std::optional<std::string_view> text() const;

  friend bool operator==(const Value&, const Value&) = default;

 private:
  Kind kind_;
};

using NamedValues = std::vector<std::pair<std::string_view, Value>>;

// Rows that all have the same keys in the same order.
class RowSet {
 public:
  RowSet() = default;
  // Of rows that may turn out to be none: the keys are known all the same.
  explicit RowSet(std::vector<std::string> keys) : keys_(std::move(keys)) {}

  // The first row gives the keys. Throws std::logic_error for a row with others: a defect of the experiment.
  void add(const NamedValues& row);
  void add(std::initializer_list<NamedValues::value_type> row) { add(NamedValues(row)); }

  [[nodiscard]] const std::vector<std::string>& keys() const { return keys_; }
  [[nodiscard]] std::optional<std::size_t> place_of(std::string_view key) const;
  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] const Value& at(std::size_t row, std::size_t place) const { return rows_[row][place]; }
  // Throws std::out_of_range for a key that is not there.
  [[nodiscard]] const Value& at(std::size_t row, std::string_view key) const;
  void set(std::size_t row, std::string_view key, Value value);

 private:
  std::vector<std::string> keys_;
  std::vector<std::vector<Value>> rows_;
};

// The row sets of one experiment by their names.
using Records = std::map<std::string, RowSet, std::less<>>;

}  // namespace sightline::report
