#include "host/scene/read/json_text.hpp"

#include "host/base/result.hpp"

namespace sightline::scene {

base::Error json_syntax_error(std::string_view source, std::string_view what) {
  const std::size_t line = what.find("line ");
  const std::size_t colon = what.find(": ", line == std::string_view::npos ? 0 : line);
  if (line == std::string_view::npos || colon == std::string_view::npos)
    return {std::string(source), "", std::string(what)};
  return {std::string(source), std::string(what.substr(line, colon - line)),
          std::string(what.substr(colon + 2))};
}

std::string indexed(std::string_view place, std::size_t i) {
  return std::string(place) + "[" + std::to_string(i) + "]";
}

}  // namespace sightline::scene
