#include "tools/asm/engine.hpp"

#include <algorithm>
#include <tuple>

#include "host/base/number.hpp"
#include "tools/image/binary.hpp"

namespace sightline::assembler {
namespace {

// Enough for chains of forward references that move each other. A longer chain is an error.
constexpr int most_layout_passes = 16;
constexpr std::size_t most_errors = 1000;  // the same limit for warnings
constexpr std::size_t most_characters_shown = 40;

// The separator is a line break, which no name contains.
std::string local_key(const std::string& key, std::size_t source) {
  return key + "\n" + std::to_string(source);
}

}  // namespace

std::string Radix::text(std::uint32_t value, unsigned digits) const {
  return base == 8 ? sightline::base::octal(value, digits) : image::hexadecimal(value, digits);
}

void Places::add(std::uint32_t place) {
  now_.push_back(place);
  last_ = place;
  next_.reset();
}

std::optional<std::uint32_t> Places::next() const {
  if (next_) return next_;
  return now_.size() < before_.size() ? std::optional(before_[now_.size()]) : std::nullopt;
}

bool Places::end_pass() {
  if (next_) now_.push_back(*next_);
  const bool differ = now_ != before_;
  before_ = std::move(now_);
  now_.clear();
  next_.reset();
  last_.reset();
  return differ;
}

Engine::Engine(std::span<const SourceFile> sources, const Naming& naming, const Radix& radix)
    : naming_(naming),
      radix_(radix),
      sources_(sources.size()),
      files_(sources.begin(), sources.end()),
      modules_(sources.size()) {}

// --- Passes

void Engine::run(const std::function<void()>& enter_names, const std::function<void()>& read) {
  enter_names();
  bool settled = false;
  while (!settled && pass_ < most_layout_passes) {
    read_once(read);
    const bool changed = end_layout_pass();
    settled = pass_ == 1 ? !awaits_value_ : !changed || stopped_;
    const bool any_declares = std::any_of(modules_.begin(), modules_.end(), [](const Module& module) { return module.declares; });
    if (sources_ < 2 || !any_declares || names_are_local_) continue;
    names_are_local_ = true;
    settled = false;
    pass_ = 0;
    symbols_.clear();
    places_ = {};
    enter_names();
  }
  final_ = true;
  read_once(read);
  report_unsettled(settled);
}

void Engine::read_once(const std::function<void()>& read) {
  ++pass_;
  awaits_value_ = false;
  stopped_ = false;
  unlisted_ = {};
  read();
}

// A name that only the pass before defined, because a condition had another value in it, is undefined again. True if a name
// or place differs from the pass before.
bool Engine::end_layout_pass() {
  bool changed = false;
  for (auto& [key, symbol] : symbols_) {
    if (symbol.defined_in_pass != pass_ && symbol.defined_in_pass != 0) {
      symbol.kind = SymbolKind::undefined;
      symbol.value.reset();
      symbol.defined_in_pass = 0;
    }
    changed = changed || symbol.value != symbol.before;
    symbol.before = symbol.value;
  }
  return end_places() || changed;
}

bool Engine::end_places() {
  bool differ = false;
  for (Places& places : places_) differ = places.end_pass() || differ;
  return differ;
}

// Only the first: the others follow from it. A language may define names in the last pass alone or in the others alone, so
// that this is an error only where the layout passes did so, too.
void Engine::report_unsettled(bool settled) {
  const Symbol* first = nullptr;
  for (const auto& [key, symbol] : symbols_) {
    const bool moved = is_defined(symbol) && symbol.value && symbol.before && symbol.value != symbol.before;
    const bool of_source = symbol.kind != SymbolKind::permanent && symbol.kind != SymbolKind::define;
    const bool comes_and_goes = !settled && of_source && is_defined(symbol) != symbol.before.has_value();
    if ((moved || comes_and_goes) && (first == nullptr || symbol.defined < first->defined)) first = &symbol;
  }
  const auto shown = [this](std::uint32_t value) { return radix_.text(value, radix_.value_digits); };
  const std::string expected = "a definition that does not depend on itself";
  if (first != nullptr && first->value && first->before && is_defined(*first)) {
    error(first->defined, in_quotes(first->name) + " = " + shown(*first->value) + ", in the pass before " + shown(*first->before) + " (phase error)",
          expected);
  } else if (first != nullptr && errors_ == 0) {
    error(first->defined, in_quotes(first->name) + ", which only every second pass defines", expected);
  } else if (end_places() && errors_ == 0) {
    error({0, 1, 1}, "literals or labels at other addresses than in the pass before", "addresses that do not depend on themselves");
  }
}

// --- Files

std::optional<std::size_t> Engine::include(const std::string& path, const IncludeReader& reader) {
  const auto known = included_.find(path);
  if (known != included_.end()) return known->second;
  std::optional<std::size_t> index;
  if (auto text = reader ? reader(path) : std::nullopt) {
    index = files_.size();
    files_.push_back({path, std::move(*text)});
  }
  return included_[path] = index;
}

std::string Engine::where(const Position& at) const {
  return at.line == 0 ? "the command line" : files_[at.file].name + ":" + std::to_string(at.line);
}

// --- Names

// Names of the machine and of the command line are common to all sources.
std::string Engine::table_key(const std::string& key) const {
  if (!names_are_local_ || !declares() || is_declared(key)) return key;
  const Symbol* const common = find_in(key, std::nullopt);
  const bool defined = common != nullptr && (common->kind == SymbolKind::permanent || common->kind == SymbolKind::define || common->was_permanent);
  return defined ? key : local_key(key, source_);
}

Symbol* Engine::find(const std::string& key) {
  const auto found = names_are_local_ ? symbols_.find(table_key(key)) : symbols_.find(key);
  return found == symbols_.end() ? nullptr : &found->second;
}

const Symbol* Engine::find_in(const std::string& key, std::optional<std::size_t> source) const {
  const auto found = symbols_.find(source ? local_key(key, *source) : key);
  return found == symbols_.end() ? nullptr : &found->second;
}

Symbol& Engine::symbol(const std::string& key, std::string_view written) {
  Symbol& symbol = names_are_local_ ? symbols_[table_key(key)] : symbols_[key];
  if (symbol.name.empty()) symbol.name = std::string(written);
  return symbol;
}

Symbol& Engine::look_up(std::string_view written, const Position& at) {
  Symbol& found = symbol(naming_.key(written), written);
  if (found.kind == SymbolKind::undefined && found.defined.line == 0) found.defined = at;
  if (!final_ || (written.size() <= naming_.significant && found.name.size() <= naming_.significant)) return found;
  const auto whole = [this](std::string_view name) { return naming_.any_case ? lower_case(name) : std::string(name); };
  if (whole(written) != whole(found.name) && clashes_.insert(whole(written)).second) {
    warning(at, in_quotes(written) + ", the same symbol as " + in_quotes(found.name),
            "names that differ in their first " + std::string(naming_.in_words) + " characters");
  }
  return found;
}

void Engine::enter(std::string_view name, std::uint32_t value, SymbolKind kind, int form) {
  Symbol& symbol = symbols_[naming_.key(name)];
  symbol.name = std::string(name);
  symbol.kind = kind;
  symbol.value = symbol.before = value;
  symbol.form = form;
}

void Engine::define(Symbol& symbol, SymbolKind kind, std::optional<std::uint32_t> value, const Position& at, int form) {
  if (!value) await_value();
  if (!is_defined(symbol)) symbol.defined = at;
  symbol.kind = kind;
  symbol.value = value;
  symbol.form = form;
  symbol.defined_in_pass = pass_;
}

void Engine::declare(const std::string& key, bool external) {
  modules_[source_].declares = true;
  modules_[source_].shared.insert(key);
  if (external) externals_.insert(key);
}

// --- Memory

std::optional<Position> Engine::put(std::uint32_t address, std::uint32_t value, const Position& at, ListedLine& line, std::string note) {
  if (line.row) {
    if (!note.empty()) line.filled = true;
    const bool begins = line.cells == 0 || line.cells == radix_.cells_a_row;
    ListingLine& row = begins ? begin_row(line, address, at) : listing_[line.last];
    row.code += radix_.text(value, radix_.cell_digits);
    if (!note.empty()) row.source = std::move(note);
    ++line.cells;
  }
  if (address >= memory_.size()) memory_.resize(std::size_t{address} + 1);
  Cell& cell = memory_[address];
  cell.value = value;
  if (cell.line != 0) return Position{cell.file, cell.line, 1};
  cell.file = static_cast<std::uint32_t>(at.file);
  cell.line = static_cast<std::uint32_t>(at.line);
  return std::nullopt;
}

// --- The listing

ListedLine Engine::add_line(std::string text) {
  listing_.push_back({"", "", std::move(text)});
  return {listing_.size() - 1};
}

// The row of the line itself if it is free, else one below.
ListingLine& Engine::begin_row(ListedLine& line, std::uint32_t address, const Position& at) {
  if (line.filled) listing_.push_back({"", "", ""});
  line.last = line.filled ? listing_.size() - 1 : *line.row;
  ListingLine& row = listing_[line.last];
  row.address = radix_.text(address, radix_.address_digits);
  if (line.cells == 0 && line.of_source) {
    row.file = files_[at.file].name;
    row.line_number = at.line;
  }
  line.cells = 0;
  line.filled = true;
  return row;
}

ListedLine& Engine::line_at(const Position& at) {
  while (listed_ < at.line && !unlisted_.empty()) {
    const std::size_t end = std::min(unlisted_.find('\n'), unlisted_.size());
    const bool returns = end > 0 && unlisted_[end - 1] == '\r';
    line_ = add_line(std::string(unlisted_.substr(0, returns ? end - 1 : end)));
    unlisted_.remove_prefix(std::min(end + 1, unlisted_.size()));
    ++listed_;
  }
  line_.of_source = at.line <= listed_;
  return line_;
}

void Engine::show(ListedLine& line, std::uint32_t value, bool equated, const Position& at) {
  if (!line.row || line.filled) return;
  ListingLine& row = begin_row(line, value, at);
  if (!equated) return;
  row.code = "=";
  row.file.clear();
  row.line_number = 0;
}

// --- Diagnostics

void Engine::report(Severity severity, const Position& at, std::string found, std::string expected) {
  if (!final_ || stopped_) return;
  const bool is_error = severity == Severity::error;
  std::size_t& count = is_error ? errors_ : warnings_;
  if (count > most_errors) return;
  if (++count > most_errors) {
    found = "more than " + std::to_string(most_errors) + (is_error ? " errors" : " warnings");
    expected = is_error ? "fewer; the rest is not read" : "fewer; the rest is not shown";
    stopped_ = is_error;
  }
  diagnostics_.emplace_back(at, Diagnostic{severity, files_[at.file].name, at.line, at.column, std::move(found), std::move(expected)});
}

std::string in_quotes(std::string_view text) {
  std::string shown = "'";
  for (const char c : text.substr(0, most_characters_shown)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= ' ' && byte < 0177) {
      shown += c;
    } else {
      shown += "\\" + base::octal(byte, 3);
    }
  }
  return shown + (text.size() > most_characters_shown ? "...'" : "'");
}

