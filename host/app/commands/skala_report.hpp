// What `sightline skala` prints of a picture: a summary for people, or one JSON document.
#pragma once

#include <string>
#include <vector>

#include "host/app/commands/skala_session.hpp"

namespace sightline::app {

// Both end in a newline; `pictures` are the files written.
[[nodiscard]] std::string skala_summary(const SkalaRequest& order, const SkalaOutcome& outcome,
                                        const std::vector<std::string>& pictures);
[[nodiscard]] std::string skala_document(const SkalaRequest& order, const SkalaOutcome& outcome,
                                         const std::vector<std::string>& pictures);

}  // namespace sightline::app
