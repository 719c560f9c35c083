#include "host/app/help_formatter.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/base/number.hpp"

namespace sightline::app {

namespace {

// Wraps `text`, which begins at column `column`; further lines are indented by `indent`. The last line has no newline.
std::string wrap(std::string_view text, std::size_t column, std::size_t indent) {
  std::string result;
  bool first_word = true;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" \n"), text.size()));
    if (text.empty()) return result;
    const std::string_view word = text.substr(0, text.find_first_of(" \n"));
    text.remove_prefix(word.size());
    if (!first_word && column + 1 + word.size() > help_width()) {
      result += '\n' + std::string(indent, ' ');
      column = indent;
      first_word = true;
    }
    if (!first_word) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
    first_word = false;
  }
}

// A row of two columns; the second is empty or wrapped.
std::string two_columns(std::string first, std::string_view second, std::size_t width) {
  first.insert(0, 2, ' ');
  if (second.empty()) return first + '\n';
  if (first.size() + 1 < width) {
    first.resize(width, ' ');
  } else {
    first += '\n' + std::string(width, ' ');
  }
  return first + wrap(second, width, width) + '\n';
}

std::string indented_line(std::string_view line) {
  const std::size_t indent = line.find_first_not_of(' ');
  if (line.size() <= help_width()) return std::string(line) + '\n';
  const std::size_t gap = line.find("  ", indent);
  const std::size_t text = gap == std::string_view::npos ? indent : line.find_first_not_of(' ', gap);
  return std::string(line.substr(0, text)) + wrap(line.substr(text), text, text) + '\n';
}

// A command of an example, indented by two spaces. Long lines are broken between words with a backslash, so that the command
// can be copied. Quoted words are broken only if they are longer than a line; those are shell scripts, in which the backslash
// has the same meaning.
std::string example_line(std::string line) {
  struct Break {
    std::size_t at = std::string::npos;
    bool quoted = false;
  };
  std::string result;
  bool quoted = false;  // whether the line begins inside quotes
  while (line.size() > help_width()) {
    Break outside;
    Break any;
    bool now = quoted;
    for (std::size_t at = line.find_first_not_of(' '); at + 2 <= help_width(); ++at) {
      if (line[at] == '"' || line[at] == '\'') now = !now;
      if (line[at] != ' ') continue;
      any = {at, now};
      if (!now) outside = any;
    }
    const Break& chosen = outside.at != std::string::npos ? outside : any;
    if (chosen.at == std::string::npos) break;
    result += line.substr(0, chosen.at) + " \\\n";
    quoted = chosen.quoted;
    line = "    " + line.substr(chosen.at + 1);
  }
  return result + line + '\n';
}

struct ValueHelp {
  std::string name;
  std::string range;  // "1 to 1000", or empty
};

// The parser describes values as "N:INT in [1 - 1000]" and "NAME:{a,b}".
ValueHelp value_help(const CLI::Option& option) {
  std::string name = option.get_type_name();
  std::string range;
  if (const std::size_t set = name.find(":{"); set != std::string::npos) return {name.substr(set + 1), ""};
  if (const std::size_t in = name.find(" in ["); in != std::string::npos) {
    range = name.substr(in + 5, name.size() - in - 6);
    if (const std::size_t dash = range.find(" - "); dash != std::string::npos) range.replace(dash, 3, " to ");
    name.erase(name.rfind(':', in));
  }
  if (name == "INT" || name == "UINT") name = "N";
  return {std::move(name), std::move(range)};
}

bool takes_many(const CLI::Option& option) {
  return option.get_expected_max() >= CLI::detail::expected_max_vector_size;
}

