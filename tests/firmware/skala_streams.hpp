// Random command streams for the Skala program: chains of short and long lines, mixed with all other commands.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace sightline::skala_test {

struct StreamKind {
  int device = 0;
  bool visibility = true;
  bool silhouettes = false;
  bool surfaces = false;
};

class StreamMaker {
 public:
  StreamMaker(StreamKind kind, std::uint32_t seed) : kind_(kind), random_(seed) {}

  std::vector<std::uint8_t> make(int commands) {
    span_ = choose(0, 3) == 0 ? 255 : (choose(0, 1) == 1 ? 40 : 6);
    left_ = choose(0, 255 - span_);
    low_ = choose(0, 3) == 0 ? (choose(0, 1) == 1 ? 0 : 255 - span_) : choose(0, 255 - span_);
    put({0x0A, kind_.device | (kind_.visibility ? 0 : 0x80)});
    silhouette();
    for (int i = 0; i < commands; ++i) command(choose(0, 32));
    put({0x00});
    return bytes_;
  }

 private:
  // Not std::uniform_int_distribution, whose results depend on the library.
  int choose(int a, int b) { return a + static_cast<int>(random_() % static_cast<std::uint32_t>(b - a + 1)); }
  void put(std::initializer_list<int> values) {
    for (const int value : values) bytes_.push_back(static_cast<std::uint8_t>(value));
  }
  void silhouette() {
    if (kind_.silhouettes) put({0x0C, choose(1, 7)});
  }
  int across() { return left_ + choose(0, span_); }
  int up() { return low_ + choose(0, span_); }
  void at(int code, int x, int y) {
    x_ = x;
    y_ = y;
    put({code, x, y});
  }
  void near(int code) {
    const int dx = choose(0, 4) == 0 ? choose(-2, 2) : choose(-3, 12);
    at(code, std::clamp(x_ + dx, 0, 255), std::clamp(y_ + choose(-15, 15), 0, 255));
  }

  void command(int what) {
    if (what < 14) return near(0x02);
    if (what < 16) return at(0x02, across(), up());
    if (what < 17) return at(0x01, across(), up());
    if (what < 18) return near(0x03);
    if (what < 20) return near(0x04);
    if (what < 21) return put({0x05, choose(0, 255)});
    if (what < 23) {
      put({0x06});
      if (choose(0, 1) == 1) at(0x01, across(), up());
      return;
    }
    if (what < 24 && choose(0, 3) == 0) {
      put({0x07});
      return silhouette();
    }
    if (what < 26) return curve();
    if (what < 29 && kind_.surfaces) return choose(0, 2) < 2 ? surface() : rim();
    if (what == 29) return put({0x0D});
    if (what < 33) return cell();
    near(0x02);
  }
  void curve() {
    const int x = across();
    const int n = std::min(choose(1, choose(0, 3) == 0 ? 256 : 12), 256 - x);
    int y = up();
    put({0x08, x, n});
    for (int i = 0; i < n; ++i) {
      put({y});
      x_ = x + i;
      y_ = y;
      y = std::clamp(y + (choose(0, 3) == 0 ? choose(-20, 20) : choose(-2, 2)), 0, 255);
    }
  }
  void surface() {
    const bool close = choose(0, 1) == 1;
    const int n = choose(1, close ? 30 : 8);
    put({0x09, n});
    for (int i = 0; i < n; ++i) {
      if (close && i > 0) {  // a slice as a grid gives it, with vertices that fall together
        x_ = std::clamp(x_ + choose(-1, 9), 0, 255);
        y_ = std::clamp(y_ + choose(-12, 12) * choose(0, 3) / 2, 0, 255);
      } else {
        x_ = across();
        y_ = up();
      }
      put({x_, y_, choose(0, 255)});
    }
  }
  // A cell's contours and margins, sometimes without the COMMIT.
  void cell() {
    near(0x01);
    if (choose(0, 1) == 1) near(0x03);
    if (choose(0, 1) == 1) near(0x01);
    for (int i = choose(0, 2); i >= 0; --i) near(0x04);
    if (choose(0, 3) > 0) put({0x06});
  }
  void rim() {
    at(0x0B, across(), up());
    put({choose(0, 7)});
    if (choose(0, 2) == 0) {
      const int x = across();
      put({0x0E, x, choose(1, 256 - x)});
    }
  }

  StreamKind kind_;
  std::mt19937 random_;
  std::vector<std::uint8_t> bytes_;
  int span_ = 0, left_ = 0, low_ = 0, x_ = 0, y_ = 0;
};

}  // namespace sightline::skala_test
