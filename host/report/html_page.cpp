#include "host/report/html_page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "host/base/file.hpp"
#include "host/report/html_style.hpp"
#include "host/report/table_text.hpp"

namespace sightline::report {

namespace {

// Longer tables and larger galleries are collapsed within their chapter.
constexpr std::size_t most_open = 12;

// The number of columns that fit on paper at a readable size.
constexpr std::size_t most_printed = 14;

constexpr std::string_view replacement = "\uFFFD";

// The bytes of the UTF-8 character at the beginning of `text`; 0 if there is none. Unicode 15, table 3-7.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return follows(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    const bool overlong = lead == 0xE0 && byte(1) < 0xA0;
    const bool surrogate = lead == 0xED && byte(1) > 0x9F;
    return follows(1) && follows(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    const bool outside = (lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) > 0x8F);
    return follows(1) && follows(2) && follows(3) && !outside ? 4 : 0;
  }
  return 0;
}

bool is_control(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\t' && c != '\n' && c != '\r') || byte == 0x7F;
}

bool is_number(const Cell& cell) {
  return std::holds_alternative<std::int64_t>(cell) || std::holds_alternative<Real>(cell);
}

class HtmlWriter {
 public:
  explicit HtmlWriter(const Report& report) : report_(report) {}

  std::string text() && {
    for (const Section& section : report_.sections) {
      html_ += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n", escape_html(section.id),
                           escape_html(section.title));
      add(section);
      html_ += "</section>\n";
    }
    // Written first, to count the statements that do not hold.
    const std::string sections = std::exchange(html_, {});
    head();
    html_ += "<main>\n";
    introduction();
    contents();
    html_ += sections;
    html_ += fmt::format("</main>\n<footer><p>Made by sightline {}.</p></footer>\n</body>\n</html>\n",
                         escape_html(report_.version));
    return std::move(html_);
  }

 private:
  // The header stays visible and links to the parts.
  void head() {
    const std::string title = escape_html(report_.title);
    html_ += fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>{}</title>\n<style>{}{}</style>\n</head>\n<body>\n<header><h1>{}</h1><nav aria-label=\"Sections\">",
        title, page_style, filter_style(), title);
    for (const Section& section : report_.sections)
      html_ += fmt::format("<a href=\"#{}\">{}</a>", escape_html(section.id),
                           escape_html(section.title.substr(0, section.title.find(':'))));
    html_ += "</nav></header>\n";
  }

  // The filter of cards works without scripts: a choice hides the cards of the other tables.
  [[nodiscard]] std::string filter_style() const {
    std::string style;
    for (const Section& section : report_.sections)
      for (const Table* const table : card_tables(section))
        style += fmt::format("section:has(#show-{0}:checked) .cards:not(#cards-{0}) {{ display: none; }}\n", escape_html(table->id));
    return style;
  }
  static std::vector<const Table*> card_tables(const Section& section) {
    std::vector<const Table*> tables;
    for (const Block& block : section.blocks)
      if (const auto* const table = std::get_if<Table>(&block); table != nullptr && !table->cards_name.empty())
        tables.push_back(table);
    return tables;
  }

  void introduction() {
    for (const std::string& paragraph : report_.introduction) add(Paragraph{paragraph});
    if (failed_ > 0)
      html_ += fmt::format("<p class=\"bad\">{} of the page's statements do not hold in this run; each says so where it would "
                           "stand.</p>\n", failed_);
  }

  void contents() {
    html_ += "<details class=\"contents\"><summary>Contents</summary>\n<ol>\n";
    for (const Section& section : report_.sections) {
      html_ += fmt::format("<li><a href=\"#{}\">{}</a>\n<ul>\n", escape_html(section.id),
                           escape_html(section.title));
      for (const Block& block : section.blocks) {
        if (const auto* const panel = std::get_if<Panel>(&block)) entry(panel->id, panel->title.text);
        if (const auto* const table = std::get_if<Table>(&block)) entry(table->id, table->title);
        if (const auto* const figure = std::get_if<Figure>(&block)) entry(figure->id, figure->title);
        if (const auto* const gallery = std::get_if<Gallery>(&block)) entry(gallery->id, gallery->title);
      }
      html_ += "</ul></li>\n";
    }
    html_ += "</ol>\n</details>\n";
  }

  void entry(const std::string& id, const std::string& title) {
    html_ += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", escape_html(id), escape_html(title));
  }

  // Consecutive figures are side by side where the page is wide enough. Chapters are collapsed.
  void add(const Section& section) {
    bool in_row = false;
    bool in_chapter = false;
    bool filter = !card_tables(section).empty();
    for (const Block& block : section.blocks) {
      const bool figure = std::holds_alternative<Figure>(block);
      if (figure != in_row) html_ += figure ? "<div class=\"plots\">\n" : "</div>\n";
      in_row = figure;
      if (const auto* const heading = std::get_if<Heading>(&block)) {
        if (in_chapter) html_ += "</details>\n";
        in_chapter = true;
        html_ += fmt::format("<details class=\"chapter\" id=\"{}\"><summary><h3>{}</h3></summary>\n", escape_html(heading->id),
                             escape_html(heading->text));
      }
      if (const auto* const table = std::get_if<Table>(&block); filter && table != nullptr && !table->cards_name.empty()) {
        add_filter(section);
        filter = false;
      }
      std::visit([this](const auto& content) { add(content); }, block);
    }
    if (in_row) html_ += "</div>\n";
    if (in_chapter) html_ += "</details>\n";
  }

  void add(const Paragraph& paragraph) { add(paragraph.text, ""); }
  // Adds the text and the statements that do not hold in this run.
  void add(const CheckedText& said, std::string_view look) {
    if (!said.text.empty() || said.failed.empty()) html_ += fmt::format("<p{}>{}</p>\n", look, escape_html(said.text));
    for (const std::string& failed : said.failed)
      html_ += fmt::format("<p class=\"bad\">Not in this run: {}</p>\n", escape_html(failed));
    failed_ += said.failed.size();
  }
  void add(const Heading&) {}  // written by add(Section)

  void add(const Opening& opening) {
    html_ += "<div class=\"answers\">\n";
    for (const auto& [question, answer] : opening.answers) {
      html_ += fmt::format("<div><h3>{}</h3>\n", escape_html(question));
      add(answer, "");
      html_ += "</div>\n";
    }
    html_ += "</div>\n<div class=\"answer-plots\">\n";
    for (const std::string& drawing : opening.drawings) html_ += drawing;
    html_ += fmt::format("</div>\n<p class=\"note\">{}</p>\n", escape_html(opening.caption));
  }

  void add(const Panel& panel) {
    html_ += fmt::format("<article class=\"panel\" id=\"{}\">\n<div>\n<h3>{}</h3>\n", escape_html(panel.id), escape_html(panel.title.text));
    add(CheckedText("", panel.title.failed), "");
    if (!panel.source.empty()) html_ += "<p class=\"note\">" + escape_html(panel.source) + "</p>\n";
    if (!panel.facts.empty()) {
      html_ += "<dl class=\"facts\">";
      for (const auto& [label, value] : panel.facts)
        html_ += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", escape_html(label), escape_html(value));
      html_ += "</dl>\n";
    }
    for (const CheckedText& text : panel.text) add(text, "");
    html_ += "</div>\n<div class=\"pictures\">\n";
    for (const Figure& figure : panel.figures) add(figure);
    html_ += "</div>\n</article>\n";
  }

  // Choices of cards: by table, and by outcome.
  void add_filter(const Section& section) {
    constexpr std::string_view choice = "<label><input type=\"radio\" name=\"{}-{}\" {}> {}</label>\n";
    const std::string name = escape_html(section.id);
    html_ += "<form class=\"filter\">\n<fieldset><legend>Method</legend>\n";
    html_ += fmt::format(choice, name, "method", "checked", "all");
    for (const Table* const table : card_tables(section))
      html_ += fmt::format(choice, name, "method", fmt::format("id=\"show-{}\"", escape_html(table->id)), escape_html(table->cards_name));
    html_ += "</fieldset>\n<fieldset><legend>base::Result</legend>\n";
    html_ += fmt::format(choice, name, "outcome", "checked", "all");
    html_ += fmt::format(choice, name, "outcome", "class=\"show-bad\"", "some method is wrong");
    html_ += fmt::format(choice, name, "outcome", "class=\"show-good\"", "all methods are right");
    html_ += "</fieldset>\n</form>\n";
  }

  // The first cell is the card's name; verdicts are below the rest.
  void add_cards(const Table& table) {
    html_ += "<div class=\"deck\">\n";
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      const auto& cells = table.rows[row];
      const bool bad = std::any_of(cells.begin(), cells.end(), [](const Cell& cell) {
        const auto* const verdict = std::get_if<Verdict>(&cell);
        return verdict != nullptr && !verdict->good;
      });
      html_ += fmt::format("<article class=\"card {}\">\n<h4>{}</h4>\n", bad ? "wrong" : "right", escape_html(cell_text(cells.at(0))));
      if (row < table.cards.size() && !table.cards[row].empty()) {
        html_ += "<div class=\"pair\">\n";
        for (const Figure& figure : table.cards[row]) add(figure);
        html_ += "</div>\n";
      }
      html_ += "<dl>";
      for (std::size_t i = 1; i < cells.size(); ++i) {
        const std::string text = cell_text(cells[i]);
        if (text.empty() || std::holds_alternative<std::monostate>(cells[i])) continue;
        const auto* const verdict = std::get_if<Verdict>(&cells[i]);
        html_ += fmt::format("<dt>{}</dt><dd{}>{}</dd>", escape_html(table.columns[i].title),
                             verdict == nullptr ? "" : look_of(*verdict), escape_html(text));
      }
      html_ += "</dl>\n</article>\n";
    }
    html_ += "</div>\n";
  }

  void add_end(const Table& table) {
    for (const CheckedText& note : table.notes) add(note, " class=\"note\"");
    html_ += fmt::format(
        "<p class=\"files\"><a href=\"tables/{0}.csv\">CSV</a><a href=\"tables/{0}.json\">JSON</a></p>\n",
        escape_html(table.id));
  }

  void add(const Table& table) {
    const std::string id = escape_html(table.id);
    if (!table.cards_name.empty()) {
      html_ += fmt::format("<div class=\"cards\" id=\"cards-{}\">\n", id);
      begin(id, table.title, false);
      add_cards(table);
      add_end(table);
      html_ += "</div>\n";
      return;
    }
    const bool folded = table.folded || table.rows.size() > most_open;
    begin(id, table.title, folded);
    html_ += fmt::format(
        "<div class=\"wide\" role=\"region\" aria-labelledby=\"{0}\" tabindex=\"0\">\n<table{1}>\n<thead><tr>", id,
        table.columns.size() > most_printed ? " class=\"many\"" : "");
    std::vector<bool> numbers;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      numbers.push_back(holds_numbers(table, i));
      heading(table.columns[i], numbers[i]);
    }
    html_ += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
      html_ += "<tr>";
      for (std::size_t i = 0; i < row.size(); ++i) add(row[i], i < numbers.size() && numbers[i], i == 0);
      html_ += "</tr>\n";
    }
    html_ += "</tbody>\n</table>\n</div>\n";
    add_end(table);
    if (folded) html_ += "</details>\n";
  }

  // A title with an anchor. If folded, the following content is in a closed `details`.
  void begin(const std::string& id, const std::string& title, bool folded) {
    const std::string heading = fmt::format("<h4 id=\"{}\">{}</h4>", id, escape_html(title));
    html_ += folded ? "<details><summary>" + heading + "</summary>\n" : heading + "\n";
  }

  static bool holds_numbers(const Table& table, std::size_t at) {
    return std::any_of(table.rows.begin(), table.rows.end(),
                       [at](const auto& row) { return at < row.size() && is_number(row[at]); });
  }

  // The heading of a column of numbers is right-aligned, and so are its texts for missing numbers.
  void heading(const Column& column, bool numbers) {
    html_ += fmt::format("<th scope=\"col\"{}>{}", numbers ? " class=\"n\"" : "", escape_html(column.title));
    if (!column.unit.empty()) html_ += "<small>" + escape_html(column.unit) + "</small>";
    html_ += "</th>";
  }

  static std::string_view look_of(const Verdict& verdict) { return verdict.good ? " class=\"good\"" : " class=\"bad\""; }

  // The first cell names the row and stays visible.
  void add(const Cell& cell, bool among_numbers, bool first) {
    std::string_view look;
    if (is_number(cell) || (among_numbers && std::holds_alternative<std::monostate>(cell)))
      look = " class=\"n\"";
    if (const auto* const verdict = std::get_if<Verdict>(&cell)) look = look_of(*verdict);
    html_ += fmt::format("<{0}{1}>{2}</{3}>", first ? "th scope=\"row\"" : "td", look, escape_html(cell_text(cell)), first ? "th" : "td");
  }

  void add(const Figure& figure) {
    html_ += fmt::format(
        "<figure{}><img{} src=\"{}\" alt=\"{}\">\n<figcaption><b>{}</b> {}",
        figure.id.empty() ? "" : fmt::format(" id=\"{}\"", escape_html(figure.id)), look_of(figure),
        escape_html(data_uri(figure.media_type, figure.bytes)), escape_html(figure.alternative),
        escape_html(figure.title), escape_html(figure.caption.text));
    for (const std::string& failed : figure.caption.failed)
      html_ += fmt::format("<br><span class=\"bad\">Not in this run: {}</span>", escape_html(failed));
    failed_ += figure.caption.failed.size();
    html_ += "</figcaption></figure>\n";
  }

  // Drawings on white are inverted if the reader prefers dark pages.
  static std::string_view look_of(const Figure& figure) {
    if (figure.media_type == "image/svg+xml") return " class=\"drawing\"";
    return figure.pixelated ? " class=\"pixelated\"" : "";
  }

  void add(const Gallery& gallery) {
    const bool folded = gallery.folded || gallery.figures.size() > most_open;
    begin(escape_html(gallery.id), gallery.title, folded);
    html_ += "<div class=\"gallery\">\n";
    for (const Figure& figure : gallery.figures) add(figure);
    html_ += "</div>\n";
    if (folded) html_ += "</details>\n";
  }

  void add(const Listing& listing) {
    const std::string file = escape_html(listing.file);
    const base::Bytes bytes(listing.text.begin(), listing.text.end());
    html_ += fmt::format(
        "<details id=\"{0}\"><summary>{1}</summary>\n<p class=\"files\"><a download=\"{1}\" "
        "href=\"{2}\">save "
        "{1}</a></p>\n<pre>{3}</pre></details>\n",
        escape_html(listing.id), file, data_uri("text/plain", bytes), escape_html(listing.text));
  }

  const Report& report_;
  std::string html_;
  std::size_t failed_ = 0;  // number of statements that do not hold
};

}  // namespace

std::string html_page(const Report& report) {
  return HtmlWriter(report).text();
}

std::string escape_html(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    switch (text.front()) {
      case '&': escaped += "&amp;"; break;
      case '<': escaped += "&lt;"; break;
      case '>': escaped += "&gt;"; break;
      case '"': escaped += "&quot;"; break;
      case '\'': escaped += "&#39;"; break;
      default:
        if (length == 0 || is_control(text.front())) {
          escaped += replacement;
        } else {
          escaped += text.substr(0, length);
        }
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return escaped;
}

std::string data_uri(std::string_view media_type, const base::Bytes& bytes) {
  // RFC 4648, section 4.
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string uri = fmt::format("data:{};base64,", media_type);
  uri.reserve(uri.size() + bytes.size() / 3 * 4 + 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = bytes.size() - at < 3 ? bytes.size() - at : 3;
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i) group = group << 8U | (i < count ? bytes[at + i] : 0U);
    for (std::size_t i = 0; i < 4; ++i) uri += i <= count ? letters[group >> (18U - 6U * i) & 0x3FU] : '=';
  }
  return uri;
}

}  // namespace sightline::report
