// Runs Skala's program and its native twin together, for tests.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "host/programs/skala/check.hpp"
#include "host/programs/skala/machine.hpp"
#include "host/programs/skala/stream.hpp"
#include "host/scene/heights/function.hpp"

namespace sightline::programs::skala {

inline TwinPicture twin_with_only(std::span<const std::uint8_t> stream, Device device) {
  Equipment equipment;
  equipment.present = {};
  equipment.present[static_cast<std::size_t>(device)] = true;
  return run_twin(stream, equipment);
}

// The same status, dots, movements and masks, and no device errors.
inline testing::AssertionResult same_as_twin(const MachinePicture& guest, const TwinPicture& twin,
                                             Device device) {
  if (!guest.ended) return testing::AssertionFailure() << "the program did not end";
  for (const DeviceFault& fault : guest.faults)
    return testing::AssertionFailure() << fault.what << ": " << fault.count;
  const std::string difference = difference_from_twin(guest, twin, device);
  if (!difference.empty()) return testing::AssertionFailure() << difference;
  return testing::AssertionSuccess();
}

inline testing::AssertionResult agrees(std::span<const std::uint8_t> stream,
                                       const MachineOptions& options = {}) {
  const MachinePicture machine = run_machine(resident_program(), stream, options);
  const TwinPicture twin = twin_with_only(stream, options.device);
  if (twin.status == Status::complete && points_walked(stream, machine.columns) != twin.counts.points_walked)
    return testing::AssertionFailure() << points_walked(stream, machine.columns) << " points walked, by the twin "
                                       << twin.counts.points_walked;
  return same_as_twin(machine, twin, options.device);
}

inline std::vector<std::uint8_t> stream_of(std::string_view function, scene::GridSize size,
                                           const View& view, const Output& output = {}) {
  return stream_of(scene::sample(*scene::height_function(function), size), view, output);
}

// As the command draws it: contours with silhouettes.
inline View view_of(Subject subject, double rotation = 0) {
  View view;
  view.subject = subject;
  view.rotation = rotation;
  view.silhouette = subject == Subject::contours;
  return view;
}

inline constexpr std::array<Subject, 3> skala_pictures{Subject::lines, Subject::surface,
                                                           Subject::contours};
inline constexpr std::array<std::string_view, 3> skala_picture_names{"lines", "surface", "contours"};

}  // namespace sightline::programs::skala