// --- Results

void Engine::finish(AssemblyReport& report, bool by_place) {
  report.naming = naming_;
  report.listing = std::move(listing_);
  if (by_place) {
    std::stable_sort(diagnostics_.begin(), diagnostics_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  }
  for (auto& [at, diagnostic] : diagnostics_) report.diagnostics.push_back(std::move(diagnostic));
  std::vector<std::pair<std::string, const Symbol*>> listed;
  for (const auto& [key, symbol] : symbols_) {
    if (symbol.kind != SymbolKind::permanent && symbol.value) listed.emplace_back(naming_.order(symbol.name), &symbol);
  }
  const auto place = [](const auto& each) {
    return std::tie(each.first, *each.second->value, each.second->defined, each.second->name);
  };
  std::sort(listed.begin(), listed.end(), [&place](const auto& a, const auto& b) { return place(a) < place(b); });
  for (const auto& [order, symbol] : listed) {
    const bool in_file = symbol->defined.line != 0;
    report.symbols.push_back({symbol->name, *symbol->value, symbol->kind, in_file ? files_[symbol->defined.file].name : std::string(),
                              symbol->defined.line, symbol->defined.column});
  }
}

std::string write_symbols(std::span<const ProgramSymbol> symbols, const Radix& radix) {
  std::string text;
  for (const ProgramSymbol& symbol : symbols) text += symbol.name + " " + radix.text(symbol.value, radix.value_digits) + "\n";
  return text;
}

}  // namespace sightline::assembler
