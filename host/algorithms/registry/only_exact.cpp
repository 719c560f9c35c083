// In place of line_table.cpp: a table of one row, for the module of host/bindings/npm.
#include <array>

#include "host/algorithms/registry/exact_lines.hpp"
#include "host/algorithms/registry/lines.hpp"

namespace sightline::registry {
namespace {

constexpr std::array table{exact_lines};

}  // namespace

std::span<const LineAlgorithm> line_algorithms() {
  return table;
}

}  // namespace sightline::registry
