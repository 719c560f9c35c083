// IOTs of devices that no machine here has, but that period programs use without testing whether they exist: they do
// nothing (bit 14 clears AC, as in every IOT), and cause no warning.
//
// The codes are those that a PDP-7 kernel of 1970 executes on a machine without the devices. Which of the 7042xx to 7047xx
// belong to the display and which to the data set is unknown.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace sightline::pdp7 {

struct AbsentDevice {
  std::uint32_t first;
  std::uint32_t last;
  std::string_view name;
};

inline constexpr std::array absent_devices{
    AbsentDevice{0700501, 0700501, "Graphic-2 display"},
    AbsentDevice{0700547, 0700547, "Graphic-2 display"},
    AbsentDevice{0700723, 0700723, "Graphic-2 display"},
    AbsentDevice{0700742, 0700742, "Graphic-2 display"},
    AbsentDevice{0701012, 0701012, "Graphic-2 display"},
    AbsentDevice{0701052, 0701052, "Graphic-2 display"},
    AbsentDevice{0704206, 0704206, "Graphic-2 display or data set"},
    AbsentDevice{0704301, 0704424, "Graphic-2 display or data set"},
    AbsentDevice{0704704, 0704761, "Graphic-2 display or data set"},
    AbsentDevice{0706700, 0706777, "card reader"},
};

[[nodiscard]] constexpr bool belongs_to_absent_device(std::uint32_t word) {
  for (const AbsentDevice& each : absent_devices)
    if (word >= each.first && word <= each.last) return true;
  return false;
}

}  // namespace sightline::pdp7