class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(28); }

  // The parser separates groups by more than one empty line.
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    std::string help = CLI::Formatter::make_help(app, std::move(name), mode);
    for (std::size_t at = 0; (at = help.find("\n\n\n", at)) != std::string::npos;) help.erase(at, 1);
    return help;
  }

  std::string make_description(const CLI::App* app) const override {
    return wrap(app->get_description(), 0, 0) + '\n';
  }

  std::string make_footer(const CLI::App* app) const override { return help_text(app->get_footer()); }

  std::string make_subcommand(const CLI::App* command) const override {
    return two_columns(command->get_name(), command->get_description(), get_column_width());
  }

  std::string make_option(const CLI::Option* option, bool positional) const override {
    return option->get_description().empty() ? "" : entry(*option, positional, "");
  }

 protected:
  // `more`: an additional condition, or empty.
  std::string entry(const CLI::Option& option, bool positional, const std::string& more) const {
    std::string left = make_option_name(&option, positional);
    if (const std::string value = value_help(option).name; !value.empty() && !positional)
      left += ' ' + value;
    if (takes_many(option) && option.get_allow_extra_args() && option.get_delimiter() == '\0')
      left += positional ? "..." : " ...";
    return two_columns(std::move(left), option.get_description() + conditions(option, positional, more),
                       get_column_width());
  }

 private:
  // " (1 to 9; default: 3; not with --other)", or nothing.
  static std::string conditions(const CLI::Option& option, bool positional, const std::string& more) {
    std::vector<std::string> list;
    if (const std::string range = value_help(option).range; !range.empty()) list.push_back(range);
    if (!option.get_default_str().empty()) list.push_back("default: " + option.get_default_str());
    if (takes_many(option) && !option.get_allow_extra_args()) list.emplace_back("may be repeated");
    if (option.get_required() && !positional) list.emplace_back("required");
    for (const CLI::Option* other : option.get_needs()) list.push_back("needs " + other->get_name());
    std::vector<std::string> excluded;  // the parser keeps them in a set without a fixed order
    for (const CLI::Option* other : option.get_excludes())
      if (!other->get_description().empty()) excluded.push_back("not with " + other->get_name());
    std::sort(excluded.begin(), excluded.end());
    list.insert(list.end(), excluded.begin(), excluded.end());
    if (!more.empty()) list.push_back(more);
    return list.empty() ? "" : " (" + CLI::detail::join(list, "; ") + ")";
  }
};

class SharedOptionsFormatter : public HelpFormatter {
 public:
  std::string make_subcommands(const CLI::App* app, CLI::AppFormatMode mode) const override {
    const std::vector<const CLI::App*> commands = app->get_subcommands([](const CLI::App*) { return true; });
    struct Group {
      std::string name;
      std::string entries;
    };
    std::vector<Group> groups;
    std::vector<std::string> listed;  // entries, without the list of commands that lack the option
    for (const CLI::App* command : commands) {
      for (const CLI::Option* option : command->get_options()) {
        if (!option->nonpositional() || option->get_description().empty() || option == command->get_help_ptr()) continue;
        const std::string text = entry(*option, false, "");
        if (std::find(listed.begin(), listed.end(), text) != listed.end()) continue;
        listed.push_back(text);
        std::size_t alike = 0;
        std::vector<std::string> without;
        for (const CLI::App* other : commands) {
          const CLI::Option* const same = other->get_option_no_throw(option->get_name());
          if (same == nullptr) without.push_back(other->get_name());
          if (same != nullptr && entry(*same, false, "") == text) ++alike;
        }
        if (2 * alike <= commands.size()) continue;
        const std::string name = option->get_group() == "Options" ? std::string(shared_heading) : option->get_group();
        auto group = std::find_if(groups.begin(), groups.end(), [&name](const Group& each) { return each.name == name; });
        if (group == groups.end()) group = groups.insert(groups.end(), Group{name, ""});
        group->entries += entry(*option, false, without.empty() ? "" : "all but " + CLI::detail::join(without, ", "));
      }
    }
    std::stable_partition(groups.begin(), groups.end(), [](const Group& group) { return group.name == shared_heading; });
    std::string text = HelpFormatter::make_subcommands(app, mode);
    for (const Group& group : groups) text += "\n" + group.name + ":\n" + group.entries;
    return text;
  }

 private:
  // tools/manual/completion.awk stops at this heading, because these options are typed after a subcommand.
  static constexpr std::string_view shared_heading = "Options of most subcommands";
};

std::size_t terminal_width() {
  constexpr std::size_t least = 40;
  constexpr std::size_t most_readable = 100;
  constexpr std::size_t unknown = 80;
  const char* const columns = std::getenv("COLUMNS");
  if (columns != nullptr)
    if (const auto width = base::whole_number<std::size_t>(columns); width && *width > 0)
      return std::max(*width, least);
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    return std::clamp<std::size_t>(size.ws_col, least, most_readable);
  return unknown;
}

}  // namespace

std::string help_text(std::string_view text) {
  std::string result;
  bool examples = false;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (!line.starts_with(' ')) examples = line.ends_with("xamples:");
    if (examples && line.starts_with("  ") && !line.starts_with("   ")) {
      result += example_line(std::string(line));
    } else {
      result += line.starts_with(' ') ? indented_line(line) : wrap(line, 0, 0) + '\n';
    }
  }
  return result;
}

std::size_t help_width() {
  static const std::size_t width = terminal_width();
  return width;
}

std::shared_ptr<CLI::FormatterBase> help_formatter() {
  return std::make_shared<HelpFormatter>();
}

std::shared_ptr<CLI::FormatterBase> help_formatter_with_shared_options() {
  return std::make_shared<SharedOptionsFormatter>();
}

}  // namespace sightline::app
