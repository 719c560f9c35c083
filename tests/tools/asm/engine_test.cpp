// The engine of the assemblers, with a language of three statements whose results can be worked out by hand.
#include "tools/asm/engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace sightline::assembler {
namespace {

using Texts = std::vector<std::string>;

// name = first + offset; `declare first`, external if offset is not 0; `if first`: skip the next statement if first is offset.
struct Statement {
  std::string name;
  std::string first;  // empty: 0
  std::uint32_t offset = 0;
};
using Source = std::vector<Statement>;
using Sources = std::vector<Source>;

class Toy {
 public:
  explicit Toy(Sources sources) : sources_(std::move(sources)) {
    for (std::size_t i = 0; i < sources_.size(); ++i) files_.push_back({std::string(1, static_cast<char>('a' + i)), ""});
    engine_.emplace(files_, Naming{}, octal_words);
  }

  void run() {
    engine_->run([] {}, [this] { read(); });
    engine_->finish(report_, true);
  }
  [[nodiscard]] Engine& engine() { return *engine_; }
  [[nodiscard]] int passes() const { return passes_; }
  [[nodiscard]] std::optional<std::uint32_t> value_of(const std::string& name) const { return report_.value_of(name); }
  [[nodiscard]] Texts messages() const {
    Texts texts;
    for (const Diagnostic& diagnostic : report_.diagnostics) texts.push_back(to_string(diagnostic));
    return texts;
  }
  std::function<void()> at_end = [] {};

 private:
  void read() {
    ++passes_;
    for (std::size_t source = 0; source < sources_.size(); ++source) {
      engine_->begin_source(source);
      for (std::size_t line = 0; line < sources_[source].size(); ++line) statement(sources_[source][line], {source, line + 1, 1});
    }
    at_end();
  }
  void statement(const Statement& each, const Position& at) {
    if (each.name == "declare") return engine_->declare(each.first, each.offset != 0);
    if (each.name == "if") {
      const Symbol* const found = engine_->find(each.first);
      if (found == nullptr || !found->value) engine_->await_value();
      skip_ = found == nullptr || found->value.value_or(0) == each.offset;
      return;
    }
    if (std::exchange(skip_, false)) return;
    std::optional<std::uint32_t> value = 0;
    if (!each.first.empty()) {
      const Symbol* const found = engine_->find(each.first);
      value = found == nullptr ? std::nullopt : found->value;
      if (!value) engine_->error(at, "'" + each.first + "'", "a value");
    }
    if (value) *value += each.offset;
    engine_->define(engine_->look_up(each.name, at), SymbolKind::constant, value, at);
  }

