// Writes the generated sections of the manual, or checks that they equal the text from the code.
//
//   manual_facts --check ROOT FILE...     exit code 1 if a section differs
//   manual_facts --write ROOT FILE...     rewrites the sections in place
//
// A section is between the lines `<!-- begin NAME -->` and `<!-- end NAME -->`. ROOT is the repository.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "facts.hpp"

namespace {

using sightline::base::Error;
using sightline::base::Result;

constexpr std::string_view begin_mark = "<!-- begin ";
constexpr std::string_view end_mark = "<!-- end ";
constexpr std::string_view mark_close = " -->\n";

std::string place(const std::string& text, std::size_t at) {
  std::size_t line = 1;
  for (std::size_t i = 0; i < at; ++i) line += text[i] == '\n' ? 1 : 0;
  return "line " + std::to_string(line);
}

// The text with all sections as generated, and their number.
Result<std::string> rewrite_sections(const std::string& text, const std::string& file, const std::string& root, int& count) {
  std::string result;
  std::size_t at = 0;
  for (;;) {
    const std::size_t begin = text.find(begin_mark, at);
    if (begin == std::string::npos) break;
    const std::size_t name_end = text.find(mark_close, begin);
    if (name_end == std::string::npos) return Error{file, place(text, begin), "a mark without \" -->\"", "one line"};
    const std::string name = text.substr(begin + begin_mark.size(), name_end - begin - begin_mark.size());
    const std::string end_line = std::string(end_mark) + name + " -->\n";
    const std::size_t body = name_end + mark_close.size();
    const std::size_t end = text.find(end_line, body);
    if (end == std::string::npos || text.find(begin_mark, body) < end)
      return Error{file, place(text, begin), "section \"" + name + "\" without an end", end_line};
    const auto made = sightline::manual::section(name, root);
    if (!made) {
      Error error = made.error();
      error.place = place(text, begin);
      if (error.file.empty()) error.file = file;
      return error;
    }
    result += text.substr(at, body - at) + "\n" + made.value() + "\n" + end_line;
    at = end + end_line.size();
    ++count;
  }
  if (const std::size_t stray = text.find(end_mark, at); stray != std::string::npos)
    return Error{file, place(text, stray), "the end of a section that does not begin", std::string(begin_mark)};
  return result + text.substr(at);
}

// The first line that differs, for the message.
std::string first_difference(const std::string& is, const std::string& wanted) {
  std::size_t at = 0;
  while (at < is.size() && at < wanted.size() && is[at] == wanted[at]) ++at;
  const auto line_of = [at](const std::string& text) {
    const std::size_t from = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
    return text.substr(from, text.find('\n', from) - from);
  };
  return place(is, at) + "\n  has     " + line_of(is) + "\n  code    " + line_of(wanted);
}

int complain(const std::string& message) {
  std::fprintf(stderr, "manual_facts: %s\n", message.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view mode = argc > 1 ? argv[1] : "";
  if (argc < 4 || (mode != "--check" && mode != "--write"))
    return complain("usage: manual_facts --check|--write ROOT FILE...") + 1;
  const std::string root = argv[2];
  int count = 0;
  int different = 0;
  for (int i = 3; i < argc; ++i) {
    const std::string file = argv[i];
    std::ifstream in(file, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    if (!in) return complain(file + ": cannot be read");
    const auto wanted = rewrite_sections(text, file, root, count);
    if (!wanted) return complain(wanted.error().message());
    if (wanted.value() == text) continue;
    if (mode == "--write") {
      std::ofstream out(file, std::ios::binary | std::ios::trunc);
      if (!(out << wanted.value()).flush()) return complain(file + ": cannot be written");
    } else {
      ++different;
      complain(file + ": a generated section differs from the code, " + first_difference(text, wanted.value()));
    }
  }
  if (count == 0) return complain("no generated section in these files");
  if (different != 0)
    return complain("rewrite them with `ninja write_manual` in the build folder, and read the change");
  std::printf("%d generated sections\n", count);
  return 0;
}
