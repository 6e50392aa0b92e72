#include "contactd/section_warnings.hpp"

#include <array>
#include <cstdio>

namespace contactd {

std::vector<std::string> section_warnings(double accuracy, const SectionEvidence& evidence) {
    if (!(evidence.error > accuracy)) return {};
    std::array<char, 300> text{};
    std::snprintf(text.data(), text.size(),
                  "The stated error, %.2g, exceeds the accuracy asked for, %g: %.2g of it is half of what "
                  "coefficients are not reciprocal by, as of strips beside an edge. Narrower strips, or some that "
                  "keep away from the edge, have less of it.",
                  evidence.error, accuracy, evidence.reciprocity_defect / 2);
    return {text.data()};
}

}  // namespace contactd
