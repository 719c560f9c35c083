// Reading with several threads: the same scene, the same report and the same error as with one.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <map>
#include <random>

#include "host/scene/generate/scene.hpp"
#include "host/scene/model/index_set.hpp"
#include "host/scene/model/vertex_pool.hpp"
#include "host/scene/read/changes.hpp"
#include "host/scene/read/poly_file.hpp"
#include "host/scene/read/poly_text.hpp"

namespace sightline::scene {
namespace {

constexpr unsigned job_counts[] = {2, 3, 7};

// All that a reader returns, as text.
std::string outcome(const std::string& text, PolyFormat format, unsigned jobs, bool mend) {
  PolyImportOptions options;
  options.mend = mend;
  options.jobs = jobs;
  const auto read = read_poly(text, "file", format, options);
  if (!read) return "error " + read.error().message();
  std::string result = write_poly(read->scene, PolyFormat::json).value();
  for (const std::string& note : read->report.notes) result += note + "\n";
  const MendReport& faces = read->report.faces;
  for (const std::size_t count : {faces.merged_vertices, faces.joined_vertices, faces.dropped_faces, faces.duplicate_faces, faces.split_faces,
                                  faces.turned_faces, faces.sheets})
    result += std::to_string(count) + " ";
  return result + std::to_string(std::bit_cast<std::uint64_t>(read->report.largest_shift));
}

// Returns what one thread reads.
std::string expect_equal_for_all_jobs(const std::string& text, PolyFormat format) {
  for (const bool mend : {false, true})
    for (const unsigned jobs : job_counts) EXPECT_EQ(outcome(text, format, jobs, mend), outcome(text, format, 1, mend)) << jobs << " threads, mending " << mend;
  return outcome(text, format, 1, true);
}

// A bumpy sphere of quadrilaterals that are in no plane, and triangles at the poles; fractions with 1 to 6 decimals.
std::vector<std::string> sphere_lines(int rows, int columns, bool colours) {
  std::vector<std::string> lines{std::to_string(rows * columns + 2) + " " + std::to_string((rows + 1) * columns) + " 0"};
  const auto add_vertex = [&](double polar, double around, int decimals) {
    const double r = 100 + 5 * std::sin(7 * polar) * std::cos(5 * around);
    char line[100];
    std::snprintf(line, sizeof line, "%.*f %.*f %.*f", decimals, r * std::sin(polar) * std::cos(around), decimals, r * std::sin(polar) * std::sin(around),
                  decimals, r * std::cos(polar));
    lines.emplace_back(line);
  };
  constexpr double pi = 3.14159265358979;
  add_vertex(0, 0, 6);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) add_vertex(pi * (row + 1) / (rows + 1), 2 * pi * column / columns, 1 + row * 5 / rows);
  add_vertex(pi, 0, 6);
  const auto at = [&](int row, int column) {
    if (row < 0) return 0;
    return row == rows ? rows * columns + 1 : 1 + row * columns + column % columns;
  };
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      std::string line = row == 0 || row == rows ? "3 " : "4 ";
      line += std::to_string(at(row - 1, column)) + " " + std::to_string(at(row, column));
      if (row < rows) line += " " + std::to_string(at(row, column + 1));
      if (row > 0) line += " " + std::to_string(at(row - 1, column + 1));
      if (colours) line += row % 3 == 0 ? " 255 0 0" : row % 3 == 1 ? " 0 0 255" : "";
      lines.push_back(line);
    }
  }
  return lines;
}

std::string text_of(const std::vector<std::string>& lines, const std::string& end = "\n") {
  std::string text = "OFF" + end;
  for (const std::string& line : lines) text += line + end;
  return text;
}

