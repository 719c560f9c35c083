// See options.hpp.
#include "host/bindings/npm/options.hpp"

#include <fmt/core.h>

#include <optional>
#include <utility>

namespace sightline::npm {
namespace {

// Calls visit(name, member) until it returns true.
template <class Visit>
bool visit_options(LoadOptions& o, const Visit& visit) {
  return visit("mend", o.mend) || visit("weld", o.weld) || visit("planar_tolerance", o.planar_tolerance) ||
         visit("eye", o.eye);
}
template <class Visit>
bool visit_options(Camera& o, const Visit& visit) {
  return visit("view", o.view) || visit("perspective", o.perspective) || visit("direction", o.direction) || visit("eye", o.eye) ||
         visit("look_at", o.look_at) || visit("up", o.up) || visit("vertical", o.vertical);
}
template <class Visit>
bool visit_options(DrawOptions& o, const Visit& visit) {
  return visit("edges", o.edges) || visit("crease", o.crease) || visit("hidden", o.hidden) || visit("width", o.width) ||
         visit("height", o.height) || visit("scale", o.scale) || visit("field", o.field) || visit("min_length", o.min_length);
}
template <class Visit>
bool visit_options(FileOptions& o, const Visit& visit) {
  return visit("format", o.format) || visit("title", o.title) || visit("margin", o.margin) || visit("pen", o.pen) ||
         visit("as_found", o.as_found);
}

// Sets a member; returns what would have been accepted, or null.
const char* set(double& member, const Value& value) {
  if (value.type != Value::Type::number) return "a number";
  member = value.numbers[0];
  return nullptr;
}
const char* set(bool& member, const Value& value) {
  if (value.type != Value::Type::truth) return "true or false";
  member = value.numbers[0] != 0;
  return nullptr;
}
const char* set(std::string& member, const Value& value) {
  if (value.type != Value::Type::text) return "a text";
  member = value.text;
  return nullptr;
}
const char* set(Point& member, const Value& value) {
  if (value.type != Value::Type::point) return "three numbers";
  member = value.numbers;
  return nullptr;
}
template <class Member>
const char* set(std::optional<Member>& member, const Value& value) {
  Member given{};
  const char* const expected = set(given, value);
  if (expected == nullptr) member = given;
  return expected;
}

std::string found_text(const Value& value) {
  switch (value.type) {
    case Value::Type::number: return fmt::format("found {}", value.numbers[0]);
    case Value::Type::truth: return value.numbers[0] != 0 ? "found true" : "found false";
    case Value::Type::text: return fmt::format("found \"{}\"", value.text);
    case Value::Type::point: return "found three numbers";
    case Value::Type::other: break;
  }
  return "found " + value.text;
}

// Sets the option of that name. nullopt: there is none of that name in these options.
template <class Options>
std::optional<base::Result<base::Done>> set_option(Options& options, std::string_view name, const Value& value) {
  const char* expected = nullptr;
  if (!visit_options(options, [&](std::string_view each, auto& member) {
        if (each != name) return false;
        expected = set(member, value);
        return true;
      }))
    return std::nullopt;
  if (expected == nullptr) return base::Done{};
  return base::Error{.file = std::string(name), .found = found_text(value), .expected = expected, .kind = base::ErrorKind::usage};
}

template <class... Options>
std::string names_of(Options&... options) {
  std::string names;
  const auto add = [&names](std::string_view name, auto&) {
    if (!names.empty()) names += ", ";
    names += name;
    return false;
  };
  static_cast<void>((visit_options(options, add) || ...));
  return names;
}

}  // namespace

base::Result<base::Done> Options::set(Call call, std::string_view name, const Value& value) {
  std::optional<base::Result<base::Done>> result;
  std::string names;
  switch (call) {
    case Call::load:
      result = set_option(load, name, value);
      names = names_of(load);
      break;
    case Call::draw:
      result = set_option(camera, name, value);
      if (!result) {
        result = set_option(draw, name, value);
        draw_text_ += fmt::format("{}={} {}\n", name, value.numbers[0], value.text);
      }
      names = names_of(camera, draw);
      break;
    case Call::file:
      result = set_option(file, name, value);
      names = names_of(file);
      break;
  }
  if (result) return *std::move(result);
  return base::Error{.file = std::string(name), .found = "no such option", .expected = std::move(names), .kind = base::ErrorKind::usage};
}

}  // namespace sightline::npm
