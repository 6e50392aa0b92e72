#include "checks.hpp"

#include <cmath>
#include <string>

#include "given/not_covered.hpp"
#include "types/number_text.hpp"

namespace contactd::cases {

int whole(double value, const char* name) {
    if (!(std::abs(value) <= 1e9) || value != std::round(value))
        throw NotCovered(Subject::input,
                         std::string(name) + " is " + number_text(value) + "; it must be a whole number.");
    return static_cast<int>(value);
}

double positive(double value, const char* name) {
    if (!(value > 0))
        throw NotCovered(Subject::input, std::string(name) + " is " + number_text(value) + "; it must be positive.");
    return value;
}

}  // namespace contactd::cases
