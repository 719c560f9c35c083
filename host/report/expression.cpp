// A recursive descent parser over a tree of nodes.
#include "host/report/expression.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "host/base/text.hpp"
#include "host/report/table_text.hpp"

namespace sightline::report {

struct Expression::Node {
  enum class Kind : std::uint8_t { constant, path, function, unary, binary } kind = Kind::constant;
  Value constant = {};
  std::string word = {};  // an operator, a function, the first name of a path
  std::vector<std::string> names = {};  // of a path, behind the first
  std::vector<std::shared_ptr<const Node>> parts = {};  // operands, arguments; the filter of a path
  std::string text = {};  // as written
};

namespace {

using Node = Expression::Node;
using NodePointer = std::shared_ptr<const Node>;

constexpr std::array<std::string_view, 7> aggregates{"min", "max", "mean", "sum", "first", "last", "distinct"};
constexpr std::array<std::string_view, 6> comparisons{"<=", ">=", "!=", "=", "<", ">"};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  NodePointer whole() {
    blanks();
    auto node = either();
    if (at_ < text_.size()) throw Wrong(fmt::format("\"{}\": found \"{}\", expected an operator or the end", text_, text_.substr(at_)));
    return node;
  }

 private:
  void blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool take(std::string_view token) {
    if (text_.substr(at_, token.size()) != token) return false;
    const bool word = is_letter(token.back());
    const std::size_t next = at_ + token.size();
    if (word && next < text_.size() && (is_letter(text_[next]) || is_digit(text_[next]))) return false;
    at_ = next;
    blanks();
    return true;
  }
  void need(std::string_view token) {
    if (!take(token)) throw Wrong(fmt::format("\"{}\": expected \"{}\" at character {}", text_, token, at_ + 1));
  }
  NodePointer made(Node node, std::size_t begun) {
    node.text = text_.substr(begun, at_ - begun);
    while (node.text.ends_with(' ')) node.text.pop_back();
    return std::make_shared<const Node>(std::move(node));
  }
  NodePointer binary(std::string_view word, NodePointer left, NodePointer right, std::size_t begun) {
    Node node{.kind = Node::Kind::binary, .word = std::string(word)};
    node.parts = {std::move(left), std::move(right)};
    return made(std::move(node), begun);
  }

  template <class Next, std::size_t n>
  NodePointer left_to_right(const std::array<std::string_view, n>& words, Next next) {
    const std::size_t begun = at_;
    auto node = next();
    while (true) {
      const auto word = std::find_if(words.begin(), words.end(), [this](auto w) { return take(w); });
      if (word == words.end()) return node;
      node = binary(*word, std::move(node), next(), begun);
    }
  }

  NodePointer either() {
    return left_to_right(std::array<std::string_view, 1>{"or"}, [this] { return both(); });
  }
  NodePointer both() {
    return left_to_right(std::array<std::string_view, 1>{"and"}, [this] { return comparison(); });
  }
  NodePointer comparison() {
    const std::size_t begun = at_;
    if (take("not")) return unary("not", comparison(), begun);
    auto left = sum();
    if (take("is")) {
      need("missing");
      return unary("missing", std::move(left), begun);
    }
    for (const std::string_view word : comparisons)
      if (take(word)) return binary(word, std::move(left), sum(), begun);
    return left;
  }
  NodePointer sum() {
    return left_to_right(std::array<std::string_view, 2>{"+", "-"}, [this] { return product(); });
  }
  NodePointer product() {
    return left_to_right(std::array<std::string_view, 2>{"*", "/"}, [this] { return primary(); });
  }
  NodePointer unary(std::string_view word, NodePointer part, std::size_t begun) {
    Node node{.kind = Node::Kind::unary, .word = std::string(word)};
    node.parts = {std::move(part)};
    return made(std::move(node), begun);
  }

