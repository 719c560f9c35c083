// Skala's program on its machine: receipt over both links, several blocks, every status, the measurements, and the plotters'
// movements
// compared with the twin's.
#include "host/programs/skala/machine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "host/programs/skala/skala.hpp"
#include "tests/host/programs/skala/machine_support.hpp"
#include "tests/host/programs/skala/twin/support.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::skala {
namespace {

SkalaBytes picture(Device device = Device::ef9365) {
  return SkalaBytes().device(device).reset();
}

MachinePicture run(const SkalaBytes& bytes, const MachineOptions& options = {}) {
  return run_machine(resident_program(), bytes.bytes(), options);
}

MachineOptions on(Device device) {
  MachineOptions options;
  options.device = device;
  return options;
}

TEST(SkalaGuest, DrawsALine) {
  const auto guest = run(picture().move(10, 20).draw(14, 22).commit().end());
  EXPECT_TRUE(guest.ended);
  EXPECT_EQ(guest.status, Status::complete);
  EXPECT_EQ(guest.blocks, 1);
  EXPECT_EQ(points_lit(guest), 5U);
  EXPECT_EQ(guest.raster.at(10, 20), 7);
  EXPECT_EQ(guest.raster.at(14, 22), 7);
  EXPECT_EQ(guest.columns.mask_top[14], 22);
  EXPECT_TRUE(guest.moves.empty());
}

TEST(SkalaGuest, DrawingTimeExcludesTheLink) {
  const auto bytes = stream_of("franke", {17, 9}, view_of(Subject::lines, 30));
  MachineOptions serial;
  serial.link = Link::serial;
  const auto fast = run_machine(resident_program(), bytes);
  const auto slow = run_machine(resident_program(), bytes, serial);
  EXPECT_EQ(fast.raster, slow.raster);
  // 10 bits per byte at 9600 baud.
  EXPECT_GE(slow.total.count() - slow.drawing.count(), static_cast<std::int64_t>(bytes.size()) * 3125 - 3125);
  EXPECT_LT(fast.total.count() - fast.drawing.count(),
            static_cast<std::int64_t>(bytes.size()) * 400 + 20'000);
  EXPECT_GT(fast.drawing.count(), 100'000);
  EXPECT_LT(std::abs(fast.drawing.count() - slow.drawing.count()), 60'000)
      << "except the wait for the clear";
}

TEST(SkalaGuest, RunsAreRepeatable) {
  const auto bytes = stream_of("peaks", {17, 9}, view_of(Subject::surface, 30));
  const auto first = run_machine(resident_program(), bytes);
  const auto second = run_machine(resident_program(), bytes);
  EXPECT_EQ(first.drawing, second.drawing);
  EXPECT_EQ(first.instructions, second.instructions);
}

TEST(SkalaGuest, BothLinksOnEveryDevice) {
  for (const Device device : {Device::ef9365, Device::alt256, Device::calcomp, Device::minigraf}) {
    for (const Link link : {Link::parallel, Link::serial}) {
      SCOPED_TRACE(testing::Message()
                   << "device " << static_cast<int>(device) << " link " << static_cast<int>(link));
      MachineOptions options = on(device);
      options.link = link;
      EXPECT_TRUE(agrees(stream_of("rogers", {9, 7}, view_of(Subject::lines, 30), {device}), options));
    }
  }
}

TEST(SkalaGuest, PicturesOfSeveralBlocks) {
  for (const Subject what : skala_pictures) {
    SCOPED_TRACE(skala_picture_names[static_cast<std::size_t>(what)]);
    const View view = view_of(what, 20);
    const bool contours = what == Subject::contours;
    const auto bytes =
        stream_of("terrain", contours ? scene::GridSize{50, 50} : scene::GridSize{256, 200}, view);
    ASSERT_GT(bytes.size(), buffer_bytes);
    const auto guest = run_machine(resident_program(), bytes);
    EXPECT_TRUE(same_as_twin(guest, run_twin(bytes), Device::ef9365));
    EXPECT_GE(guest.blocks, 2);
    EXPECT_LT(guest.drawing, guest.total);
  }
}

// A block ends with the first command that leaves less than 800 bytes: here exactly 800 remain, or 799.
TEST(SkalaGuest, TheBufferIsFullAtTheSpecifiedSize) {
  for (const int filler : {0, 1}) {
    SkalaBytes bytes = picture().move(3, 4).draw(9, 4);
    const int wanted = static_cast<int>(buffer_bytes - buffer_reserve) + filler;
    while (static_cast<int>(bytes.bytes().size()) < wanted) bytes.send(Command::commit);
    const auto guest = run(bytes.end());
    EXPECT_EQ(guest.blocks, 1 + filler);
    EXPECT_TRUE(same_as_twin(guest, run_twin(bytes.bytes()), Device::ef9365));
  }
}

TEST(SkalaGuest, BadStreamsStopWithTheirStatus) {
  const auto status_of = [](const SkalaBytes& bytes) {
    const auto guest = run(bytes);
    EXPECT_TRUE(guest.ended);
    EXPECT_TRUE(same_as_twin(guest, run_twin(bytes.bytes()), Device::ef9365));
    return guest.status;
  };
  EXPECT_EQ(status_of(picture().byte(15)), Status::unknown_command);
  EXPECT_EQ(status_of(picture().draw(5, 5).byte(255)), Status::unknown_command);
  EXPECT_EQ(status_of(SkalaBytes().send(Command::device, {4})), Status::argument_out_of_range);
  EXPECT_EQ(status_of(SkalaBytes().send(Command::device, {0xFF})), Status::argument_out_of_range);
  EXPECT_EQ(status_of(picture().send(Command::gap, {1, 0})), Status::argument_out_of_range);
  EXPECT_EQ(status_of(picture().send(Command::curve, {200, 57})), Status::argument_out_of_range);
}

TEST(SkalaGuest, AStreamWithoutEndIsAborted) {
  MachineOptions options;
  options.t_state_limit = 1'000'000;
  const auto guest = run(picture().draw(5, 5), options);
  EXPECT_FALSE(guest.ended);
  EXPECT_EQ(guest.status, Status::running);
  EXPECT_EQ(points_lit(guest), 0U);
}

TEST(SkalaGuest, ARunawayProgramIsAborted) {
  Program program = resident_program();
  program.memory[program.labels.drawing] = 0xC3;  // JMP to itself
  program.memory[program.labels.drawing + 1U] = static_cast<std::uint8_t>(program.labels.drawing & 0xFF);
  program.memory[program.labels.drawing + 2U] = static_cast<std::uint8_t>(program.labels.drawing >> 8);
  MachineOptions options;
  options.t_state_limit = 500'000;
  const auto guest = run_machine(program, picture().end().bytes(), options);
  EXPECT_FALSE(guest.ended);
  EXPECT_GE(guest.total.count(), 500'000);
}

TEST(SkalaGuest, AnAbsentDevice) {
  for (const Device asked : {Device::ef9365, Device::alt256, Device::calcomp}) {
    const Device there = asked == Device::ef9365 ? Device::alt256 : Device::ef9365;
    const auto bytes = picture(asked).draw(9, 9).end();
    const auto guest = run(bytes, on(there));
    EXPECT_EQ(guest.status, Status::device_missing) << static_cast<int>(asked);
    EXPECT_TRUE(same_as_twin(guest, twin_with_only(bytes.bytes(), there), there));
    EXPECT_FALSE(guest.unanswered.empty());
  }
}

TEST(SkalaGuest, PlottersMoveLikeTheTwin) {
  for (const Device device : {Device::calcomp, Device::minigraf}) {
    for (const Subject what : skala_pictures) {
      SCOPED_TRACE(testing::Message() << "device " << static_cast<int>(device) << ' '
                                      << skala_picture_names[static_cast<std::size_t>(what)]);
      const auto bytes = stream_of("sinc", {13, 11}, view_of(what, 30), {device});
      MachineOptions options = on(device);
      options.keep_strokes = true;
      const auto guest = run_machine(resident_program(), bytes, options);
      const auto twin = twin_with_only(bytes, device);
      EXPECT_TRUE(same_as_twin(guest, twin, device));
      const PlotterWork work = plotter_work(guest.moves);
      EXPECT_EQ(work.pen_lifts, twin.counts.pen_lifts);
      EXPECT_EQ(work.steps_pen_down, twin.counts.steps_pen_down);
      EXPECT_EQ(work.steps_pen_up, twin.counts.steps_pen_up);
      EXPECT_GT(work.pen_lifts, 0U);
      // A mark where the pen comes down and one per step: no movement is lost between program and paper.
      EXPECT_EQ(guest.strokes.size(), work.pen_lifts + work.steps_pen_down);
      // The plotter is the slower one by far.
      const double plotter = core::in_seconds(work.time);
      const double drawing = static_cast<double>(guest.drawing.count()) / 3e6;
      EXPECT_GT(drawing, 0.99 * plotter);
      EXPECT_LT(drawing, 1.25 * plotter);
    }
  }
}

// A complete order: its counts, the run without the visibility test, and the same together with the twin.
TEST(SkalaRun, AnOrderIsRunAndChecked) {
  for (const Subject subject : skala_pictures) {
    for (const Device device : {Device::ef9365, Device::calcomp}) {
      for (const bool visibility : {true, false}) {
        SCOPED_TRACE(testing::Message() << skala_picture_names[static_cast<std::size_t>(subject)] << " device " << static_cast<int>(device)
                                        << (visibility ? "" : " without visibility"));
        Order order;
        order.grid = scene::sample(*scene::height_function("peaks"), {13, 12});
        order.view = view_of(subject, 30);
        order.view.visibility = visibility;
        order.device = device;
        order.time_plain = true;
        const auto unchecked = skala::run(order);
        ASSERT_TRUE(unchecked) << unchecked.error().message();
        EXPECT_FALSE(unchecked->counts);
        EXPECT_EQ(unchecked->plain_drawing.has_value(), visibility);
        EXPECT_EQ(unchecked->visibility_cost().has_value(), visibility);
        order.check = true;
        const auto checked = skala::run(order);
        ASSERT_TRUE(checked) << checked.error().message();
        ASSERT_TRUE(checked->counts);
        EXPECT_EQ(unchecked->points_walked, checked->counts->points_walked);
        EXPECT_EQ(unchecked->plotter.pen_lifts, checked->counts->pen_lifts);
        EXPECT_EQ(unchecked->picture.total, checked->picture.total);
        EXPECT_EQ(unchecked->picture.raster, checked->picture.raster);
      }
    }
  }
}

TEST(SkalaRun, AProgramThatStopsIsAnError) {
  const auto stopped = skala::run(picture().byte(15).bytes(), Device::ef9365, false);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, base::ErrorKind::program_failed);
  EXPECT_EQ(stopped.error().message(), "the program stopped: unknown command");
  const auto missing = skala::run(picture(Device::calcomp).end().bytes(), Device::ef9365, true);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, base::ErrorKind::program_failed);
}

TEST(SkalaGuest, PenPathsGoFromLoweringToLifting) {
  const auto guest =
      run(picture(Device::calcomp).move(2, 1).draw(5, 1).draw(5, 3).move(0, 0).draw(2, 2).end(),
          on(Device::calcomp));
  EXPECT_TRUE(guest.strokes.empty()) << "kept without a request";
  const std::vector<picture::PenPath> expected{{{{2, 1}, {5, 1}, {5, 3}}}, {{{0, 0}, {1, 1}}}};
  const auto paths = pen_paths(guest.moves);
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_EQ(paths[0], expected[0]);
  EXPECT_EQ(paths[1].corners.front(), (picture::PenPoint{0, 0}));
}

// Programs with one wrong byte: a checked run either fails or has the picture of the right program.
TEST(SkalaGuest, ACheckedRunOfAWrongProgramFails) {
  const auto stream = picture().draw(60, 9).draw(5, 40).end();
  const auto right = skala::run(stream.bytes(), Device::ef9365, true);
  ASSERT_TRUE(right) << right.error().message();
  Program program = resident_program();
  int differences = 0;
  for (std::size_t at = 100; at < program.memory.size(); at += tests::effort(41U, 211U)) {
    program.memory[at] ^= 1U;
    const auto wrong = skala::run(stream.bytes(), Device::ef9365, true, program);
    program.memory[at] ^= 1U;
    if (wrong) EXPECT_EQ(wrong->picture.raster, right->picture.raster) << "byte " << at;
    else differences += wrong.error().kind == base::ErrorKind::differs ? 1 : 0;
  }
  EXPECT_GT(differences, 0);
}

}  // namespace
}  // namespace sightline::programs::skala
