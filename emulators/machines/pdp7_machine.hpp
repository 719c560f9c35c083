// Until its users include pdp7.hpp.
#pragma once

#include "pdp7.hpp"
