// The words of core that the Type 340 reads as display words, and their modes: those from its last start on, followed as
// the display follows them. A pass that has ended, by a stop word or at an edge, has read no word after the display's
// address. For a running pass, the words still to be read are taken from core as it is now, up to a stop word.
#pragma once

#include <cstdint>
#include <functional>
#include <map>

#include "emulators/core/word.hpp"
#include "emulators/type340/display.hpp"
#include "emulators/type340/words.hpp"

namespace sightline::machines {

// Modes by address. `start`: where the last pass began; `word` reads core, at 13 bits of address.
[[nodiscard]] std::map<std::uint32_t, type340::Mode> display_file(const type340::Options& options, const type340::Registers& registers,
                                                                 std::uint16_t start,
                                                                 const std::function<core::Word18(std::uint32_t)>& word);

}  // namespace sightline::machines
