// Instantiates the search with planes of sight of 64 and 128 bits.
#include "host/algorithms/jones/search.hpp"

namespace sightline::algorithms::jones {

template class Search<NarrowArithmetic>;
template class Search<MediumArithmetic>;
template class Search<WideArithmetic>;
template class Search<WideArithmetic, TraceListener>;

}  // namespace sightline::algorithms::jones