TEST(ReadingWithThreads, OffHasTheSameVerticesFacesColoursAndPrecision) {
  for (const bool colours : {false, true}) {
    const std::vector<std::string> lines = sphere_lines(30, 40, colours);
    const std::string read = expect_equal_for_all_jobs(text_of(lines), PolyFormat::off);
    EXPECT_EQ(read.find("error"), std::string::npos);
    EXPECT_EQ(read.find("material_of") != std::string::npos, colours);
    EXPECT_EQ(expect_equal_for_all_jobs(text_of(lines, "\r\n"), PolyFormat::off), read);
    EXPECT_EQ(expect_equal_for_all_jobs(text_of(lines, "\r"), PolyFormat::off), read) << "the whole text is one part";
    // Lines between which nothing can be cut.
    std::vector<std::string> strange;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const std::size_t blank = lines[i].find(' ');
      if (i % 5 == 1) strange.push_back("# a comment \\");
      if (i % 5 == 2) strange.push_back(i % 2 == 0 ? "" : "\t");
      if (i % 3 != 0 || i == 0) strange.push_back(lines[i]);
      else strange.insert(strange.end(), {lines[i].substr(0, blank) + " \\", lines[i].substr(blank) + "  # more"});
    }
    EXPECT_EQ(expect_equal_for_all_jobs(text_of(strange), PolyFormat::off), read);
  }
}

TEST(ReadingWithThreads, AFaultInALaterPartIsTheSameError) {
  const std::vector<std::string> good = sphere_lines(30, 40, false);
  const std::size_t late = good.size() * 3 / 4;
  std::vector<std::string> lines = good;
  lines[late] = "4 1 2 x 4";
  lines[late + 7] = "4 1 2 y 4";
  // With the line of OFF, lines[i] is line i + 2 of the file.
  EXPECT_EQ(expect_equal_for_all_jobs(text_of(lines), PolyFormat::off).find("error file: line " + std::to_string(late + 2) + ": found \"x\""), 0U);
  lines = good;
  lines[900] = "1 2";
  EXPECT_EQ(expect_equal_for_all_jobs(text_of(lines), PolyFormat::off).find("error file: line 902: found 2 numbers"), 0U);
  lines = good;
  lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(late));
  EXPECT_EQ(expect_equal_for_all_jobs(text_of(lines), PolyFormat::off).find("error file: end of file: found 1239 faces, expected 1240"), 0U);
  lines = good;
  lines.push_back("3 0 1 2");
  EXPECT_EQ(expect_equal_for_all_jobs(text_of(lines), PolyFormat::off).find("error file: line " + std::to_string(good.size() + 2) + ": found \"3\""), 0U);
  // What mending leaves out.
  lines = good;
  lines[1100] = "nan 1 2";
  lines[late] = "2 1 2";
  EXPECT_NE(expect_equal_for_all_jobs(text_of(lines), PolyFormat::off).find("with a coordinate that is no finite number"), std::string::npos);
}

TEST(ReadingWithThreads, DamageIsMendedInTheSameWay) {
  std::vector<std::string> lines = sphere_lines(30, 40, true);
  lines[0] = "1202 1246 0";
  const std::size_t middle = lines.size() - 300;
  lines.insert(lines.end(), {lines[middle], lines[middle + 80], "3 5 5 6", "3 700 701 700", "4 2 3 4 3", "3 1 2 3"});
  expect_equal_for_all_jobs(text_of(lines), PolyFormat::off);
  const auto boxes = generate_scene("boxes", 300, 5);
  ASSERT_TRUE(boxes);
  expect_equal_for_all_jobs(write_poly(*boxes, PolyFormat::off).value(), PolyFormat::off);
}

TEST(ReadingWithThreads, StlHasTheSameVerticesAndTheSameError) {
  const auto sphere = read_poly(text_of(sphere_lines(30, 40, false)), "sphere", PolyFormat::off, {.mend = true});
  ASSERT_TRUE(sphere);
  std::string stl = write_poly(sphere->scene, PolyFormat::stl).value();
  EXPECT_EQ(expect_equal_for_all_jobs(stl, PolyFormat::stl).find("error"), std::string::npos);
  const std::size_t triangles = (stl.size() - 84) / 50;
  // 0 and -0 are one coordinate.
  for (std::size_t t = 0; t < triangles; t += 3) stl.replace(84 + 50 * t + 12, 4, t % 2 == 0 ? std::string("\0\0\0\0", 4) : std::string("\0\0\0\x80", 4));
  expect_equal_for_all_jobs(stl, PolyFormat::stl);
  for (const std::size_t t : {triangles * 3 / 4, triangles * 3 / 4 + 5}) stl.replace(84 + 50 * t + 28, 4, std::string("\0\0\x80\x7f", 4));
  const std::string place = "byte " + std::to_string(84 + 50 * (triangles * 3 / 4) + 28);
  for (const unsigned jobs : {1U, 2U, 3U, 7U}) EXPECT_NE(outcome(stl, PolyFormat::stl, jobs, false).find(place), std::string::npos);
  EXPECT_NE(expect_equal_for_all_jobs(stl, PolyFormat::stl).find("2 faces with a coordinate that is no finite number"), std::string::npos);
}

