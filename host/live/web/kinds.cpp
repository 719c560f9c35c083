// The request that finds the kind of a file.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "host/base/text.hpp"
#include "host/machines/engine.hpp"
#include "host/machines/machine.hpp"
#include "host/machines/state.hpp"
#include "host/live/snapshot.hpp"
#include "host/live/web/requests.hpp"
#include "host/scene/heights/read_grid.hpp"
#include "host/scene/heights/grid_formats.hpp"
#include "host/scene/read/cell_complex_file.hpp"
#include "host/scene/read/changes.hpp"
#include "host/scene/read/json_documents.hpp"
#include "host/scene/read/load.hpp"
#include "host/scene/read/poly_file.hpp"

namespace sightline::live::web {
namespace {

using machines::MachineDescription;
using scene::PolyFormat;

constexpr std::string_view expected =
    "a mesh or scene (STL, PLY, OFF, OBJ, JSON), a grid of heights (CSV, ESRI, Surfer), a source, a program "
    "or tape (RIM, HRI, octal, Intel HEX, "
    ".com), a snapshot or a lesson";
// Texts of at most so many bytes are tried with both assemblers.
constexpr std::size_t largest_guess = 1 << 20;

struct File {
  const std::string& name;
  const Bytes& bytes;
  std::string_view text;  // the same bytes without a byte-order mark

  [[nodiscard]] bool ends_in(std::initializer_list<std::string_view> endings) const {
    const std::string small = base::lower_case(name);
    return std::any_of(endings.begin(), endings.end(),
                       [&small](std::string_view each) { return small.ends_with(each); });
  }
};

Json kind(std::string_view name, std::string_view title) {
  return Json{{"kind", name}, {"title", title}};
}
Json kind_of_machine(std::string_view name, std::string_view title, const MachineDescription& machine) {
  return Json{{"kind", name}, {"title", title}, {"machine", machine.name}};
}
// The answer for a damaged file of a kind.
Json damaged(std::string_view name, std::string_view complaint) {
  return Json{{"kind", name}, {"error", complaint}};
}

bool is_text(std::string_view text) {
  return std::none_of(text.begin(), text.end(), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code == 0177 ||
           (code < ' ' && (code < '\t' || code > '\r') && code != 032);  // CP/M ends texts with 32
  });
}

// The beginning of the first line that is not empty, or the first bytes of a binary file.
std::string beginning_of(const File& file) {
  if (const std::string_view format = scene::foreign_format_of(file.text); !format.empty())
    return std::string(format);
  if (!is_text(file.text)) {
    std::string digits;
    for (std::size_t i = 0; i < std::min<std::size_t>(file.bytes.size(), 4); ++i)
      digits += fmt::format(" {:02X}", file.bytes[i]);
    return fmt::format("binary data that begins with{}", digits);
  }
  std::string_view rest = base::without_blanks(file.text);
  std::string line(base::without_blanks(base::take_line(rest)));
  constexpr std::size_t longest = 40;
  if (line.size() > longest) {
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U)
      --end;  // not inside a UTF-8 character
    line = line.substr(0, end) + "...";
  }
  return line.empty() ? "a text of blanks only" : fmt::format("a text that begins with \"{}\"", line);
}
Json unknown(const File& file) {
  return damaged("unknown",
                 fmt::format("{}: found {}, expected {}", file.name, beginning_of(file), expected));
}

Json snapshot(const File& file) {
  const auto read = decode_snapshot(file.bytes, file.name);
  if (!read) return damaged("snapshot", read.error().message());
  const bool pdp7 = read->machine == machines::pdp7().name;
  Json answer = kind_of_machine("snapshot", pdp7 ? "a snapshot of a PDP-7" : "a snapshot of an 8080",
                                pdp7 ? machines::pdp7() : machines::i8080());
  Json configuration = Json::array();
  for (const std::string& word : read->configuration) configuration.push_back(word);
  answer["configuration"] = std::move(configuration);
  return answer;
}

Json scene_file(const File& file) {
  const scene::SceneFile given{.name = file.name, .text = std::string(file.text)};
  const PolyFormat format = scene::poly_format_of(file.name, file.text);
  if (!scene::can_be_written(format)) {
    return damaged("scene", fmt::format("{}: found a glTF or 3MF file, which this page does not read, "
                                        "expected STL, PLY, OFF, OBJ or JSON; convert it "
                                        "with: sightline scene convert {} -o mesh.stl",
                                        file.name, base::shell_word(file.name)));
  }
  const auto loaded = scene::load_scene(given, {.mend = true});
  if (!loaded) return damaged("scene", loaded.error().message());
  const std::size_t faces = scene::face_count(loaded->scene);
  const bool cells = loaded->cells.has_value();
  Json answer =
      kind("scene", cells ? "a scene of cells"
                          : fmt::format("a {} of {} face{}", scene::can_be_mended(given) ? "mesh" : "scene",
                                        faces, faces == 1 ? "" : "s"));
  answer["faces"] = faces;
  answer["cells"] = cells;
  if (const std::string changes = scene::changes_text(loaded->report); !changes.empty()) answer["changes"] = changes;
  return answer;
}

Json grid(const File& file) {
  const auto read = scene::read_height_grid(file.text, file.name, {.thin_to_fit = true});
  if (!read) return damaged("grid", read.error().message());
  const std::string note = read->note.empty() ? "" : "; " + read->note;
  return kind("grid", fmt::format("a grid of {} by {} heights{}", read->points(), read->slices(), note));
}