  NodePointer primary() {
    blanks();
    const std::size_t begun = at_;
    if (take("-")) return unary("-", primary(), begun);
    if (take("(")) {
      auto node = either();
      need(")");
      return node;
    }
    if (at_ < text_.size() && text_[at_] == '\'') return quoted(begun);
    if (at_ < text_.size() && is_digit(text_[at_])) return number(begun);
    return named(begun);
  }

  NodePointer quoted(std::size_t begun) {
    const std::size_t end = text_.find('\'', at_ + 1);
    if (end == std::string_view::npos) throw Wrong(fmt::format("\"{}\": a text does not end", text_));
    const std::string_view inside = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    blanks();
    return made({.constant = Value(inside)}, begun);
  }

  NodePointer number(std::size_t begun) {
    double real = 0;
    const auto read = std::from_chars(text_.data() + at_, text_.data() + text_.size(), real);
    const std::string_view digits(text_.data() + at_, static_cast<std::size_t>(read.ptr - text_.data()) - at_);
    at_ += digits.size();
    blanks();
    const bool whole = digits.find_first_not_of("0123456789") == std::string_view::npos;
    return made({.constant = whole ? Value(static_cast<std::int64_t>(real)) : Value(real)}, begun);
  }

  std::string name() {
    const std::size_t begun = at_;
    while (at_ < text_.size() && (is_letter(text_[at_]) || (at_ > begun && is_digit(text_[at_])))) ++at_;
    if (at_ == begun) throw Wrong(fmt::format("\"{}\": expected a name or a number at character {}", text_, at_ + 1));
    return std::string(text_.substr(begun, at_ - begun));
  }

