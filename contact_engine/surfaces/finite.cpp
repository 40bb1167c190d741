#include "finite.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace braidx {

void require_finite(Unknowns q) {
    const auto bad =
        std::ranges::find_if(q, [](double value) { return !(std::abs(value) < too_far); });
    if (bad == q.end())
        return;
    std::ostringstream message;
    message << "unknown " << bad - q.begin() << " of " << q.size() << " is " << *bad
            << ": contact needs finite positions and directors, below " << too_far
            << "; look for where the start or the computation before made it";
    throw std::invalid_argument(message.str());
}

} // namespace braidx
