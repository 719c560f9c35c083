#include "facts.hpp"

#include <fmt/core.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <map>

#include "assembler_facts.hpp"
#include "host/machines/machine.hpp"
#include "host/scene/generate/scene.hpp"
#include "host/scene/heights/function.hpp"
#include "host/scene/read/builtin.hpp"
#include "i8080_facts.hpp"
#include "pdp7_facts.hpp"
#include "snapshot_facts.hpp"
#include "table.hpp"

namespace sightline::manual {
namespace {

using Text = base::Result<std::string>;

Text read(const std::string& root, const std::string& path) {
  std::ifstream file(root + "/" + path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file || text.empty()) return base::Error{.file = path, .found = "cannot be read, or is empty"};
  return text;
}

// "PATH", or "PATH from WORD": the file from the line that begins with WORD.
Text source(const std::string& root, const std::string& what) {
  constexpr std::string_view from = " from ";
  const std::string path = what.substr(0, what.find(from));
  auto text = read(root, path);
  if (!text) return text;
  if (path.size() < what.size()) {
    const std::string word = what.substr(path.size() + from.size());
    const std::size_t line = text.value().find("\n" + word);
    if (line == std::string::npos) return base::Error{.file = path, .found = "no line that begins with " + word};
    text = text.value().substr(line + 1);
  }
  const std::string language = path.ends_with(".cpp") ? "cpp" : path.ends_with(".txt") ? "cmake" : "";
  return "```" + language + "\n" + text.value() + "```\n";
}

// The program formats that `run` loads and `asm` writes.
std::string program_formats() {
  Table table{"machine", "format", "told by"};
  for (const auto* machine : machines::machines()) {
    for (const auto& format : machine->formats) {
      table.row({std::string(machine->name), code(format.name),
                 format.ending.empty() ? "its content" : "the ending " + code(format.ending)});
    }
  }
  return table.text();
}

// The meaning of the registers, in the order of a dump.
std::string registers() {
  Table table{"machine", "register", "bits", "in a dump"};
  for (const auto* machine : machines::machines()) {
    for (const auto& row : machine->registers) {
      table.row({std::string(machine->name), code(row.name), fmt::format("{}", row.bits), row.in_dump ? "yes" : ""});
    }
  }
  return table.text();
}

std::string height_functions() {
  Table table{"name", "x and z", "formula", "what it is"};
  for (const scene::HeightFunction& row : scene::height_functions()) {
    table.row({code(row.name), fmt::format("{:g} to {:g}", row.domain.low, row.domain.high), code(row.formula),
               std::string(row.description)});
  }
  return table.text();
}

std::string scene_names() {
  std::string text = "Built in:";
  for (const std::string_view name : scene::builtin_scene_names()) text += " " + code(name);
  text += " (cells), and the models of Table 1 of Plantinga, Seales and Dyer (1990):";
  for (const std::string_view name : scene::builtin_model_names()) text += " " + code(name);
  text += ". Families, written FAMILY-SIZE or FAMILY-SIZE-SEED:";
  for (const std::string_view name : scene::generator_names()) text += " " + code(name);
  return text + ".\n";
}

const std::map<std::string, std::function<Text(const std::string& root)>, std::less<>>& sections() {
  const auto plain = [](std::string (*make)()) { return [make](const std::string&) { return Text(make()); }; };
  static const std::map<std::string, std::function<Text(const std::string&)>, std::less<>> all{
      {"pdp7-instructions", plain(pdp7_instructions)},
      {"pdp7-operate", plain(pdp7_operate)},
      {"pdp7-eae", plain(pdp7_eae)},
      {"pdp7-iots", plain(pdp7_iots)},
      {"pdp7-status", plain(pdp7_status)},
      {"pdp7-timing", plain(pdp7_timing)},
      {"type340-modes", plain(type340_modes)},
      {"type340-times", plain(type340_times)},
      {"type340-codes", plain(type340_codes)},
      {"i8080-effects", plain(i8080_effects)},
      {"i8080-instructions", plain(i8080_instructions)},
      {"i8080-ports", plain(i8080_ports)},
      {"ef9365-status", plain(ef9365_status)},
      {"board-times", plain(board_times)},
      {"calcomp-status", plain(calcomp_status)},
      {"i8251-status", plain(i8251_status)},
      {"pdp7-refused", [](const std::string&) { return pdp7_refused(); }},
      {"bell-refused", [](const std::string&) { return bell_refused(); }},
      {"i8080-refused", [](const std::string&) { return i8080_refused(); }},
      {"pdp7-pseudo-operations",
       [](const std::string& root) {
         const auto text = read(root, "tools/asm/pdp7/pseudo.cpp");
         return text ? pdp7_pseudo_operations(text.value()) : text;
       }},
      {"i8080-dialects", plain(i8080_dialects)},
      {"i8080-directives",
       [](const std::string& root) {
         const auto text = read(root, "tools/asm/i8080/vocabulary.cpp");
         return text ? i8080_directives(text.value()) : text;
       }},
      {"program-formats", plain(program_formats)},
      {"registers", plain(registers)},
      {"height-functions", plain(height_functions)},
      {"scene-names", plain(scene_names)},
      {"snapshot-pdp7", plain(snapshot_pdp7)},
      {"snapshot-i8080", plain(snapshot_i8080)},
  };
  return all;
}

}  // namespace

Text section(std::string_view name, const std::string& root) {
  constexpr std::string_view file_prefix = "source ";
  constexpr std::string_view word_prefix = "type340-word-";
  if (name.starts_with(file_prefix)) return source(root, std::string(name.substr(file_prefix.size())));
  if (name.starts_with(word_prefix) && name.size() == word_prefix.size() + 1 && name.back() >= '0' &&
      name.back() <= '7')
    return type340_words(static_cast<std::size_t>(name.back() - '0'));
  const auto found = sections().find(name);
  if (found != sections().end()) return found->second(root);
  std::string names = "source PATH, source PATH from WORD, type340-word-0 to type340-word-7";
  for (const auto& [known, make] : sections()) names += ", " + known;
  return base::Error{.found = "section \"" + std::string(name) + "\"", .expected = "one of " + names};
}

}  // namespace sightline::manual
