// The bytes a device has handed to the outside world, in order: the first of them, up to a bound, so that no
// program can fill the host's memory. Later bytes are only counted.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "../core/state_visitor.hpp"

namespace sightline::devices {

class KeptBytes {
 public:
  static constexpr std::size_t usual_bound = std::size_t{1} << 24;

  KeptBytes() = default;
  explicit KeptBytes(std::size_t bound) : bound_(bound) {}

  void push_back(std::uint8_t byte) {
    if (before_ + bytes_.size() < bound_)
      bytes_.push_back(byte);
    else
      ++left_out_;
  }

  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  [[nodiscard]] std::uint64_t left_out() const { return left_out_; }
  // All that were handed out, also before the machine was restored, and what was not kept.
  [[nodiscard]] std::uint64_t total() const { return before_ + bytes_.size() + left_out_; }

  void visit_state(core::StateVisitor& visit) {
    visit.output("bytes", bytes_, before_);
    visit("left_out", left_out_);
  }

 private:
  std::size_t bound_ = usual_bound;
  std::vector<std::uint8_t> bytes_;
  std::uint64_t before_ = 0;  // bytes before the first of bytes_: the machine was restored after them
  std::uint64_t left_out_ = 0;
};

}  // namespace sightline::devices
