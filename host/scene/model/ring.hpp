// The vertices of an outline or a hole, in order: as a std::vector, but up to four of them lie in the ring itself, so that
// the triangles and quadrilaterals of a mesh need no memory of their own.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace sightline::scene {

using VertexIndex = std::uint32_t;

class Ring {
 public:
  using value_type = VertexIndex;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;
  using reference = VertexIndex&;
  using const_reference = const VertexIndex&;
  using iterator = VertexIndex*;
  using const_iterator = const VertexIndex*;

  Ring() = default;
  Ring(std::initializer_list<VertexIndex> vertices) { assign(vertices.begin(), vertices.end()); }
  Ring(std::span<const VertexIndex> vertices) { assign(vertices.begin(), vertices.end()); }          // NOLINT(google-explicit-constructor)
  Ring(const std::vector<VertexIndex>& vertices) { assign(vertices.begin(), vertices.end()); }  // NOLINT(google-explicit-constructor)
  template <std::forward_iterator Iterator>
  Ring(Iterator first, Iterator last) {
    assign(first, last);
  }
  Ring(const Ring& other) { assign(other.begin(), other.end()); }
  Ring(Ring&& other) noexcept { take(other); }
  Ring& operator=(const Ring& other) {
    if (this != &other) assign(other.begin(), other.end());
    return *this;
  }
  Ring& operator=(Ring&& other) noexcept {
    if (this == &other) return *this;
    release();
    take(other);
    return *this;
  }
  Ring& operator=(std::initializer_list<VertexIndex> vertices) {
    assign(vertices.begin(), vertices.end());
    return *this;
  }
  ~Ring() { release(); }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] VertexIndex* data() { return capacity_ == inside ? place_.near : place_.far; }
  [[nodiscard]] const VertexIndex* data() const { return capacity_ == inside ? place_.near : place_.far; }
  [[nodiscard]] iterator begin() { return data(); }
  [[nodiscard]] iterator end() { return data() + size_; }
  [[nodiscard]] const_iterator begin() const { return data(); }
  [[nodiscard]] const_iterator end() const { return data() + size_; }
  [[nodiscard]] VertexIndex& operator[](std::size_t i) { return data()[i]; }
  [[nodiscard]] const VertexIndex& operator[](std::size_t i) const { return data()[i]; }
  [[nodiscard]] VertexIndex& front() { return *data(); }
  [[nodiscard]] const VertexIndex& front() const { return *data(); }
  [[nodiscard]] VertexIndex& back() { return data()[size_ - 1]; }
  [[nodiscard]] const VertexIndex& back() const { return data()[size_ - 1]; }

  void reserve(std::size_t count) {
    if (count > capacity_) grow(count);
  }
  void push_back(VertexIndex vertex) {
    if (size_ == capacity_) grow(2 * std::size_t{capacity_});
    data()[size_++] = vertex;
  }
  void pop_back() { --size_; }
  void clear() { size_ = 0; }
  void resize(std::size_t count) {
    reserve(count);
    if (count > size_) std::fill(end(), data() + count, VertexIndex{0});
    size_ = static_cast<std::uint32_t>(count);
  }
  // The range is no part of this ring.
  template <std::forward_iterator Iterator>
  void assign(Iterator first, Iterator last) {
    const auto count = static_cast<std::size_t>(std::distance(first, last));
    reserve(count);
    std::copy(first, last, data());
    size_ = static_cast<std::uint32_t>(count);
  }
  // The range is no part of this ring.
  template <std::forward_iterator Iterator>
  iterator insert(const_iterator before, Iterator first, Iterator last) {
    const auto at = static_cast<std::size_t>(before - begin());
    const auto count = static_cast<std::size_t>(std::distance(first, last));
    const std::size_t rest = size_ - at;
    resize(size_ + count);
    std::copy_backward(begin() + at, begin() + at + rest, end());
    std::copy(first, last, begin() + at);
    return begin() + at;
  }
  iterator insert(const_iterator before, VertexIndex vertex) { return insert(before, &vertex, &vertex + 1); }
  iterator erase(const_iterator first, const_iterator last) {
    iterator to = begin() + (first - begin());
    std::copy(last, static_cast<const Ring&>(*this).end(), to);
    size_ -= static_cast<std::uint32_t>(last - first);
    return to;
  }
  iterator erase(const_iterator at) { return erase(at, at + 1); }

  friend bool operator==(const Ring& a, const Ring& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); }

 private:
  static constexpr std::uint32_t inside = 4;
  union Place {
    VertexIndex near[inside];
    VertexIndex* far;
  };

  void grow(std::size_t count) {
    auto* const larger = new VertexIndex[count];
    std::copy(begin(), end(), larger);
    release();
    place_.far = larger;
    capacity_ = static_cast<std::uint32_t>(count);
  }
  void release() {
    if (capacity_ > inside) delete[] place_.far;
  }
  void take(Ring& other) {
    place_ = other.place_;
    size_ = std::exchange(other.size_, 0U);
    capacity_ = std::exchange(other.capacity_, inside);
  }

  Place place_;
  std::uint32_t size_ = 0;
  std::uint32_t capacity_ = inside;
};

}  // namespace sightline::scene
