// What the machine shows against what is there: the structure of every picture is that of hidden-line removal from nothing
// at the machine's own angle, every line ends within a point of where it should, and nothing flickers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "emulators/type340/words.hpp"
#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/plantinga/edge_structure.hpp"
#include "host/algorithms/plantinga/frame.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/guests/turn/session.hpp"
#include "tests/host/guests/turn/turned_model.hpp"
#include "tests/support/effort.hpp"

namespace sightline::guests::turn {
namespace {

namespace plantinga = algorithms::plantinga;

double radians(std::uint32_t angle) { return angle * 2 * std::numbers::pi / (1 << 18); }

// State of every slot by hidden-line removal from nothing. The sight is within 10^-6 of the angle.
std::vector<std::uint32_t> states_from_nothing(const TurnedModel& of, double angle,
                                               const std::vector<std::vector<plantinga::Occluder>>& occluders) {
  constexpr double length = 1 << 20;
  const plantinga::Sight sight{std::lround(std::sin(angle) * length), std::lround(std::cos(angle) * length)};
  std::vector<plantinga::EdgeStructure> structures;
  for (plantinga::EdgeIndex e = 0; e < of.model.edges().size(); ++e)
    structures.push_back(plantinga::structure_at(of.model, e, occluders[e], sight));
  std::vector<std::uint32_t> states;
  for (const Tape::Slot& slot : of.tape.slot_of) {
    const auto& pieces = structures[slot.edge];
    if (slot.piece >= pieces.size()) {
      states.push_back(0);
      continue;
    }
    const auto code = [&](const plantinga::End& end) -> std::uint32_t {
      if (end.kind() == plantinga::EndKind::vertex) return 1;
      const auto& partners = of.tape.partners[slot.edge];
      return 2 + static_cast<std::uint32_t>(std::find(partners.begin(), partners.end(), end.bits) - partners.begin());
    };
    const std::uint32_t low = code(pieces[slot.piece].low);
    const std::uint32_t high = code(pieces[slot.piece].high);
    states.push_back(slot.reversed ? high << 12U | low << 6U : low << 12U | high << 6U);
  }
  return states;
}

TEST(TurnStructure, IsThatOfTheMachinesOwnAngle) {
  for (const std::string& name : {cube, block, crossed, lshape, star}) {
    const TurnedModel& of = turned(name);
    std::vector<std::vector<plantinga::Occluder>> occluders;
    for (plantinga::EdgeIndex e = 0; e < of.model.edges().size(); ++e) occluders.push_back(of.model.occluders_of(e));
    const Session session(of.tape, true);
    for (const std::uint32_t direction : {0U, backward_switch}) {
      Guest guest(session.program(), of.tape);
      GuestPicture picture;
      const std::uint32_t step = turns() > 1 ? 811 : tests::effort(5197U, 20011U);
      const std::uint32_t slots = of.tape.words[6].value();
      int compared = 0;
      for (std::uint32_t k = 0; k < Session::pictures_of_turn(step); ++k) {
        ASSERT_TRUE(guest.next(direction | step, picture));
        const double angle = radians(picture.angle);
        const bool near_event = std::any_of(of.list.events.begin(), of.list.events.end(), [angle](const auto& event) {
          return std::abs(std::remainder(event.direction.angle - angle, 2 * std::numbers::pi)) < 2e-6;
        });
        if (near_event) continue;
        ++compared;
        const auto expected = states_from_nothing(of, angle, occluders);
        for (std::uint32_t s = 0; s < expected.size(); ++s)
          ASSERT_EQ(guest.peek(slots + 4 * s).value(), expected[s]) << name << " angle " << picture.angle << " slot " << s;
      }
      EXPECT_GT(compared, tests::effort(40, 10)) << name;
    }
  }
}

// Another algorithm, of this computer: which parts of every edge are seen.
TEST(TurnStructure, IsThePictureOfTheExactAlgorithm) {
  for (const std::string& name : {block, crossed, lshape, star}) {
    const TurnedModel& of = turned(name);
    Twin twin(of.tape.words, model_base(of.tape.memory));
    plantinga::FrameMaker frames(of.model);
    Picture picture;
    int compared = 0;
    for (std::uint32_t k = 0; k < tests::effort(60U, 6U); ++k) {
      ASSERT_TRUE(twin.next(4391, picture));
      const double angle = radians(picture.angle);
      // Cameras are below 2^15: within 2^-15 of the angle.
      const bool near_event = std::any_of(of.list.events.begin(), of.list.events.end(), [angle](const auto& event) {
        return std::abs(std::remainder(event.direction.angle - angle, 2 * std::numbers::pi)) < 1e-4;
      });
      if (near_event) continue;
      ++compared;
      const plantinga::Sight sight{std::lround(std::sin(angle) * 32767), std::lround(std::cos(angle) * 32767)};
      frames.place(std::atan2(static_cast<double>(sight.x), static_cast<double>(sight.z)));
      const auto exact = algorithms::exact::visible_edges(of.scene, plantinga::camera_of(sight));
      std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::array<double, 2>>> seen;
      for (const auto& piece : exact.pieces)
        seen[{piece.edge.from, piece.edge.to}].push_back({piece.low.to_double(), piece.high.to_double()});
      std::size_t pieces = 0;
      for (std::uint32_t s = 0; s < of.tape.slots; ++s) {
        const std::uint32_t state = twin.state(s);
        if (state == 0) continue;
        ++pieces;
        const Tape::Slot& slot = of.tape.slot_of[s];
        const auto& edge = of.model.edges()[slot.edge];
        const auto& expected = seen[{edge.from, edge.to}];
        ASSERT_LT(slot.piece, expected.size()) << name << " angle " << picture.angle << " edge " << slot.edge;
        for (unsigned e = 0; e < 2; ++e) {
          const std::uint32_t code = (state >> (e == 0 ? 12U : 6U)) & 077U;
          const bool second = (e == 0) == slot.reversed;
          double at = second ? 1 : 0;
          if (code != 1) at = frames.parameter_of(slot.edge, {of.tape.partners[slot.edge][code - 2]});
          EXPECT_NEAR(at, expected[slot.piece][second ? 1 : 0], 1e-6) << name << " angle " << picture.angle;
        }
      }
      EXPECT_EQ(pieces, exact.pieces.size()) << name << " angle " << picture.angle;
    }
    EXPECT_GT(compared, tests::effort(40, 3)) << name;
  }
}

using Points = std::vector<std::array<int, 2>>;

// Where the beam is after each word of a display file that moves it; a beginning of lines too.
Points corners_of(const std::vector<core::Word18>& file) {
  Points corners;
  int x = 0;
  int y = 0;
  type340::Mode mode = type340::Mode::parameter;
  for (const core::Word18 word : file) {
    if (mode == type340::Mode::point) {
      const auto point = type340::decode_point(word);
      (point.y ? y : x) = point.coordinate;
      if (!point.y) corners.push_back({x, y});
    } else if (mode == type340::Mode::vector) {
      const auto vector = type340::decode_vector(word);
      x += vector.left ? -vector.dx : vector.dx;
      y += vector.down ? -vector.dy : vector.dy;
      corners.push_back({x, y});
    }
    const auto next = type340::following(mode, word);
    if (next.stops) break;
    mode = next.mode;
  }
  return corners;
}

// Ends of pieces in doubles, along the exact structure: each must be a corner of the display file, within a point.
TEST(TurnStructure, EndsAreWithinAPoint) {
  for (const std::string& name : {cube, block, crossed, lshape, star}) {
    const TurnedModel& of = turned(name);
    Twin twin(of.tape.words, model_base(of.tape.memory));
    plantinga::FrameMaker frames(of.model);
    const double scale = points_per_unit(of.model);
    const double middle = static_cast<double>(twice_middle(of.model)) / 2;
    double worst = 0;
    Picture picture;
    for (std::uint32_t k = 0; k < tests::effort(400U, 60U); ++k) {
      ASSERT_TRUE(twin.next(4391, picture));
      const Points corners = corners_of(picture.display_file);
      const double angle = radians(picture.angle);
      frames.place(angle);
      for (std::uint32_t s = 0; s < of.tape.slots; ++s) {
        const std::uint32_t state = twin.state(s);
        if (state == 0) continue;
        const Tape::Slot& slot = of.tape.slot_of[s];
        const auto& edge = of.model.edges()[slot.edge];
        std::array<std::array<double, 2>, 2> ends{};
        for (unsigned e = 0; e < 2; ++e) {
          const std::uint32_t code = (state >> (e == 0 ? 12U : 6U)) & 077U;
          double at = (e == 0) == slot.reversed ? 1 : 0;
          if (code != 1) at = frames.parameter_of(slot.edge, {of.tape.partners[slot.edge][code - 2]});
          const auto& p = of.model.vertices()[edge.from];
          const auto& q = of.model.vertices()[edge.to];
          const auto mix = [at](std::int64_t a, std::int64_t b) {
            return static_cast<double>(a) + at * static_cast<double>(b - a);
          };
          const double u = mix(p[0], q[0]) * std::cos(angle) - mix(p[2], q[2]) * std::sin(angle);
          ends[e] = {512 + scale * u, 512 + scale * (mix(p[1], q[1]) - middle)};
        }
        // What is shorter than rounding may be left out.
        if (std::hypot(ends[0][0] - ends[1][0], ends[0][1] - ends[1][1]) < 2) continue;
        for (const auto& end : ends) {
          double best = 1e9;
          for (const auto& corner : corners)
            best = std::min(best, std::max(std::abs(corner[0] - end[0]), std::abs(corner[1] - end[1])));
          worst = std::max(worst, best);
        }
      }
    }
    RecordProperty("worst_" + std::to_string(of.tape.edges), std::to_string(worst));
    EXPECT_LE(worst, 1.0) << name;
  }
}

// Points of the lines, each word of a file as a straight line.
std::vector<bool> raster_of(const std::vector<core::Word18>& file) {
  std::vector<bool> lit(1024 * 1024, false);
  int x = 0;
  int y = 0;
  type340::Mode mode = type340::Mode::parameter;
  for (const core::Word18 word : file) {
    if (mode == type340::Mode::point) {
      const auto point = type340::decode_point(word);
      (point.y ? y : x) = point.coordinate;
    } else if (mode == type340::Mode::vector) {
      const auto vector = type340::decode_vector(word);
      const int dx = vector.left ? -vector.dx : vector.dx;
      const int dy = vector.down ? -vector.dy : vector.dy;
      const int length = std::max(std::abs(dx), std::abs(dy));
      for (int i = 0; i <= length; ++i) {
        const int px = x + (length == 0 ? 0 : static_cast<int>(std::lround(static_cast<double>(i) * dx / length)));
        const int py = y + (length == 0 ? 0 : static_cast<int>(std::lround(static_cast<double>(i) * dy / length)));
        lit[static_cast<std::size_t>(py) * 1024 + static_cast<std::size_t>(px)] = true;
      }
      x += dx;
      y += dy;
    }
    const auto next = type340::following(mode, word);
    if (next.stops) break;
    mode = next.mode;
  }
  return lit;
}

// Lit points of one picture farther than `reach` from every lit point of the other.
int strangers(const std::vector<bool>& one, const std::vector<bool>& other, int reach) {
  int count = 0;
  for (int y = 0; y < 1024; ++y)
    for (int x = 0; x < 1024; ++x) {
      if (!one[static_cast<std::size_t>(y * 1024 + x)]) continue;
      bool near = false;
      for (int b = std::max(0, y - reach); b <= std::min(1023, y + reach) && !near; ++b)
        for (int a = std::max(0, x - reach); a <= std::min(1023, x + reach) && !near; ++a)
          near = other[static_cast<std::size_t>(b * 1024 + a)];
      count += near ? 0 : 1;
    }
  return count;
}

// At an event a piece comes where another line is, or from no length; so no point of a picture is farther from the picture
// before than what moves: a point a step at the rim, and a rounding at each end.
TEST(TurnStructure, NothingFlickersAtEvents) {
  NEEDS_OPTIMISED_CODE();
  for (const std::string& name : {block, star}) {
    const TurnedModel& of = turned(name);
    Twin twin(of.tape.words, model_base(of.tape.memory));
    constexpr std::uint32_t step = 82;  // 0.99 points at the rim
    constexpr int reach = 4;
    Picture picture;
    ASSERT_TRUE(twin.next(step, picture));
    std::vector<bool> before = raster_of(picture.display_file);
    int events = 0;
    // Far places of the turn, around events.
    for (int k = 0; k < (turns() > 1 ? 3000 : 80); ++k) {
      ASSERT_TRUE(twin.next(step, picture));
      events += static_cast<int>(picture.events);
      std::vector<bool> now = raster_of(picture.display_file);
      EXPECT_EQ(strangers(now, before, reach), 0) << name << " angle " << picture.angle;
      EXPECT_EQ(strangers(before, now, reach), 0) << name << " angle " << picture.angle;
      before = std::move(now);
    }
    if (name == star) {
      EXPECT_GE(events, 2);
    }
  }
}

}  // namespace
}  // namespace sightline::guests::turn
