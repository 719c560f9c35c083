#include "host/report/text.hpp"

#include <fmt/core.h>

#include <optional>
#include <utility>

#include "host/report/table_text.hpp"

namespace sightline::report {

// Words, or a value, or a condition with one or two texts.
struct Text::Piece {
  std::string words = {};
  std::optional<Expression> value = {};
  int places = Real::as_needed;
  std::optional<Expression> condition = {};
  Text then = {};
  std::optional<Text> otherwise = {};
};

namespace {

// Where the brace at the beginning of `text` is closed.
std::size_t closing_brace(std::string_view text) {
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '{') ++depth;
    if (text[at] == '}' && --depth == 0) return at;
  }
  throw Wrong(fmt::format("\"{}\": a brace is not closed", text));
}

// At bars that stand alone and in no braces.
std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t begun = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '{') ++depth;
    if (text[at] == '}') --depth;
    if (text[at] != '|' || depth > 0) continue;
    if (text.substr(at, 2) == "||") {
      ++at;
      continue;
    }
    parts.push_back(text.substr(begun, at - begun));
    begun = at + 1;
  }
  parts.push_back(text.substr(begun));
  return parts;
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

}  // namespace

Text::Text(std::string_view text, std::string place) : place_(std::move(place)) {
  with_place(place_, [&] { read(text); });
}

void Text::read(std::string_view text) {
  Piece words;
  const auto flush = [&] {
    if (!words.words.empty()) pieces_.push_back(std::make_shared<const Piece>(std::exchange(words, {})));
  };
  while (!text.empty()) {
    if (text.front() != '{' && text.front() != '}') {
      words.words += text.front();
      text.remove_prefix(text.starts_with("||") ? 2 : 1);
      continue;
    }
    if (text.front() == '}') throw Wrong(fmt::format("\"{}\": a brace was not opened", text));
    flush();
    const std::size_t end = closing_brace(text);
    std::string_view inside = text.substr(1, end - 1);
    text.remove_prefix(end + 1);
    Piece piece;
    if (inside.starts_with("if ")) {
      const auto parts = split(inside.substr(3));
      if (parts.size() < 2 || parts.size() > 3)
        throw Wrong(fmt::format("\"{}\": expected a condition and one or two texts between bars", inside));
      piece.condition.emplace(trimmed(parts[0]));
      piece.then = Text(trimmed(parts[1]));
      if (parts.size() == 3) piece.otherwise = Text(trimmed(parts[2]));
    } else {
      if (const std::size_t colon = inside.rfind(':'); colon != std::string_view::npos) {
        const std::string_view places = inside.substr(colon + 1);
        if (places.size() != 1 || places[0] < '0' || places[0] > '9')
          throw Wrong(fmt::format("\"{}\": expected the number of places, 0 to 9, behind the colon", inside));
        piece.places = places[0] - '0';
        inside = inside.substr(0, colon);
      }
      piece.value.emplace(trimmed(inside));
    }
    pieces_.push_back(std::make_shared<const Piece>(std::move(piece)));
  }
  flush();
}

Said Text::said(const Scope& scope) const {
  return with_place(place_, [&] { return said_pieces(scope); });
}

Said Text::said_pieces(const Scope& scope) const {
  Said said;
  const auto add = [&](Said part) {
    said.text += part.text;
    said.failed.insert(said.failed.end(), part.failed.begin(), part.failed.end());
  };
  for (const auto& piece : pieces_) {
    if (piece->value) {
      add({shown_text(cell_of(piece->value->value(scope), piece->places)), {}});
    } else if (!piece->condition) {
      add({piece->words, {}});
    } else if (piece->condition->holds(scope)) {
      add(piece->then.said(scope));
    } else if (piece->otherwise) {
      add(piece->otherwise->said(scope));
    } else {
      add({"", {fmt::format("\"{}\" needs {}; here {}", piece->then.said(scope).text, piece->condition->text(),
                            piece->condition->explain(scope))}});
    }
  }
  return said;
}

void Text::collect(std::vector<Reference>& references, std::string_view row_set) const {
  for (const auto& piece : pieces_) {
    if (piece->value) piece->value->collect(references, row_set);
    if (!piece->condition) continue;
    piece->condition->collect(references, row_set);
    piece->then.collect(references, row_set);
    if (piece->otherwise) piece->otherwise->collect(references, row_set);
  }
}

}  // namespace sightline::report
