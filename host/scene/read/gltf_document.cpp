// See gltf_document.hpp.
#include "host/scene/read/gltf_document.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <utility>

#include "host/base/file.hpp"
#include "host/scene/read/poly_text.hpp"

namespace sightline::scene {
namespace {

constexpr std::uint64_t most_json_number = std::uint64_t{1} << 53;
constexpr std::uint64_t most_zeros = 10'000'000;               // elements of an accessor without a buffer
constexpr std::uint64_t most_sparse = 100'000'000;             // of all accessors
constexpr std::size_t most_file_bytes = std::size_t{2} << 30;  // of all files that are named

enum GltfComponent : std::uint16_t {
  gltf_int8 = 5120,
  gltf_uint8 = 5121,
  gltf_int16 = 5122,
  gltf_uint16 = 5123,
  gltf_uint32 = 5125,
  gltf_float32 = 5126
};

// 0: no component type.
std::size_t component_size(std::uint64_t type) {
  switch (type) {
    case gltf_int8:
    case gltf_uint8: return 1;
    case gltf_int16:
    case gltf_uint16: return 2;
    case gltf_uint32:
    case gltf_float32: return 4;
    default: return 0;
  }
}

std::uint32_t component_word(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < size; ++i) word |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + i])} << (8 * i);
  return word;
}

double component_value(std::uint32_t word, unsigned type) {
  switch (type) {
    case gltf_int8: return static_cast<std::int8_t>(word);
    case gltf_int16: return static_cast<std::int16_t>(word);
    case gltf_float32: return static_cast<double>(std::bit_cast<float>(word));
    default: return word;
  }
}

std::string percent_decoded(std::string_view text) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
  };
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0) {
      result += static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2]));
      i += 2;
    } else {
      result += text[i];
    }
  }
  return result;
}

// RFC 4648; empty if there is another character.
std::optional<std::string> base64_decoded(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string result;
  result.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  unsigned count = 0;
  for (const char c : text) {
    const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+'             ? 62
                      : c == '/'             ? 63
                                             : -1;
    if (digit < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    result += static_cast<char>(bits >> count & 0xffU);
  }
  return result;
}

}  // namespace

double GltfAccessor::value(std::uint64_t i, std::size_t c) const {
  std::uint32_t word = 0;
  if (!bytes.empty()) word = component_word(bytes, i * stride + c * size, size);
  if (sparse > 0) {
    std::uint64_t low = 0;
    std::uint64_t high = sparse;
    while (low < high) {
      const std::uint64_t middle = (low + high) / 2;
      if (component_word(places, middle * place_size, place_size) < i)
        low = middle + 1;
      else
        high = middle;
    }
    if (low < sparse && component_word(places, low * place_size, place_size) == i)
      word = component_word(values, (low * components + c) * size, size);
  }
  const double number = component_value(word, type);
  return unit == 1 ? number : std::max(number * unit, -1.0);
}

std::uint64_t GltfAccessor::whole(std::uint64_t i) const {
  if (sparse == 0 && !bytes.empty()) return component_word(bytes, i * stride, size);
  return static_cast<std::uint64_t>(value(i, 0));
}

void GltfDocument::fail(const std::string& place, std::string found, std::string expected, std::string remedy) {
  if (error_) return;
  error_ = base::Error{"", place, std::move(found), std::move(expected), remedy.empty() ? export_again : std::move(remedy)};
}

