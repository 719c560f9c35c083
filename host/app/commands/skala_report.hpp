// The output of `sightline skala` for a picture: a summary or one JSON document.
#pragma once

#include <string>
#include <vector>

#include "host/app/commands/skala_pictures.hpp"

namespace sightline::app {

// Both end in a newline; `pictures` are the files written.
[[nodiscard]] std::string skala_summary(const SkalaRequest& request, const programs::skala::Outcome& outcome,
                                        const std::vector<std::string>& pictures);
[[nodiscard]] std::string skala_document(const SkalaRequest& request, const programs::skala::Outcome& outcome,
                                         const std::vector<std::string>& pictures);

}  // namespace sightline::app
