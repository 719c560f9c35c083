#include "host/app/commands/demo_page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "host/app/commands/answer_output.hpp"
#include "host/app/outputs.hpp"
#include "host/base/text.hpp"
#include "host/picture/raster_difference.hpp"
#include "host/picture/svg.hpp"

namespace sightline::app {
namespace {

using compare::AnswerRow;

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --ground: #ffffff; --ink: #1d1f21; --quiet: #5c6166; --rule: #d6d6cf; --band: #f3f3ed; --link: #0b5394;
  --good: #1b6e2d; --bad: #a61c1c; }
@media (prefers-color-scheme: dark) { :root { --ground: #17191b; --ink: #e4e4df; --quiet: #a2a7ab; --rule: #3a3e42; --band: #202326;
  --link: #8ab8ea; --good: #7fcf8e; --bad: #ff9a92; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--ground); color: var(--ink); font: 1rem/1.45 system-ui, "Segoe UI", "DejaVu Sans", sans-serif;
  overflow-wrap: break-word; }
main { margin: 0 auto; padding: .8rem 1.25rem 3rem; max-width: 76rem; }
h1 { font-size: 1.35rem; margin: .2rem 0 .6rem; } h2 { font-size: 1.2rem; margin: 1.8rem 0 .4rem; } h1, h2 { line-height: 1.25; }
p { max-width: 52rem; margin: .4rem 0; } a { color: var(--link); }
.answers { display: grid; grid-template-columns: repeat(3, minmax(0, 1fr)); gap: .8rem; margin: 0; }
.answers div { background: var(--band); border-left: 4px solid var(--link); padding: .5rem .8rem; }
.answers dt { font-weight: 650; } .answers dd { margin: .1rem 0 0; font-size: .95rem; }
.note, figcaption { color: var(--quiet); font-size: .87rem; }
.wide { overflow-x: auto; max-width: 100%; width: fit-content; border: 1px solid var(--rule); }
.long { max-height: 36rem; overflow-y: auto; }
table { border-collapse: separate; border-spacing: 0; font-size: .86rem; line-height: 1.3; }
th, td { padding: .24rem .6rem; text-align: left; vertical-align: top; border-bottom: 1px solid var(--rule); background: var(--ground); }
thead th { position: sticky; top: 0; z-index: 1; vertical-align: bottom; border-bottom: 1.5px solid var(--ink); font-weight: 650; }
tbody th { font-weight: 400; white-space: nowrap; } th small { color: var(--quiet); }
tr.scene th { font-weight: 650; background: var(--band); }
.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; } .p { min-width: 12rem; }
.good { color: var(--good); } .bad { color: var(--bad); font-weight: 650; }
.plots { display: grid; grid-template-columns: repeat(2, minmax(0, 36rem)); gap: .5rem 1.5rem; align-items: start; }
.plots svg { display: block; width: 100%; height: auto; }
.gallery { display: grid; gap: 1rem; margin: .6rem 0; }
.of3 { grid-template-columns: repeat(3, minmax(0, 21rem)); } .of4 { grid-template-columns: repeat(4, minmax(0, 1fr)); }
figure { margin: 0; min-width: 0; } figure img { display: block; width: 100%; height: auto; border: 1px solid var(--rule); background: #fff; }
figcaption { margin-top: .25rem; } .points { image-rendering: pixelated; }
summary { cursor: pointer; padding: .3rem 0; } details { border-bottom: 1px solid var(--rule); }
pre { overflow-x: auto; padding: .6rem .8rem; background: var(--band); font-size: .8rem; line-height: 1.35; }
@media (max-width: 48rem) { main { padding: .6rem .75rem 2rem; } .answers, .plots { grid-template-columns: minmax(0, 1fr); }
  .answers { gap: .5rem; } .gallery { gap: .5rem; }
  .of4 { grid-template-columns: repeat(2, minmax(0, 1fr)); } figcaption { font-size: .8rem; line-height: 1.25; }
  th, td { padding: .24rem .4rem; } .methods th small { display: block; max-width: 8.2rem; white-space: normal; } h1 { font-size: 1.2rem; } }
)";

// The paper of a method and the machine on which it runs.
std::string_view method_text(std::string_view method) {
  struct Known {
    std::string_view method;
    std::string_view text;
  };
  constexpr Known known[] = {{compare::jones_pdp7_name, "Jones 1971, PDP-7"},
                             {compare::jones_twin_name, "the same program in C++"},
                             {"exact", "of today, exact"},
                             {"jones", "Jones 1971, exact"},
                             {"montani-re", "Montani and Re 1985"},
                             {"plantinga", "Plantinga 1990, exact"},
                             {"willis", "Willis 1977"},
                             {"willis-8080", "Willis 1977, 8080"},
                             {"stripes-8080", "Montani and Re 1985, 8080"},
                             {"turn-pdp7", "Plantinga 1990, PDP-7"},
                             {"skala-8080", "Skala 1985, 8080"},
                             {"skala-twin", "the same program in C++"},
                             {"skala", "Skala 1985, not rounded"}};
  for (const Known& each : known)
    if (each.method == method) return each.text;
  return {};
}

// Escapes a text for HTML; line ends are kept.
std::string html(std::string_view text) {
  std::string escaped;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    escaped += picture::xml_text(text.substr(0, end));
    if (end == std::string_view::npos) break;
    escaped += '\n';
    text.remove_prefix(end + 1);
  }
  return escaped;
}

// The same for a text with times (base::time_text): writes us as a micro sign.
std::string html_with_times(std::string_view text) {
  std::string escaped = html(text);
  for (std::size_t at = 0; (at = escaped.find(" us", at)) != std::string::npos; at += 3) {
    const auto is = [&](std::size_t place, int (*kind)(int)) {
      return place < escaped.size() && kind(static_cast<unsigned char>(escaped[place])) != 0;
    };
    if (at > 0 && is(at - 1, std::isdigit) && !is(at + 3, std::isalnum)) escaped.replace(at, 3, " &#181;s");
  }
  return escaped;
}

std::string element(std::string_view tag, std::string_view classes, const std::string& escaped) {
  return fmt::format("<{}{}>{}</{}>", tag, classes.empty() ? std::string() : fmt::format(" class=\"{}\"", classes), escaped, tag);
}

std::string cell(std::string_view tag, std::string_view classes, std::string_view text) {
  return element(tag, classes, html(text));
}

std::string time_cell(std::string_view text) {
  return element("td", "n", html_with_times(text));
}

bool timed_here(const std::vector<AnswerRow>& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const AnswerRow& row) { return row.host_seconds.has_value(); });
}

