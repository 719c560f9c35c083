// See vcd.hpp.
#include "host/machines/vcd.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "host/base/nearest_name.hpp"
#include "host/base/text.hpp"

namespace sightline::machines {

VcdTarget vcd_target(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  const std::string_view behind = colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1);
  // A colon followed by a path is part of the file name.
  if (behind.empty() || behind.find_first_of("./") != std::string_view::npos) return {std::string(text), {}};
  return {std::string(text.substr(0, colon)), std::string(behind)};
}

std::string vcd_help(std::span<const VcdSignal> signals) {
  std::string text = "\nSignals of --vcd, by group:\n";
  for (std::size_t n = 0; n < signals.size(); ++n) {
    if (n == 0 || signals[n].group != signals[n - 1].group) text += fmt::format("  {}\n", signals[n].group);
    text += fmt::format("    {:<12} {:>2}  {}\n", signals[n].name, signals[n].bits, signals[n].meaning);
  }
  return text;
}

Result<VcdWriter> VcdWriter::make(std::string_view machine, std::span<const VcdSignal> signals, std::string_view chosen) {
  VcdWriter writer(machine, signals);
  for (std::size_t n = 0; n < signals.size(); ++n) {
    // Printable characters from ! on, least significant digit first.
    constexpr std::size_t digits = 94;
    std::string identifier;
    for (std::size_t rest = n + 1; rest != 0; rest = (rest - 1) / digits)
      identifier += static_cast<char>('!' + (rest - 1) % digits);
    writer.wires_.push_back({chosen.empty(), false, 0, identifier});
  }
  while (!chosen.empty()) {
    const std::string_view name = chosen.substr(0, chosen.find(','));
    chosen.remove_prefix(std::min(name.size() + 1, chosen.size()));
    bool found = false;
    std::vector<std::string> names;
    for (std::size_t n = 0; n < signals.size(); ++n) {
      const bool this_one = signals[n].name == name || signals[n].group == name;
      writer.wires_[n].chosen = writer.wires_[n].chosen || this_one;
      found = found || this_one;
      names.emplace_back(signals[n].name);
      if (n == 0 || signals[n].group != signals[n - 1].group) names.emplace_back(signals[n].group);
    }
    if (found) continue;
    const std::string remedy = base::did_you_mean(name, names);
    return base::usage_error(fmt::format("--vcd: found signal \"{}\", expected some of {}{}", name, base::joined(names, ", "),
                             remedy.empty() ? "" : "; " + remedy));
  }
  return writer;
}

void VcdWriter::begin(std::string& text) const {
  base::append(text, "$version Sightline $end\n$timescale 1 ns $end\n$scope module {} $end\n", machine_);
  std::string_view group;
  for (std::size_t n = 0; n < signals_.size(); ++n) {
    if (!wires_[n].chosen) continue;
    if (signals_[n].group != group) {
      if (!group.empty()) text += "$upscope $end\n";
      group = signals_[n].group;
      base::append(text, "$scope module {} $end\n", group);
    }
    base::append(text, "$var wire {} {} {} $end\n", signals_[n].bits, wires_[n].identifier, signals_[n].name);
  }
  if (!group.empty()) text += "$upscope $end\n";
  text += "$upscope $end\n$enddefinitions $end\n";
}

void VcdWriter::finish(std::int64_t nanoseconds) {
  text_.write([&](std::string& text) {
    if (time_ < 0) begin(text);
    if (nanoseconds > time_) base::append(text, "#{}\n", nanoseconds);
  });
  time_ = std::max(time_, nanoseconds);
  text_.finish();
}

void VcdWriter::write(std::int64_t nanoseconds, std::size_t signal, std::uint32_t value) {
  Wire& wire = wires_[signal];
  text_.write([&](std::string& text) {
    if (time_ < 0) begin(text);
    if (nanoseconds != time_) base::append(text, "#{}\n", nanoseconds);
    const unsigned bits = signals_[signal].bits;
    if (bits == 1) {
      text += value == floating ? 'z' : value != 0 ? '1' : '0';
    } else {
      text += 'b';
      // Leading zeros may be omitted.
      unsigned first = bits;
      while (first > 1 && (value >> (first - 1) & 1U) == 0) --first;
      if (value == floating) {
        text += 'z';
      } else {
        while (first-- > 0) text += static_cast<char>('0' + (value >> first & 1U));
      }
      text += ' ';
    }
    text += wire.identifier;
    text += '\n';
  });
  time_ = nanoseconds;
  wire.known = true;
  wire.value = value;
}

}  // namespace sightline::machines
