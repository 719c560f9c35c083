// A JSON value, as printed by --json and as stored in scene files.
//
// Objects keep the order in which their members were added. dump() writes the same bytes as
// nlohmann::ordered_json, because people compare these documents byte for byte with earlier ones.
// The library itself is included by json.cpp alone, because its headers are 95,000 lines long.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::base {

struct JsonMember;

class Json {
 public:
  using Array = std::vector<Json>;
  using Object = std::vector<JsonMember>;

  // null
  Json() = default;
  Json(std::nullptr_t) {}
  template <class Bool>
  requires std::is_same_v<Bool, bool>  // no type that only converts to bool, such as a pointer
  Json(Bool value) : value_(value) {}
  Json(double value) : value_(value) {}
  template <class Integer>
  requires(std::is_integral_v<Integer> && !std::is_same_v<Integer, bool>) Json(Integer value)
      : value_(stored_integer(value)) {}
  Json(std::string text) : value_(Owned<std::string>(std::move(text))) {}
  Json(std::string_view text) : Json(std::string(text)) {}
  Json(const char* text) : Json(std::string(text)) {}
  // null if there is no value
  template <class Value>
  Json(const std::optional<Value>& value) : Json(value ? Json(*value) : Json()) {}
  // An array of the elements of any range.
  template <class Range>
  requires(!std::is_convertible_v<const Range&, std::string_view> &&
           requires(const Range& range) {
             std::begin(range);
             std::end(range);
           }) Json(const Range& range)
      : Json(array()) {
    for (const auto& element : range) push_back(element);
  }

  // An object: Json{{"name", name}, {"count", 3}}. Arrays are written Json::array({low, high}).
  Json(std::initializer_list<JsonMember> members);
  [[nodiscard]] static Json object() { return Json(std::initializer_list<JsonMember>()); }
  [[nodiscard]] static Json array(std::initializer_list<Json> elements = {});

  // The value of `key`, added as null if there is none; a null becomes an object.
  Json& operator[](std::string_view key);
  // Sets every member of `members`, another object; those that exist keep their place.
  void update(const Json& members);
  // A null becomes an array.
  void push_back(Json element);

  [[nodiscard]] bool is_null() const { return holds<std::monostate>(); }
  [[nodiscard]] bool is_array() const { return holds<Owned<Array>>(); }
  [[nodiscard]] bool is_object() const { return holds<Owned<Object>>(); }
  [[nodiscard]] bool is_string() const { return holds<Owned<std::string>>(); }
  [[nodiscard]] bool is_number() const;

  // The value as this type; none if it has another type or is out of range.
  [[nodiscard]] std::optional<bool> boolean() const;
  [[nodiscard]] std::optional<std::int64_t> integer() const;  // a number without point and exponent
  [[nodiscard]] std::optional<double> number() const;         // any number
  [[nodiscard]] const std::string* text() const;              // null: not a string

  // Elements of an array or members of an object; 0 for anything else.
  [[nodiscard]] std::size_t size() const;
  // Of an array; i < size().
  [[nodiscard]] const Json& operator[](std::size_t i) const { return elements()[i]; }
  [[nodiscard]] Json& operator[](std::size_t i) { return (*std::get<Owned<Array>>(value_))[i]; }
  // Of an object: the value of `key`, of the last one if there are several; null if there is none.
  [[nodiscard]] const Json* find(std::string_view key) const;
  // Empty if the value is no array, or no object.
  [[nodiscard]] const Array& elements() const;
  [[nodiscard]] const Object& members() const;

  // With `indent`: that many spaces per level and one element or member per line. Without: one line. Bytes that are not
  // UTF-8 become U+FFFD; numbers that are not finite become null.
  [[nodiscard]] std::string dump(std::optional<unsigned> indent = std::nullopt) const;

 private:
  // A value on the heap that is copied with its owner: a Json is 16 bytes, whatever it holds.
  template <class T>
  class Owned {
   public:
    explicit Owned(T value);
    Owned(const Owned& other);
    Owned(Owned&&) noexcept = default;
    Owned& operator=(const Owned& other);
    Owned& operator=(Owned&&) noexcept = default;
    ~Owned() { empty(); }
    [[nodiscard]] bool has_value() const { return value_ != nullptr; }
    [[nodiscard]] T& operator*() const { return *value_; }

   private:
    void empty();
    std::unique_ptr<T> value_;
  };

  template <class Integer>
  static auto stored_integer(Integer value) {
    if constexpr (std::is_signed_v<Integer>) {
      return static_cast<std::int64_t>(value);
    } else {
      return static_cast<std::uint64_t>(value);
    }
  }
  template <class T>
  [[nodiscard]] bool holds() const {
    return std::holds_alternative<T>(value_);
  }
  Json& append();
  Json& append(std::string key);
  [[nodiscard]] bool is_deep() const;
  static void take_deep(Array& from, Array& pending);
  static void take_deep(Object& from, Array& pending);
  void write(std::string& out, std::optional<unsigned> indent, unsigned column) const;
  friend class JsonBuilder;

  std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, Owned<std::string>, Owned<Array>,
               Owned<Object>>
      value_;
};

struct JsonMember {
  std::string key;
  Json value;
};

// A short description of a value: "an object", "an array of 3", "a string", "-1.5".
[[nodiscard]] std::string describe(const Json& value);

// Parses a JSON text. `source` is its name in errors; their place is a line and a column.
[[nodiscard]] Result<Json> parse_json(std::string_view text, std::string_view source);

// "openings[3]"
[[nodiscard]] std::string indexed(std::string_view place, std::size_t i);

}  // namespace sightline::base
