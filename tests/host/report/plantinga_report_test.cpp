// Plantinga, Seales and Dyer in the report: events of edges read from text, hard cases, lists kept between
// reports.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>

#include "host/algorithms/plantinga/event_file.hpp"
#include "host/base/file.hpp"
#include "host/report/experiments/plantinga_models.hpp"
#include "host/report/hard_cases/plantinga.hpp"
#include "host/report/hard_cases/plantinga_checks.hpp"
#include "host/report/table_text.hpp"

namespace sightline::harness::report {
namespace {

namespace native = algorithms::plantinga;

Context quiet() {
  Context context;
  context.host_times = false;
  return context;
}

TEST(PlantingaReport, LinesOfEdgesAreReadOrRefusedByLine) {
  const auto read = read_event_lines("# remark\n\nedge -1 2 3  4 5 -6  # more\nvertex 0 8388607 0\n");
  ASSERT_TRUE(read);
  ASSERT_EQ(read->edges.size(), 1U);
  EXPECT_EQ(read->edges[0].to, (native::Vector3{4, 5, -6}));
  ASSERT_EQ(read->vertices.size(), 1U);
  for (const char* const wrong : {"edge 1 2 3", "vertex 1 2 3 4", "vertex 1 2 x", "vertex 8388608 0 0",
                                  "vertex 1 2 -", "line 1 2 3", "vertex 1 2 99999999999999999999"}) {
    const auto refused = read_event_lines(std::string("vertex 1 2 3\n") + wrong);
    ASSERT_FALSE(refused) << wrong;
    EXPECT_TRUE(refused.error().message().starts_with("line 2: found \"")) << wrong;
  }
}

const Table& cases() {
  static const Table table = [] {
    auto made = plantinga_cases(quiet());
    return made.has_value() ? std::move(*made) : Table{};
  }();
  return table;
}

TEST(PlantingaReport, EveryHardCaseHasItsRowAndIsRight) {
  std::string seen = " ";
  for (const auto& row : cases().rows) {
    seen += shown_text(row[0]) + " ";
    ASSERT_TRUE(std::holds_alternative<Verdict>(row[5])) << shown_text(row[0]);
    for (const std::size_t column : {5U, 7U, 8U}) {
      if (const auto* const verdict = std::get_if<Verdict>(&row[column]))
        EXPECT_TRUE(verdict->good) << shown_text(row[0]) << ' ' << shown_text(row[1]) << ": "
                                   << verdict->text;
      else
        EXPECT_TRUE(shown_text(row[column]).starts_with("not applicable: ")) << shown_text(row[0]);
    }
  }
  for (const char* const id : {"P1", "P1b", "P1c", "P1d"})
    EXPECT_NE(seen.find(" " + std::string(id) + " "), std::string::npos) << id;
  for (int i = 2; i <= 22; ++i) EXPECT_NE(seen.find(" P" + std::to_string(i) + " "), std::string::npos) << i;
}

TEST(PlantingaReport, DoublesFailBeforeTheExactBuild) {
  const Table table = plantinga_families(quiet());
  std::size_t exact = 0;
  for (const auto& row : table.rows) {
    const bool is_exact = shown_text(row[2]).starts_with("exact");
    exact += is_exact ? 1 : 0;
    const auto* const first = std::get_if<Real>(&row[3]);
    EXPECT_EQ(std::get<Verdict>(row[4]).good, is_exact) << shown_text(row[2]);
    EXPECT_EQ(first == nullptr, is_exact) << shown_text(row[2]);
    // 24 and 53 bits of precision: no earlier than that, and not much later.
    if (first == nullptr) continue;
    const double bits = shown_text(row[2]).find("single") != std::string::npos ? 24 : 53;
    EXPECT_GT(first->value, bits - 2) << shown_text(row[2]);
    EXPECT_LT(first->value, bits + 5) << shown_text(row[2]);
  }
  EXPECT_EQ(exact, 3U);
}

// The judges must be able to say no.
TEST(PlantingaReport, AListWithoutOneOfItsEventsIsNotRight) {
  const scene::PolyScene scene = plantinga_scene("grid");
  native::RotationModel model(scene);
  TurnedScene turned{scene, model, *native::build_event_list(model)};
  EXPECT_EQ(large_steps(turned), std::nullopt);
  turned.list.events.erase(turned.list.events.begin() + 300);
  EXPECT_NE(large_steps(turned), std::nullopt);
  EXPECT_NE(four_faces_edge_on(turned), std::nullopt);
  EXPECT_NE(fronts_always_seen(turned), std::nullopt);
}

class PlantingaCache : public ::testing::Test {
 protected:
  PlantingaCache() {
    std::string pattern = (std::filesystem::temp_directory_path() / "sightline-cache-XXXXXX").string();
    EXPECT_NE(mkdtemp(pattern.data()), nullptr);
    context_.host_times = false;
    context_.cache = pattern + "/made/when/needed";
    root_ = pattern;
  }
  ~PlantingaCache() override { std::filesystem::remove_all(root_); }

  [[nodiscard]] StudiedModel study() const {
    return study_model(context_, "grid");
  }
  [[nodiscard]] std::string file() const { return context_.cache + "/grid.events"; }
  [[nodiscard]] base::Bytes bytes() const { return *base::read_file(file()); }

  Context context_;
  std::string root_;
};

TEST_F(PlantingaCache, KeepsListsAndMakesAnewWhatIsOfNoUse) {
  EXPECT_FALSE(study().from_cache);
  const base::Bytes good = bytes();
  EXPECT_TRUE(study().from_cache);
  EXPECT_EQ(native::encode_events(study().list), good);
  const auto made_anew = [&](const base::Bytes& found) {
    EXPECT_TRUE(base::write_file_atomically(file(), std::span(found)));
    EXPECT_FALSE(study().from_cache);
    EXPECT_EQ(bytes(), good);
  };
  base::Bytes damaged = good;
  damaged[good.size() / 2] ^= 1;
  made_anew(damaged);
  made_anew(base::Bytes(good.begin(), good.begin() + 100));
  made_anew({});
  native::EventList of_another = study().list;
  of_another.fingerprint ^= 1;
  made_anew(native::encode_events(of_another));
}

TEST_F(PlantingaCache, IsNotNeeded) {
  std::ofstream(root_ + "/made") << "a file where a folder should be";
  EXPECT_FALSE(study().from_cache);
  EXPECT_EQ(study().list.changes.size(), 1845U);
}

}  // namespace
}  // namespace sightline::harness::report
