// Quotations from the papers, with their places: papers.json, each claim once. The report uses all of them; the
// tables of `compare` show each method's time from its paper.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace sightline::compare {

// papers.json, under its name.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> papers_file();

// What the paper says of the time of a program on its machine, in a few words with the year: "a few seconds, 1971".
// Empty if no paper mentions the method in this picture (MethodView::picture). Skala's time is that of lines on a
// board, "skala-8080" or "skala-8080 alt256".
[[nodiscard]] std::string paper_figure(std::string_view method, std::string_view picture);

}  // namespace sightline::compare