Json json_file(const File& file) {
  if (scene::is_cell_complex(file.text)) return scene_file(file);
  const auto document = base::parse_json(file.text, file.name);
  if (!document) return damaged("unknown", document.error().message());
  if (const Json* const schema = document->find("schema"); schema != nullptr && schema->text() != nullptr) {
    if (*schema->text() == "sightline/explain/1") return kind("lesson", "a lesson");
    return damaged("unknown", fmt::format("{}: found a JSON document of the schema \"{}\", expected a scene "
                                          "or a lesson (sightline/explain/1)",
                                          file.name, *schema->text()));
  }
  if (scene::is_poly_document(*document) || document->find("cells") != nullptr) return scene_file(file);
  return unknown(file);
}

// Whether a format of the machine reads the file without an error.
bool reads_as(const MachineDescription& machine, std::string_view format, const File& file) {
  const auto found = std::find_if(machine.formats.begin(), machine.formats.end(),
                                  [format](const auto& each) { return each.name == format; });
  return found->recognise(file.bytes) &&
         found->read(file.bytes, file.name, format == "hri" ? std::optional<std::uint32_t>(0) : std::nullopt);
}

std::optional<Json> program(const File& file) {
  const MachineDescription& pdp7 = machines::pdp7();
  const MachineDescription& i8080 = machines::i8080();
  const auto found = std::find_if(i8080.formats.begin(), i8080.formats.end(),
                                  [](const auto& each) { return each.name == "hex"; });
  if (found->recognise(file.bytes))
    return kind_of_machine("program", "a program of the 8080 in Intel HEX", i8080);
  for (const MachineDescription* const machine : {&pdp7, &i8080})
    if (machines::is_dump(*machine, file.bytes))
      return kind_of_machine("program", machine == &pdp7 ? "a dump of a PDP-7" : "a dump of an 8080",
                             *machine);
  if (is_text(file.text)) {
    if (reads_as(pdp7, "octal", file))
      return kind_of_machine("program", "an octal core image of the PDP-7", pdp7);
  } else if (reads_as(pdp7, "rim", file)) {
    return kind_of_machine("program", "a RIM tape of the PDP-7", pdp7);
  } else if (reads_as(pdp7, "hri", file)) {
    return kind_of_machine("program", "an HRI tape of the PDP-7", pdp7);
  }
  return std::nullopt;
}

Json source(const MachineDescription& machine) {
  return kind_of_machine("source", machine.name == "pdp7" ? "a source of the PDP-7" : "a source of the 8080",
                         machine);
}
// A text that one of the assemblers assembles to words without an error.
std::optional<Json> assembled(const File& file) {
  if (file.text.size() > largest_guess) return std::nullopt;
  for (const MachineDescription* const machine : {&machines::pdp7(), &machines::i8080()}) {
    const std::array<assembler::SourceFile, 1> sources{
        assembler::SourceFile{file.name, std::string(file.text)}};
    const machines::Arguments options(machine->assembler.options);
    const auto made =
        machine->assembler.assemble(sources, options, [](const std::string&) { return std::nullopt; });
    if (made && !assembler::any_errors(made->diagnostics) && !made->program.words.empty())
      return source(*machine);
  }
  return std::nullopt;
}

Json kind_by_name(const File& file) {
  if (file.ends_in({".rim", ".hri", ".tape", ".ptp"}))
    return kind_of_machine("program", "a tape", machines::pdp7());
  if (!is_text(file.text) && file.ends_in({".com", ".bin"}))
    return kind_of_machine("program", "a program of the 8080", machines::i8080());
  if (file.ends_in({".csv", ".tsv", ".asc", ".grd", ".xyz"})) return grid(file);
  const auto format = scene::poly_format_of(file.name);
  // A .json file that is no JSON is unknown.
  if (format && *format != PolyFormat::json) return scene_file(file);
  return unknown(file);
}

Json kind_of(const File& file) {
  constexpr auto& signature = machines::snapshot_signature;
  if (file.bytes.empty())
    return damaged("unknown", fmt::format("{}: found an empty file, expected {}", file.name, expected));
  if (file.bytes.size() >= signature.size() &&
      std::equal(signature.begin(), signature.end(), file.bytes.begin()))
    return snapshot(file);
  // By content only: for a text that is no mesh, poly_format_of(".json") returns JSON.
  const PolyFormat mesh = scene::poly_format_of(".json", file.text);
  const bool other_archive = mesh == PolyFormat::threemf && !file.ends_in({".3mf"});
  if (mesh != PolyFormat::json && !other_archive) return scene_file(file);
  if (const std::string_view first = base::without_blanks(file.text).substr(0, 1);
      first == "{" || first == "[")
    return json_file(file);
  if (!scene::foreign_format_of(file.text).empty()) return unknown(file);
  if (scene::grid_format_of(file.text, file.name) != nullptr) return grid(file);
  if (auto found = program(file)) return std::move(*found);
  if (!is_text(file.text)) return kind_by_name(file);
  if (file.text.starts_with("newmtl") || file.ends_in({".mtl"}))
    return kind("material", "the materials of an OBJ file");
  if (file.ends_in({".asm", ".mac", ".src"})) return source(machines::i8080());
  if (file.ends_in({".s", ".pal"})) return source(machines::pdp7());
  if (scene::read_height_grid(file.text, file.name, {.thin_to_fit = true})) return grid(file);
  if (auto found = assembled(file)) return std::move(*found);
  return kind_by_name(file);
}

}  // namespace

Json kinds_answer(Workbench& workbench, std::string_view what, const Json& request) {
  if (what != "kind") return {};
  const std::string name = text_of(request, "file");
  const Bytes* const bytes = workbench.file(name);
  if (bytes == nullptr) return error_answer(fmt::format("{}: no such file on the page", name));
  const std::string text(bytes->begin(), bytes->end());
  return kind_of({name, *bytes, base::without_byte_order_mark(text)});
}

}  // namespace sightline::live::web