std::string defect_row(const AnswerRow& row, int columns) {
  return row.defect.empty()
             ? std::string()
             : fmt::format("<tr><th></th><td class=\"bad\" colspan=\"{}\">{}</td></tr>\n", columns - 1, html(row.defect));
}

// One row per method, over all scenes; the emulated machines come first.
std::string methods_html(const std::vector<AnswerRow>& methods) {
  constexpr int columns = 6;
  std::string text = "<div class=\"wide\" tabindex=\"0\">\n<table class=\"methods\">\n<thead><tr>" + cell("th", "", "method") +
                     cell("th", "n", "time") + cell("th", "n", "different, %") + cell("th", "n", "farthest, points") +
                     cell("th", "n", "nothing wrong") + cell("th", "p", "the paper says") + "</tr></thead>\n<tbody>\n";
  for (const bool emulated : {true, false}) {
    base::append(text, "<tr class=\"scene\"><th colspan=\"{}\">{}</th></tr>\n", columns,
                 emulated ? "Old machines, emulated time" : "This computer, measured time");
    for (const AnswerRow& row : methods) {
      if (row.emulated_seconds.has_value() != emulated) continue;
      const AnswerCells cells = answer_cells(row);
      const bool exact = row.exact && row.right == row.views;
      const std::string wrong = row.views > 1
                                    ? fmt::format("{:.3g} ({:.3g})", row.wrong_percent.median, row.wrong_percent.greatest)
                                    : fmt::format("{:.3g}", row.wrong_percent.greatest);
      const std::string_view who = method_text(row.method);
      base::append(text, "<tr><th>{} <small>{}{}{}</small></th>", html(row.method), html(who), who.empty() ? "" : ", ",
                   html(row.picture));
      text += time_cell(emulated ? cells.emulated : cells.host) + cell("td", "n", exact ? "0, exact" : wrong) +
              cell("td", "n", cells.greatest) + cell("td", "n", row.rounding == "dots" && row.defect.empty() ? "-" : fmt::format("{} of {}", row.right, row.views)) +
              cell("td", "p", cells.paper) + "</tr>\n" + defect_row(row, columns);
    }
  }
  return text + "</tbody>\n</table>\n</div>\n";
}

