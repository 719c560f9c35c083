// Queries of chapters on rows: selected rows, a single row, least and greatest values, sums.
//
// Rows are a vector of structs, or the result of `where`. A value is a member (&View::pieces) or a function of the
// row; empty optional values are skipped.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace sightline::report {

template <class Row>
using Chosen = std::vector<std::reference_wrapper<const Row>>;

template <class Rows>
struct RowOf {
  using Row = std::remove_cvref_t<std::unwrap_reference_t<typename Rows::value_type>>;
};

template <class T>
struct Range {
  T least{};
  T greatest{};
};

// All rows for which `holds` is true. `rows` must outlive the result.
template <class Rows, class Holds>
auto where(const Rows& rows, Holds holds) {
  Chosen<typename RowOf<Rows>::Row> chosen;
  for (const typename RowOf<Rows>::Row& row : rows)
    if (std::invoke(holds, row)) chosen.push_back(row);
  return chosen;
}

template <class Rows, class Holds>
std::size_t count(const Rows& rows, Holds holds) {
  return where(rows, holds).size();
}

// A condition on rows: equals(&View::scene, "house").
template <class Member, class Wanted>
auto equals(Member member, Wanted wanted) {
  return [member, wanted = std::move(wanted)](const auto& row) { return std::invoke(member, row) == wanted; };
}

// The row for which `holds` is true. Throws std::logic_error, a defect of the chapter, unless there is exactly one.
template <class Rows, class Holds>
const auto& only(const Rows& rows, Holds holds) {
  const auto chosen = where(rows, holds);
  if (chosen.size() != 1) throw std::logic_error("a chapter asks for one row, and found " + std::to_string(chosen.size()));
  return chosen.front().get();
}

// The values of all rows, without empty ones.
template <class Rows, class Value>
auto values(const Rows& rows, Value value) {
  using Given = std::remove_cvref_t<std::invoke_result_t<Value, const typename RowOf<Rows>::Row&>>;
  if constexpr (requires(const Given& given) { given.has_value(); }) {
    std::vector<typename Given::value_type> all;
    for (const typename RowOf<Rows>::Row& row : rows)
      if (const auto& given = std::invoke(value, row)) all.push_back(*given);
    return all;
  } else {
    std::vector<Given> all;
    for (const typename RowOf<Rows>::Row& row : rows) all.push_back(std::invoke(value, row));
    return all;
  }
}

// Throws std::logic_error if there is no value, as do least, greatest and mean.
template <class Rows, class Value>
auto range_of(const Rows& rows, Value value) {
  const auto all = values(rows, value);
  if (all.empty()) throw std::logic_error("a chapter asks for the least of no values");
  const auto [least, greatest] = std::minmax_element(all.begin(), all.end());
  return Range<typename decltype(all)::value_type>{*least, *greatest};
}
template <class Rows, class Value>
auto least(const Rows& rows, Value value) {
  return range_of(rows, value).least;
}
template <class Rows, class Value>
auto greatest(const Rows& rows, Value value) {
  return range_of(rows, value).greatest;
}

template <class Rows, class Value>
auto sum(const Rows& rows, Value value) {
  const auto all = values(rows, value);
  typename decltype(all)::value_type total{};
  for (const auto& one : all) total += one;
  return total;
}
template <class Rows, class Value>
double mean(const Rows& rows, Value value) {
  const auto all = values(rows, value);
  if (all.empty()) throw std::logic_error("a chapter asks for the mean of no values");
  double total = 0;
  for (const auto& one : all) total += static_cast<double>(one);
  return total / static_cast<double>(all.size());
}

// The number of different values.
template <class Rows, class Value>
std::size_t distinct(const Rows& rows, Value value) {
  auto all = values(rows, value);
  std::sort(all.begin(), all.end());
  return static_cast<std::size_t>(std::unique(all.begin(), all.end()) - all.begin());
}

}  // namespace sightline::report