TEST(ReadingWithThreads, PartsOfATextAreWholeLines) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += "line" + std::to_string(i) + (i % 7 == 0 ? " \\\n" : i % 5 == 0 ? "\r\n" : "\n");
  for (const std::string& whole : {text, text + "no end", std::string("one line"), std::string()}) {
    const std::string with_head = "head\n" + whole;
    PolyLines all(with_head, "file");
    ASSERT_TRUE(all.next());
    for (const std::size_t count : {1U, 2U, 9U, 500U}) {
      std::string joined;
      for (const std::string_view part : all.parts(count)) {
        const bool begins_a_line = joined.empty() || (joined.ends_with('\n') && !joined.ends_with("\\\n"));
        EXPECT_TRUE(begins_a_line || part.empty()) << joined.substr(joined.size() - 5);
        joined += part;
      }
      EXPECT_EQ(joined, whole);
    }
  }
}

TEST(ReadingWithThreads, LinesWithFieldsAreCountedAsTheyAreRead) {
  for (const std::string text : {"", "\n", "a", "a\n", "a\n\n b # c\n# d\n  # e\n\tf", "#\n#a\n a", " \n\t\n", "1.#QNAN 2\n#QNAN\n1.#x", "a\\\nb\nc\\\n# d\ne",
                                 "a\rb\r\nc\n\rd", "a\\", "\\\n\\\n", "\v\f\na"}) {
    std::size_t count = 0;
    for (PolyLines lines(text, "file"); lines.next();) ++count;
    EXPECT_EQ(count_lines(text), count) << text;
  }
}

TEST(EqualItems, TheFirstOfEachIsFoundWithEachNumberOfThreads) {
  std::mt19937 random(3);
  for (const std::size_t count : {0U, 1U, 2U, 500U, 5000U}) {
    std::vector<std::uint32_t> values(count);
    for (std::uint32_t& value : values) value = static_cast<std::uint32_t>(random() % 1000);
    std::vector<std::uint32_t> expected(count);
    std::map<std::uint32_t, std::uint32_t> seen;
    for (std::uint32_t i = 0; i < count; ++i) expected[i] = seen.try_emplace(values[i], i).first->second;
    const auto are_same = [&](std::uint32_t a, std::uint32_t b) { return values[a] == values[b]; };
    for (const unsigned jobs : {1U, 2U, 3U, 7U}) {
      EXPECT_EQ(first_of_same(count, [&](std::uint32_t i) { return std::uint64_t{values[i]}; }, are_same, jobs), expected);
      // All in one class, and different values with one key.
      EXPECT_EQ(first_of_same(count, [&](std::uint32_t i) { return std::uint64_t{values[i] % 2}; }, are_same, jobs), expected);
    }
  }
}

TEST(PooledPoints, AreNumberedInTheOrderInWhichTheyFirstCome) {
  std::mt19937 random(4);
  std::vector<std::array<double, 3>> points(5000);
  for (auto& p : points) p = {random() % 2 == 0 ? 0.0 : -0.0, static_cast<double>(random() % 40), static_cast<double>(random() % 40)};
  std::vector<std::array<double, 3>> different;
  std::vector<VertexIndex> numbers;
  for (const auto& p : points) {
    const auto found = std::find(different.begin(), different.end(), p);
    numbers.push_back(static_cast<VertexIndex>(found - different.begin()));
    if (found == different.end()) different.push_back(p);
  }
  for (const unsigned jobs : {1U, 2U, 3U, 7U, 300U}) {
    std::vector<std::array<double, 3>> vertices;
    std::vector<VertexIndex> taken(points.size());
    pool_points<double>(points.size(), [&](std::size_t i) { return points[i]; }, 10, jobs, vertices, [&](std::size_t i, VertexIndex v) { taken[i] = v; });
    EXPECT_EQ(vertices, different) << jobs;
    EXPECT_EQ(taken, numbers) << jobs;
  }
}

}  // namespace
}  // namespace sightline::scene
