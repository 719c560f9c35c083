// A small report: every kind of block and cell, and text that is difficult for HTML, CSV and gnuplot.
#pragma once

#include <limits>
#include <string>

#include "host/report/document.hpp"

namespace sightline::report {

inline const std::string nasty = "<b>\"A & B\", 'C'</b>\r\n`id`";

inline Table sample_table() {
  Table table;
  table.id = "sample";
  table.title = nasty;
  table.columns = {{"name", "Name", ""},
                   {"count", "Count", "words"},
                   {"view_s", "View", "s"},
                   {"host_ns", "Host", "ns"},
                   {"right", "Right", ""}};
  table.rows = {
      {nasty, std::int64_t{1048576}, Real{0.1, 3}, Real{1e9}, Verdict{true, "yes"}},
      {std::string("plain"), std::int64_t{-12}, std::monostate{}, Real{0.5}, Verdict{false, "no, 3 px"}},
      {std::string(), std::int64_t{0}, Real{std::numeric_limits<double>::infinity()}, Real{2},
       std::monostate{}}};
  table.notes = {"A note with <angles>."};
  return table;
}

inline Figure sample_figure(const std::string& id) {
  return {id, nasty, "Caption", "Alt \"text\"", "image/png", {0x89, 'P', 'N', 'G'}, true};
}

inline Table sample_cards() {
  Table table;
  table.id = "cards-sample";
  table.title = "Cards";
  table.columns = {{"name", "Name", ""}, {"right", "Right", ""}};
  table.rows = {{std::string("A"), Verdict{true, "yes"}}, {std::string("B"), Verdict{false, "no"}}};
  table.cards_name = nasty;
  table.cards = {{{"", "correct", {}, "correct", "image/png", {1}, false}}, {}};
  return table;
}

inline Panel sample_panel() {
  return {"panel", CheckedText(nasty), nasty, {{nasty, "1 s"}}, {nasty}, {}};
}

inline Section sample_section() {
  Section section{"sample-part", nasty, {}};
  section.blocks.emplace_back(Paragraph{nasty});
  section.blocks.emplace_back(Heading{"A heading", "chapter"});
  section.blocks.emplace_back(sample_table());
  section.blocks.emplace_back(sample_figure("figure"));
  section.blocks.emplace_back(Gallery{"gallery", "Gallery", {sample_figure("small"), sample_figure("smaller")}});
  section.blocks.emplace_back(sample_panel());
  section.blocks.emplace_back(sample_cards());
  return section;
}

inline Report sample_report() {
  return {nasty, "0.0", {"Introduction."}, {sample_section()}};
}

}  // namespace sightline::report