std::optional<GltfEntry> GltfDocument::entry(const std::string& kind, const base::Json& reference, const std::string& place) {
  if (error_) return std::nullopt;
  auto [known, is_new] = kinds_.try_emplace(kind);
  Kind& entries = known->second;
  if (is_new) {
    entries.all = root_.find(kind);
    if (entries.all != nullptr)
      for (const base::JsonMember& member : entries.all->members()) entries.named[member.key] = &member.value;
  }
  const base::Json* const all = entries.all;
  const std::size_t count = all != nullptr && all->is_array() ? all->size() : 0;
  const auto number = reference.number();
  GltfEntry entry;
  if (const std::string* const name = reference.text(); name != nullptr && !entries.named.empty()) {
    const auto found = entries.named.find(*name);
    if (found != entries.named.end()) entry = {found->second, kind + "." + printable_name(*name)};
  } else if (number && *number >= 0 && *number < static_cast<double>(count) && std::floor(*number) == *number) {
    const auto i = static_cast<std::size_t>(*number);
    entry = {&(*all)[i], base::indexed(kind, i)};
  }
  constexpr std::size_t most_members = 1000;  // each is looked for by going through all
  if (entry.json != nullptr && entry.json->members().size() <= most_members) return entry;
  if (entry.json != nullptr) {
    fail(entry.place, "found an object of " + std::to_string(entry.json->size()) + " members",
         "at most " + std::to_string(most_members));
    return std::nullopt;
  }
  std::string expected = "the number of one of the " + std::to_string(count) + " " + kind + ", from 0";
  if (count == 0) expected = entries.named.empty() ? "a file with " + kind : "a name of " + kind;
  fail(place, "found " + (reference.is_string() ? quoted_excerpt(*reference.text()) : base::describe(reference)), expected);
  return std::nullopt;
}

std::optional<GltfEntry> GltfDocument::entry_of(const std::string& kind, const GltfEntry& from, const std::string& member) {
  const base::Json* const reference = from.json->find(member);
  if (reference != nullptr) return entry(kind, *reference, from.place + "." + member);
  fail(from.place, "found no member \"" + member + "\"", "one of the " + kind);
  return std::nullopt;
}

std::optional<std::uint64_t> GltfDocument::whole(const GltfEntry& from, const std::string& member, std::uint64_t most,
                                                 std::optional<std::uint64_t> otherwise) {
  if (error_) return std::nullopt;
  const base::Json* const json = from.json->find(member);
  if (json == nullptr && otherwise) return otherwise;
  const auto number = json == nullptr ? std::nullopt : json->number();
  if (number && *number >= 0 && *number <= static_cast<double>(most) && std::floor(*number) == *number)
    return static_cast<std::uint64_t>(*number);
  fail(from.place + "." + member, "found " + (json == nullptr ? "nothing" : base::describe(*json)),
       "a whole number up to " + std::to_string(most));
  return std::nullopt;
}

bool GltfDocument::numbers(const GltfEntry& from, const std::string& member, std::size_t count, double* values) {
  const base::Json* const json = from.json->find(member);
  if (json == nullptr || error_) return false;
  for (std::size_t i = 0; i < count && json->size() == count && json->is_array(); ++i) {
    const auto number = (*json)[i].number();
    if (!number) {
      fail(base::indexed(from.place + "." + member, i), "found " + base::describe((*json)[i]), "a number");
      return false;
    }
    values[i] = *number;
  }
  if (json->is_array() && json->size() == count) return true;
  fail(from.place + "." + member, "found " + base::describe(*json), "an array of " + std::to_string(count));
  return false;
}

std::optional<std::string> GltfDocument::bytes_of(const std::string& uri, const std::string& place) {
  constexpr std::string_view scheme = "data:";
  if (uri.starts_with(scheme)) {
    const std::size_t comma = uri.find(',');
    const std::string_view data = comma == std::string::npos ? std::string_view() : std::string_view(uri).substr(comma + 1);
    if (comma == std::string::npos || !std::string_view(uri).substr(0, comma).ends_with(";base64")) return percent_decoded(data);
    auto bytes = base64_decoded(data);
    if (!bytes) bytes = base64_decoded(percent_decoded(data));
    if (!bytes) fail(place, "found a character that is none of base64", "A to Z, a to z, 0 to 9, + and /");
    return bytes;
  }
  const std::string name = percent_decoded(uri);
  const std::string shown = "found " + quoted_excerpt(name);
  if (folder_.empty()) {
    fail(place, shown + ", which has no folder to be read from: the file came from standard input", "",
         "give the file by its name");
    return std::nullopt;
  }
  std::error_code failed;
  const std::filesystem::path root = std::filesystem::canonical(folder_, failed);
  const std::filesystem::path path = std::filesystem::weakly_canonical(root / name, failed);
  const auto [end, unused] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
  if (failed || root.empty() || end != root.end() || name.starts_with('/') || name.find('\0') != std::string::npos) {
    fail(place, shown + ", which is outside of the file's folder, and not read", "",
         "move both files into one folder and write its name here");
    return std::nullopt;
  }
  if (!std::filesystem::is_regular_file(path, failed)) {
    fail(place, shown + ", which is not in the file's folder", "", "put it beside the file, or export as GLB");
    return std::nullopt;
  }
  const auto bytes = base::read_file(path.string(), most_file_bytes - file_bytes_);
  if (!bytes) {
    fail(place, bytes.error().message(), "", "make the file readable");
    return std::nullopt;
  }
  file_bytes_ += bytes->size();
  return std::string(bytes->begin(), bytes->end());
}

