#include "contactd/contact_regions.hpp"

#include <cmath>
#include <cstddef>
#include <string>

#include "contactd/error.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

void check(const Extent& extent, const std::string& field) {
    if (!std::isfinite(extent.from) || !std::isfinite(extent.to) || !(extent.from < extent.to))
        throw InvalidArgument(field, "is [" + number_text(extent.from) + ", " + number_text(extent.to) +
                                         "]; the upper limit of a region must exceed the lower limit");
}

}  // namespace

void validate(const ContactRegions& regions) {
    const std::size_t count = regions.limits.size();
    if (count == 0) throw InvalidArgument("regions.limits", "is empty; remove regions if all elements may touch");
    for (std::size_t i = 0; i < count; ++i) {
        const std::string field = "regions.limits[" + std::to_string(i) + "]";
        check(regions.limits[i].x, field + ".x");
        check(regions.limits[i].y, field + ".y");
    }
    if (regions.shares.size() != count * count)
        throw InvalidArgument("regions.shares", "has " + std::to_string(regions.shares.size()) + " numbers; " +
                                                    std::to_string(count) + " regions need " +
                                                    std::to_string(count * count) + ", one for each pair");
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j) {
            const double share = regions.shares[i * count + j];
            const std::string field = "regions.shares[" + std::to_string(i * count + j) + "]";
            if (!(share >= 0 && share <= 1))
                throw InvalidArgument(field, "is " + number_text(share) + "; a share must lie in [0, 1]");
            if (i == j && share != 1)
                throw InvalidArgument(field, "is " + number_text(share) + "; the share of a region on itself is 1");
            if (share != regions.shares[j * count + i])
                throw InvalidArgument(field,
                                      "is " + number_text(share) + ", but the share in the opposite direction is " +
                                          number_text(regions.shares[j * count + i]) + "; shares must be symmetric");
        }
}

}  // namespace contactd
