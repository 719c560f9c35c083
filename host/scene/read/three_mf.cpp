// See three_mf.hpp.
#include "host/scene/read/three_mf.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "host/base/number.hpp"
#include "host/base/text.hpp"
#include "host/scene/read/placed_meshes.hpp"
#include "host/scene/read/poly_text.hpp"
#include "host/scene/read/precision.hpp"
#include "host/scene/read/zip_archive.hpp"

namespace sightline::scene {
namespace {

constexpr std::uint64_t most_model_bytes = std::uint64_t{1} << 30;  // inflated, all models together
constexpr std::uint64_t most_tree_bytes = std::uint64_t{4} << 30;   // of one model as a tree
constexpr std::size_t most_levels = 100;                            // of components

struct ThreeMfUnit {
  std::string_view name;
  std::string_view here;  // as other formats name it
  double millimetres;
};
constexpr std::array three_mf_units{ThreeMfUnit{"millimeter", "mm", 1},  ThreeMfUnit{"micron", "um", 0.001},
                                    ThreeMfUnit{"centimeter", "cm", 10}, ThreeMfUnit{"inch", "inch", 25.4},
                                    ThreeMfUnit{"foot", "ft", 304.8},    ThreeMfUnit{"meter", "m", 1000}};

// --- XML with namespaces

std::string_view prefix_of(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? std::string_view() : name.substr(0, colon);
}

std::string_view local_name(std::string_view name) { return name.substr(name.find(':') + 1); }

// What a prefix stands for at a node; empty: nothing. Of an element with any number of attributes, the first hundred count.
std::string_view namespace_of(pugi::xml_node node, std::string_view prefix) {
  for (; node; node = node.parent()) {
    int left = 100;
    for (pugi::xml_attribute attribute = node.first_attribute(); attribute && left-- > 0;
         attribute = attribute.next_attribute()) {
      const std::string_view name = attribute.name();
      if (prefix.empty() ? name == "xmlns" : name.starts_with("xmlns:") && name.substr(6) == prefix) return attribute.value();
    }
  }
  return {};
}

// Whether it is an element of the core specification; files without any namespace are taken, too.
bool is_core(pugi::xml_node node, std::string_view name) {
  if (local_name(node.name()) != name) return false;
  const std::string_view space = namespace_of(node, prefix_of(node.name()));
  return space.empty() || space.find("/3dmanufacturing/core/") != std::string_view::npos ||
         space.find("/3dmanufacturing/2013/01") != std::string_view::npos;
}

pugi::xml_node core_child(pugi::xml_node node, std::string_view name) {
  for (const pugi::xml_node child : node.children())
    if (is_core(child, name)) return child;
  return {};
}

// The attribute "path" of the production extension; empty: there is none.
std::string_view part_named_by(pugi::xml_node node) {
  for (const pugi::xml_attribute attribute : node.attributes()) {
    const std::string_view prefix = prefix_of(attribute.name());
    if (local_name(attribute.name()) == "path" && !prefix.empty() &&
        namespace_of(node, prefix).find("/production/") != std::string_view::npos)
      return attribute.value();
  }
  return {};
}

// "line 3, column 14" of a text's byte.
std::string line_and_column(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte);
  const std::size_t line = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1;
  const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

// --- the models of an archive

struct ThreeMfComponent {
  std::string part;  // empty: the one of the object
  std::string object;
  Transform transform = no_transform;
  std::size_t index = 0;  // of the object, once it is checked
};

struct ThreeMfObject {
  std::size_t part = 0;
  std::string name;
  bool has_name = false;
  std::string type;
  LocalMesh mesh;
  std::vector<ThreeMfComponent> components;

  enum class State : std::uint8_t { unchecked, being_checked, checked };
  State state = State::unchecked;
  std::size_t corners = 0;  // with those of the components
  std::size_t levels = 0;   // of components below
};

struct ThreeMfPart {
  std::string name;
  const ThreeMfUnit* unit = three_mf_units.data();
  std::map<std::string, std::size_t, std::less<>> objects;  // by id
};

class ThreeMfReader {
 public:
  explicit ThreeMfReader(ZipArchive archive) : archive_(std::move(archive)) {
    for (std::size_t i = 0; i < archive_.names().size(); ++i) entries_.emplace(entry_key(archive_.names()[i]), i);
  }