  Sources sources_;
  std::vector<SourceFile> files_;
  std::optional<Engine> engine_;
  AssemblyReport report_;
  int passes_ = 0;
  bool skip_ = false;
};

TEST(AssemblerEngine, ReadsTwiceWhatNeedsNothingFromLaterLines) {
  Toy toy(Sources{{{"a", "", 3}, {"b", "a", 2}}});
  toy.run();
  EXPECT_EQ(toy.messages(), Texts{});
  EXPECT_EQ(toy.value_of("b"), 5U);
  EXPECT_EQ(toy.passes(), 2);
}

// A chain of n later names settles in pass n + 1, which pass n + 2 confirms; the last pass makes the program.
TEST(AssemblerEngine, RepeatsPassesUntilAChainSettles) {
  for (std::uint32_t length = 1; length <= 20; ++length) {
    Source lines;
    for (std::uint32_t i = 0; i < length; ++i) lines.push_back({"n" + std::to_string(i), "n" + std::to_string(i + 1), 1});
    lines.push_back({"n" + std::to_string(length), "", 100});
    Toy toy(Sources{lines});
    toy.run();
    if (length <= 15) {
      EXPECT_EQ(toy.messages(), Texts{}) << length;
      EXPECT_EQ(toy.value_of("n0"), 100 + length);
    }
    EXPECT_EQ(toy.passes(), std::min(static_cast<int>(length) + 3, 17));
    EXPECT_EQ(toy.messages().empty(), length <= 15) << length;
  }
}

TEST(AssemblerEngine, WhatDependsOnItselfHasNoValue) {
  Toy toy(Sources{{{"a", "b", 1}, {"b", "a", 1}}});
  toy.run();
  EXPECT_EQ(toy.messages(), (Texts{"a:1:1: error: found 'b', expected a value", "a:2:1: error: found 'a', expected a value"}));
  EXPECT_LE(toy.passes(), 4);
}

// The first pass takes an unknown x as 0, so that `if` skips y only in that pass, or in all passes but that one.
TEST(AssemblerEngine, ANameThatOnlyAnEarlierPassDefinedIsForgotten) {
  Toy toy(Sources{{{"if", "x", 0}, {"y", "", 1}, {"z", "y", 0}, {"x", "", 7}}});
  toy.run();
  EXPECT_EQ(toy.value_of("z"), 1U);
  Toy gone(Sources{{{"if", "x", 7}, {"y", "", 1}, {"x", "", 7}}});
  gone.run();
  EXPECT_EQ(gone.value_of("y"), std::nullopt);
}

TEST(AssemblerEngine, WhatNeverSettlesIsOneError) {
  Toy toy(Sources{{{"if", "x", 1}, {"y", "", 4}, {"x", "y", 0}, {"if", "y", 0}, {"x", "", 1}}});
  toy.run();
  EXPECT_EQ(toy.messages(), (Texts{"a:2:1: error: found 'y', which only every second pass defines, expected a definition that does not "
                                   "depend on itself"}));
  // The value changes with each pass: the error shows both.
  Toy counting(Sources{{{"a", "c", 0}, {"c", "a", 0}}});
  std::uint32_t pass = 0;
  counting.at_end = [&] {
    Symbol& c = counting.engine().symbol("c", "c");
    counting.engine().define(c, SymbolKind::constant, ++pass, {0, 2, 1});
  };
  counting.run();
  EXPECT_EQ(counting.messages(), (Texts{"a:1:1: error: found 'a' = 000020, in the pass before 000017 (phase error), expected a definition that "
                                        "does not depend on itself"}));
}

TEST(AssemblerEngine, NothingElseIsReportedAfterAnError) {
  Toy toy({Source{{"a", "nobody", 0}, {"c", "", 0}}});
  std::uint32_t pass = 0;
  toy.at_end = [&] { toy.engine().define(toy.engine().symbol("c", "c"), SymbolKind::constant, ++pass, {0, 2, 1}); };
  toy.run();
  EXPECT_EQ(toy.messages(), (Texts{"a:1:1: error: found 'nobody', expected a value"}));
}

TEST(AssemblerEngine, NamesAreLocalToSourcesThatDeclareNames) {
  Toy together(Sources{{{"n", "", 1}}, {{"m", "n", 0}}});
  together.run();
  EXPECT_EQ(together.value_of("m"), 1U);
  EXPECT_EQ(together.passes(), 2);
  Toy apart(Sources{{{"declare", "m", 0}, {"n", "", 1}, {"m", "n", 4}}, {{"declare", "m", 1}, {"n", "m", 10}, {"k", "n", 0}}});
  apart.run();
  EXPECT_EQ(apart.messages(), Texts{});
  EXPECT_EQ(apart.value_of("m"), 5U);
  EXPECT_EQ(apart.value_of("k"), 15U);
  Toy missing(Sources{{{"declare", "m", 0}, {"m", "", 4}, {"n", "", 1}}, {{"k", "n", 0}}});
  missing.run();
  EXPECT_EQ(missing.messages(), (Texts{"b:1:1: error: found 'n', expected a value"}));
}

TEST(AssemblerEngine, PlacesAreThoseOfThePassBefore) {
  Toy toy(Sources(1));
  std::vector<std::optional<std::uint32_t>> seen;
  toy.at_end = [&] {
    Places& places = toy.engine().places(3);
    EXPECT_EQ(places.last(), std::nullopt);
    seen = {places.next()};
    places.add(10);
    seen.push_back(places.last());
    seen.push_back(places.next());
    places.set_next(15);
    seen.push_back(places.next());
    places.add(20);
    places.set_last(12);
    seen.push_back(places.last());
    seen.push_back(places.next());
    toy.engine().await_value();
  };
  toy.run();
  EXPECT_EQ(seen, (std::vector<std::optional<std::uint32_t>>{10, 10, 20, 15, 12, std::nullopt}));
  EXPECT_EQ(toy.passes(), 3);
}

TEST(AssemblerEngine, MemoryKeepsTheLastValueAndTheFirstPlace) {
  Toy toy(Sources(1));
  toy.at_end = [&] {
    if (!toy.engine().final()) return;
    ListedLine unlisted;
    EXPECT_EQ(toy.engine().put(7, 1, {0, 3, 2}, unlisted), std::nullopt);
    EXPECT_EQ(toy.engine().put(2, 5, {0, 4, 2}, unlisted), std::nullopt);
    EXPECT_EQ(toy.engine().put(7, 2, {0, 5, 2}, unlisted)->line, 3U);
    EXPECT_EQ(toy.engine().put(7, 3, {0, 6, 2}, unlisted)->line, 3U);
  };
  toy.run();
  std::vector<std::uint32_t> cells;
  toy.engine().for_each_cell([&](std::uint32_t address, std::uint32_t value) { cells.insert(cells.end(), {address, value}); });
  EXPECT_EQ(cells, (std::vector<std::uint32_t>{2, 5, 7, 3}));
}

TEST(AssemblerEngine, AThousandErrorsEndTheProgram) {
  Toy toy(Sources(1));
  int reports = 0;
  toy.at_end = [&] {
    for (std::size_t line = 1; line <= 3000 && !toy.engine().stopped(); ++line, ++reports) toy.engine().error({0, line, 1}, "x", "y");
  };
  toy.run();
  ASSERT_EQ(toy.messages().size(), 1001U);
  EXPECT_EQ(toy.messages().back(), "a:1001:1: error: found more than 1000 errors, expected fewer; the rest is not read");
  EXPECT_EQ(reports, 3000 + 1001) << "nothing stops a pass that reports nothing";
  Toy warned(Sources(1));
  warned.at_end = [&] {
    for (std::size_t line = 1; line <= 3000; ++line) warned.engine().warning({0, line, 1}, "x", "y");
    warned.engine().error({0, 1, 1}, "z", "y");
  };
  warned.run();
  EXPECT_EQ(warned.messages().size(), 1002U);
}

TEST(AssemblerEngine, AnIncludedFileIsReadOnce) {
  Toy toy(Sources(1));
  int reads = 0;
  const IncludeReader reader = [&](const std::string& path) -> std::optional<std::string> {
    ++reads;
    return path == "there" ? std::optional<std::string>("text") : std::nullopt;
  };
  toy.at_end = [&] {
    const auto index = toy.engine().include("there", reader);
    ASSERT_TRUE(index);
    EXPECT_EQ(toy.engine().file(*index).text, "text");
    EXPECT_FALSE(toy.engine().include("gone", reader));
    EXPECT_FALSE(toy.engine().include("any", {}));
  };
  toy.run();
  EXPECT_EQ(reads, 2);
}

TEST(AssemblerEngine, NamesAreComparedAsTheLanguageSays) {
  EXPECT_EQ(Naming{}.key("aB$c"), "ab$c");
  EXPECT_EQ(Naming{.dollar_counts = false}.key("aB$c"), "abc");
  EXPECT_EQ((Naming{.significant = 3, .any_case = false}.key("aBcd")), "aBc");
}

}  // namespace
}  // namespace sightline::assembler
