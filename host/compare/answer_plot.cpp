// See answer_plot.hpp.
#include "host/compare/answer_plot.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "host/base/number.hpp"
#include "host/base/text.hpp"
#include "host/picture/svg.hpp"

namespace sightline::compare {
namespace {

using picture::xml_text;

// In the drawing's units, of which a panel is `panel_width` wide: letters of 13 are 11 pixels high at a width of 350
// pixels.
constexpr double panel_width = 410;
constexpr double letter_height = 15;
constexpr double letter_width = 7.3;  // average of common letters, rounded up
constexpr double bold_width = 8.2;
constexpr double left_end = 62;
constexpr double right_end = 402;
constexpr double top_end = 56;
constexpr double bottom_end = 318;
constexpr double row_height = 19;  // of the strip
constexpr double mark_size = 5;

// Okabe and Ito's colours (2008), with those that would be too pale for text darkened; then the ones for dark
// backgrounds.
struct SeriesColour {
  std::string_view light;
  std::string_view dark;
};
constexpr std::array<SeriesColour, 8> colours{{{"#0072b2", "#6cc0f5"},
                                               {"#b84e00", "#ff9d5c"},
                                               {"#007a58", "#3fd0a4"},
                                               {"#a8467c", "#eba6cc"},
                                               {"#444444", "#d0d0d0"},
                                               {"#8a6400", "#f0c040"},
                                               {"#5b4bb0", "#b3a8ff"},
                                               {"#a01c1c", "#ff9a92"}}};

std::string style_text() {
  std::string light =
      "text{font:13px system-ui,'Segoe UI','DejaVu Sans',sans-serif;fill:#1d1f21;stroke:none}"
      ".b{font-weight:650}.q{fill:#5c6166}.e{text-anchor:end}.m{text-anchor:middle}"
      ".o{stroke:#ffffff;stroke-width:4px;stroke-linejoin:round;fill:none}"
      ".g{fill:#ffffff}.r{stroke:#dcdcd6;stroke-width:1;fill:none}.x{stroke:#5c6166;stroke-width:1;fill:none}.z{fill:#f3f3ed}";
  std::string dark =
      "text{fill:#e4e4df}.q{fill:#a2a7ab}.o{stroke:#17191b}.g{fill:#17191b}.r{stroke:#303438}.x{stroke:#a2a7ab}.z{fill:#202326}";
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const auto rules = [i](std::string_view colour, std::string_view ground) {
      return fmt::format(
          "text.c{0}{{fill:{1}}}.l{0}{{stroke:{1};stroke-width:1.6;fill:none}}.f{0}{{stroke:{1};stroke-width:1.6;fill:{1}}}"
          ".h{0}{{stroke:{1};stroke-width:1.6;fill:{2}}}",
          i, colour, ground);
    };
    light += rules(colours[i].light, "#ffffff");
    dark += rules(colours[i].dark, "#17191b");
  }
  // The rules apply to this drawing only: a page has its own.
  std::string text = "<style>";
  const auto add_scoped = [&text](std::string_view rules) {
    while (!rules.empty()) {
      const std::size_t end = rules.find('}') + 1;
      text += ".answer-plot ";
      text += rules.substr(0, end);
      rules.remove_prefix(end);
    }
  };
  add_scoped(light);
  text += "@media (prefers-color-scheme:dark){";
  add_scoped(dark);
  return text + "}</style>\n";
}

struct Place {
  double x = 0;
  double y = 0;
};

struct Box {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;

