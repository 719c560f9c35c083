// A PDP-7 with a Type 340 display: a program of five words shows a display file of eight, a square of 64 points.
#include <cstdio>
#include <sightline/machines/pdp7.hpp>
using namespace sightline;
struct Screen : core::StrokeTaker {  // takes every flash of the beam
  void strokes(std::span<const core::Stroke> strokes) override { flashes += strokes.size(); }
  std::size_t flashes = 0;
} screen;
int main() {
  pdp7::Machine pdp7({.devices = {"display"}});
  pdp7.strokes().hand_to(&screen);
  pdp7.load(0100, {0760200, 0700606, 0700601, 0600102, 0740040});  // LAW 200; IDLA; IDSI; JMP .-1; HLT
  pdp7.load(0200, {0020117, 0220400, 0100400, 0200100, 0240000, 0200300, 0740000, 0003000});
  pdp7.start(0100);
  if (pdp7.run() == pdp7::StopReason::halt) std::printf("halted: %zu flashes\n", screen.flashes);
}
