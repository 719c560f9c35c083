#include "tests/support/read_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace sightline::tests {

DrawnLines lines_of_svg(const std::string& svg, double paper_height) {
  DrawnLines lines;
  for (std::size_t at = svg.find(" d=\""); at != std::string::npos; at = svg.find(" d=\"", at + 1)) {
    const std::string text = svg.substr(at + 4, svg.find('"', at + 4) - at - 4);
    double x = 0;
    double y = 0;
    for (const char* next = text.c_str(); *next != 0 && *next != 'z';) {
      const bool begins = *next == 'M';
      if (begins) {
        lines.emplace_back();
        x = y = 0;
      }
      char* end = nullptr;
      x += std::strtod(begins || *next == 'l' ? next + 1 : next, &end);
      y += std::strtod(end, &end);
      lines.back().push_back({x, paper_height - y});
      next = end;
    }
  }
  return lines;
}

DrawnLines lines_of_pdf(const std::string& pdf) {
  const std::size_t stream = pdf.find("stream\n") + 7;
  const auto length = static_cast<std::size_t>(std::atol(pdf.c_str() + pdf.find("/Length ") + 8));
  DrawnLines lines;
  std::istringstream words(pdf.substr(stream, length));
  std::array<std::string, 2> before;
  for (std::string word; words >> word;) {
    if (word == "m" || word == "l") {
      if (word == "m") lines.emplace_back();
      lines.back().emplace_back(std::atof(before[0].c_str()), std::atof(before[1].c_str()));
    }
    before = {before[1], word};
  }
  return lines;
}

DrawnLines lines_of_dxf(const std::string& dxf) {
  std::istringstream text(dxf);
  DrawnLines lines;
  std::string entity;
  double x = 0;
  for (std::string code, value; std::getline(text, code) && std::getline(text, value);) {
    const int group = std::atoi(code.c_str());
    if (group == 0) entity = value;
    if (group == 0 && (value == "POLYLINE" || value == "POINT")) lines.emplace_back();
    if (entity != "VERTEX" && entity != "POINT") continue;
    if (group == 10) x = std::atof(value.c_str());
    if (group == 20) lines.back().emplace_back(x, std::atof(value.c_str()));
  }
  return lines;
}

DrawnLines lines_of_hpgl(const std::string& hpgl) {
  DrawnLines lines;
  std::istringstream commands(hpgl);
  std::pair<double, double> pen;
  bool down = false;
  for (std::string command; std::getline(commands, command, ';');) {
    command.erase(0, command.find_first_not_of("\r\n "));
    const std::string name = command.substr(0, 2);
    if (name != "PU" && name != "PD") continue;
    std::istringstream numbers(command.substr(2));
    if (name == "PD" && !down) lines.push_back({pen});
    down = name == "PD";
    for (std::string x, y; std::getline(numbers, x, ',') && std::getline(numbers, y, ',');) {
      pen = {std::atof(x.c_str()), std::atof(y.c_str())};
      if (down) lines.back().push_back(pen);
    }
  }
  return lines;
}

DrawnLines lines_of_steps(const std::string& steps) {
  // Clockwise from +y; then pen up, pen down and the end of the file (emulators/devices/calcomp565.hpp).
  constexpr std::array<std::array<int, 2>, 8> directions{{{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};
  DrawnLines lines;
  std::pair<double, double> pen;
  bool down = false;
  for (const char c : steps) {
    const auto code = static_cast<unsigned char>(c);
    if (code < directions.size()) {
      pen.first += directions[code][0];
      pen.second += directions[code][1];
      if (down) lines.back().push_back(pen);
    } else if (code != 0xff) {
      const bool lowers = code == 9;
      if (lowers && !down) lines.push_back({pen});
      down = lowers;
    }
  }
  return lines;
}

std::vector<DrawnSegment> segments_of(const DrawnLines& lines) {
  std::vector<DrawnSegment> segments;
  for (const DrawnLine& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i)
      segments.push_back({line[i - 1].first, line[i - 1].second, line[i].first, line[i].second});
  return segments;
}

double distance_to(const DrawnSegment& segment, double x, double y) {
  const double across = segment[2] - segment[0];
  const double up = segment[3] - segment[1];
  const double square = across * across + up * up;
  double t = square > 0 ? ((x - segment[0]) * across + (y - segment[1]) * up) / square : 0;
  t = std::clamp(t, 0.0, 1.0);
  return std::hypot(segment[0] + t * across - x, segment[1] + t * up - y);
}

double distance_from(const std::vector<DrawnSegment>& others, const DrawnSegment& segment) {
  double farthest = 0;
  for (const double t : {0.0, 0.5, 1.0}) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const DrawnSegment& other : others)
      nearest = std::min(nearest, distance_to(other, segment[0] + t * (segment[2] - segment[0]), segment[1] + t * (segment[3] - segment[1])));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

}  // namespace sightline::tests
