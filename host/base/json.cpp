#include "host/base/json.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>

namespace sightline::base {

namespace {

using nlohmann::ordered_json;

// The library writes all scalars; escapes and digits are therefore those of nlohmann::json.
std::string library_text(const ordered_json& scalar) {
  return scalar.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

template <class Integer>
void write_integer(std::string& out, Integer value) {
  char digits[24];
  const auto written = std::to_chars(digits, digits + sizeof digits, value);
  out.append(digits, written.ptr);
}

void write_text(std::string& out, const std::string& text) {
  const bool plain = std::all_of(text.begin(), text.end(),
                                 [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
  if (plain) {
    (out += '"').append(text) += '"';
  } else {
    out += library_text(ordered_json(text));
  }
}

void begin_line(std::string& out, std::optional<unsigned> indent, unsigned column) {
  if (!indent) return;
  out += '\n';
  out.append(column, ' ');
}

const Json::Array no_elements;
const Json::Object no_members;

}  // namespace

template <class T>
Json::Owned<T>::Owned(T value) : value_(std::make_unique<T>(std::move(value))) {}
template <class T>
Json::Owned<T>::Owned(const Owned& other) : value_(std::make_unique<T>(*other.value_)) {}
template <class T>
Json::Owned<T>& Json::Owned<T>::operator=(const Owned& other) {
  value_ = std::make_unique<T>(*other.value_);
  return *this;
}
// A document may be nested as deep as a file is long: nested values are destroyed in a loop, not by recursion.
template <class T>
void Json::Owned<T>::empty() {
  if constexpr (!std::is_same_v<T, std::string>) {
    if (!value_) return;
    Array pending;
    take_deep(*value_, pending);
    while (!pending.empty()) {
      Json next = std::move(pending.back());
      pending.pop_back();
      if (auto* const array = std::get_if<Owned<Array>>(&next.value_)) take_deep(**array, pending);
      if (auto* const object = std::get_if<Owned<Object>>(&next.value_)) take_deep(**object, pending);
    }
  }
}

template class Json::Owned<std::string>;
template class Json::Owned<Json::Array>;
template class Json::Owned<Json::Object>;

// Whether it is an array or object with elements. A value that was moved from has none.
bool Json::is_deep() const {
  const auto* const array = std::get_if<Owned<Array>>(&value_);
  const auto* const object = std::get_if<Owned<Object>>(&value_);
  return (array != nullptr && array->has_value() && !(**array).empty()) ||
         (object != nullptr && object->has_value() && !(**object).empty());
}

void Json::take_deep(Array& from, Array& pending) {
  for (Json& element : from)
    if (element.is_deep()) pending.push_back(std::move(element));
}

void Json::take_deep(Object& from, Array& pending) {
  for (JsonMember& member : from)
    if (member.value.is_deep()) pending.push_back(std::move(member.value));
}

Json::Json(std::initializer_list<JsonMember> members) : value_(Owned<Object>(members)) {}

Json Json::array(std::initializer_list<Json> elements) {
  Json json;
  json.value_ = Owned<Array>(elements);
  return json;
}

Json& Json::append() {
  return (*std::get<Owned<Array>>(value_)).emplace_back();
}

Json& Json::append(std::string key) {
  return (*std::get<Owned<Object>>(value_)).emplace_back(JsonMember{std::move(key), {}}).value;
}

Json& Json::operator[](std::string_view key) {
  if (is_null()) *this = object();
  for (JsonMember& member : *std::get<Owned<Object>>(value_))
    if (member.key == key) return member.value;
  return append(std::string(key));
}

void Json::update(const Json& members) {
  for (const JsonMember& member : members.members()) (*this)[member.key] = member.value;
}

void Json::push_back(Json element) {
  if (is_null()) *this = array();
  append() = std::move(element);
}

bool Json::is_number() const {
  return holds<std::int64_t>() || holds<std::uint64_t>() || holds<double>();
}

std::optional<bool> Json::boolean() const {
  return holds<bool>() ? std::optional(std::get<bool>(value_)) : std::nullopt;
}

std::optional<std::int64_t> Json::integer() const {
  if (holds<std::int64_t>()) return std::get<std::int64_t>(value_);
  if (!holds<std::uint64_t>()) return std::nullopt;
  const std::uint64_t value = std::get<std::uint64_t>(value_);
  if (value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

std::optional<double> Json::number() const {
  if (holds<double>()) return std::get<double>(value_);
  if (holds<std::int64_t>()) return static_cast<double>(std::get<std::int64_t>(value_));
  if (holds<std::uint64_t>()) return static_cast<double>(std::get<std::uint64_t>(value_));
  return std::nullopt;
}

const std::string* Json::text() const {
  return is_string() ? &*std::get<Owned<std::string>>(value_) : nullptr;
}

const Json::Array& Json::elements() const {
  return is_array() ? *std::get<Owned<Array>>(value_) : no_elements;
}

const Json::Object& Json::members() const {
  return is_object() ? *std::get<Owned<Object>>(value_) : no_members;
}

std::size_t Json::size() const {
  return is_array() ? elements().size() : members().size();
}

const Json* Json::find(std::string_view key) const {
  const Object& all = members();
  const auto found =
      std::find_if(all.rbegin(), all.rend(), [key](const JsonMember& m) { return m.key == key; });
  return found != all.rend() ? &found->value : nullptr;
}

std::string Json::dump(std::optional<unsigned> indent) const {
  std::string out;
  write(out, indent, 0);
  return out;
}

void Json::write(std::string& out, std::optional<unsigned> indent, unsigned column) const {
  if (const auto value = boolean()) {
    out += *value ? "true" : "false";
  } else if (holds<std::int64_t>()) {
    write_integer(out, std::get<std::int64_t>(value_));
  } else if (holds<std::uint64_t>()) {
    write_integer(out, std::get<std::uint64_t>(value_));
  } else if (holds<double>()) {
    out += library_text(std::get<double>(value_));
  } else if (const std::string* const string = text()) {
    write_text(out, *string);
  } else if (is_null()) {
    out += "null";
  } else if (size() == 0) {
    out += is_array() ? "[]" : "{}";
  } else {
    const unsigned inner = column + indent.value_or(0);
    char separator = is_array() ? '[' : '{';
    for (const Json& element : elements()) {
      out += std::exchange(separator, ',');
      begin_line(out, indent, inner);
      element.write(out, indent, inner);
    }
    for (const JsonMember& member : members()) {
      out += std::exchange(separator, ',');
      begin_line(out, indent, inner);
      write_text(out, member.key);
      out += indent ? ": " : ":";
      member.value.write(out, indent, inner);
    }
    begin_line(out, indent, column);
    out += is_array() ? ']' : '}';
  }
}

std::string describe(const Json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array of " + std::to_string(value.size());
  if (value.is_string()) return "a string";
  return value.dump();
}

// The library's parser calls it for each value; it builds a Json from the outermost value inwards.
class JsonBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit JsonBuilder(std::string_view source) : source_(source) {}

  Result<Json> result() {
    if (error_) return *std::move(error_);
    return std::move(document_);
  }

  bool null() override { return add(Json()); }
  bool boolean(bool value) override { return add(Json(value)); }
  bool number_integer(number_integer_t value) override { return add(Json(value)); }
  bool number_unsigned(number_unsigned_t value) override { return add(Json(value)); }
  bool number_float(number_float_t value, const string_t&) override { return add(Json(value)); }
  bool string(string_t& value) override { return add(Json(std::move(value))); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_array() override { return close(); }
  bool key(string_t& value) override {
    key_ = std::move(value);
    return true;
  }

  // "[...] parse error at line L, column C: cause"
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) override {
    const std::string_view what = error.what();
    const std::size_t line = what.find("line ");
    const std::size_t colon = what.find(": ", line == std::string_view::npos ? 0 : line);
    if (line == std::string_view::npos || colon == std::string_view::npos) {
      error_ = Error{.file = source_, .found = std::string(what)};
    } else {
      error_ = Error{.file = source_,
                     .place = std::string(what.substr(line, colon - line)),
                     .found = std::string(what.substr(colon + 2))};
    }
    return false;
  }

 private:
  Json& place() {
    if (open_.empty()) return document_;
    return open_.back()->is_array() ? open_.back()->append() : open_.back()->append(std::move(key_));
  }
  bool add(Json value) {
    place() = std::move(value);
    return true;
  }
  bool open(Json value) {
    Json& at = place();
    at = std::move(value);
    open_.push_back(&at);
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string source_;
  Json document_;
  std::vector<Json*> open_;  // arrays and objects not yet closed, outermost first
  std::string key_;
  std::optional<Error> error_;
};

Result<Json> parse_json(std::string_view text, std::string_view source) {
  JsonBuilder builder(source);
  static_cast<void>(nlohmann::json::sax_parse(text, &builder));
  return builder.result();
}

std::string indexed(std::string_view place, std::size_t i) {
  return std::string(place) + "[" + std::to_string(i) + "]";
}

}  // namespace sightline::base