std::optional<std::string_view> GltfDocument::buffer(const GltfEntry& entry) {
  const auto length = whole(entry, "byteLength", most_json_number);
  if (!length) return std::nullopt;
  std::string_view bytes;
  const base::Json* const uri = entry.json->find("uri");
  if (uri == nullptr && !binary_.empty() && entry.place == "buffers[0]") {
    bytes = binary_;
  } else if (uri == nullptr || uri->text() == nullptr) {
    fail(entry.place + ".uri", "found " + (uri == nullptr ? "none" : base::describe(*uri)), "the name of a file or its bytes");
    return std::nullopt;
  } else {
    auto known = buffers_.find(entry.json);
    if (known == buffers_.end()) {
      auto read = bytes_of(*uri->text(), entry.place + ".uri");
      if (!read) return std::nullopt;
      known = buffers_.emplace(entry.json, std::move(*read)).first;
    }
    bytes = known->second;
  }
  if (*length <= bytes.size()) return bytes.substr(0, *length);
  fail(entry.place + ".byteLength", "found " + std::to_string(*length),
       "at most the " + std::to_string(bytes.size()) + " bytes that are there");
  return std::nullopt;
}

std::optional<std::string_view> GltfDocument::view(const GltfEntry& entry) {
  const auto whose = entry_of("buffers", entry, "buffer");
  const auto bytes = whose ? buffer(*whose) : std::nullopt;
  if (!bytes) return std::nullopt;
  const auto offset = whole(entry, "byteOffset", bytes->size(), 0);
  if (!offset) return std::nullopt;
  const auto length = whole(entry, "byteLength", bytes->size() - *offset);
  if (!length) return std::nullopt;
  return bytes->substr(*offset, *length);
}

// The bytes of `count` elements of `element` bytes in the buffer view that a member bufferView names.
std::optional<std::string_view> GltfDocument::part_of_view(const GltfEntry& from, const std::string& place, std::uint64_t count,
                                                           std::size_t element, std::size_t stride) {
  const auto whose = entry_of("bufferViews", from, "bufferView");
  const auto bytes = whose ? view(*whose) : std::nullopt;
  if (!bytes) return std::nullopt;
  const auto offset = whole(from, "byteOffset", bytes->size(), 0);
  if (!offset) return std::nullopt;
  const std::uint64_t needed = count == 0 ? 0 : (count - 1) * stride + element;
  if (needed <= bytes->size() - *offset) return bytes->substr(*offset);
  fail(place, "found " + std::to_string(count) + " elements of " + std::to_string(stride) + " bytes",
       "at most the " + std::to_string(bytes->size() - *offset) + " bytes that " + whose->place + " has left");
  return std::nullopt;
}

