#include "host/explain/lesson_page.hpp"

namespace sightline::explain {
namespace {

std::string_view player_file(std::string_view name) {
  for (const auto& [file, content] : player_files())
    if (file == name) return content;
  return {};
}

// Only "<" can end a script element or begin a comment in it; as an escape it is the same JSON.
std::string for_script(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

std::string page_of(const Lesson& lesson) {
  std::string page;
  std::string_view rest = player_file("page.html");
  while (!rest.empty()) {
    const std::size_t open = rest.find("{{");
    page += rest.substr(0, open);
    if (open == std::string_view::npos) break;
    const std::size_t close = rest.find("}}", open);
    const std::string_view name = rest.substr(open + 2, close - open - 2);
    page += name == "lesson" ? for_script(json_of(lesson)) : std::string(player_file(name));
    rest = rest.substr(close + 2);
  }
  return page;
}

}  // namespace sightline::explain
