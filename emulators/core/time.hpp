// Emulated time. The PDP-7 and the Type 340 share one clock that counts whole nanoseconds from the start of a run.
//
// `Duration` and `Instant` are distinct types, and so are those of the 8080's clock (tstates.hpp): adding or comparing
// nanoseconds and T-states does not compile. They are not std::chrono's, because <chrono> adds twenty thousand lines of
// stream headers to every file that includes it. No emulated time comes from the host's clock.
#pragma once

#include <cstdint>
#include <limits>

namespace sightline::core {

// A whole number of ticks, which may be negative. `Tick` is a tag type, never instantiated.
template <class Tick>
class TickCount {
 public:
  constexpr TickCount() = default;
  explicit constexpr TickCount(std::int64_t ticks) : ticks_(ticks) {}

  [[nodiscard]] constexpr std::int64_t count() const { return ticks_; }
  [[nodiscard]] static constexpr TickCount min() {
    return TickCount(std::numeric_limits<std::int64_t>::min());
  }
  [[nodiscard]] static constexpr TickCount max() {
    return TickCount(std::numeric_limits<std::int64_t>::max());
  }

  constexpr TickCount& operator+=(TickCount b) { return ticks_ += b.ticks_, *this; }
  constexpr TickCount& operator-=(TickCount b) { return ticks_ -= b.ticks_, *this; }
  friend constexpr TickCount operator-(TickCount a) { return TickCount(-a.ticks_); }
  friend constexpr TickCount operator+(TickCount a, TickCount b) { return TickCount(a.ticks_ + b.ticks_); }
  friend constexpr TickCount operator-(TickCount a, TickCount b) { return TickCount(a.ticks_ - b.ticks_); }
  friend constexpr TickCount operator*(TickCount a, std::int64_t n) { return TickCount(a.ticks_ * n); }
  friend constexpr TickCount operator*(std::int64_t n, TickCount a) { return TickCount(n * a.ticks_); }
  friend constexpr TickCount operator/(TickCount a, std::int64_t n) { return TickCount(a.ticks_ / n); }
  friend constexpr std::int64_t operator/(TickCount a, TickCount b) { return a.ticks_ / b.ticks_; }
  friend constexpr TickCount operator%(TickCount a, TickCount b) { return TickCount(a.ticks_ % b.ticks_); }

  friend constexpr bool operator==(TickCount, TickCount) = default;
  friend constexpr bool operator<(TickCount a, TickCount b) { return a.ticks_ < b.ticks_; }
  friend constexpr bool operator>(TickCount a, TickCount b) { return a.ticks_ > b.ticks_; }
  friend constexpr bool operator<=(TickCount a, TickCount b) { return a.ticks_ <= b.ticks_; }
  friend constexpr bool operator>=(TickCount a, TickCount b) { return a.ticks_ >= b.ticks_; }

 private:
  std::int64_t ticks_ = 0;
};

// An instant: a number of ticks after the start of a run.
template <class Tick>
class TickInstant {
 public:
  constexpr TickInstant() = default;
  explicit constexpr TickInstant(TickCount<Tick> since_start) : since_start_(since_start) {}

  [[nodiscard]] constexpr TickCount<Tick> time_since_epoch() const { return since_start_; }
  [[nodiscard]] static constexpr TickInstant min() { return TickInstant(TickCount<Tick>::min()); }
  [[nodiscard]] static constexpr TickInstant max() { return TickInstant(TickCount<Tick>::max()); }

  constexpr TickInstant& operator+=(TickCount<Tick> b) { return since_start_ += b, *this; }
  constexpr TickInstant& operator-=(TickCount<Tick> b) { return since_start_ -= b, *this; }
  friend constexpr TickInstant operator+(TickInstant a, TickCount<Tick> b) {
    return TickInstant(a.since_start_ + b);
  }
  friend constexpr TickInstant operator+(TickCount<Tick> a, TickInstant b) {
    return TickInstant(a + b.since_start_);
  }
  friend constexpr TickInstant operator-(TickInstant a, TickCount<Tick> b) {
    return TickInstant(a.since_start_ - b);
  }
  friend constexpr TickCount<Tick> operator-(TickInstant a, TickInstant b) {
    return a.since_start_ - b.since_start_;
  }

  friend constexpr bool operator==(TickInstant, TickInstant) = default;
  friend constexpr bool operator<(TickInstant a, TickInstant b) { return a.since_start_ < b.since_start_; }
  friend constexpr bool operator>(TickInstant a, TickInstant b) { return a.since_start_ > b.since_start_; }
  friend constexpr bool operator<=(TickInstant a, TickInstant b) { return a.since_start_ <= b.since_start_; }
  friend constexpr bool operator>=(TickInstant a, TickInstant b) { return a.since_start_ >= b.since_start_; }

 private:
  TickCount<Tick> since_start_;
};

struct Nanosecond;
using Duration = TickCount<Nanosecond>;
using Instant = TickInstant<Nanosecond>;

// Later than any instant a run can reach: the deadline of a device without a pending event.
inline constexpr Instant never = Instant::max();

[[nodiscard]] constexpr Instant at_nanoseconds(std::int64_t ns) {
  return Instant(Duration(ns));
}
[[nodiscard]] constexpr std::int64_t nanoseconds_of(Instant t) {
  return t.time_since_epoch().count();
}

[[nodiscard]] constexpr Duration milliseconds(std::int64_t n) {
  return Duration(n * 1'000'000);
}
[[nodiscard]] constexpr Duration seconds(std::int64_t n) {
  return Duration(n * 1'000'000'000);
}
[[nodiscard]] constexpr double in_seconds(Duration d) {
  return static_cast<double>(d.count()) / 1e9;
}

}  // namespace sightline::core
