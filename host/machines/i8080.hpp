// An 8080 configured for one run, with the devices that the run needs on its ports.
//
// For CP/M programs memory has two entries of the operating system, in the form in which exercisers and benchmarks of the
// 8080 have found them since their first emulator: OUT 0 at 0000, which ends the run, and OUT 1; RET at 0005, where BDOS
// functions are called. The host does their work between the OUT and the RET, in no time: a call costs 20 T-states and the
// end 10, as in the published T-states of such programs. A program may begin with SP = 0000: then a RET at the top level
// takes the two bytes of the OUT 0 as its address, 00D3, where a second OUT 0 ends the run in the same time. Functions 0, 2,
// 5 and 9 keep the registers; all others return in A and L with B and H 0 (CP/M 2.2 Interface Guide). Waiting for a key takes
// no time. cpm.hpp has the rest.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "emulators/machines/i8080.hpp"
#include "host/machines/cpm.hpp"
#include "host/machines/machine.hpp"
#include "host/machines/vcd.hpp"

namespace sightline::machines {

struct I8080Setup {
  std::unique_ptr<i8080::Machine> machine = std::make_unique<i8080::Machine>();
  std::map<std::string_view, Bytes> sent;  // bytes that the host sends, by name of the link, which refers to them
  std::map<std::string_view, std::string> sent_from;  // the names of these files
  std::optional<CpmSetup> cpm;             // CP/M for the program
  std::vector<std::string> configuration;  // see Machine
  bool observed = false;                   // take("--trace"), take("--bus") or take("--vcd") will be called
  std::optional<VcdWriter> vcd;            // made from i8080_signals()
  bool monitored = false;                  // has a probe, but no trace and bus log
  bool keep_console = false;               // printed text goes into the report
  bool console = false;                    // keys can be typed, take_printed() returns the output
  bool drawing = false;                    // keep the lines that the plotter draws
  bool grey = false;                       // --png
};

// The registers of the description are A F B C D E H L SP PC INTE.
[[nodiscard]] std::unique_ptr<Machine> make_i8080(I8080Setup setup);

}  // namespace sightline::machines
