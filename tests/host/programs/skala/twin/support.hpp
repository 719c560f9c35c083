// Command streams written by hand for tests of the Skala program's twin, and its raster as text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "emulators/core/raster.hpp"
#include "host/programs/skala/twin/twin.hpp"

namespace sightline::programs::skala {

// Bytes to send; arguments are ints so that tests need no casts, and only their low byte is used.
class SkalaBytes {
 public:
  SkalaBytes& byte(int value) {
    bytes_.push_back(static_cast<std::uint8_t>(value));
    return *this;
  }
  SkalaBytes& send(Command command, std::initializer_list<int> arguments = {}) {
    byte(static_cast<int>(command));
    for (const int argument : arguments) byte(argument);
    return *this;
  }
  SkalaBytes& device(Device device, bool visibility = true) {
    return send(Command::device, {static_cast<int>(device) | (visibility ? 0 : no_visibility)});
  }
  SkalaBytes& move(int x, int y) { return send(Command::move, {x, y}); }
  SkalaBytes& draw(int x, int y) { return send(Command::draw, {x, y}); }
  SkalaBytes& test(int x, int y) { return send(Command::test_draw, {x, y}); }
  SkalaBytes& mask(int x, int y) { return send(Command::mask, {x, y}); }
  SkalaBytes& commit() { return send(Command::commit); }
  SkalaBytes& reset() { return send(Command::reset); }
  SkalaBytes& end() { return send(Command::end); }
  SkalaBytes& surface(std::initializer_list<std::initializer_list<int>> vertices) {
    send(Command::surface, {static_cast<int>(vertices.size())});
    for (const auto& vertex : vertices)
      for (const int value : vertex) byte(value);
    return *this;
  }
  SkalaBytes& add(const SkalaBytes& more) {
    bytes_.insert(bytes_.end(), more.bytes_.begin(), more.bytes_.end());
    return *this;
  }

  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  [[nodiscard]] TwinPicture run() const { return run_twin(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
};

// The dots with x0 <= x <= x1 and y0 <= y <= y1, top row first, '.' for 0.
[[nodiscard]] inline std::vector<std::string> skala_window(const core::Raster& raster, int x0, int y0, int x1,
                                                           int y1) {
  std::vector<std::string> rows;
  for (int y = y1; y >= y0; --y) {
    std::string row;
    for (int x = x0; x <= x1; ++x) {
      const int value = raster.at(static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y));
      row += value == 0 ? '.' : static_cast<char>('0' + value);
    }
    rows.push_back(row);
  }
  return rows;
}

[[nodiscard]] inline std::size_t lit_dots(const core::Raster& raster) {
  std::size_t count = 0;
  for (const std::uint8_t value : raster.points()) count += value != 0 ? 1 : 0;
  return count;
}

}  // namespace sightline::programs::skala
