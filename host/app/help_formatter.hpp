// The one look of every --help: lines of at most help_width() columns, values and ranges in plain words, what
// an option is when it is not given in one place. Leaves out the types of the option parser (TEXT, INT,
// UINT), and options without a description.
//
// The text below the options is laid out here as well. A line is a paragraph. An indented one that is too long
// goes on below its text ("  term   text"), or below its beginning if it has no term.
#pragma once

#include <cstddef>
#include <memory>

namespace CLI {
class FormatterBase;
}

namespace sightline::app {

// The width of the terminal, or COLUMNS; at most 100, which is also the width if neither is known.
[[nodiscard]] std::size_t help_width();

[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_formatter();

}  // namespace sightline::app
