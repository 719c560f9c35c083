// The smallest PDP-7 with all devices, started: reader, punch and printer work, the clock is on, and the display draws long
// vectors under
// a light pen.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <utility>

#include "host/machines/pdp7.hpp"

namespace sightline::test {

inline std::unique_ptr<machines::Machine> small_pdp7(bool monitored = false) {
  machines::Pdp7Setup setup;
  setup.monitored = monitored;
  setup.machine.core_words = 4096;
  setup.display = type340::Options{true, true, true};
  setup.configuration = {"--memory 4k", "--eae"};
  setup.reader_tape = machines::Bytes(40, 0277);
  setup.keys = {{core::at_nanoseconds(0), 'A'}, {core::at_nanoseconds(0), 'B'}};
  setup.switch_script = {{core::at_nanoseconds(1'000'000'000), core::Word18(1)}};
  setup.pen_script = {{core::at_nanoseconds(0), type340::LightPen{0, 0, 1023, 1023}},
                      {core::at_nanoseconds(2'000'000'000), std::nullopt}};
  setup.screen = machines::Screen::Outputs{true, true};
  auto machine = machines::make_pdp7(std::move(setup)).value();
  std::uint32_t at = 0100;
  const auto put = [&](std::initializer_list<std::uint32_t> words) {
    for (const std::uint32_t word : words) machine->put(at++, word);
  };
  // LAC 107, IDLA, RSB, PLS, TLS, CLON, JMP 106; the address of the file.
  put({0200107, 0700606, 0700144, 0700206, 0700406, 0700044, 0600106, 0000200});
  at = 0200;
  // Point mode; Y; X, then vectors.
  put({0020117, 0220400, 0102400, 0237577, 0237777});
  machine->start(0100);
  return machine;
}

}  // namespace sightline::test