  [[nodiscard]] bool meets(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

double width_of(std::string_view text, bool bold = false) {
  return (bold ? bold_width : letter_width) * static_cast<double>(text.size()) + 2;
}

// The mark of a series, centred on (0, 0).
std::string mark_path(std::size_t series) {
  constexpr std::array<std::string_view, 8> paths{"M-5,0a5,5 0 1,0 10,0a5,5 0 1,0 -10,0Z",               // circle
                                                  "M-4.5,-4.5H4.5V4.5H-4.5Z",                            // square
                                                  "M0,-6L5.5,4.5H-5.5Z",                                 // triangle
                                                  "M0,-6.5L6.5,0L0,6.5L-6.5,0Z",                         // diamond
                                                  "M0,6L5.5,-4.5H-5.5Z",                                 // triangle on its tip
                                                  "M-2,-6H2V-2H6V2H2V6H-2V2H-6V-2H-2Z",                  // cross
                                                  "M-6,-2.5L-2.5,-6H2.5L6,-2.5V2.5L2.5,6H-2.5L-6,2.5Z",  // octagon
                                                  "M-6,-5H6L0,0L6,5H-6L0,0Z"};                           // hourglass
  return std::string(paths[series % paths.size()]);
}

std::string number_text(double value) {
  std::string text = fmt::format("{:.3g}", value);
  if (const std::size_t at = text.find("e-0"); at != std::string::npos) text.erase(at + 2, 1);
  return text;
}

// ASCII except for the micro sign.
std::string time_text(double seconds) {
  std::string text = base::time_text(seconds);
  if (text.ends_with(" us")) text.replace(text.size() - 2, 2, "&#181;s");
  return text;
}

// A logarithmic axis whose ends are 1, 2 or 5 times a power of 10.
class Axis {
 public:
  // There is at least one value, and all are greater than 0 (precondition).
  Axis(const std::vector<double>& values, double from, double to) : from_(from), to_(to) {
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    low_ = step_of(*least * 0.8, false);
    high_ = step_of(*greatest * 1.25, true);
    if (high_ - low_ < 3) {  // at least a decade
      --low_;
      high_ = low_ + 3;
    }
  }

  [[nodiscard]] double place(double value) const {
    const double part = (std::log10(value) - std::log10(step(low_))) / (std::log10(step(high_)) - std::log10(step(low_)));
    return from_ + part * (to_ - from_);
  }
  // At most `most` marks, so that they can be labelled.
  [[nodiscard]] std::vector<double> marks(int most) const {
    std::vector<double> all;
    for (const int each : {1, 3, 6, 9}) {
      all.clear();
      for (int n = low_; n <= high_; ++n)
        if (((n % each) + each) % each == 0) all.push_back(step(n));
      if (static_cast<int>(all.size()) <= most) break;
    }
    return all;
  }

 private:
  // By number: step 0 is 1, step 1 is 2, step 2 is 5, step 3 is 10.
  static double step(int n) {
    const int decade = n >= 0 ? n / 3 : -((2 - n) / 3);
    constexpr std::array<double, 3> parts{1, 2, 5};
    return parts[static_cast<std::size_t>(n - 3 * decade)] * std::pow(10.0, decade);
  }
  static int step_of(double value, bool above) {
    int n = 3 * static_cast<int>(std::floor(std::log10(value))) - 1;
    while (step(n) < value) ++n;  // the first step >= value
    return above || step(n) == value ? n : n - 1;
  }

  double from_;
  double to_;
  int low_ = 0;
  int high_ = 0;
};

// Smaller errors are in the strip, with their number: an error of a hundred-thousandth would only stretch the axis.
constexpr double least_percent = 1e-3;

bool in_strip(const PlotPoint& point) {
  return point.wrong_percent < least_percent;
}

bool drawable(const PlotPoint& point) {
  return std::isfinite(point.seconds) && point.seconds > 0 && std::isfinite(point.wrong_percent) && point.wrong_percent >= 0;
}

struct Series {
  std::string name;
  std::vector<PlotPoint> points;
  std::vector<Place> places;
  std::vector<std::size_t> front;

  [[nodiscard]] bool in_front(std::size_t point) const { return std::find(front.begin(), front.end(), point) != front.end(); }
  [[nodiscard]] std::string whole_name(std::size_t point) const {
    return points[point].label.empty() ? name : name + ", " + points[point].label;
  }
};

// One panel: from its points to the text of the drawing.
class Panel {
 public:
  Panel(const std::vector<PlotPoint>& points, PlotPanel panel) : panel_(panel) {
    for (const PlotPoint& point : points) {
      if (point.panel != panel || !drawable(point)) continue;
      const auto known = std::find_if(series_.begin(), series_.end(), [&](const Series& s) { return s.name == point.series; });
      Series& series = known != series_.end() ? *known : series_.emplace_back(Series{point.series, {}, {}, {}});
      series.points.push_back(point);
      seconds_.push_back(point.seconds);
      if (!in_strip(point)) wrong_.push_back(point.wrong_percent);
    }
    if (seconds_.empty()) {
      height_ = 90;
      text_ = heading() + fmt::format("<text class=\"q\" x=\"8\" y=\"56\">{}</text>\n",
                                      panel == PlotPanel::emulated ? "No old machine draws this."
                                                                   : "No times of this computer were measured.");
      return;
    }
    for (Series& series : series_) {
      series.front = front_of(series.points);
      series.places.resize(series.points.size());
    }
    draw();
  }

  [[nodiscard]] double height() const { return height_; }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] bool empty() const { return seconds_.empty(); }

 private:
  [[nodiscard]] std::string heading() const {
    return fmt::format("<text class=\"b\" x=\"8\" y=\"18\">{}</text>\n", panel_ == PlotPanel::emulated
                                                                             ? "Old machines: emulated time of a view"
                                                                             : "This computer: measured time of a view");
  }

  void draw() {
    const Axis across(seconds_, left_end + 14, right_end - 14);
    const double bottom = wrong_.empty() ? top_end - 8 : bottom_end;
    for (Series& series : series_)
      for (std::size_t i = 0; i < series.points.size(); ++i) series.places[i].x = across.place(series.points[i].seconds);
    std::string axes;
    if (!wrong_.empty()) {
      const Axis up(wrong_, bottom - 10, top_end + 10);
      for (Series& series : series_)
        for (std::size_t i = 0; i < series.points.size(); ++i)
          if (!in_strip(series.points[i])) series.places[i].y = up.place(series.points[i].wrong_percent);
      axes += fmt::format("<text class=\"q\" x=\"8\" y=\"{:.1f}\">different, % of the length seen, of faces of the picture</text>\n", top_end - 14);
      for (const double value : up.marks(7)) {
        const double y = up.place(value);
        base::append(axes,
                     "<path class=\"r\" d=\"M{:.1f},{:.1f}H{:.1f}\"/><text class=\"q e\" x=\"{:.1f}\" y=\"{:.1f}\">{} %</text>\n",
                     left_end, y, right_end, left_end - 6, y + 4.5, number_text(value));
      }
    }
    const double strip_top = bottom + 8;
    const std::string strip = strip_labels(strip_top);
    const double strip_bottom = strip_rows_ > 0 ? strip_top + row_height * strip_rows_ + 6 : bottom;
    for (const double value : across.marks(6)) {
      const double x = across.place(value);
      base::append(
          axes, "<path class=\"r\" d=\"M{0:.1f},{1:.1f}V{2:.1f}\"/><text class=\"q m\" x=\"{0:.1f}\" y=\"{3:.1f}\">{4}</text>\n",
          x, wrong_.empty() ? strip_top : top_end, strip_bottom, strip_bottom + 17, time_text(value));
    }
    if (!wrong_.empty())
      base::append(axes, "<path class=\"x\" d=\"M{0:.1f},{1:.1f}V{2:.1f}H{3:.1f}\"/>\n", left_end, top_end, bottom, right_end);
    std::string ground;
    if (strip_rows_ > 0) {
      ground = fmt::format("<rect class=\"z\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>\n", left_end,
                           strip_top, right_end - left_end, strip_bottom - strip_top);
      // A point that is not 0 has its number next to its name.
      const bool all_zero = std::all_of(series_.begin(), series_.end(), [](const Series& s) {
        return std::all_of(s.points.begin(), s.points.end(), [](const PlotPoint& p) { return !in_strip(p) || p.wrong_percent == 0; });
      });
      base::append(axes, "<text class=\"q e\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", left_end - 6, strip_top + 17, all_zero ? "0 %" : "near 0 %");
    }
    place_labels(bottom);
    text_ = heading() + ground + axes + fronts() + leaders_ + marks() + strip + labels_;
    height_ = strip_bottom + 26;
  }

  // Rows of marks, with the name on the side that has room.
  std::string strip_labels(double top) {
    struct Item {
      std::size_t series = 0;
      std::size_t point = 0;
    };
    std::vector<Item> items;
    for (std::size_t s = 0; s < series_.size(); ++s)
      for (std::size_t i = 0; i < series_[s].points.size(); ++i)
        if (in_strip(series_[s].points[i])) items.push_back({s, i});
    std::stable_sort(items.begin(), items.end(), [&](const Item& a, const Item& b) {
      return series_[a.series].points[a.point].seconds < series_[b.series].points[b.point].seconds;
    });
    std::vector<std::vector<std::pair<double, double>>> rows;
    std::string text;
    for (const Item& item : items) {
      Place& place = series_[item.series].places[item.point];
      std::string name = series_[item.series].whole_name(item.point);
      if (const double percent = series_[item.series].points[item.point].wrong_percent; percent > 0)
        name += fmt::format(" ({} %)", number_text(percent));
      const double width = width_of(name);
      const auto side = [&](bool right) {
        return right ? std::pair(place.x - mark_size - 2, place.x + 9 + width)
                     : std::pair(place.x - 9 - width, place.x + mark_size + 2);
      };
      std::optional<std::pair<std::size_t, bool>> found;
      for (std::size_t row = 0; !found; ++row) {
        if (row == rows.size()) rows.emplace_back();
        for (const bool right : {true, false}) {
          const auto [from, to] = side(right);
          // In a separate row, a name that fits on neither side goes to the one with more room.
          const bool fits = from >= left_end && to <= right_end;
          const bool more_room = right == (right_end - place.x > place.x - left_end);
          if (!fits && !(rows[row].empty() && more_room)) continue;
          if (std::any_of(rows[row].begin(), rows[row].end(),
                          [from = from, to = to](const auto& other) { return from < other.second && other.first < to; }))
            continue;
          found = {row, right};
          break;
        }
      }
      rows[found->first].push_back(side(found->second));
      place.y = top + 3 + row_height * (static_cast<double>(found->first) + 0.5);
      base::append(text, "<text class=\"c{}{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", item.series % colours.size(),
                   found->second ? "" : " e", found->second ? place.x + 9 : place.x - 9, place.y + 4.5, xml_text(name));
    }
    strip_rows_ = static_cast<int>(rows.size());
    return text;
  }

  [[nodiscard]] std::string fronts() const {
    std::string text;
    for (std::size_t s = 0; s < series_.size(); ++s) {
      const Series& series = series_[s];
      if (series.front.size() < 2) continue;
      std::string points;
      for (const std::size_t i : series.front)
        base::append(points, "{}{:.1f},{:.1f}", points.empty() ? "" : " ", series.places[i].x, series.places[i].y);
      base::append(text, "<polyline class=\"l{}\" points=\"{}\"/>\n", s % colours.size(), points);
    }
    return text;
  }

  [[nodiscard]] std::string marks() const {
    std::string text;
    for (std::size_t s = 0; s < series_.size(); ++s) {
      const Series& series = series_[s];
      for (std::size_t i = 0; i < series.points.size(); ++i) {
        const PlotPoint& point = series.points[i];
        const std::string different = point.wrong_percent > 0 ? number_text(point.wrong_percent) + " % different" : "nothing different";
        base::append(text,
                     "<path class=\"{}{}\" transform=\"translate({:.1f} {:.1f})\" d=\"{}\"><title>{}: {}, {}</title></path>\n",
                     series.in_front(i) ? 'f' : 'h', s % colours.size(), series.places[i].x, series.places[i].y, mark_path(s),
                     xml_text(series.whole_name(i)), time_text(point.seconds), different);
      }
    }
    return text;
  }

  // Puts the names of series and variants next to their marks, where nothing else is. A variant's name that has no
  // place is left out: it is in the mark's title.
  void place_labels(double bottom) {
    std::vector<Box> taken;
    for (const Series& series : series_) {
      for (std::size_t i = 0; i < series.points.size(); ++i)
        if (!in_strip(series.points[i]))
          taken.push_back({series.places[i].x - mark_size - 1, series.places[i].y - mark_size - 1,
                           series.places[i].x + mark_size + 1, series.places[i].y + mark_size + 1});
    }
    const Box inside{left_end + 2, top_end, right_end + 4, bottom - 1};
    const auto place = [&](const std::string& text, const Place& mark, double distance, bool bold, std::size_t series) {
      const double width = width_of(text, bold);
      const double d = distance + mark_size + 3;
      const double e = distance > 0 ? d * 0.7 : mark_size;
      struct Corner {
        double x;
        double y;
        double part;  // the part of the text's width that is left of its anchor
      };
      const std::array<Corner, 8> corners{{{mark.x + d, mark.y - letter_height / 2, 0},
                                           {mark.x - d, mark.y - letter_height / 2, 1},
                                           {mark.x + e, mark.y - e - letter_height, 0},
                                           {mark.x + e, mark.y + e, 0},
                                           {mark.x - e, mark.y - e - letter_height, 1},
                                           {mark.x - e, mark.y + e, 1},
                                           {mark.x, mark.y - d - letter_height, 0.5},
                                           {mark.x, mark.y + d, 0.5}}};
      for (const Corner& corner : corners) {
        const double left = corner.x - corner.part * width;
        const Box box{left, corner.y, left + width, corner.y + letter_height};
        if (box.left < inside.left || box.right > inside.right || box.top < inside.top || box.bottom > inside.bottom) continue;
        if (std::any_of(taken.begin(), taken.end(), [&](const Box& other) { return box.meets(other); })) continue;
        taken.push_back(box);
        const std::string at = fmt::format("x=\"{:.1f}\" y=\"{:.1f}\"", corner.x, corner.y + 11.5);
        const std::string shown = xml_text(text);
        const std::string classes = fmt::format("{}{}c{}",
                                                corner.part == 1  ? "e "
                                                : corner.part > 0 ? "m "
                                                                  : "",
                                                bold ? "b " : "", series % colours.size());
        base::append(labels_, "<text class=\"{0} o\" {1}>{2}</text><text class=\"{0}\" {1}>{2}</text>\n", classes, at, shown);
        if (distance > 0) {
          const Place end{std::clamp(mark.x, box.left, box.right), std::clamp(mark.y, box.top, box.bottom)};
          base::append(leaders_, "<path class=\"x\" d=\"M{:.1f},{:.1f}L{:.1f},{:.1f}\"/>\n", mark.x, mark.y, end.x, end.y);
        }
        return true;
      }
      return false;
    };
    for (std::size_t s = 0; s < series_.size(); ++s) {
      const Series& series = series_[s];
      const bool one = series.points.size() == 1;
      bool placed = false;
      bool any = false;
      for (const double distance : {0.0, 14.0, 30.0, 60.0, 100.0}) {
        for (std::size_t i = 0; i < series.points.size() && !placed; ++i) {
          if (in_strip(series.points[i])) continue;
          any = true;
          placed = place(one ? series.whole_name(0) : series.name, series.places[i], distance, true, s);
        }
        if (placed || !any) break;
      }
    }
    for (const bool front : {true, false}) {
      for (std::size_t s = 0; s < series_.size(); ++s) {
        const Series& series = series_[s];
        for (std::size_t i = 0; i < series.points.size(); ++i) {
          if (series.points.size() == 1 || in_strip(series.points[i]) || series.points[i].label.empty() ||
              series.in_front(i) != front)
            continue;
          static_cast<void>(place(series.points[i].label, series.places[i], 0, false, s));
        }
      }
    }
  }

  PlotPanel panel_;
  std::vector<Series> series_;
  std::vector<double> seconds_;
  std::vector<double> wrong_;  // of points outside the strip
  int strip_rows_ = 0;
  std::string labels_;
  std::string leaders_;
  double height_ = 0;
  std::string text_;
};

std::string svg_start(double width, double height, std::string_view label) {
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"answer-plot\" role=\"img\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
             "width=\"{0:.0f}\" "
             "height=\"{1:.0f}\" aria-label=\"{2}\">\n<title>{2}</title>\n",
             width, height, xml_text(label)) +
         style_text() + fmt::format("<rect class=\"g\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", width, height);
}

}  // namespace