  NodePointer named(std::size_t begun) {
    Node node{.kind = Node::Kind::path, .word = name()};
    if (at_ < text_.size() && text_[at_] == '(') {
      node.kind = Node::Kind::function;
      need("(");
      do node.parts.push_back(sum());
      while (take(","));
      need(")");
      const std::size_t wanted = node.word == "abs" ? 1 : node.word == "min" || node.word == "max" ? 2 : 0;
      if (node.parts.size() != wanted)
        throw Wrong(fmt::format("\"{}\": expected abs(x), min(x, y) or max(x, y)", text_));
      return made(std::move(node), begun);
    }
    if (at_ < text_.size() && text_[at_] == '[') {
      need("[");
      node.parts.push_back(either());
      need("]");
    }
    while (at_ < text_.size() && text_[at_] == '.') {
      ++at_;
      node.names.push_back(name());
    }
    blanks();
    return made(std::move(node), begun);
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

Value value_of(const Node& node, const Scope& scope);

Scope row_scope(const Scope& scope, const RowSet& set, std::size_t row) {
  return {&set, row, &scope, scope.set_named, scope.values};
}

bool truth(const Value& value) {
  const auto number = value.number();
  return number && *number != 0;
}

// Of values that are there; those of numbers fail on others.
Value aggregate(std::string_view how, const std::vector<Value>& values, const std::string& text) {
  if (how == "first") return values.empty() ? Value() : values.front();
  if (how == "last") return values.empty() ? Value() : values.back();
  if (how == "distinct") {
    std::vector<Value> different;
    for (const Value& value : values)
      if (std::find(different.begin(), different.end(), value) == different.end()) different.push_back(value);
    return different.size();
  }
  if (values.empty()) return {};
  const bool counts = std::all_of(values.begin(), values.end(), [](const Value& value) {
    return std::holds_alternative<std::int64_t>(value.kind());
  });
  std::vector<double> numbers;
  for (const Value& value : values) {
    const auto number = value.number();
    if (!number) throw Wrong(fmt::format("{}: found words, expected numbers", text));
    numbers.push_back(*number);
  }
  double result = 0;
  if (how == "min") result = *std::min_element(numbers.begin(), numbers.end());
  if (how == "max") result = *std::max_element(numbers.begin(), numbers.end());
  if (how == "sum" || how == "mean")
    for (const double number : numbers) result += number;
  if (how == "mean") return result / static_cast<double>(numbers.size());
  return counts ? Value(static_cast<std::int64_t>(result)) : Value(result);
}

Value of_set(const Node& node, const RowSet& set, const Scope& scope) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < set.size(); ++row)
    if (node.parts.empty() || truth(value_of(*node.parts.front(), row_scope(scope, set, row)))) rows.push_back(row);
  if (node.names.size() == 1 && node.names.front() == "rows") return rows.size();
  const auto place = node.names.empty() ? std::nullopt : set.place_of(node.names.front());
  if (!place)
    throw Wrong(fmt::format("{}: found no key \"{}\" in the records, expected one of {}", node.text,
                            node.names.empty() ? "" : node.names.front(), base::joined(set.keys(), ", ")));
  if (node.names.size() == 1) {
    if (rows.size() != 1)
      throw Wrong(fmt::format("{}: found {} rows, expected 1; choose with [...] or end with .min, .max, .mean, .sum, "
                              ".first, .last or .distinct",
                              node.text, rows.size()));
    return set.at(rows.front(), *place);
  }
  const std::string& how = node.names[1];
  if (node.names.size() != 2 || std::find(aggregates.begin(), aggregates.end(), how) == aggregates.end())
    throw Wrong(fmt::format("{}: found .{}, expected one of {}", node.text, how, base::joined(aggregates, ", ")));
  std::vector<Value> values;
  for (const std::size_t row : rows)
    if (const Value& value = set.at(row, *place); !value.missing()) values.push_back(value);
  return aggregate(how, values, node.text);
}

Value of_path(const Node& node, const Scope& scope) {
  if (node.word == "outer" && node.names.size() == 1 && node.parts.empty()) {
    if (scope.outer == nullptr) throw Wrong(node.text + ": there is no outer row");
    return of_path({.kind = Node::Kind::path, .word = node.names.front(), .text = node.text}, *scope.outer);
  }
  if (node.names.empty() && node.parts.empty() && scope.set != nullptr)
    if (const auto place = scope.set->place_of(node.word)) return scope.set->at(scope.row, *place);
  std::string dotted = node.word;
  for (const std::string& name : node.names) dotted += "." + name;
  if (node.parts.empty())
    if (const auto found = scope.values.find(dotted); found != scope.values.end()) return found->second;
  const RowSet* const set = scope.set_named ? scope.set_named(node.word) : nullptr;
  if (set != nullptr) return of_set(node, *set, scope);
  std::string known;
  if (scope.set != nullptr) known = fmt::format(" in the row; it has {}", base::joined(scope.set->keys(), ", "));
  throw Wrong(fmt::format("{}: found no \"{}\" among the sets{}", node.text, node.word, known));
}

double number_of(const Value& value, const Node& node) {
  const auto number = value.number();
  if (!number) throw Wrong(fmt::format("{}: found words, expected a number", node.text));
  return *number;
}

Value compared(const Node& node, const Value& left, const Value& right) {
  if (left.missing() || right.missing()) return 0;
  const auto order = [&]() -> int {
    if (const auto a = left.text(), b = right.text(); a && b) return a->compare(*b);
    const double a = number_of(left, *node.parts[0]);
    const double b = number_of(right, *node.parts[1]);
    return a < b ? -1 : a > b ? 1 : 0;
  }();
  const std::string& word = node.word;
  const bool holds = word == "=" ? order == 0 : word == "!=" ? order != 0 : word == "<" ? order < 0 :
                     word == "<=" ? order <= 0 : word == ">" ? order > 0 : order >= 0;
  return holds ? 1 : 0;
}

Value computed(const Node& node, const Value& left, const Value& right) {
  if (left.missing() || right.missing()) return {};
  const double a = number_of(left, *node.parts[0]);
  const double b = number_of(right, *node.parts[1]);
  const bool counts = std::holds_alternative<std::int64_t>(left.kind()) && std::holds_alternative<std::int64_t>(right.kind());
  const auto result = [&](double value) { return counts ? Value(static_cast<std::int64_t>(value)) : Value(value); };
  if (node.word == "+") return result(a + b);
  if (node.word == "-") return result(a - b);
  if (node.word == "*") return result(a * b);
  if (node.word == "min") return result(std::min(a, b));
  if (node.word == "max") return result(std::max(a, b));
  if (b == 0) return {};
  return a / b;
}

Value of_binary(const Node& node, const Scope& scope) {
  const Value left = value_of(*node.parts[0], scope);
  if (node.word == "and") return truth(left) && truth(value_of(*node.parts[1], scope)) ? 1 : 0;
  if (node.word == "or") return truth(left) || truth(value_of(*node.parts[1], scope)) ? 1 : 0;
  const Value right = value_of(*node.parts[1], scope);
  const bool comparison = std::find(comparisons.begin(), comparisons.end(), node.word) != comparisons.end();
  return comparison ? compared(node, left, right) : computed(node, left, right);
}

Value of_unary(const Node& node, const Scope& scope) {
  const Value value = value_of(*node.parts.front(), scope);
  if (node.word == "not") return truth(value) ? 0 : 1;
  if (node.word == "missing") return value.missing() ? 1 : 0;
  if (value.missing()) return {};
  if (const auto* const count = std::get_if<std::int64_t>(&value.kind()))
    return node.word == "-" ? -*count : std::abs(*count);
  const double number = number_of(value, *node.parts.front());
  return node.word == "-" ? -number : std::abs(number);
}

Value value_of(const Node& node, const Scope& scope) {
  switch (node.kind) {
    case Node::Kind::constant: return node.constant;
    case Node::Kind::path: return of_path(node, scope);
    case Node::Kind::unary: return of_unary(node, scope);
    case Node::Kind::binary: return of_binary(node, scope);
    case Node::Kind::function:
      if (node.word == "abs") return of_unary(node, scope);
      return computed(node, value_of(*node.parts[0], scope), value_of(*node.parts[1], scope));
  }
  return {};
}

void collect(const Node& node, std::vector<Reference>& references, std::string_view row_set) {
  if (node.kind == Node::Kind::path) {
    const bool of_row = node.names.empty() && node.parts.empty();
    if (of_row) references.push_back({std::string(row_set), node.word});
    // The outer row's set is not known here: the key is looked for in any.
    if (!node.names.empty()) references.push_back({node.word == "outer" ? "" : node.word, node.names.front()});
    for (const NodePointer& part : node.parts) collect(*part, references, node.word);
    return;
  }
  for (const NodePointer& part : node.parts) collect(*part, references, row_set);
}

// "left is 3.2" of every side of every comparison that is no constant.
void explain(const Node& node, const Scope& scope, std::vector<std::string>& sides) {
  if (node.kind != Node::Kind::binary && node.kind != Node::Kind::unary) return;
  for (const NodePointer& part : node.parts) {
    const bool logic = part->word == "and" || part->word == "or" || part->word == "not" ||
                       std::find(comparisons.begin(), comparisons.end(), part->word) != comparisons.end();
    if (logic) {
      explain(*part, scope, sides);
    } else if (part->kind != Node::Kind::constant) {
      sides.push_back(fmt::format("{} is {}", part->text, shown_text(cell_of(value_of(*part, scope)))));
    }
  }
}

}  // namespace

Expression::Expression(std::string_view text, std::string place)
    : text_(text), place_(std::move(place)), root_(with_place(place_, [this] { return Parser(text_).whole(); })) {}

Value Expression::value(const Scope& scope) const {
  return with_place(place_, [&] { return value_of(*root_, scope); });
}

bool Expression::holds(const Scope& scope) const {
  return truth(value(scope));
}

std::string Expression::explain(const Scope& scope) const {
  std::vector<std::string> sides;
  report::explain(*root_, scope, sides);
  return base::joined(sides, ", ");
}

void Expression::collect(std::vector<Reference>& references, std::string_view row_set) const {
  report::collect(*root_, references, row_set);
}

}  // namespace sightline::report
