// The one look of every --help: lines of at most help_width columns, values and ranges in plain words, what
// an option is when it is not given in one place. Leaves out the types of the option parser (TEXT, INT,
// UINT), and options without a description.
//
// A footer is laid out here as well: lines of one paragraph are joined and broken anew, a line that ends in a
// full stop or a colon ends its paragraph. What is indented stays a line of its own; one that is too long
// goes on below its text ("  term   text"), or below its beginning if it has no term.
#pragma once

#include <cstddef>
#include <memory>

namespace CLI {
class FormatterBase;
}

namespace sightline::app {

inline constexpr std::size_t help_width = 100;

[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_formatter();

}  // namespace sightline::app