std::vector<std::size_t> front_of(const std::vector<PlotPoint>& series) {
  std::vector<std::size_t> order(series.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const PlotPoint& p = series[a];
    const PlotPoint& q = series[b];
    return p.seconds != q.seconds ? p.seconds < q.seconds : p.wrong_percent < q.wrong_percent;
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || series[i].wrong_percent < series[front.back()].wrong_percent) front.push_back(i);
  return front;
}

std::vector<PlotPoint> medians_of(const std::vector<PlotPoint>& points) {
  std::vector<std::vector<PlotPoint>> groups;
  for (const PlotPoint& point : points) {
    const auto known = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
      const PlotPoint& first = group.front();
      return first.panel == point.panel && first.series == point.series && first.label == point.label;
    });
    if (known != groups.end())
      known->push_back(point);
    else
      groups.push_back({point});
  }
  std::vector<PlotPoint> medians;
  for (const auto& group : groups) {
    const auto median = [&group](double PlotPoint::*value) {
      std::vector<double> values;
      for (const PlotPoint& point : group) values.push_back(point.*value);
      const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
      std::nth_element(values.begin(), middle, values.end());
      return *middle;
    };
    PlotPoint point = group.front();
    point.seconds = median(&PlotPoint::seconds);
    point.wrong_percent = median(&PlotPoint::wrong_percent);
    medians.push_back(std::move(point));
  }
  return medians;
}

