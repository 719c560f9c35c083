// The machine's pictures compared with hidden-line removal: every structure equals that from scratch at the machine's own angle,
// every
// line ends where the program's words can place it, and nothing flickers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "emulators/type340/vector_generator.hpp"
#include "emulators/type340/words.hpp"
#include "host/algorithms/exact/visible_edges.hpp"
#include "host/algorithms/plantinga/edge_structure.hpp"
#include "host/algorithms/plantinga/frame.hpp"
#include "host/algorithms/plantinga/visible_edges.hpp"
#include "host/programs/turn/precision.hpp"
#include "host/programs/turn/turn.hpp"
#include "tests/host/programs/turn/turned_model.hpp"
#include "tests/support/effort.hpp"

namespace sightline::programs::turn {
namespace {

namespace plantinga = algorithms::plantinga;

// Compares an angle of the machine with a direction, exactly: fractions of 90 bits on both sides of the word's angle decide it.
// Directions of
// events have degree one or two: one that near to a word equals it, and is then a multiple of an eighth of a right angle.
int word_to_direction(std::uint32_t word, const plantinga::Direction& direction) {
  const auto at = static_cast<std::int64_t>(word) - (word > 1U << 17U ? 1 << 18 : 0);
  // Half turns are both ends of the range of angles.
  if (at == 1 << 17) return direction == plantinga::rational_direction(0, -1) ? 0 : 1;
  if (at == 0 || std::abs(at) == 1 << 16) {
    const auto exact = plantinga::rational_direction(at == 0 ? 0 : at, at == 0 ? 1 : 0);
    return plantinga::compare(exact, direction);
  }
  const long double turn = static_cast<long double>(at) * std::numbers::pi_v<long double> / (1 << 17);
  const auto near = [&](long double by) {
    const auto scaled = [](long double f) {
      // 62 bits of the number; long double has 64.
      return static_cast<plantinga::Int128>(std::llround(f * 0x1p61L));
    };
    return plantinga::rational_direction(scaled(std::sin(turn + by)), scaled(std::cos(turn + by)));
  };
  constexpr long double uncertain = 0x1p-55L;
  const int low = plantinga::compare(near(-uncertain), direction);
  const int high = plantinga::compare(near(uncertain), direction);
  return low == high ? low : 0;
}

// A direction between the same two events as an angle of the machine, by exact order; nothing if all such directions have long
// numbers.
std::optional<plantinga::Sight> sight_of_word(const plantinga::EventList& list, std::uint32_t word) {
  const auto next = std::find_if(list.events.begin(), list.events.end(),
                                 [word](const plantinga::Event& event) { return word_to_direction(word, event.direction) < 0; });
  const auto& after = next == list.events.end() ? list.events.front() : *next;
  const auto& before = next == list.events.begin() ? list.events.back() : *std::prev(next);
  return plantinga::sight_between(before.direction, after.direction);
}

// The state of every slot by hidden-line removal from scratch.
std::vector<std::uint32_t> states_from_scratch(const TurnedModel& of, const plantinga::Sight& sight,
                                               const std::vector<std::vector<plantinga::Occluder>>& occluders) {
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

TEST(TurnStructure, EqualsThatFromScratchAtTheMachinesAngle) {
  for (const std::string& name : {cube, block, crossed, lshape, star}) {
    const TurnedModel& of = turned_model(name);
    std::vector<std::vector<plantinga::Occluder>> occluders;
    for (plantinga::EdgeIndex e = 0; e < of.model.edges().size(); ++e) occluders.push_back(of.model.occluders_of(e));
    const Program program = assemble_program(true, of.tape.memory);
    for (const std::uint32_t direction : {0U, backward_switch}) {
      Machine machine(program, of.tape);
      Picture shown;
      const std::uint32_t step = turns() > 1 ? 811 : tests::effort(5197U, 20011U);
      const std::uint32_t slots = of.tape.words[6].value();
      int compared = 0;
      for (std::uint32_t k = 0; k < pictures_of_turn(step); ++k) {
        ASSERT_TRUE(machine.next(direction | step, shown));
        const auto sight = sight_of_word(of.list, shown.angle);
        if (!sight) continue;
        ++compared;
        const auto expected = states_from_scratch(of, *sight, occluders);
        for (std::uint32_t s = 0; s < expected.size(); ++s)
          ASSERT_EQ(machine.peek(slots + 4 * s).value(), expected[s]) << name << " angle " << shown.angle << " slot " << s;
      }
      // All except those between two events less than 2^-40 apart.
      EXPECT_GE(compared + 1, static_cast<int>(pictures_of_turn(step))) << name;
    }
  }
}

// Every event takes effect at the first word that is not before it.
TEST(TurnStructure, EventsAreAtTheirWordsExactly) {
  for (const std::string& name : {cube, block, crossed, lshape, star, std::string("boxes-8")}) {
    const TurnedModel& of = turned_model(name);
    for (const plantinga::Event& event : of.list.events) {
      const std::uint32_t word = event_word(event.direction);
      ASSERT_GE(word_to_direction(word, event.direction), 0) << name << " word " << word;
      // There is no event before the first angle of the list.
      if (word != (1U << 17U) + 1) {
        ASSERT_LT(word_to_direction((word - 1) & 0777777U, event.direction), 0) << name << " word " << word;
      }
    }
  }
}

// An independent algorithm on this computer: the visible parts of every edge.
TEST(TurnStructure, IsThePictureOfTheExactAlgorithm) {
  for (const std::string& name : {block, crossed, lshape, star}) {
    const TurnedModel& of = turned_model(name);
    Twin twin(of.tape.words, model_base(of.tape.memory));
    plantinga::FrameMaker frames(of.model);
    TwinPicture picture;
    int compared = 0;
    for (std::uint32_t k = 0; k < tests::effort(60U, 6U); ++k) {
      ASSERT_TRUE(twin.next(4391, picture));
      const double angle = radians(picture.angle);
      // Camera vectors are below 2^15: within 2^-15 of the angle.
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

// The beam's position after each word of a display file that moves it, including the starts of lines.
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

// Ends of pieces in doubles, along the exact structure: each must be a corner of the display file, within the error that the
// program's
// words explain for this end.
TEST(TurnStructure, EndsAreWithinThePrecisionOfTheWords) {
  for (const std::string& name : {cube, block, crossed, lshape, star}) {
    const TurnedModel& of = turned_model(name);
    Twin twin(of.tape.words, model_base(of.tape.memory));
    plantinga::FrameMaker frames(of.model);
    const Precision precision(of.tape);
    const double scale = points_per_unit(of.model);
    const double middle = static_cast<double>(twice_middle(of.model)) / 2;
    double worst = 0;
    double bound = 0;
    std::size_t ends = 0;
    std::size_t beyond_a_point = 0;
    TwinPicture picture;
    for (std::uint32_t k = 0; k < tests::effort(400U, 60U); ++k) {
      ASSERT_TRUE(twin.next(4391, picture));
      const Points corners = corners_of(picture.display_file);
      const double angle = radians(picture.angle);
      frames.place(angle);
      std::vector<std::uint32_t> states;
      for (std::uint32_t s = 0; s < of.tape.slots; ++s) states.push_back(twin.state(s));
      for (const PieceBound& piece : precision.pieces(states, picture.angle)) {
        if (piece.may_be_missing) continue;
        const Tape::Slot& slot = of.tape.slot_of[piece.slot];
        const auto& edge = of.model.edges()[slot.edge];
        for (unsigned e = 0; e < 2; ++e) {
          const std::uint32_t code = (states[piece.slot] >> (e == 0 ? 12U : 6U)) & 077U;
          double at = (e == 0) == slot.reversed ? 1 : 0;
          if (code != 1) at = frames.parameter_of(slot.edge, {of.tape.partners[slot.edge][code - 2]});
          EXPECT_NEAR(slot.reversed ? 1 - at : at, piece.ends[e].at, piece.ends[e].along + 1e-9) << name << " angle " << picture.angle;
          const auto& p = of.model.vertices()[edge.from];
          const auto& q = of.model.vertices()[edge.to];
          const auto mix = [at](std::int64_t a, std::int64_t b) {
            return static_cast<double>(a) + at * static_cast<double>(b - a);
          };
          const double x = 512 + scale * (mix(p[0], q[0]) * std::cos(angle) - mix(p[2], q[2]) * std::sin(angle));
          const double y = 512 + scale * (mix(p[1], q[1]) - middle);
          double best = 1e9;
          bool within = false;
          for (const auto& corner : corners) {
            const double dx = std::abs(corner[0] - x);
            const double dy = std::abs(corner[1] - y);
            best = std::min(best, std::max(dx, dy));
            within = within || (dx <= piece.ends[e].x + 1e-9 && dy <= piece.ends[e].y + 1e-9);
          }
          EXPECT_TRUE(within) << name << " angle " << picture.angle << " edge " << slot.edge;
          worst = std::max(worst, best);
          bound = std::max({bound, piece.ends[e].x, piece.ends[e].y});
          ++ends;
          beyond_a_point += best > 1 ? 1U : 0U;
        }
      }
    }
    RecordProperty("ends_" + std::to_string(of.tape.edges), std::to_string(ends));
    RecordProperty("worst_" + std::to_string(of.tape.edges), std::to_string(worst));
    RecordProperty("bound_" + std::to_string(of.tape.edges), std::to_string(bound));
    EXPECT_EQ(beyond_a_point, 0U) << name;
  }
}

// The program's cosine and sine of every angle of a quarter turn.
TEST(TurnPrecision, RotationIsWithinItsBound) {
  double worst = 0;
  constexpr std::uint32_t quarter = 1U << 16U;
  for (std::uint32_t a = 0; a <= quarter; ++a) {
    const double s = Twin::sine(a) - 16384 * std::sin(radians(a));
    const double c = Twin::sine(quarter - a) - 16384 * std::cos(radians(a));
    worst = std::max(worst, std::hypot(s, c));
  }
  EXPECT_LE(worst, rotation_error);
  EXPECT_GT(worst, rotation_error - 0.01);
}

// Every vector word of the display, pulse by pulse.
TEST(TurnPrecision, TheBeamStaysWithinItsBound) {
  double worst = 0;
  for (unsigned dx = 0; dx < 128; ++dx) {
    for (unsigned dy = 0; dy < 128; ++dy) {
      if ((dx | dy) == 0) continue;
      type340::RateMultiplier generator;
      int x = 0;
      int y = 0;
      for (int n = type340::pulses_of_vector(static_cast<std::uint8_t>(dx), static_cast<std::uint8_t>(dy)); n > 0; --n) {
        const auto step = generator.count(static_cast<std::uint8_t>(dx), static_cast<std::uint8_t>(dy));
        x += step.x ? 1 : 0;
        y += step.y ? 1 : 0;
        worst = std::max(worst, std::abs(x * static_cast<double>(dy) - y * static_cast<double>(dx)) / std::hypot(dx, dy));
      }
    }
  }
  EXPECT_LE(worst, vector_wander);
  EXPECT_GT(worst, vector_wander - 0.01);
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

// The number of lit points of one picture that are farther than `reach` from every lit point of the other.
int count_far_points(const std::vector<bool>& one, const std::vector<bool>& other, int reach) {
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

// At an event a piece appears on another line or with length zero. So no point of a picture is farther from the picture before
// than the
// motion explains: a point per step at the rim, and a rounding at each end.
TEST(TurnStructure, NothingFlickersAtEvents) {
  NEEDS_OPTIMISED_CODE();
  for (const std::string& name : {block, star}) {
    const TurnedModel& of = turned_model(name);
    Twin twin(of.tape.words, model_base(of.tape.memory));
    constexpr std::uint32_t step = 82;  // 0.99 points at the rim
    constexpr int reach = 4;
    TwinPicture picture;
    ASSERT_TRUE(twin.next(step, picture));
    std::vector<bool> before = raster_of(picture.display_file);
    int events = 0;
    // Distant parts of the turn, around events.
    for (int k = 0; k < (turns() > 1 ? 3000 : 80); ++k) {
      ASSERT_TRUE(twin.next(step, picture));
      events += static_cast<int>(picture.events);
      std::vector<bool> now = raster_of(picture.display_file);
      EXPECT_EQ(count_far_points(now, before, reach), 0) << name << " angle " << picture.angle;
      EXPECT_EQ(count_far_points(before, now, reach), 0) << name << " angle " << picture.angle;
      before = std::move(now);
    }
    if (name == star) {
      EXPECT_GE(events, 2);
    }
  }
}

}  // namespace
}  // namespace sightline::programs::turn
