#include "host/live/web/requests.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "host/scene/read/builtin.hpp"

namespace sightline::live::web {

std::string text_of(const Json& request, std::string_view key) {
  const Json* const member = request.find(key);
  const std::string* const text = member != nullptr ? member->text() : nullptr;
  return text != nullptr ? *text : std::string();
}
double number_of(const Json& request, std::string_view key, double otherwise) {
  const Json* const member = request.find(key);
  return member != nullptr ? member->number().value_or(otherwise) : otherwise;
}
bool flag_of(const Json& request, std::string_view key, bool otherwise) {
  const Json* const member = request.find(key);
  return member != nullptr ? member->boolean().value_or(otherwise) : otherwise;
}

base::Result<scene::LoadedScene> scene_named(const Workbench& workbench, const std::string& name) {
  if (const Bytes* const bytes = workbench.file(name))
    return scene::load_scene({.name = name, .text = std::string(bytes->begin(), bytes->end())});
  auto found = scene::named_scene(name);
  if (!found) return base::fail(fmt::format("{}: no scene of that name, and no such file on the page", name));
  if (!*found) return std::move(found->error());
  return scene::load_scene(std::move(**found));
}

Json make_pdp7(Workbench& workbench, const std::string& file, const CoreProgram& program, std::uint32_t switches) {
  const auto& formats = guests::run::pdp7().formats;
  const auto octal = std::find_if(formats.begin(), formats.end(), [](const auto& each) { return each.name == "octal"; });
  auto written = octal->write(program.image, file);
  if (!written) return refusal(written.error().message);
  workbench.put_file(file, std::move(*written));
  Json options{{"--load", file}, {"--display", true}, {program.eae ? "--eae" : "--no-eae", true}};
  options.update(program.options);
  Json made = workbench.answer(Json{{"do", "make"}, {"machine", "pdp7"}, {"options", std::move(options)}});
  Desk* const desk = desk_of(workbench, made);
  if (desk == nullptr) return made;
  if (const auto number = desk->debugger().register_named("SR")) desk->debugger().set(*number, switches);
  std::string table;
  for (const auto& [name, value] : program.symbols) table += fmt::format("{} {:o}\n", name, value);
  Symbols symbols(8);
  static_cast<void>(symbols.add_table(table));
  desk->debugger().set_symbols(std::move(symbols));
  desk->debugger().start(*program.image.start);
  return made;
}

Desk* desk_of(Workbench& workbench, const Json& made) {
  const Json* const id = made.find("id");
  return id != nullptr ? workbench.desk(static_cast<int>(*id->integer())) : nullptr;
}

}  // namespace sightline::live::web