// One row per scene and method.
std::string table_html(const std::vector<AnswerRow>& rows) {
  const bool host = timed_here(rows);
  const int columns = host ? 9 : 8;
  std::string text = "<div class=\"wide long\" tabindex=\"0\">\n<table>\n<thead><tr>" + cell("th", "", "method") +
                     cell("th", "", "draws") + cell("th", "", "rounded to") + cell("th", "n", "emulated time");
  if (host) text += cell("th", "n", "time here");
  text += cell("th", "n", "different") + cell("th", "n", "farthest, points") + cell("th", "n", "wrong") + cell("th", "", "read") +
          "</tr></thead>\n<tbody>\n";
  std::string scene;
  for (const AnswerRow& row : rows) {
    if (row.scene != scene) {
      scene = row.scene;
      // Not an error of a method: all of them draw straight lines between the samples.
      const std::string chord =
          row.chord ? fmt::format(" <small>between its samples the function is up to {:.2f} dots off these lines</small>", *row.chord)
                    : std::string();
      base::append(text, "<tr class=\"scene\"><th colspan=\"{}\">{}{}</th></tr>\n", columns, html(scene), chord);
    }
    const AnswerCells cells = answer_cells(row);
    text += "<tr>" + cell("th", "", row.method) + cell("td", "", row.picture) + cell("td", "", cells.rounding) +
            time_cell(cells.emulated);
    if (host) text += time_cell(cells.host);
    text += cell("td", "n", cells.wrong) + cell("td", "n", cells.greatest) + cell("td", "n", cells.far) +
            cell("td", "", cells.read) + "</tr>\n" + defect_row(row, columns);
  }
  return text + "</tbody>\n</table>\n</div>\n";
}

std::string gallery_html(const PageGallery& gallery) {
  std::string text = fmt::format("<h2>{}</h2>\n<p class=\"note\">{}</p>\n<div class=\"gallery of{}\">\n", html(gallery.title),
                                 html(gallery.text), gallery.columns);
  for (const PageFigure& figure : gallery.figures) {
    const std::string caption = html(figure.caption);
    base::append(
        text,
        "<figure><a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\" loading=\"lazy\"{2}></a><figcaption>{1}</figcaption></figure>\n",
        html(figure.file), caption, figure.points ? " class=\"points\"" : "");
  }
  return text + "</div>\n";
}

// --- Pictures

// The window of `side` points with the most differing points; among those the one with the most lit points, then the lowest, then
// the leftmost.
struct Window {
  int left = 0;
  int bottom = 0;
};
Window window_of(const picture::PixelGrid& truth, const picture::PixelGrid& lit, int side) {
  constexpr int step = 32;
  Window best;
  std::int64_t most = -1;
  for (int bottom = 0; bottom + side <= truth.height; bottom += step) {
    for (int left = 0; left + side <= truth.width; left += step) {
      std::int64_t weight = 0;
      for (int row = bottom; row < bottom + side; ++row) {
        for (int column = left; column < left + side; ++column) {
          const bool in_truth = truth.at(column, row) != 0;
          const bool in_lit = lit.at(column, row) != 0;
          weight += (in_truth != in_lit ? std::int64_t{side} * side : 0) + (in_lit ? 1 : 0);
        }
      }
      if (weight <= most) continue;
      most = weight;
      best = {left, bottom};
    }
  }
  return best;
}

picture::PixelGrid part_of(const picture::PixelGrid& grid, const Window& window, int side) {
  picture::PixelGrid part(side, side);
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) part.set(column, row, grid.at(window.left + column, window.bottom + row));
  return part;
}

// The part of the screen in which most points differ, enlarged so that single points can be seen.
constexpr int shown_points = 128;
void write_difference(const std::string& directory, const std::string& file, const std::string& title,
                      const picture::PixelGrid& truth, const picture::PixelGrid& lit) {
  constexpr int scale = 6;
  const Window window = window_of(truth, lit, shown_points);
  Output png((std::filesystem::path(directory) / file).string());
  write_png(png, picture::difference_image(part_of(truth, window, shown_points), part_of(lit, window, shown_points), scale),
            {{"Title", title}, {"Software", "sightline"}});
  png.commit();
}

