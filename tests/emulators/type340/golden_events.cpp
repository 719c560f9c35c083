// Reader of the Type 340 event files: see golden_events.hpp.
#include "tests/emulators/type340/golden_events.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>

namespace sightline::type340::testing {
namespace {

constexpr std::string_view flag_records[] = {"S1", "S0", "T1", "T0", "H1", "H0", "V1",
                                             "V0", "F1", "F0", "L1", "L0", "R"};

[[nodiscard]] bool read_header(std::istream& line, EventFile& file) {
  if (!(line >> file.id)) return false;
  LightPen pen;
  bool has_pen = false;
  for (std::string field; line >> field;) {
    const auto equals = field.find('=');
    if (equals == std::string::npos) return false;
    const std::string name = field.substr(0, equals);
    std::istringstream value(field.substr(equals + 1));
    char comma = ',';
    std::int64_t ns = 0;
    if (name == "pen") {
      has_pen = true;
      value >> pen.left >> comma >> pen.bottom >> comma >> pen.right >> comma >> pen.top;
    } else {
      value >> ns;
      if (name == "lat") file.latency = ns;
      if (name == "pendly") pen.delay = core::Duration(ns);
    }
    if (!value || comma != ',') return false;
  }
  if (has_pen) file.pen = pen;
  return true;
}

[[nodiscard]] bool read_words(std::istream& line, EventFile& file) {
  std::size_t segment = 0;
  std::int64_t delay = 0;
  if (!(line >> segment >> delay) || segment != file.segments.size()) return false;
  auto& words = file.segments.emplace_back();
  line >> std::oct;
  for (std::uint32_t word = 0; line >> word;) words.emplace_back(word);
  return !words.empty() && line.eof();
}

// Directions are numbered as on a numeric keypad.
[[nodiscard]] bool read_flashes(std::istream& line, EventFile& file) {
  std::int64_t t = 0;
  std::int64_t k = 0;
  int x = 0;
  int y = 0;
  int intensity = 0;
  if (!(line >> t >> k >> x >> y >> intensity)) return false;
  const auto add = [&] {
    file.events.push_back(
        {t, "I " + std::to_string(x) + ' ' + std::to_string(y) + ' ' + std::to_string(intensity)});
  };
  add();
  int step = 0;
  std::string keys;
  if (!(line >> step >> keys)) return true;
  for (const char key : keys) {
    if (key < '1' || key > '9') return false;
    x += ((key - '1') % 3 - 1) * step;
    y += ((key - '1') / 3 - 1) * step;
    t += 1500;
    add();
  }
  return true;
}

[[nodiscard]] bool read_timed(const std::string& record, std::istream& line, EventFile& file) {
  Event event{0, record};
  std::int64_t k = 0;
  if (!(line >> event.time >> k)) return false;
  for (std::string rest; line >> rest;) event.text += ' ' + rest;
  file.events.push_back(event);
  return true;
}

[[nodiscard]] bool read_record(const std::string& record, std::istream& line, EventFile& file) {
  if (record == "W") return read_words(line, file);
  if (record == "I") return read_flashes(line, file);
  if (record == "X") {
    line >> std::ws;
    return static_cast<bool>(std::getline(line, file.final_state));
  }
  const bool flag = std::ranges::find(flag_records, record) != std::end(flag_records);
  return (flag || record == "G" || record == "Q") && read_timed(record, line, file);
}

}  // namespace

EventFiles read_event_files(const std::filesystem::path& path) {
  EventFiles result;
  std::ifstream in(path);
  if (!in) result.error = path.string() + ": cannot be read";
  int number = 0;
  for (std::string text; result.error.empty() && std::getline(in, text);) {
    ++number;
    if (text.empty() || text[0] == '#') continue;
    std::istringstream line(text);
    std::string record;
    line >> record;
    if (record == "FILE") result.files.emplace_back();
    const bool good = record == "FILE" ? read_header(line, result.files.back())
                                       : !result.files.empty() && read_record(record, line, result.files.back());
    if (!good) {
      result.error = path.string() + ':' + std::to_string(number) + ": found \"" + text.substr(0, 60) +
                     "\", expected a record of FORMAT.md";
    }
  }
  for (EventFile& file : result.files) std::ranges::sort(file.events);
  return result;
}

}  // namespace sightline::type340::testing
