// What experiments.cpp lists, an experiment a line; the file of an experiment says what its records are.
#pragma once

#include "host/report/experiment.hpp"

namespace sightline::report {

[[nodiscard]] Records cross_check(const Context& context);
[[nodiscard]] Records hard_cases(const Context& context);
[[nodiscard]] Records montani_re_8080(const Context& context);
[[nodiscard]] Records montani_re_growth(const Context& context);
[[nodiscard]] Records montani_re_stripes(const Context& context);
[[nodiscard]] Records montani_re_tables(const Context& context);
[[nodiscard]] Records plantinga_accuracy(const Context& context);
[[nodiscard]] Records plantinga_pdp7(const Context& context);
[[nodiscard]] Records plantinga_turns(const Context& context);
[[nodiscard]] Records willis_flight(const Context& context);
[[nodiscard]] Records willis_order(const Context& context);
[[nodiscard]] Records willis_times(const Context& context);

}  // namespace sightline::report
