// Plantinga, Seales and Dyer in the report: lists cached between reports.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "host/algorithms/plantinga/event_file.hpp"
#include "host/base/file.hpp"
#include "host/report/experiments/plantinga_models.hpp"

namespace sightline::report {
namespace {

namespace native = algorithms::plantinga;

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

TEST_F(PlantingaCache, KeepsListsAndReplacesUnusableOnes) {
  EXPECT_FALSE(study().from_cache);
  const base::Bytes good = bytes();
  EXPECT_TRUE(study().from_cache);
  EXPECT_EQ(native::encode_events(study().list), good);
  const auto rebuilt = [&](const base::Bytes& found) {
    EXPECT_TRUE(base::write_file_atomically(file(), std::span(found)));
    EXPECT_FALSE(study().from_cache);
    EXPECT_EQ(bytes(), good);
  };
  base::Bytes damaged = good;
  damaged[good.size() / 2] ^= 1;
  rebuilt(damaged);
  rebuilt(base::Bytes(good.begin(), good.begin() + 100));
  rebuilt({});
  native::EventList of_another = study().list;
  of_another.fingerprint ^= 1;
  rebuilt(native::encode_events(of_another));
}

TEST_F(PlantingaCache, IsNotNeeded) {
  std::ofstream(root_ + "/made") << "a file where a folder should be";
  EXPECT_FALSE(study().from_cache);
  EXPECT_EQ(study().list.changes.size(), 1845U);
}

}  // namespace
}  // namespace sightline::report