  base::Result<PolyMesh> run() {
    read_modifiers();
    if (const auto root = root_part()) {
      load(*root);
      for (const ThreeMfComponent& item : items_)
        if (!error_) build(item);
    }
    if (error_) return *error_;
    std::vector<std::string> notes;
    for (const auto& [what, count] : left_out_)
      notes.push_back(std::to_string(count) + " " + (count == 1 ? what.first : what.second));
    auto mesh = meshes_.take();
    if (!mesh && !notes.empty())
      return base::Error{"", parts_.front().name, "found only " + notes.front(), "an object to be printed, of type \"model\"",
                         ""};
    if (!mesh && items_.empty())
      return base::Error{"", parts_.front().name, "found nothing that is built", "an item in the element \"build\"",
                         "add the objects to the plate"};
    if (!mesh) return mesh;
    mesh->notes = std::move(notes);
    mesh->unit = parts_.front().unit->here;
    mesh->vertical = 2;
    return mesh;
  }

 private:
  bool fail(std::string place, std::string found, std::string expected, std::string remedy = export_again) {
    if (!error_) error_ = base::Error{"", std::move(place), std::move(found), std::move(expected), std::move(remedy)};
    return false;
  }

  void leave_out(const std::string& one, const std::string& several) { ++left_out_[{one, several}]; }

  // --- parts

  // Names of parts are compared without their first slash and without case.
  static std::string entry_key(std::string_view name) {
    std::string key = base::lower_case(name);
    std::replace(key.begin(), key.end(), '\\', '/');
    key.erase(0, std::min(key.find_first_not_of('/'), key.size()));
    return key;
  }

  // As the archive's relationships say; archives without them are taken, too.
  std::optional<std::size_t> root_part() {
    const auto relations = entries_.find("_rels/.rels");
    if (relations != entries_.end()) {
      constexpr std::uint64_t most = 1 << 20;
      auto text = archive_.read(relations->second, most);
      pugi::xml_document tree;
      if (text && tree.load_buffer_inplace(text->data(), text->size(), pugi::parse_minimal | pugi::parse_escapes)) {
        for (const pugi::xml_node relation : tree.document_element().children()) {
          if (!std::string_view(relation.attribute("Type").value()).ends_with("/3dmodel")) continue;
          const std::string_view target = relation.attribute("Target").value();
          const auto found = entries_.find(entry_key(target));
          if (found != entries_.end()) return found->second;
          fail("_rels/.rels", "found the model " + quoted_excerpt(target), "the name of a part of the archive");
          return std::nullopt;
        }
      }
    }
    const auto usual = entries_.find("3d/3dmodel.model");
    if (usual != entries_.end()) return usual->second;
    for (std::size_t i = 0; i < archive_.names().size(); ++i)
      if (entry_key(archive_.names()[i]).ends_with(".model")) return i;
    fail("byte 0", "found a ZIP archive without a file *.model", "3MF", "");
    return std::nullopt;
  }

  // PrusaSlicer keeps an object's modifiers among its triangles; a file of its own says which triangles these are.
  void read_modifiers() {
    const auto entry = entries_.find("metadata/slic3r_pe_model.config");
    if (entry == entries_.end()) return;
    constexpr std::uint64_t most = 1 << 20;
    auto text = archive_.read(entry->second, most);
    pugi::xml_document tree;
    if (!text || !tree.load_buffer_inplace(text->data(), text->size(), pugi::parse_minimal)) return;
    for (const pugi::xml_node object : tree.document_element().children("object")) {
      for (const pugi::xml_node volume : object.children("volume")) {
        const std::string_view type = volume.find_child_by_attribute("metadata", "key", "volume_type").attribute("value").value();
        const auto first = base::unsigned_number(volume.attribute("firstid").value());
        const auto last = base::unsigned_number(volume.attribute("lastid").value());
        if (!type.empty() && type != "ModelPart" && first && last)
          modifiers_[object.attribute("id").value()].push_back({*first, *last});
      }
    }
  }