std::string panel_svg(const std::vector<PlotPoint>& points, PlotPanel panel) {
  const Panel drawn(points, panel);
  return svg_start(
             panel_width, drawn.height(),
             panel == PlotPanel::emulated ? "Time against error on the old machines" : "Time against error on this computer") +
         drawn.text() + "</svg>\n";
}

base::Result<std::string> plot_svg(const std::vector<PlotPoint>& points, std::string_view title) {
  constexpr double gap = 20;
  constexpr double title_height = 30;
  const Panel emulated(points, PlotPanel::emulated);
  const Panel host(points, PlotPanel::host);
  if (emulated.empty() && host.empty()) return base::bad_input("nothing to plot: no method has both a time and an error here");
  std::string text = svg_start(2 * panel_width + gap, title_height + std::max(emulated.height(), host.height()), title);
  base::append(text, "<text class=\"b\" x=\"8\" y=\"20\">{}</text>\n", xml_text(title));
  base::append(text, "<g transform=\"translate(0 {:.0f})\">\n{}</g>\n", title_height, emulated.text());
  base::append(text, "<g transform=\"translate({:.0f} {:.0f})\">\n{}</g>\n</svg>\n", panel_width + gap, title_height,
               host.text());
  return text;
}

}  // namespace sightline::compare
