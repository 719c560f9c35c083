// A list that stores up to `near` items inline and allocates memory only for more. For objects that contain many short
// lists.
//
// Single items cannot be removed. Items are trivially copyable and have a default value.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace sightline::base {

template <class Item, std::size_t near>
class ShortList {
  static_assert(std::is_trivially_copyable_v<Item> && near > 0);

 public:
  void push_back(const Item& item) {
    if (size_ < near) {
      near_[size_] = item;
    } else {
      if (size_ == near) far_.assign(near_.begin(), near_.end());
      far_.push_back(item);
    }
    ++size_;
  }
  void clear() {
    size_ = 0;
    far_.clear();
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const Item* data() const { return size_ <= near ? near_.data() : far_.data(); }
  [[nodiscard]] Item* data() { return size_ <= near ? near_.data() : far_.data(); }
  // k < size() (precondition).
  [[nodiscard]] const Item& operator[](std::size_t k) const { return data()[k]; }
  [[nodiscard]] Item& operator[](std::size_t k) { return data()[k]; }
  [[nodiscard]] const Item* begin() const { return data(); }
  [[nodiscard]] const Item* end() const { return data() + size_; }

 private:
  std::size_t size_ = 0;
  std::array<Item, near> near_{};
  std::vector<Item> far_;  // all items, once there are more than `near`
};

}  // namespace sightline::base
