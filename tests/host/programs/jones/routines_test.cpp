// The arithmetic routines of Jones's program, called one by one on the emulated PDP-7 and compared with plain 64-bit arithmetic
// or with
// the twin's functions, with and without the EAE. Ranges: SPECIFICATION.md and the comment at each label. Clipping and masks:
// jones_clip_routines_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "host/programs/jones/twin/elements.hpp"
#include "tests/firmware/jones_routine.hpp"
#include "tests/support/dice.hpp"

namespace sightline::programs::jones {
namespace {

using End = RoutineMachine::End;

constexpr int rounds = 2000;

class JonesRoutines : public testing::TestWithParam<bool> {
 protected:
  RoutineMachine machine{GetParam()};
  Dice dice{1971};

  std::int32_t up_to(std::int32_t high) {
    return dice(0, 3) == 0 ? high - dice(0, std::min(high, 3)) : dice(0, high);
  }

  void expect_muldiv(std::int32_t a, std::int32_t b, std::int32_t c) {
    machine.set("mdm", b);
    machine.set("mdd", c);
    ASSERT_EQ(machine.call("muldiv", a), End::returned);
    EXPECT_EQ(machine.ac(), (std::int64_t{a} * b + c / 2) / c) << a << " * " << b << " / " << c;
  }
};

TEST_P(JonesRoutines, MultiplyAndDivide) {
  constexpr std::int32_t largest = 131071;
  for (const std::int32_t c : {1, 2, 3, 127, 128, 65535, 65536, largest - 1, largest}) {
    for (const std::int32_t b : {0, 1, c / 2, c - 1, c}) {
      for (const std::int32_t a : {0, 1, 2, c / 2, c, 65536, largest}) expect_muldiv(a, b, c);
    }
  }
  for (int i = 0; i < rounds; ++i) {
    const std::int32_t c = 1 + up_to(largest - 1);
    expect_muldiv(up_to(largest), up_to(c), c);
  }
}

// Only the EAE can get a quotient above AC.
TEST_P(JonesRoutines, DivideOverflowIsAFault) {
  if (!machine.eae()) GTEST_SKIP() << "without the EAE b is not above c, and nothing can overflow";
  for (int i = 0; i < rounds; ++i) {
    const std::int32_t a = 1 + up_to(131070), b = up_to(131071), c = 1 + dice(0, 300);
    if (a == c) continue;
    const std::int64_t dividend = std::int64_t{a} * b + c / 2;
    machine.set("mdm", b);
    machine.set("mdd", c);
    const End end = machine.call("muldiv", a);
    const bool overflow = (dividend >> 18) >= c;
    ASSERT_EQ(end, overflow ? End::fault : End::returned) << a << ' ' << b << ' ' << c;
    if (overflow) {
      EXPECT_EQ(machine.ac(), static_cast<std::int32_t>(Status::arithmetic_overflow));
    } else {
      EXPECT_EQ(core::Word18(static_cast<std::uint32_t>(machine.ac())).value(), dividend / c);
    }
  }
}

TEST_P(JonesRoutines, Perspective) {
  for (int i = 0; i < rounds; ++i) {
    const Window window = window_of(i % 3 == 0 ? Pass::left : Pass::mono, i % 7 == 0 ? 4096 : dice(64, 4096));
    const std::int32_t z = i % 5 == 0 ? 1 + dice(0, 40) : 1 + up_to(131070);
    const std::int32_t limit = bound(window.bound_factor, z);
    const std::int32_t x = (i % 2 == 0 ? -1 : 1) * up_to(limit);
    machine.set("pjw", window.width_scale);
    ASSERT_EQ(machine.call("setz", z), End::returned);
    ASSERT_EQ(machine.call("proj", x), End::returned);
    const std::int64_t magnitude = (std::int64_t{std::abs(x)} * window.width_scale + z / 2) / z;
    ASSERT_EQ(machine.ac(), x < 0 ? -magnitude : magnitude) << x << " / " << z << " W " << window.width_scale;
    Operations operations;
    ASSERT_EQ(machine.ac(), project({x, 0, z}, window.width_scale, operations)->x);
  }
}

TEST_P(JonesRoutines, BoundsFollowTheScale) {
  for (std::int32_t scale = 64; scale <= 4096; scale += scale < 600 ? 1 : 37) {
    const Window window = window_of(Pass::mono, scale);
    machine.set("pjw", window.width_scale);
    ASSERT_EQ(machine.call("setbnd"), End::returned);
    ASSERT_EQ(machine.cell("km1") + 1, window.bound_factor) << scale;
    for (int i = 0; i < 20; ++i) {
      const std::int32_t z = i % 2 == 0 ? 1 + dice(0, 200) : dice(1, 131071);
      machine.set("pz", z);
      ASSERT_EQ(machine.call("newz"), End::returned);
      const std::int32_t limit = bound(window.bound_factor, z);
      ASSERT_EQ(machine.cell("bound"), limit) << "K " << window.bound_factor << " z " << z;
      const std::int32_t x = dice(-100000, 100000);
      ASSERT_EQ(machine.call("clamp", x), End::returned);
      ASSERT_EQ(machine.ac(), std::clamp(x, -limit, limit));
      for (const std::int32_t edge : {limit - 1, limit, limit + 1}) {
        if (edge > 131071) continue;
        machine.call("clamp", edge);
        ASSERT_EQ(machine.ac(), std::min(edge, limit));
        machine.call("clamp", -edge);
        ASSERT_EQ(machine.ac(), -std::min(edge, limit));
      }
    }
  }
}

TEST_P(JonesRoutines, LeastDepthInTheBound) {
  for (const std::int32_t scale : {64, 100, 128, 200, 256, 511, 512, 4096}) {
    const Window window = window_of(Pass::mono, scale);
    machine.set("pjw", window.width_scale);
    ASSERT_EQ(machine.call("setbnd"), End::returned);
    for (int i = 0; i < 200; ++i) {
      const std::int32_t x = i < 100 ? i - 50 : dice(-100000, 100000);
      ASSERT_EQ(machine.call("zleast", x), End::returned);
      ASSERT_EQ(machine.ac(), std::max(near_z, (std::abs(x) + window.bound_factor - 1) / window.bound_factor))
          << x;
      ASSERT_EQ(machine.ac(), depth_inside(std::abs(x), window.bound_factor)) << x;
    }
  }
}

TEST_P(JonesRoutines, LimitKeepsANumberInItsRange) {
  for (int i = 0; i < rounds; ++i) {
    const std::int32_t low = dice(-16000, 16000), high = low + dice(0, 16000);
    const std::int32_t value = i % 4 == 0   ? low + dice(-1, 1)
                               : i % 4 == 1 ? high + dice(-1, 1)
                                            : dice(-60000, 60000);
    machine.set("limlo", low);
    machine.set("limhi", high);
    ASSERT_EQ(machine.call("limit", value), End::returned);
    ASSERT_EQ(machine.ac(), std::clamp(value, low, high));
  }
}

TEST_P(JonesRoutines, DoubleProductAddsToTheAccumulator) {
  constexpr std::int32_t most = 2047;
  const auto factor = [&] { return dice(0, 5) == 0 ? (dice(0, 1) ? most : -most) : dice(-most, most); };
  for (int i = 0; i < rounds; ++i) {
    machine.set("acch", 0);
    machine.set("accl", 0);
    std::int64_t sum = 0;
    for (int term = 0; term < 4; ++term) {
      const std::int32_t a = factor(), b = term == 3 ? 0 : factor();
      machine.set("smb", b);
      ASSERT_EQ(machine.call("addprd", a), End::returned);
      sum += std::int64_t{a} * b;
      ASSERT_EQ(machine.accumulator(), sum * machine.product_unit()) << a << " * " << b;
    }
  }
}

TEST_P(JonesRoutines, ElevenStepMultiplication) {
  if (machine.eae()) GTEST_SKIP() << "the machine multiplies";
  for (int i = 0; i < rounds; ++i) {
    const std::int32_t a = up_to(2047), b = up_to(2047);
    machine.set("mpyb", b);
    ASSERT_EQ(machine.call("mpy", a), End::returned);
    const std::int64_t product =
        std::int64_t{machine.cell("mpyh")} << 18 | machine.word(machine.at("mpyl")).value();
    ASSERT_EQ(product, (std::int64_t{a} * b) << (8 - machine_fraction_bits)) << a << " * " << b;
  }
}

// Pieces as words, joined and not, compared with the twin's display file.
TEST_P(JonesRoutines, DisplayWordsOfPieces) {
  for (int file = 0; file < 40; ++file) {
    const bool joining = file % 2 == 0;
    const Window window;
    DisplayFile expected(1400, joining);
    constexpr int unit = 1 << machine_fraction_bits;
    const auto point_of = [&](ScreenPoint at) {
      return ScreenPoint{((at.x + unit / 2) >> machine_fraction_bits) + window.centre_x,
                         ((at.y + unit / 2) >> machine_fraction_bits) + window.centre_y};
    };
    Operations operations;
    machine.set("mode", joining ? 0 : 2);
    machine.set("runing", 1);
    machine.set("file",
                static_cast<std::int32_t>(machine.at("filea")));  // so the other is the one being made
    machine.set("cx2", unit * window.centre_x + unit / 2);
    ASSERT_EQ(machine.call("newfil"), End::returned);
    ASSERT_EQ(machine.cell("dfs"), static_cast<std::int32_t>(machine.at("fileb")));
    machine.set("file", static_cast<std::int32_t>(machine.at("fileb")));  // already shown
    ScreenPoint end{};
    for (int i = 0; i < 60; ++i) {
      const auto coordinate = [&] { return dice(-512 * unit, 511 * unit); };
      ScreenSegment line{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
      if (i % 3 == 1) line.a = end;
      if (i % 4 == 1) line.b = {line.a.x, coordinate()};
      if (i % 4 == 2) line.b = {line.a.x + dice(-2, 2), line.a.y + dice(-2, 2)};
      line.b = {std::clamp(line.b.x, -512 * unit, 511 * unit),
                std::clamp(line.b.y, -512 * unit, 511 * unit)};
      machine.set("lax", line.a.x);
      machine.set("lay", line.a.y);
      machine.set("lbx", line.b.x);
      machine.set("lby", line.b.y);
      ASSERT_EQ(machine.call("piece"), End::returned);
      ASSERT_NE(expected.add(point_of(line.a), point_of(line.b), operations), DisplayFile::Outcome::full);
      end = line.b;
    }
    std::vector<core::Word18> words;
    for (pdp7::Address at = machine.at("fileb"); words.empty() || words.back().value() != 03000; ++at) {
      ASSERT_LT(words.size(), 1400U);
      words.push_back(machine.word(at));
    }
    EXPECT_TRUE(same_words(words, std::move(expected).finish()));
  }
}

INSTANTIATE_TEST_SUITE_P(Eae, JonesRoutines, testing::Bool(),
                         [](const auto& eae) { return std::string(eae.param ? "WithEae" : "WithoutEae"); });

}  // namespace
}  // namespace sightline::programs::jones
