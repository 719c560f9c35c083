#include "host/programs/stripes/check.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace sightline::programs::stripes {

std::string difference_from_twin(const MachinePicture& machine, const TwinPicture& twin) {
  if (machine.status != twin.status || machine.fault != twin.fault)
    return fmt::format("status: the program \"{}\" (face {}), its twin \"{}\" (face {})", text_of(machine.status), machine.fault,
                       text_of(twin.status), twin.fault);
  if (!machine.order.empty() && !twin.order.empty() && machine.order != twin.order) {
    const auto [here, there] = std::mismatch(machine.order.begin(), machine.order.end(), twin.order.begin());
    return fmt::format("place {} of the priority list: the program face {}, its twin face {}", here - machine.order.begin(), *here,
                       *there);
  }
  const auto dots = machine.raster.points();
  const auto twins = twin.raster.points();
  if (const auto [here, there] = std::mismatch(dots.begin(), dots.end(), twins.begin()); here != dots.end()) {
    const auto at = here - dots.begin();
    return fmt::format("dot ({}, {}): the program {}, its twin {}", at % core::Raster::width, at / core::Raster::width, *here,
                       *there);
  }
  const auto [here, there] =
      std::mismatch(machine.commands.begin(), machine.commands.end(), twin.commands.begin(), twin.commands.end());
  if (here == machine.commands.end() && there == twin.commands.end()) return {};
  const auto said = [](auto at, auto end) { return at == end ? std::string("none") : fmt::format("{}", *at); };
  return fmt::format("command {} to the plotter: the program {}, its twin {}", here - machine.commands.begin(),
                     said(here, machine.commands.end()), said(there, twin.commands.end()));
}

}  // namespace sightline::programs::stripes
