// Texts of data/*.json: words with placeholders and conditions.
//
//   {views.second_view_s.max:3}     a value, with so many places behind the point (expression.hpp)
//   {if cost.max <= 20 | text}      a statement with its threshold: if it fails, the text is left out and the
//                                   page says that it does not hold in this run, and what was found
//   {if cost.max <= 20 | text | other text}
//   ||                              the character |
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/report/document.hpp"
#include "host/report/expression.hpp"

namespace sightline::report {

class Text {
 public:
  Text() = default;
  // Throws Wrong, whose words begin with the place if there is one.
  explicit Text(std::string_view text, std::string place = {});

  // Throws Wrong.
  [[nodiscard]] Said said(const Scope& scope) const;
  // For titles and names, which state nothing that could fail.
  [[nodiscard]] std::string words(const Scope& scope) const { return said(scope).text; }
  void collect(std::vector<Reference>& references, std::string_view row_set) const;
  [[nodiscard]] bool empty() const { return pieces_.empty(); }

 private:
  struct Piece;
  void read(std::string_view text);
  [[nodiscard]] Said said_pieces(const Scope& scope) const;

  std::string place_;
  std::vector<std::shared_ptr<const Piece>> pieces_;
};

}  // namespace sightline::report