std::string difference_caption(const std::string& name, const picture::RasterDifference& raster) {
  if (raster.same()) return fmt::format("{}: all {} points are those of exact lines", name, raster.lit_in_truth);
  return fmt::format("{}: {} points missing (orange), {} extra (blue) of {}, none farther off than {:.1f}", name,
                     raster.missing.all, raster.extra.all, raster.lit_in_truth, raster.hausdorff.greatest);
}

PageGallery jones_gallery(const std::string& directory, const DemoResults& results) {
  PageGallery gallery{
      "Jones 1971: the screen of the PDP-7",
      3,
      "Photographs of the Type 340 with the shutter open for 0.2 s; every point of one pass; and the points beside those that "
      "exact "
      "lines light by the display's own rule, grey in both: the 128 by 128 of the 1024 by 1024 in which most differ.",
      {}};
  for (const JonesRow& row : results.jones) {
    if (!row.eae) continue;
    const std::string stem = file_stem(row.scene);
    gallery.figures.push_back(
        {stem + "-phosphor.png", fmt::format("{}, photographed: {:.2f} s a view", row.scene, core::in_seconds(row.view.time))});
    gallery.figures.push_back({stem + ".png", fmt::format("{}, point by point: {} of {} cells read, {} lines", row.scene,
                                                          row.view.distinct_cells, row.cells, row.view.pieces)});
    for (const compare::SceneComparison& scene : results.answer.scenes) {
      if (scene.scene != row.scene) continue;
      for (const compare::ComparedPicture& compared : scene.pictures) {
        if (!compared.raster) continue;
        const std::string file = stem + "-difference.png";
        write_difference(directory, file, row.scene + ", points of the PDP-7 and of exact lines", compared.lit_in_truth,
                         compared.lit);
        gallery.figures.push_back({file, difference_caption(row.scene, *compared.raster), true});
      }
    }
  }
  for (const WalkRow& row : results.walks) {
    if (!row.eae) continue;
    const std::string stem = walk_stem(row.scene, row.rotation);
    gallery.figures.push_back({stem + "-phosphor.png", fmt::format("{} after a walk{} through {} of its cells: {:.2f} s a view on the way", row.scene, row.rotation ? ", the view turning," : "", row.entered, row.mean_s)});
    gallery.figures.push_back({stem + ".png", fmt::format("{} after the walk, point by point", row.scene)});
  }
  return gallery;
}

PageGallery skala_gallery(const std::string& directory, const DemoResults& results) {
  PageGallery gallery{
      "Skala 1985: the raster board of the 8080",
      4,
      "Each function as lines, as a shaded surface and as contours on the EF9365 board; and the dots of its lines beside those "
      "that exact lines light by the program's own rule, grey in both: the 128 by 128 of the 256 by 256 in which most differ.",
      {}};
  for (const SkalaDemoRow& row : results.skala.rows) {
    const auto add = [&](const char* suffix, const char* what, const programs::skala::Outcome& outcome) {
      gallery.figures.push_back(
          {fmt::format("{}-{}.png", row.function, suffix),
           fmt::format("{}, {}: {:.2f} s", row.function, what, core::in_seconds(outcome.picture.drawing)), true});
    };
    add("lines", "lines", row.lines);
    add("surface", "surface", row.surface);
    add("contours", "contours", row.contours);
    for (const auto& [name, function] : results.answer.functions) {
      if (name != row.function) continue;
      for (const compare::ComparedDevice& device : function.devices) {
        if (device.device != programs::skala::Device::ef9365) continue;
        const std::string file = row.function + "-difference.png";
        write_difference(directory, file, row.function + ", dots of the 8080 and of exact lines", device.truth, device.dots);
        gallery.figures.push_back({file, difference_caption(row.function, device.raster), true});
      }
    }
  }
  gallery.figures.push_back({results.skala.plotted + "-calcomp.png",
                             fmt::format("{} on the CalComp 565 plotter: {:.0f} s", results.skala.plotted,
                                         core::in_seconds(results.skala.plot.plotter.time)),
                             true});
  return gallery;
}

