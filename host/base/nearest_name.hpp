// The name that a user may have meant: for errors about unknown commands, options, scenes and functions.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sightline::base {

// Insertions, deletions, substitutions and swaps of neighbours that turn one text into the other, no place changed
// twice ("optimal string alignment"). Bytes, not characters.
[[nodiscard]] std::size_t edit_distance(std::string_view from, std::string_view to);

// The name nearest to `written`, the first of several; empty if none is near. Near: a name that begins with at least two
// characters of `written`, or one that differs in at most one place, and one more for every four characters.
[[nodiscard]] std::string nearest_name(std::string_view written, std::span<const std::string> names);

// "did you mean \"jones\"?", or empty: the remedy of an Error.
[[nodiscard]] std::string did_you_mean(std::string_view written, std::span<const std::string> names);

}  // namespace sightline::base