  void leave_out_modifiers(const std::string& id, LocalMesh& mesh) {
    const auto found = modifiers_.find(id);
    if (found == modifiers_.end()) return;
    const std::size_t count = mesh.corners.size() / 3;
    // How many modifiers begin and end at each triangle.
    std::vector<std::int32_t> changes(count + 1);
    for (const auto& [first, last] : found->second) {
      leave_out("modifier", "modifiers");
      if (first >= count || first > last) continue;
      ++changes[first];
      --changes[std::min<std::uint64_t>(last, count - 1) + 1];
    }
    std::partial_sum(changes.begin(), changes.end(), changes.begin());
    std::vector<std::uint32_t> kept;
    for (std::size_t c = 0; c < mesh.corners.size(); ++c)
      if (changes[c / 3] == 0) kept.push_back(mesh.corners[c]);
    mesh.corners = std::move(kept);
  }

  // The part of an archive's entry; empty after an error. The first one that is loaded has the build items.
  std::optional<std::size_t> load(std::size_t entry) {
    if (const auto loaded = part_of_entry_.find(entry); loaded != part_of_entry_.end()) return loaded->second;
    const std::string name = printable_name(archive_.names()[entry]);
    auto text = archive_.read(entry, most_model_bytes - model_bytes_);
    if (!text) {
      if (!error_) error_ = std::move(text.error());
      return std::nullopt;
    }
    model_bytes_ += text->size();
    // What pugixml makes of an element with text behind it, and of an attribute.
    const auto count = [&](char c) { return static_cast<std::uint64_t>(std::count(text->begin(), text->end(), c)); };
    if (128 * count('<') + 40 * count('=') > most_tree_bytes) {
      fail(name, "found " + std::to_string(count('<')) + " elements", "a model that takes at most 4 GB of memory",
           "export fewer parts, or as binary STL");
      return std::nullopt;
    }
    pugi::xml_document tree;
    const pugi::xml_parse_result parsed =
        tree.load_buffer_inplace(text->data(), text->size(), pugi::parse_minimal | pugi::parse_escapes);
    if (!parsed) {
      // The tree has written to the text.
      const auto again = archive_.read(entry, most_model_bytes);
      const auto byte = static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0));
      fail(name + (again ? ", " + line_and_column(*again, byte) : ""), "found damaged XML: " + std::string(parsed.description()),
           "a 3MF model");
      return std::nullopt;
    }
    const std::size_t part = parts_.size();
    part_of_entry_[entry] = part;
    parts_.push_back({name, three_mf_units.data(), {}});
    read_model(tree.document_element(), part);
    return error_ ? std::nullopt : std::optional(part);
  }

  void read_model(pugi::xml_node model, std::size_t part) {
    const std::string name = parts_[part].name;
    if (!is_core(model, "model")) {
      fail(name, "found the element " + quoted_excerpt(model.name()), "\"model\"", "export it as 3MF again");
      return;
    }
    if (const pugi::xml_attribute said = model.attribute("unit")) {
      const auto* const unit = std::find_if(three_mf_units.begin(), three_mf_units.end(),
                                            [&](const ThreeMfUnit& u) { return u.name == said.value(); });
      if (unit == three_mf_units.end()) {
        fail(name, "found the unit " + quoted_excerpt(said.value()), "micron, millimeter, centimeter, inch, foot or meter");
        return;
      }
      parts_[part].unit = unit;
    }
    if (!can_do_without(model, name)) return;
    const pugi::xml_node resources = core_child(model, "resources");
    for (const pugi::xml_node object : resources.children())
      if (!error_ && is_core(object, "object")) read_object(object, part);
    if (part > 0) return;
    const pugi::xml_node build = core_child(model, "build");
    std::size_t number = 0;
    for (const pugi::xml_node item : build.children()) {
      if (error_ || !is_core(item, "item")) continue;
      ++number;
      const std::string_view printable = item.attribute("printable").value();
      if (printable == "0" || printable == "false") {
        leave_out("item that is not to be printed", "items that are not to be printed");
        continue;
      }
      items_.push_back(component(item, name + ", item " + std::to_string(number)));
    }
  }

