// The JSON of a glTF file with its buffers: entries by their numbers (glTF 2) or names (glTF 1), and the numbers of accessors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "host/base/json.hpp"
#include "host/base/result.hpp"

namespace sightline::scene {

struct GltfEntry {
  const base::Json* json = nullptr;
  std::string place;  // "accessors[3]"
};

// `count` elements of `components` numbers. Nothing is copied, so an accessor costs nothing, whatever its count.
class GltfAccessor {
 public:
  std::uint64_t count = 0;
  std::size_t components = 0;
  bool is_float = false;
  bool is_signed = false;  // a whole number that can be negative

  // Component c of element i; i < count, c < components.
  [[nodiscard]] double value(std::uint64_t i, std::size_t c) const;
  // The same of a whole number.
  [[nodiscard]] std::uint64_t whole(std::uint64_t i) const;

 private:
  friend class GltfDocument;
  unsigned type = 0;       // componentType
  std::size_t size = 0;    // bytes of a component
  double unit = 1;         // what a whole number is multiplied by: 1, or less if they are normalized
  std::string_view bytes;  // of the first element and all that follow; empty: all are 0
  std::size_t stride = 0;
  std::uint64_t sparse = 0;  // elements that are replaced
  std::string_view places;   // their numbers, ascending
  std::size_t place_size = 0;
  std::string_view values;
};

class GltfDocument {
 public:
  // `root` has to live as long as the document; `binary`: the second chunk of a GLB.
  GltfDocument(const base::Json& root, std::string_view binary, std::string folder)
      : root_(root), binary_(binary), folder_(std::move(folder)) {}

  [[nodiscard]] const base::Json& root() const { return root_; }
  // The first error. After it, all that returns an optional returns nothing.
  [[nodiscard]] const std::optional<base::Error>& error() const { return error_; }
  void fail(const std::string& place, std::string found, std::string expected, std::string remedy = {});

  // What a reference names among the entries of a kind: "accessors", "nodes".
  std::optional<GltfEntry> entry(const std::string& kind, const base::Json& reference, const std::string& place);
  // The same of a member; an error if there is none.
  std::optional<GltfEntry> entry_of(const std::string& kind, const GltfEntry& from, const std::string& member);
  // A whole number up to `most`; the default where there is no such member.
  std::optional<std::uint64_t> whole(const GltfEntry& from, const std::string& member, std::uint64_t most,
                                     std::optional<std::uint64_t> otherwise = {});
  // So many numbers; false without an error where there is no such member.
  bool numbers(const GltfEntry& from, const std::string& member, std::size_t count, double* values);

  // The accessor, whose elements all lie in its buffer.
  std::optional<GltfAccessor> accessor(const GltfEntry& entry);
  // The bytes of a buffer view.
  std::optional<std::string_view> view(const GltfEntry& entry);

 private:
  std::optional<std::string_view> buffer(const GltfEntry& entry);
  std::optional<std::string> bytes_of(const std::string& uri, const std::string& place);
  std::optional<std::string_view> part_of_view(const GltfEntry& from, const std::string& place, std::uint64_t count,
                                               std::size_t element, std::size_t stride);
  bool read_sparse(const GltfEntry& sparse, GltfAccessor& accessor);

  const base::Json& root_;
  std::string_view binary_;
  std::string folder_;
  struct Kind {
    const base::Json* all = nullptr;
    std::unordered_map<std::string_view, const base::Json*> named;  // of glTF 1
  };
  std::map<std::string, Kind> kinds_;
  std::map<const base::Json*, std::string> buffers_;
  std::size_t file_bytes_ = 0;
  std::map<const base::Json*, GltfAccessor> accessors_;
  std::uint64_t sparse_elements_ = 0;
  std::optional<base::Error> error_;
};

}  // namespace sightline::scene
