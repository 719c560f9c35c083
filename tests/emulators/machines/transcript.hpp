// Reads the hand-written bus transcripts of tests/data/transcripts (format: README.md there).
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace sightline::tests {

struct TranscriptCase {
  std::string file;
  int line = 0;
  std::string name;
  std::vector<std::string> rows;
  std::vector<std::string> options;  // one whole line each
  std::vector<std::pair<std::string, std::uint32_t>> set;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> core;  // address, word
  std::uint64_t run = 0;
  std::vector<std::string> events;  // repeated blanks reduced to one
  std::vector<std::pair<std::string, std::uint32_t>> end;
};

inline std::uint32_t octal(const std::string& text) {
  return static_cast<std::uint32_t>(std::stoul(text, nullptr, 8));
}

namespace detail {

inline std::vector<std::pair<std::string, std::uint32_t>> assignments(std::istringstream& words) {
  std::vector<std::pair<std::string, std::uint32_t>> result;
  for (std::string word; words >> word;) {
    const auto equals = word.find('=');
    result.emplace_back(word.substr(0, equals), octal(word.substr(equals + 1)));
  }
  return result;
}

inline void read_line(TranscriptCase& current, const std::string& text) {
  std::istringstream words(text);
  std::string first;
  words >> first;
  std::string rest;
  if (first == "row") {
    while (words >> rest) current.rows.push_back(rest);
  } else if (first == "option") {
    std::getline(words >> std::ws, rest);
    current.options.push_back(rest);
  } else if (first == "set") {
    for (auto& a : assignments(words)) current.set.push_back(a);
  } else if (first == "end") {
    current.end = assignments(words);
  } else if (first == "core") {
    words >> rest;
    std::uint32_t address = octal(rest);
    while (words >> rest) current.core.emplace_back(address++, octal(rest));
  } else if (first == "run") {
    words >> current.run;
  } else if (first[0] >= '0' && first[0] <= '9') {
    std::string event = first;
    while (words >> rest) event += " " + rest;
    current.events.push_back(event);
  } else {
    throw std::runtime_error(current.file + ": not a transcript line: " + text);
  }
}

}  // namespace detail

inline std::vector<TranscriptCase> read_transcripts(const std::filesystem::path& folder) {
  std::map<std::string, std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".txt") files.emplace(entry.path().filename().string(), entry.path());
  }
  std::vector<TranscriptCase> cases;
  for (const auto& [name, path] : files) {
    std::ifstream in(path);
    int number = 0;
    for (std::string text; std::getline(in, text);) {
      ++number;
      if (text.empty() || text[0] == '#') continue;
      if (text.rfind("case ", 0) == 0) {
        cases.push_back({});
        cases.back().file = name;
        cases.back().line = number;
        cases.back().name = text.substr(5);
      } else {
        detail::read_line(cases.back(), text);
      }
    }
  }
  return cases;
}

}  // namespace sightline::tests