  // False after an error: an extension is required that changes the geometry.
  bool can_do_without(pugi::xml_node model, const std::string& part) {
    std::string_view required = model.attribute("requiredextensions").value();
    while (!required.empty()) {
      const std::string_view prefix = required.substr(0, required.find_first_of(" \t\r\n"));
      required.remove_prefix(std::min(prefix.size() + 1, required.size()));
      const std::string_view space = namespace_of(model, prefix);
      bool harmless = prefix.empty();
      for (const std::string_view family : {"/material/", "/production/", "/slice/", "/trianglesets/"})
        harmless = harmless || space.find(family) != std::string_view::npos;
      if (harmless) continue;
      return fail(part, "found that the extension " + quoted_excerpt(prefix) + " is required, " + quoted_excerpt(space),
                  "the core of 3MF with materials, production parts and slices", "export without it, or as STL");
    }
    return true;
  }

  // --- objects

  void read_object(pugi::xml_node node, std::size_t part) {
    const std::string id = node.attribute("id").value();
    if (objects_.size() == most_placed_copies) {
      fail(parts_[part].name, "found more than " + std::to_string(most_placed_copies) + " objects", "fewer");
      return;
    }
    ThreeMfObject object;
    object.part = part;
    object.mesh.place = parts_[part].name + ", object " + printable_name(id);
    object.type = printable_name(node.attribute("type").value());
    object.has_name = *node.attribute("name").value() != '\0';
    object.name = object.has_name ? node.attribute("name").value() : "Object_" + id;
    if (id.empty()) {
      fail(parts_[part].name, "found an object without id", "an id");
      return;
    }
    if (!parts_[part].objects.emplace(id, objects_.size()).second) {
      fail(object.mesh.place, "found a second object with this id", "another id");
      return;
    }
    if (const pugi::xml_node mesh = core_child(node, "mesh")) {
      read_mesh(mesh, object.mesh);
      if (part == 0) leave_out_modifiers(id, object.mesh);
      leave_out_unused(object.mesh);
      for (const pugi::xml_node child : mesh.children())
        if (local_name(child.name()) == "beamlattice") leave_out("lattice of beams", "lattices of beams");
    }
    if (const pugi::xml_node components = core_child(node, "components")) {
      for (const pugi::xml_node child : components.children())
        if (!error_ && is_core(child, "component"))
          object.components.push_back(
              component(child, object.mesh.place + ", component " + std::to_string(object.components.size() + 1)));
    }
    objects_.push_back(std::move(object));
  }

  // The elements vertex and triangle are the bulk of a file: their namespaces are not examined.
  void read_mesh(pugi::xml_node node, LocalMesh& mesh) {
    TextPrecision precision;
    for (const pugi::xml_node vertex : core_child(node, "vertices").children()) {
      if (local_name(vertex.name()) != "vertex") continue;
      std::array<std::optional<double>, 3> point;
      for (const pugi::xml_attribute attribute : vertex.attributes()) {
        const std::string_view name = attribute.name();
        if (name.size() != 1 || name[0] < 'x' || name[0] > 'z') continue;
        const std::string_view written = attribute.value();
        const auto value = base::decimal_number(written);
        if (!value) {
          fail(mesh.place + ", vertex " + std::to_string(mesh.vertices.size()), "found " + quoted_excerpt(written), "a number");
          return;
        }
        precision.add(written, *value);
        point[static_cast<std::size_t>(name[0] - 'x')] = value;
      }
      for (std::size_t a = 0; a < 3; ++a) {
        if (point[a]) continue;
        fail(mesh.place + ", vertex " + std::to_string(mesh.vertices.size()), std::string("found no attribute ") + "xyz"[a],
             "x, y and z");
        return;
      }
      mesh.vertices.push_back({*point[0], *point[1], *point[2]});
    }
    for (const pugi::xml_node triangle : core_child(node, "triangles").children()) {
      if (local_name(triangle.name()) != "triangle") continue;
      read_triangle(triangle, mesh);
      if (error_) return;
    }
    mesh.precision = precision.result(mesh.vertices);
  }

