#include "host/report/records.hpp"

#include <algorithm>
#include <stdexcept>

namespace sightline::report {

std::optional<double> Value::number() const {
  if (const auto* const count = std::get_if<std::int64_t>(&kind_)) return static_cast<double>(*count);
  if (const auto* const number = std::get_if<double>(&kind_)) return *number;
  return std::nullopt;
}

std::optional<std::string_view> Value::text() const {
  if (const auto* const text = std::get_if<std::string>(&kind_)) return *text;
  if (const auto* const verdict = std::get_if<Verdict>(&kind_)) return verdict->text;
  return std::nullopt;
}

void RowSet::add(const NamedValues& row) {
  if (keys_.empty())
    for (const auto& [key, value] : row) keys_.emplace_back(key);
  const bool same = std::equal(row.begin(), row.end(), keys_.begin(), keys_.end(),
                               [](const auto& cell, const std::string& key) { return cell.first == key; });
  if (!same) throw std::logic_error("a row of records has other keys than the first");
  auto& values = rows_.emplace_back();
  for (const auto& [key, value] : row) values.push_back(value);
}

std::optional<std::size_t> RowSet::place_of(std::string_view key) const {
  const auto found = std::find(keys_.begin(), keys_.end(), key);
  if (found == keys_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - keys_.begin());
}

const Value& RowSet::at(std::size_t row, std::string_view key) const {
  const auto place = place_of(key);
  if (!place) throw std::out_of_range("records have no key " + std::string(key));
  return rows_.at(row)[*place];
}

void RowSet::set(std::size_t row, std::string_view key, Value value) {
  const auto place = place_of(key);
  if (!place) throw std::out_of_range("records have no key " + std::string(key));
  rows_.at(row)[*place] = std::move(value);
}

}  // namespace sightline::report
