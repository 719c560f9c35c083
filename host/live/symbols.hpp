// The symbols of a program and the lines of its source, from the files of `sightline asm --symbols` and --listing, or the .SYM file
// of a program for CP/M.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/result.hpp"

namespace sightline::live {

class Symbols {
 public:
  explicit Symbols(int radix) : radix_(radix) {}

  // Adds lines `NAME VALUE`, or a .SYM file; they replace symbols of earlier tables. An error names the line.
  // A .SYM file, which MAC, RMAC and LINK write for SID and ZSID, has `ADDRESS NAME` with four hexadecimal digits, several on a line,
  // separated by tabs, and ends at the byte 1A (Digital Research, SID User's Guide, 1978).
  [[nodiscard]] base::Result<base::Done> add_table(std::string_view text);
  // Adds lines `ADDRESS CODE SOURCE`; other lines are ignored.
  void add_listing(std::string_view text);

  // Ignores case; on the PDP-7 only the first six characters count, as in DEC's language. If several symbols match, which the
  // dialect of Bell Laboratories allows, the name must be exact.
  [[nodiscard]] std::optional<std::uint32_t> value(std::string_view name) const;
  // "begin", "begin+5", or empty: no symbol is near. If there is a listing, only symbols whose values are addresses in it count,
  // because a symbol may be any number.
  [[nodiscard]] std::string near(std::uint32_t address) const;
  // The source line of the word, without blanks at its ends.
  [[nodiscard]] std::string_view source(std::uint32_t address) const;
  [[nodiscard]] const std::map<std::string, std::uint32_t, std::less<>>& all() const { return values_; }

  // A line of a source file, by the assembler's name for the file; lines from 1.
  struct Place {
    std::string file;
    std::size_t line = 0;
    // Not <=>, because std::string of libc++ 14 lacks it.
    friend bool operator==(const Place& a, const Place& b) { return a.line == b.line && a.file == b.file; }
    friend bool operator<(const Place& a, const Place& b) { return a.file != b.file ? a.file < b.file : a.line < b.line; }
  };
  void add_line(std::uint32_t address, Place place);
  [[nodiscard]] const Place* place(std::uint32_t address) const;  // null: the word has no source line
  [[nodiscard]] const std::map<Place, std::uint32_t>& lines() const { return addresses_; }

 private:
  [[nodiscard]] std::string key(std::string_view name) const;
  [[nodiscard]] base::Result<base::Done> add_sym(std::string_view text);
  // `met`: the keys of this table so far. A later table replaces a symbol, a later symbol of the same table does not.
  void add(std::string_view name, std::uint32_t value, std::set<std::string>& met);

  int radix_;
  std::map<std::string, std::uint32_t, std::less<>> values_;  // as written
  std::map<std::string, std::optional<std::uint32_t>, std::less<>> keys_;  // nullopt: several symbols
  std::map<std::uint32_t, std::string> by_value_;
  std::map<std::uint32_t, std::string> sources_;
  std::map<std::uint32_t, Place> places_;
  std::map<Place, std::uint32_t> addresses_;  // of the first word of each line
};

}  // namespace sightline::live