  // Of a mesh with more vertices than corners, so that its copies cost no more than their faces.
  static void leave_out_unused(LocalMesh& mesh) {
    if (mesh.vertices.size() <= mesh.corners.size()) return;
    std::vector<std::array<double, 3>> used;
    for (const std::uint32_t v : number_used_vertices(mesh.corners)) used.push_back(mesh.vertices[v]);
    mesh.vertices = std::move(used);
  }

  void read_triangle(pugi::xml_node triangle, LocalMesh& mesh) {
    std::array<std::string_view, 3> written;
    for (const pugi::xml_attribute attribute : triangle.attributes()) {
      const std::string_view name = attribute.name();
      if (name.size() == 2 && name[0] == 'v' && name[1] >= '1' && name[1] <= '3')
        written[static_cast<std::size_t>(name[1] - '1')] = attribute.value();
    }
    for (const std::string_view text : written) {
      const auto vertex = base::unsigned_number(text);
      if (!vertex || *vertex >= mesh.vertices.size()) {
        const std::size_t face = mesh.corners.size() / 3;
        const std::string range =
            mesh.vertices.empty() ? "a mesh with vertices" : "0 to " + std::to_string(mesh.vertices.size() - 1);
        fail(mesh.place + ", face " + std::to_string(face),
             "found vertex " + (vertex ? std::to_string(*vertex) : quoted_excerpt(text)), range);
        return;
      }
      mesh.corners.push_back(static_cast<std::uint32_t>(*vertex));
    }
  }

