#include "contactd/count_of.hpp"

#include "contactd/error.hpp"
#include "number_text.hpp"

namespace contactd {

int count_of(double quotient, const Counted& counted) {
    if (!(quotient >= 0 && quotient <= counted.most))
        throw InvalidArgument(counted.field, counted.problem + ", which results in " + short_text(quotient) + " " +
                                                 std::string(counted.things) + "; at most " +
                                                 number_text(counted.most) +
                                                 " are allowed: " + std::string(counted.cure));
    return static_cast<int>(quotient);
}

}  // namespace contactd
