// Finds the name that a user may have meant, for errors about unknown commands, options, scenes and functions.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sightline::base {

// The optimal string alignment distance: the number of insertions, deletions, substitutions and transpositions of adjacent
// bytes that turn one text into the other, if no substring is edited twice.
[[nodiscard]] std::size_t edit_distance(std::string_view from, std::string_view to);

// The name nearest to `written`, the first of several; empty if none is near. A name is near if it begins with `written`
// (at least two characters), or if its edit distance is at most one, plus one for every four characters.
[[nodiscard]] std::string nearest_name(std::string_view written, std::span<const std::string> names);

// The remedy of an Error: "did you mean \"jones\"?", or empty.
[[nodiscard]] std::string did_you_mean(std::string_view written, std::span<const std::string> names);

}  // namespace sightline::base