  // Of a component or build item.
  ThreeMfComponent component(pugi::xml_node node, const std::string& place) {
    ThreeMfComponent result;
    if (++references_ > most_placed_copies) {
      fail(place, "found more than " + std::to_string(most_placed_copies) + " items and components", "fewer");
      return result;
    }
    result.part = part_named_by(node);
    result.object = node.attribute("objectid").value();
    const std::string_view written = node.attribute("transform").value();
    if (written.empty()) return result;
    // Of rows times matrix: the fourth row moves.
    std::array<double, 12> m{};
    std::size_t count = 0;
    std::size_t at = 0;
    while ((at = written.find_first_not_of(" \t\r\n", at)) != std::string_view::npos) {
      const std::size_t end = std::min(written.find_first_of(" \t\r\n", at), written.size());
      const auto number = base::decimal_number(written.substr(at, end - at));
      if (!number || count == m.size()) {
        fail(place, "found the transform " + quoted_excerpt(written), "twelve numbers");
        return result;
      }
      m[count++] = *number;
      at = end;
    }
    if (count != m.size()) fail(place, "found a transform of " + std::to_string(count) + " numbers", "twelve");
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j) result.transform[i][j] = m[3 * j + i];
    return result;
  }

  // --- what is built

  // What a component of a part names; empty after an error.
  std::optional<std::size_t> object_of(const ThreeMfComponent& component, std::size_t part, const std::string& place) {
    if (!component.part.empty()) {
      const auto entry = entries_.find(entry_key(component.part));
      if (entry == entries_.end()) {
        fail(place, "found the part " + quoted_excerpt(component.part), "the name of a part of the archive");
        return std::nullopt;
      }
      const auto loaded = load(entry->second);
      if (!loaded) return std::nullopt;
      part = *loaded;
    }
    const auto found = parts_[part].objects.find(component.object);
    if (found != parts_[part].objects.end()) return found->second;
    fail(place, "found the object " + quoted_excerpt(component.object), "the id of an object of " + parts_[part].name);
    return std::nullopt;
  }

  static bool is_printed(const ThreeMfObject& object) {
    return object.type != "support" && object.type != "solidsupport" && object.type != "other";
  }

  bool fail_by_levels(const std::string& place) {
    return fail(place, "found components in more than " + std::to_string(most_levels) + " levels", "fewer");
  }

  // Loads what an object consists of, and counts its corners. False after an error: it contains itself, or what is not there.
  bool check(std::size_t index, std::size_t level) {
    const std::string place = objects_[index].mesh.place;
    if (objects_[index].state == ThreeMfObject::State::checked) return true;
    if (objects_[index].state == ThreeMfObject::State::being_checked)
      return fail(place, "found an object that contains itself", "components of other objects");
    if (level > most_levels) return fail_by_levels(place);
    objects_[index].state = ThreeMfObject::State::being_checked;
    if (!is_printed(objects_[index])) {
      const std::string type = " of type \"" + objects_[index].type + "\"";
      leave_out("object" + type, "objects" + type);
      objects_[index].state = ThreeMfObject::State::checked;
      return true;
    }
    std::size_t corners = objects_[index].mesh.corners.size();
    std::size_t levels = 0;
    // Loading a part adds objects.
    for (std::size_t c = 0; c < objects_[index].components.size(); ++c) {
      const auto inner =
          object_of(objects_[index].components[c], objects_[index].part, place + ", component " + std::to_string(c + 1));
      if (!inner || !check(*inner, level + 1)) return false;
      objects_[index].components[c].index = *inner;
      corners = std::min(corners + objects_[*inner].corners, most_placed_corners + 1);
      levels = std::max(levels, objects_[*inner].levels + 1);
    }
    if (levels > most_levels) return fail_by_levels(place);
    // So that each step of place_copy has faces to place.
    std::erase_if(objects_[index].components, [&](const ThreeMfComponent& c) { return objects_[c.index].corners == 0; });
    objects_[index].corners = corners;
    objects_[index].levels = levels;
    objects_[index].state = ThreeMfObject::State::checked;
    return true;
  }

  void build(const ThreeMfComponent& item) {
    const auto object = object_of(item, 0, parts_.front().name + ", build");
    if (!object || !check(*object, 0)) return;
    built_corners_ += objects_[*object].corners;
    if (built_corners_ > most_placed_corners) {
      fail(objects_[*object].mesh.place,
           "found more than " + std::to_string(most_placed_corners) + " corners of faces, copies counted", "",
           "export fewer copies, or fewer faces");
      return;
    }
    place_copy(*object, scaled(item.transform, 0, objects_[*object].part), "");
  }

  // Each part has a unit of its own.
  Transform scaled(Transform transform, std::size_t part, std::size_t inner) const {
    const double scale = parts_[inner].unit->millimetres / parts_[part].unit->millimetres;
    for (auto& row : transform)
      for (std::size_t j = 0; j < 3; ++j) row[j] *= scale;
    return transform;
  }

  // Of a checked object. `name`: of the innermost object around it that has one.
  void place_copy(std::size_t index, const Transform& transform, const std::string& name) {
    const ThreeMfObject& object = objects_[index];
    if (object.corners == 0 || error_) return;
    const std::string& nearest = object.has_name || name.empty() ? object.name : name;
    if (!object.mesh.corners.empty()) {
      meshes_.begin_body(nearest);
      auto added = meshes_.add(object.mesh, transform);
      if (!added) error_ = std::move(added.error());
    }
    for (const ThreeMfComponent& component : object.components) {
      const Transform local = scaled(component.transform, object.part, objects_[component.index].part);
      place_copy(component.index, product(transform, local), object.has_name ? object.name : name);
    }
  }

  ZipArchive archive_;
  std::map<std::string, std::size_t, std::less<>> entries_;
  std::map<std::size_t, std::size_t> part_of_entry_;
  std::uint64_t model_bytes_ = 0;
  std::vector<ThreeMfPart> parts_;  // the first one is the archive's model
  std::vector<ThreeMfObject> objects_;
  std::vector<ThreeMfComponent> items_;
  std::size_t references_ = 0;  // items and components
  std::map<std::string, std::vector<std::array<std::uint64_t, 2>>> modifiers_;  // the first and last triangle of each, by object
  std::size_t built_corners_ = 0;
  std::map<std::pair<std::string, std::string>, std::size_t> left_out_;  // one and several of what, and how many
  PlacedMeshes meshes_;
  std::optional<base::Error> error_;
};

}  // namespace

base::Result<PolyMesh> read_three_mf(std::string_view bytes, std::string_view source) {
  auto archive = ZipArchive::open(bytes);
  auto mesh = archive ? ThreeMfReader(std::move(*archive)).run() : base::Result<PolyMesh>(std::move(archive.error()));
  if (mesh) {
    mesh->source = source;
    return mesh;
  }
  base::Error error = std::move(mesh.error());
  error.file = source;
  return error;
}

}  // namespace sightline::scene
