// The value of a Result; an error is thrown. For commands and experiments, which end with the first error. Not part of
// result.hpp, because the WebAssembly module is compiled without exceptions.
#pragma once

#include <string>
#include <utility>

#include "host/base/result.hpp"

namespace sightline::base {

template <class Value>
Value value_of(Result<Value> result) {
  if (!result) throw std::move(result.error());
  return std::move(*result);
}
// `name`: the file, scene or option that has the error, as the user named it.
template <class Value>
Value value_of(Result<Value> result, const std::string& name) {
  if (!result) result.error().file = name;
  return value_of(std::move(result));
}
template <class Value>
Value value_of(Result<Value> result, const std::string& name, ErrorKind kind) {
  if (!result) result.error().kind = kind;
  return value_of(std::move(result), name);
}

}  // namespace sightline::base
