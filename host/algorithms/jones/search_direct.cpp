// The search in planes of sight of 64 bits.
#include "host/algorithms/jones/search.hpp"

namespace sightline::algorithms::jones {

template class Search<NarrowArithmetic>;
template class Search<MediumArithmetic>;

}  // namespace sightline::algorithms::jones
