// A PDP-7 with a Type 340 display: a program of five words shows a display file, a square of 64 points.
#include <algorithm>
#include <cstdio>
#include <sightline/machines/pdp7.hpp>

using namespace sightline;

struct Screen {  // takes every flash of the beam
  static constexpr bool consumes = true;
  void begin_pass(core::Instant) {}
  void stroke(const core::Stroke& s) {
    ++flashes;
    left = std::min<int>(left, s.x);
    right = std::max<int>(right, s.x);
  }
  void end_pass(core::Instant t) { end = t; }
  int flashes = 0, left = 1023, right = 0;
  core::Instant end{};
};

int main() {
  Screen screen;
  machines::NoObserver observer;
  machines::Pdp7Options options;
  options.display = type340::Options{};
  machines::Pdp7<Screen, machines::NoObserver> pdp7(options, screen, observer);
  // LAW 200; IDLA; IDSI; JMP .-1; HLT
  pdp7::Address address = 0100;
  for (const unsigned word : {0760200U, 0700606U, 0700601U, 0600102U, 0740040U})
    pdp7.deposit(address++, core::Word18(word));
  // Intensity 7, point mode; Y; X, vector mode; right, up, left, down and escape; stop with interrupt.
  address = 0200;
  for (const unsigned word : {0020117U, 0220400U, 0100400U, 0200100U, 0240000U, 0200300U, 0740000U, 0003000U})
    pdp7.deposit(address++, core::Word18(word));
  pdp7.start(0100);
  const bool halted = pdp7.run({}) == machines::StopReason::halt;
  std::printf("%s: %d flashes, x from %d to %d, %lld ns of the display\n", halted ? "halted" : "stopped",
              screen.flashes, screen.left, screen.right,
              static_cast<long long>(core::nanoseconds_of(screen.end)));
}
