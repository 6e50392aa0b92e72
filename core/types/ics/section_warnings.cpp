#include "contactd/section_warnings.hpp"

#include <array>
#include <cstdio>

namespace contactd {

std::vector<std::string> section_warnings(double accuracy, const SectionEvidence& evidence) {
    if (!(evidence.error > accuracy)) return {};
    std::array<char, 300> text{};
    std::snprintf(text.data(), text.size(),
                  "The stated error, %.2g, exceeds the requested accuracy, %g. Half the deviation of the coefficients "
                  "from reciprocity, which strips beside an edge cause, contributes %.2g. Use narrower strips, or "
                  "strips farther from the edge.",
                  evidence.error, accuracy, evidence.reciprocity_defect / 2);
    return {text.data()};
}

}  // namespace contactd
