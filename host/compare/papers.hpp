// What the papers say, word by word and with the place: papers.json, each claim once. The report reads all of it; of every method that
// has one, the figure for its time stands in the tables of compare.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace sightline::compare {

// papers.json, under its name.
[[nodiscard]] std::span<const std::pair<std::string_view, std::string_view>> papers_file();

// What the paper says of the time of a program on its machine, in few words with the year: "a few seconds, 1971". Empty if no paper speaks
// of the method in this picture (MethodView::picture): Skala's time is that of lines on a board, "skala-8080" or "skala-8080 alt256".
[[nodiscard]] std::string paper_figure(std::string_view method, std::string_view picture);

}  // namespace sightline::compare
