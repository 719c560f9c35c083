// The first bytes that a device has sent to the outside, in order, up to a bound that protects the host's memory. Later
// bytes are only counted.
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
  // The number of all bytes sent, including those before the machine was restored and those beyond the bound.
  [[nodiscard]] std::uint64_t total() const { return before_ + bytes_.size() + left_out_; }

  void visit_state(core::StateVisitor& visit) {
    visit.output("bytes", bytes_, before_);
    visit("left_out", left_out_);
  }

 private:
  std::size_t bound_ = usual_bound;
  std::vector<std::uint8_t> bytes_;
  std::uint64_t before_ = 0;  // bytes sent before the machine was restored, which bytes_ lacks
  std::uint64_t left_out_ = 0;
};

}  // namespace sightline::devices
