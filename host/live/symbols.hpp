// The symbols of a program and the lines of its source, as our assemblers write them with --symbols and --listing.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::live {

class Symbols {
 public:
  explicit Symbols(int radix) : radix_(radix) {}

  // Lines `NAME VALUE`. A later file wins. An error names the line.
  [[nodiscard]] base::Result<base::Done> add_table(std::string_view text);
  // Lines `ADDRESS CODE SOURCE`, others are passed over.
  void add_listing(std::string_view text);

  // Any case; on the PDP-7 the first six characters, as in DEC's language. Where that means several symbols of a program,
  // which there can be in the dialect of Bell Laboratories, the name as it is written.
  [[nodiscard]] std::optional<std::uint32_t> value(std::string_view name) const;
  // "begin", "begin+5", or empty: no symbol is near. A symbol may be a number of any meaning: only those that
  // belong to an address of the listing count, if there is one.
  [[nodiscard]] std::string near(std::uint32_t address) const;
  // The line of the source that made the word, without blanks around it.
  [[nodiscard]] std::string_view source(std::uint32_t address) const;
  [[nodiscard]] const std::map<std::string, std::uint32_t, std::less<>>& all() const { return values_; }

  // A line of a source file, as the assembler names the file; lines from 1.
  struct Place {
    std::string file;
    std::size_t line = 0;
    // Not <=>, which the texts of libc++ 14 do not have.
    friend bool operator==(const Place& a, const Place& b) { return a.line == b.line && a.file == b.file; }
    friend bool operator<(const Place& a, const Place& b) { return a.file != b.file ? a.file < b.file : a.line < b.line; }
  };
  void add_line(std::uint32_t address, Place place);
  [[nodiscard]] const Place* place(std::uint32_t address) const;  // null: no line of a source made the word
  [[nodiscard]] const std::map<Place, std::uint32_t>& lines() const { return addresses_; }

 private:
  [[nodiscard]] std::string key(std::string_view name) const;

  int radix_;
  std::map<std::string, std::uint32_t, std::less<>> values_;  // as written
  std::map<std::string, std::optional<std::uint32_t>, std::less<>> keys_;  // nothing: several symbols
  std::map<std::uint32_t, std::string> by_value_;
  std::map<std::uint32_t, std::string> sources_;
  std::map<std::uint32_t, Place> places_;
  std::map<Place, std::uint32_t> addresses_;  // of the first word of each line
};

}  // namespace sightline::live
