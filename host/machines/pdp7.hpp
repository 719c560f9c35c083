// A PDP-7 configured for one run, with the devices that the run needs. A run without trace, dump or monitor has no
// observer, and a display without a stroke taker does not compute single flashes.
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
  bool display_when_used = false;           // the program's first display IOT plugs it in
  std::vector<std::pair<std::string, std::int64_t>> timing;  // values of --timing, for the report
  core::Word18 switches;
  std::vector<pdp7::SwitchSetting> switch_script;
  struct Disk {
    std::string path;                 // written back to it; empty: not written back
    std::vector<core::Word18> image;
    std::uint32_t locks = 0;          // pdp7::Rb09::attach
  };
  std::optional<Disk> disk;           // nullopt: no disk drive on the machine
  std::vector<DeviceChoice> devices;  // by --device
  Bytes reader_tape;                     // one byte a line, hole 8 = 0200
  std::string reader_name;               // of its file; empty: no tape
  std::vector<KeyPress> keys;            // in order of time
  std::vector<PenMove> pen_script;       // likewise; empty without a display
  std::vector<std::string> configuration;  // see Machine
  bool trace = false;                    // take("--trace") will be called
  std::optional<VcdWriter> vcd;          // made from pdp7_signals(); take("--vcd") will be called
  bool monitored = false;                // has a probe, but no trace
  bool picture_wanted = false;           // for an output
  std::uint32_t movie_rate = 0;          // photographs per second of emulated time; 0: no movie
  std::optional<Screen::Outputs> screen;  // for its strokes; take("--strokes") takes its log
};

// The registers of the description are PC AC L MQ SC SR ION. Error: devices that use the same IOTs.
[[nodiscard]] Result<std::unique_ptr<Machine>> make_pdp7(Pdp7Setup setup);

}  // namespace sightline::machines
