// The machine of this project: a PDP-7 that can have a Type 340 display.
#pragma once

#include <optional>

#include "../type340/display.hpp"
#include "basic_pdp7.hpp"
#include "observer.hpp"

namespace sightline::machines {

struct Pdp7Options {
  Configuration configuration{};
  std::optional<type340::Options> display;  // nullopt: no display on the machine
  bool display_when_used = false;           // it is plugged in by the program's first IOT of a display
};

// `Observer` watches the processor (observer.hpp) and outlives it.
template <class Observer = NoObserver>
class Pdp7 : public BasicPdp7<type340::Display, Observer> {
 public:
  Pdp7(const Pdp7Options& options, Observer& observer) : BasicPdp7<type340::Display, Observer>(options.configuration, observer) {
    if (!options.display) return;
    this->attach_display_when_used(*options.display);
    this->plug_in_display(!options.display_when_used);
  }
};

}  // namespace sightline::machines