PageGallery stripes_gallery(const DemoResults& results) {
  PageGallery gallery{"Montani and Re 1985: faces in stripes on the 8080", 3, "A grey a face, on the EF9365 board.", {}};
  for (const StripesDemoRow& row : results.stripes) {
    if (row.plotter) continue;
    const programs::stripes::MachinePicture& picture = row.drawn.picture;
    gallery.figures.push_back({stripes_picture(row),
                               fmt::format("{}: {} faces{} in {:.2f} s", row.scene, row.drawn.scene.faces.size(), row.antialias ? " with smooth edges" : "",
                                           core::in_seconds(picture.receiving + picture.working())),
                               true});
  }
  return gallery;
}

PageGallery circle_gallery(const DemoResults& results) {
  PageGallery gallery{"Plantinga, Seales and Dyer 1990: turns about other axes and in perspective, on this computer", 3, "", {}};
  for (const CircleRow& row : results.circles)
    gallery.figures.push_back({row.file, fmt::format("{} {}: {} events in a turn; {} of {} frames have the visible length of the view from scratch", row.model, row.view,
                                                     row.events, row.right, row.frames)});
  return gallery;
}

}  // namespace

std::vector<PageGallery> demo_galleries(const std::string& directory, const DemoResults& results) {
  return {jones_gallery(directory, results), skala_gallery(directory, results), stripes_gallery(results), circle_gallery(results)};
}

std::string demo_page(const DemoPage& page, const DemoAnswer& answer) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, "
      "initial-scale=1\">\n<title>Sightline: how fast, how wrong, against what?</title>\n<style>";
  text += style;
  text +=
      "</style>\n</head>\n<body>\n<main>\n<h1>Hidden lines on old machines and on this computer</h1>\n<dl class=\"answers\">\n";
  for (const auto& [question, said] : {std::pair("How fast?", &page.answers.fast), std::pair("How wrong?", &page.answers.wrong),
                                       std::pair("Against what?", &page.answers.against)})
    base::append(text, "<div><dt>{}</dt><dd>{}</dd></div>\n", question, html_with_times(*said));
  text += "</dl>\n<h2>Every method</h2>\n";
  text += methods_html(answer.methods);
  base::append(
      text,
      "<p class=\"note\">Medians over the views, the greatest in brackets: {} scenes and {} functions, each row by itself under "
      "\"In numbers\". "
      "Different is what is missing and what is drawn though hidden, along the lines, in per cent of the visible length, or of the points of "
      "the picture; farthest is the greatest distance of the two pictures, beside the lines too, in points of the screen (px); wrong is the "
      "different that is farther than a point from what is visible. Skala's dots have no count in \"nothing "
      "wrong\": rounding alone puts some more than a point off, and the greatest distance is their measure.</p>\n",
      answer.scenes.size(), answer.functions.size());
  text += "<h2>Time against error</h2>\n<div class=\"plots\">\n";
  text += compare::panel_svg(answer.plotted, compare::PlotPanel::emulated) +
          compare::panel_svg(answer.plotted, compare::PlotPanel::host);
  base::append(text,
               "</div>\n<p class=\"note\">{}. Filled and joined: the settings of a method of which no other is both faster and "
               "more right. Points "
               "of which less than 0.001 % is different are in the strip below, with the number if it is not 0.</p>\n",
               html(answer.plotted_text));
  for (const PageGallery& gallery : page.galleries) text += gallery_html(gallery);
  text += "<h2>In one line each</h2>\n<div class=\"wide\" tabindex=\"0\">\n<table>\n<tbody>\n";
  for (const Verdict& verdict : page.verdicts)
    base::append(text, "<tr><th>{}</th><td>{}</td><td class=\"{}\">{}</td></tr>\n", html(verdict.subject),
                 html_with_times(verdict.text), !verdict.right ? "" : *verdict.right ? "good" : "bad", html(verdict.verdict));
  text += "</tbody>\n</table>\n</div>\n<h2>In numbers</h2>\n<details><summary>Every scene and method</summary>\n";
  text += table_html(answer.rows) + "</details>\n";
  for (const auto& [title, table] : page.tables)
    base::append(text, "<details><summary>{}</summary>\n<pre tabindex=\"0\">{}</pre>\n</details>\n", html(title), html(table));
  return text + "</main>\n</body>\n</html>\n";
}

}  // namespace sightline::app
