// See papers.hpp.
#include "host/compare/papers.hpp"

#include <fmt/core.h>

#include <map>

#include "host/base/json.hpp"

namespace sightline::compare {
namespace {

std::map<std::string, std::string, std::less<>> times_of_methods() {
  std::map<std::string, std::string, std::less<>> times;
  const auto& [name, text] = papers_file().front();
  const auto document = base::parse_json(text, name);
  const base::Json* const papers = document ? document->find("papers") : nullptr;
  if (papers == nullptr) return times;  // the report reports the file's error
  for (const base::Json& paper : papers->elements()) {
    const base::Json* const claims = paper.find("claims");
    const base::Json* const year = paper.find("year");
    if (claims == nullptr || year == nullptr) continue;
    for (const auto& [key, claim] : claims->members()) {
      const base::Json* const method = claim.find("time_of");
      const base::Json* const words = claim.find("in_short");
      if (method == nullptr || words == nullptr || method->text() == nullptr || words->text() == nullptr) continue;
      times[*method->text()] = fmt::format("{}, {}", *words->text(), year->integer().value_or(0));
    }
  }
  return times;
}

}  // namespace

std::string paper_figure(std::string_view method, std::string_view picture) {
  static const auto times = times_of_methods();
  if (picture == "surface" || picture == "contours") return "";
  const auto known = times.find(method == "skala-8080 alt256" ? std::string_view("skala-8080") : method);
  return known == times.end() ? std::string() : known->second;
}

}  // namespace sightline::compare
