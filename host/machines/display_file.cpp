// See display_file.hpp.
#include "host/machines/display_file.hpp"

namespace sightline::machines {

namespace {

using type340::Mode;

// Whether a display with these options continues after a word of that mode.
bool is_supported(Mode mode, const type340::Options& options) {
  switch (mode) {
    case Mode::slave: return false;
    case Mode::character: return options.characters_342;
    case Mode::subroutine: return options.subroutines_347;
    default: return true;
  }
}

// Whether a word of that mode enters parameter mode by an escape, which returns from a subroutine.
bool escapes_to_parameter(Mode mode) {
  return mode == Mode::vector || mode == Mode::vector_continue || mode == Mode::increment || mode == Mode::character;
}

}  // namespace

std::map<std::uint32_t, Mode> display_file(const type340::Options& options, const type340::Registers& registers, std::uint16_t start,
                                           const std::function<core::Word18(std::uint32_t)>& word) {
  // A file that jumps back to its beginning has no end; one that calls the same subroutine twice reads its words again.
  constexpr int most_words = 2 * (type340::Registers::address_mask + 1);
  const bool ended = registers.stop || registers.edge();
  std::map<std::uint32_t, Mode> modes;
  Mode mode = Mode::parameter;
  std::uint16_t at = start;
  std::uint16_t return_address = 0;
  bool save = false;
  for (int left = most_words; left > 0; --left) {
    const core::Word18 here = word(at);
    modes.emplace(at, mode);
    if (!is_supported(mode, options)) break;
    const type340::Following after = type340::following(mode, here);
    if (after.stops) break;
    auto next = static_cast<std::uint16_t>((at + 1) & type340::Registers::address_mask);
    if (mode == Mode::subroutine) {
      const type340::SubroutineWord w = type340::decode_subroutine(here);
      using enum type340::SubroutineOperation;
      if (w.operation == jump_and_save) return_address = next;
      if (w.operation == jump_and_save || w.operation == deposit) save = w.operation == jump_and_save;
      if (w.operation == jump_and_save || w.operation == jump) next = w.address;
    } else if (save && after.mode == Mode::parameter && escapes_to_parameter(mode)) {
      next = return_address;
      save = false;
    }
    if (ended && next == registers.address) break;
    at = next;
    mode = after.mode;
  }
  return modes;
}

}  // namespace sightline::machines
