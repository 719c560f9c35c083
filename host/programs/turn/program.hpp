// The program of firmware/pdp7/turn, assembled from its embedded tapes for a machine with or without the EAE and with 8K or
// 32K of core.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "emulators/core/word.hpp"
#include "emulators/pdp7/state.hpp"
#include "host/programs/turn/tape.hpp"

namespace sightline::programs::turn {

// (file name, text) of the program's tapes in assembly order.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> firmware_tapes();

struct Labels {
  pdp7::Address start = 0;    // reads the model's tape
  pdp7::Address begin = 0;    // starts with the model already in core
  pdp7::Address count = 0;    // words of the model; with `checksum` the reader's results for `begin`
  pdp7::Address checksum = 0;
  pdp7::Address picture = 0;  // pictur: a picture is begun
  pdp7::Address file = 0;     // the current display file; a store here ends a picture
  pdp7::Address shown = 0;
  pdp7::Address file_begun = 0;  // dfs
  pdp7::Address angle = 0;
  pdp7::Address status = 0;
  pdp7::Address switches = 0;  // sw: switches of the current picture
  pdp7::Address wait = 0;     // waitlp: waits for the display's stop
  pdp7::Address waited = 0;
  pdp7::Address line = 0;      // vector: a line is drawn (its second word; the first holds the return)
  pdp7::Address junction = 0;  // locate: finds the position of a T-junction for drawing (likewise)
};

struct Program {
  bool eae = true;
  Memory memory = Memory::words_8k;
  std::vector<core::Word18> core;  // of the lower 8K
  std::map<std::string, std::uint32_t, std::less<>> symbols;
  Labels labels;
  std::uint32_t words = 0;  // instructions, variables, constants and the sine table
};

[[nodiscard]] Program assemble_program(bool eae, Memory memory);

}  // namespace sightline::programs::turn
