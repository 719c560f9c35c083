#include "host/explain/lesson.hpp"

#include <cmath>

namespace sightline::explain {
namespace {

using base::Json;

// Four decimals are finer than any sheet shows and keep the file short.
double rounded(double value) {
  const double thousandths = std::round(value * 10000) / 10000;
  return thousandths == 0 ? 0 : thousandths;
}

std::string_view name_of(Mark::Kind kind) {
  switch (kind) {
    case Mark::Kind::line: return "line";
    case Mark::Kind::area: return "area";
    case Mark::Kind::dot: return "dot";
    case Mark::Kind::text: return "text";
    case Mark::Kind::label: return "label";
  }
  return "";
}

Json number(double value) {
  const double shown = rounded(value);
  if (shown == std::floor(shown) && std::abs(shown) < 1e15) return static_cast<std::int64_t>(shown);
  return shown;
}

Json pair_of(const Point& point) { return Json::array({number(point[0]), number(point[1])}); }

// ["line", "seen", x, y, x, y]; a text or label ends with its words.
Json mark_of(const Mark& mark) {
  Json json = Json::array({name_of(mark.kind), name_of(mark.look)});
  for (const Point& point : mark.points) {
    json.push_back(number(point[0]));
    json.push_back(number(point[1]));
  }
  if (mark.kind == Mark::Kind::text || mark.kind == Mark::Kind::label) json.push_back(mark.text);
  return json;
}

Json step_of(const Step& step) {
  Json counts = Json::object();
  for (const Count& count : step.counts) counts[count.name] = count.value;
  Json layers = Json::array();
  for (const Layer& layer : step.changes) {
    Json marks = Json::array();
    for (const Mark& mark : layer.marks) marks.push_back(mark_of(mark));
    layers.push_back(Json{{"sheet", layer.sheet}, {"name", layer.name}, {"marks", std::move(marks)}});
  }
  return Json{{"caption", step.caption}, {"section", step.section}, {"counts", std::move(counts)}, {"layers", std::move(layers)}};
}

}  // namespace

std::string_view name_of(Look look) {
  switch (look) {
    case Look::faint: return "faint";
    case Look::plain: return "plain";
    case Look::now: return "now";
    case Look::other: return "other";
    case Look::seen: return "seen";
    case Look::hidden: return "hidden";
    case Look::waiting: return "waiting";
    case Look::mask: return "mask";
  }
  return "";
}

std::string json_of(const Lesson& lesson) {
  Json sheets = Json::array();
  for (const Sheet& sheet : lesson.sheets) {
    sheets.push_back(Json{{"title", sheet.title},
                          {"low", pair_of(sheet.low)},
                          {"high", pair_of(sheet.high)},
                          {"stretched", sheet.stretched}});
  }
  Json steps = Json::array();
  for (const Step& step : lesson.steps) steps.push_back(step_of(step));
  return Json{{"schema", "sightline/explain/1"},
              {"algorithm", lesson.algorithm},
              {"title", lesson.title},
              {"scene", lesson.scene},
              {"sheets", std::move(sheets)},
              {"steps", std::move(steps)}}
      .dump();
}

}  // namespace sightline::explain
