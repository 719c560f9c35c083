// Runs of Skala's program beside its native twin, for tests.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host/guests/skala/guest.hpp"
#include "host/guests/skala/stream.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::harness {

// Assembled once.
inline const SkalaProgram& skala_program() {
  static const SkalaProgram program = assemble_skala_program();
  return program;
}

inline SkalaTwinPicture twin_with_only(std::span<const std::uint8_t> stream, SkalaDevice device) {
  SkalaEquipment equipment;
  equipment.present = {};
  equipment.present[static_cast<std::size_t>(device)] = true;
  return run_skala_twin(stream, equipment);
}

// The same status, dots, movements and masks, and nothing a device would complain of.
inline testing::AssertionResult same_as_twin(const SkalaGuestPicture& guest, const SkalaTwinPicture& twin,
                                             SkalaDevice device) {
  if (!guest.ended) return testing::AssertionFailure() << "the program did not end";
  for (const SkalaDeviceFault& fault : guest.faults)
    return testing::AssertionFailure() << fault.what << ": " << fault.count;
  const std::string difference = difference_from_twin(guest, twin, device);
  if (!difference.empty()) return testing::AssertionFailure() << difference;
  return testing::AssertionSuccess();
}

inline testing::AssertionResult agrees(std::span<const std::uint8_t> stream,
                                       const SkalaGuestOptions& options = {}) {
  return same_as_twin(run_skala_guest(skala_program(), stream, options),
                      twin_with_only(stream, options.device), options.device);
}

inline std::vector<std::uint8_t> stream_of(std::string_view function, scene::GridSize size,
                                           const SkalaView& view) {
  return skala_stream(scene::sample(*scene::height_function(function), size), view);
}

inline constexpr std::array<SkalaPicture, 3> skala_pictures{SkalaPicture::lines, SkalaPicture::surface,
                                                            SkalaPicture::contours};
inline constexpr std::array<std::string_view, 3> skala_picture_names{"lines", "surface", "contours"};

}  // namespace sightline::harness
