// Formats the --help of all commands: lines of at most help_width() columns; the range, the default and other conditions of an
// option in parentheses. Omits the parser's types (TEXT, INT, UINT) and options without a description.
//
// The text below the options is reflowed, too. A line is a paragraph. An indented line that is too long continues below its
// text ("  term   text"), or below its beginning if it has no term. Under a heading that ends with "Examples:" a line
// indented by two spaces is a command; it is broken with a backslash, so that it can be copied.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace CLI {
class FormatterBase;
}

namespace sightline::app {

// COLUMNS if it is set, else the width of the terminal (at most 100), else 80; at least 40.
[[nodiscard]] std::size_t help_width();

// A text of host/app/help, reflowed to help_width().
[[nodiscard]] std::string help_text(std::string_view text);

[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_formatter();

// For a command with subcommands: also lists the options that more than half of them share, with the subcommands that lack them.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_formatter_with_shared_options();

}  // namespace sightline::app