bool GltfDocument::read_sparse(const GltfEntry& sparse, GltfAccessor& accessor) {
  const auto count = whole(sparse, "count", accessor.count);
  if (!count) return false;
  // Many accessors may name the same bytes.
  sparse_elements_ += *count;
  if (sparse_elements_ > most_sparse) {
    fail(sparse.place + ".count", "found more than " + std::to_string(most_sparse) + " sparse elements in all", "",
         "export without them");
    return false;
  }
  const base::Json* const indices = sparse.json->find("indices");
  const base::Json* const values = sparse.json->find("values");
  if (indices == nullptr || values == nullptr) {
    fail(sparse.place, "found no indices or no values", "both");
    return false;
  }
  const GltfEntry where{indices, sparse.place + ".indices"};
  const auto type = whole(where, "componentType", gltf_float32);
  if (!type) return false;
  if (*type != gltf_uint8 && *type != gltf_uint16 && *type != gltf_uint32) {
    fail(where.place + ".componentType", "found " + std::to_string(*type), "5121, 5123 or 5125");
    return false;
  }
  accessor.place_size = component_size(*type);
  const auto places = part_of_view(where, where.place, *count, accessor.place_size, accessor.place_size);
  const std::size_t element = accessor.components * accessor.size;
  const auto replaced = places
                            ? part_of_view({values, sparse.place + ".values"}, sparse.place + ".values", *count, element, element)
                            : std::nullopt;
  if (!replaced) return false;
  accessor.places = *places;
  accessor.values = *replaced;
  std::uint64_t least = 0;
  for (std::uint64_t i = 0; i < *count; ++i) {
    const std::uint64_t place = component_word(*places, i * accessor.place_size, accessor.place_size);
    if (place < least || place >= accessor.count) {
      fail(where.place, "found " + std::to_string(place) + " at " + std::to_string(i),
           "ascending numbers below " + std::to_string(accessor.count));
      return false;
    }
    least = place + 1;
  }
  accessor.sparse = *count;
  return true;
}

std::optional<GltfAccessor> GltfDocument::accessor(const GltfEntry& entry) {
  if (const auto known = accessors_.find(entry.json); known != accessors_.end()) return known->second;
  GltfAccessor accessor;
  const auto count = whole(entry, "count", 0xffffffff);
  const auto type = whole(entry, "componentType", gltf_float32);
  if (!count || !type) return std::nullopt;
  accessor.count = *count;
  accessor.type = static_cast<unsigned>(*type);
  accessor.size = component_size(*type);
  accessor.is_float = *type == gltf_float32;
  accessor.is_signed = *type == gltf_int8 || *type == gltf_int16;
  if (accessor.size == 0) {
    fail(entry.place + ".componentType", "found " + std::to_string(*type), "5120 to 5123, 5125 or 5126");
    return std::nullopt;
  }
  const base::Json* const shape = entry.json->find("type");
  const std::string* const name = shape == nullptr ? nullptr : shape->text();
  accessor.components = name == nullptr     ? 0
                        : *name == "SCALAR" ? 1
                        : *name == "VEC2"   ? 2
                        : *name == "VEC3"   ? 3
                        : *name == "VEC4"   ? 4
                                            : 0;
  if (accessor.components == 0) {
    fail(entry.place + ".type", "found " + (shape == nullptr ? "nothing" : base::describe(*shape)), "\"SCALAR\" or \"VEC3\"");
    return std::nullopt;
  }
  const base::Json* const normalized = entry.json->find("normalized");
  if (normalized != nullptr && normalized->boolean().value_or(false) && !accessor.is_float)
    accessor.unit =
        1 / (std::ldexp(1.0, static_cast<int>(8 * accessor.size) - (accessor.is_signed ? 1 : 0)) - 1);
  const std::size_t element = accessor.components * accessor.size;
  if (entry.json->find("bufferView") != nullptr) {
    // glTF 1 has the stride here, and 0 for none.
    const auto whose = entry_of("bufferViews", entry, "bufferView");
    const auto own = whole(entry, "byteStride", 255, 0);
    const auto stride = whose && own ? whole(*whose, "byteStride", 255, *own) : std::nullopt;
    if (!stride) return std::nullopt;
    accessor.stride = *stride == 0 ? element : *stride;
    if (accessor.stride < element) {
      fail(whose->place + ".byteStride", "found " + std::to_string(*stride),
           "at least the " + std::to_string(element) + " bytes of an element");
      return std::nullopt;
    }
    const auto bytes = part_of_view(entry, entry.place + ".count", *count, element, accessor.stride);
    if (!bytes) return std::nullopt;
    accessor.bytes = *bytes;
  } else if (*count > most_zeros) {
    fail(entry.place + ".count", "found " + std::to_string(*count),
         "at most " + std::to_string(most_zeros) + " without a buffer view");
    return std::nullopt;
  }
  const base::Json* const sparse = entry.json->find("sparse");
  if (sparse != nullptr && !read_sparse({sparse, entry.place + ".sparse"}, accessor)) return std::nullopt;
  accessors_.emplace(entry.json, accessor);
  return accessor;
}

}  // namespace sightline::scene
