// JSON values: written with the same bytes as nlohmann::ordered_json, read with located errors.
#include "host/base/json.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "host/base/json_reader.hpp"

namespace sightline::base {
namespace {

using nlohmann::ordered_json;

std::string library_dump(const ordered_json& value, int indent) {
  return value.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

TEST(Json, WritesNumbersAsTheLibraryDoes) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    const double number = i % 2 == 0
                              ? std::bit_cast<double>(random())
                              : static_cast<double>(static_cast<std::int64_t>(random() % 2000000)) / 1000;
    ASSERT_EQ(Json(number).dump(), library_dump(number, -1));
  }
  for (const double number : {0.0, -0.0, 1.0, 1e15, 1e16, 123456.0, 1e-4, 1e-5, 5e-324,
                              std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(Json(number).dump(), library_dump(number, -1));
  EXPECT_EQ(Json(std::numeric_limits<double>::quiet_NaN()).dump(), "null");
  EXPECT_EQ(Json(std::numeric_limits<std::int64_t>::min()).dump(), "-9223372036854775808");
  EXPECT_EQ(Json(std::numeric_limits<std::uint64_t>::max()).dump(), "18446744073709551615");
}

TEST(Json, WritesStringsAsTheLibraryDoes) {
  std::mt19937 random(1);
  for (int i = 0; i < 5000; ++i) {
    std::string text(random() % 12, ' ');
    const unsigned range = i % 2 == 0 ? 256 : 128;
    for (char& c : text) c = static_cast<char>(random() % range);
    ASSERT_EQ(Json(text).dump(), library_dump(text, -1));
  }
  EXPECT_EQ(Json("\u00e9 \"\\/\n\x7f").dump(), library_dump("\u00e9 \"\\/\n\x7f", -1));
}

TEST(Json, WritesDocumentsAsTheLibraryDoes) {
  const std::vector<std::string> names{"a", "b"};
  const std::array<int, 3> point{1, -2, 3};
  Json ours = {{"schema", "s/1"}, {"names", names}, {"flag", true}, {"none", nullptr}};
  ordered_json theirs{{"schema", "s/1"}, {"names", names}, {"flag", true}, {"none", nullptr}};
  ours["box"] = Json::array({point, point});
  theirs["box"] = ordered_json::array({point, point});
  ours["empty"] = Json::array();
  theirs["empty"] = ordered_json::array();
  ours["nothing"] = Json::object();
  theirs["nothing"] = ordered_json::object();
  ours["rows"].push_back({{"x", 1.5}, {"deep", Json::array({Json::array({1}), Json()})}});
  theirs["rows"].push_back({{"x", 1.5}, {"deep", ordered_json::array({ordered_json::array({1}), nullptr})}});
  ours.update({{"flag", 7}, {"last", std::optional<int>()}});
  theirs.update({{"flag", 7}, {"last", nullptr}});
  for (const int indent : {-1, 0, 1, 2}) {
    const auto ours_indent = indent < 0 ? std::nullopt : std::optional(static_cast<unsigned>(indent));
    EXPECT_EQ(ours.dump(ours_indent), library_dump(theirs, indent));
  }
}

TEST(Json, CopiesAreIndependent) {
  Json first{{"list", Json::array({1, 2})}};
  Json second = first;
  second["list"].push_back(3);
  EXPECT_EQ(first.dump(), R"({"list":[1,2]})");
  EXPECT_EQ(second.dump(), R"({"list":[1,2,3]})");
}

TEST(Json, ReadsEveryKindOfValue) {
  const auto read = parse_json(R"({"n":null,"t":true,"i":-3,"u":18446744073709551615,"d":1.5e3,"s":"\u0041",)"
                               R"("a":[1,[2]],"o":{"x":1,"x":2}})",
                               "here");
  ASSERT_TRUE(read) << read.error().message();
  const Json& document = *read;
  EXPECT_TRUE(document.find("n")->is_null());
  EXPECT_EQ(document.find("t")->boolean(), true);
  EXPECT_EQ(document.find("i")->integer(), -3);
  EXPECT_EQ(document.find("u")->integer(), std::nullopt);
  EXPECT_EQ(document.find("d")->number(), 1500);
  EXPECT_EQ(document.find("d")->integer(), std::nullopt);
  EXPECT_EQ(*document.find("s")->text(), "A");
  EXPECT_EQ((*document.find("a"))[1][0].integer(), 2);
  EXPECT_EQ(document.find("o")->find("x")->integer(), 2) << "the last of several counts";
  EXPECT_EQ(document.find("z"), nullptr);
}

TEST(Json, ReportsThePositionOfAnError) {
  const auto read = parse_json("{\n \"a\": [1,\n 2,,]}", "room.json");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().file, "room.json");
  EXPECT_EQ(read.error().place, "line 3, column 4");
  EXPECT_TRUE(read.error().found.starts_with("syntax error while parsing value - unexpected ','"))
      << read.error().found;
  EXPECT_FALSE(parse_json("", "")) << "an empty text";
  EXPECT_FALSE(parse_json("1e999", "")) << "a number out of range";
}

TEST(Json, ReadsAndDestroysDeepNesting) {
  constexpr std::size_t levels = 1'000'000;
  std::string text;
  for (std::size_t i = 0; i < levels; ++i) text += i % 2 == 0 ? "[" : "{\"a\":";
  text += "1";
  for (std::size_t i = levels; i-- > 0;) text += i % 2 == 0 ? "]" : "}";
  const auto read = parse_json(text, "deep");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->size(), 1U);
}

TEST(JsonReader, RemembersTheFirstErrorAndItsPlace) {
  const Json document = *parse_json(R"({"size":[1,2,"x"],"name":"room","on":1})", "f");
  JsonReader reader("f");
  std::vector<std::int64_t> sizes;
  reader.each(*reader.field(document, "size", ""), "size", [&](const Json& value, const std::string& place) {
    sizes.push_back(reader.integer(value, place, 0, 9));
  });
  EXPECT_EQ(sizes, (std::vector<std::int64_t>{1, 2, 0}));
  EXPECT_EQ(reader.field(document, "missing", ""), nullptr);
  ASSERT_TRUE(reader.failed());
  EXPECT_EQ(reader.error().message(), "f: size[2]: expected an integer 0..9, found a string");
}

TEST(JsonReader, SaysWhatItExpected) {
  const Json document = *parse_json(R"({"size":[1,2],"name":"","on":1.5})", "f");
  const auto error_of = [&](auto&& read) {
    JsonReader reader("");
    read(reader);
    return reader.failed() ? reader.error().message() : "none";
  };
  EXPECT_EQ(error_of([&](JsonReader& r) { static_cast<void>(r.field(document, "missing", "here")); }),
            "here: expected a field \"missing\", found none");
  EXPECT_EQ(
      error_of([&](JsonReader& r) { static_cast<void>(r.optional_field(document, "missing", "here")); }),
      "none");
  EXPECT_EQ(error_of([&](JsonReader& r) { static_cast<void>(r.field(*document.find("size"), "x", "size")); }),
            "size: expected an object, found an array of 2");
  EXPECT_EQ(error_of([&](JsonReader& r) { r.array(*document.find("size"), "size", 3); }),
            "size: expected an array of 3, found an array of 2");
  EXPECT_EQ(error_of([&](JsonReader& r) { r.name(*document.find("name"), "name", 1, 40); }),
            "name: expected a string of 1 to 40 printable ASCII characters, found a string");
  EXPECT_EQ(error_of([&](JsonReader& r) { r.name(*document.find("name"), "name", 0, 40); }), "none");
  EXPECT_EQ(error_of([&](JsonReader& r) { r.boolean(*document.find("on"), "on"); }),
            "on: expected true or false, found 1.5");
}

}  // namespace
}  // namespace sightline::base
