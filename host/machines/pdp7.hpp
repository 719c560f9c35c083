// A PDP-7 configured for one run, with the devices that the run needs. A run that nothing watches has no observer, and a
// display whose strokes nobody takes does not compute single flashes.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "emulators/machines/pdp7.hpp"
#include "emulators/type340/display.hpp"
#include "host/machines/device_option.hpp"
#include "host/machines/machine.hpp"
#include "host/machines/pdp7_scripts.hpp"
#include "host/machines/screen.hpp"
#include "host/machines/vcd.hpp"

namespace sightline::machines {

struct Pdp7Setup {
  pdp7::Options machine;
  std::optional<type340::Options> display;  // nullopt: no display on the machine
  bool display_when_used = false;           // it is plugged in by the program's first IOT of a display
  std::vector<std::pair<std::string, std::int64_t>> timing;  // what --timing has set, for the report
  core::Word18 switches;
  std::vector<pdp7::SwitchSetting> switch_script;
  struct Disk {
    std::string path;                 // it is written back to; empty: it is not
    std::vector<core::Word18> image;
    std::uint32_t number = 0;         // the checksum of its bytes
    std::uint32_t locks = 0;          // pdp7::Rb09::attach
  };
  std::optional<Disk> disk;           // nullopt: no disk drive on the machine
  std::vector<DeviceChoice> devices;  // by --device
  Bytes reader_tape;                     // one byte a line, hole 8 = 0200
  std::string reader_name;               // of its file; empty: no tape
  std::vector<KeyPress> keys;            // not before one another
  std::vector<PenMove> pen_script;       // likewise; nothing without a display
  std::vector<std::string> configuration;  // see Machine
  bool trace = false;                    // take("--trace") is to come
  std::optional<VcdWriter> vcd;          // of pdp7_signals(); take("--vcd") is to come
  bool monitored = false;                // it has a probe; instead of a trace
  bool picture_wanted = false;           // an output shows it
  std::uint32_t movie_rate = 0;          // photographs a second of emulated time; 0: no movie
  std::optional<Screen::Wishes> screen;  // of its strokes; its log is taken with take("--strokes")
};

// The registers of the description are PC AC L MQ SC SR ION. Error: devices that use the same IOTs.
[[nodiscard]] Result<std::unique_ptr<Machine>> make_pdp7(Pdp7Setup setup);

}  // namespace sightline::machines
