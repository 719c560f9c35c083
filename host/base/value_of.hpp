// For code that ends with the first error, as commands and experiments do: the value of a Result, or its error thrown.
// Apart from result.hpp, because the module for browsers is compiled without exceptions.
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
// `name` is what the user calls the thing that has the error.
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
