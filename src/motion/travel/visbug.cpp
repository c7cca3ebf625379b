#include <stdexcept>

#include "src/motion/travel/methods.hpp"

namespace rubicon::travel {

TravelResult travel_visbug21(Walker) { throw std::invalid_argument("visbug21 is not there yet"); }

}  // namespace rubicon::travel
