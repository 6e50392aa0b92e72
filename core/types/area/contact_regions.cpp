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
                                         "]; a region goes from a coordinate to a larger one");
}

}  // namespace

void validate(const ContactRegions& regions) {
    const std::size_t count = regions.limits.size();
    if (count == 0) throw InvalidArgument("regions.limits", "is empty; leave regions out where all may touch");
    for (std::size_t i = 0; i < count; ++i) {
        const std::string field = "regions.limits[" + std::to_string(i) + "]";
        check(regions.limits[i].x, field + ".x");
        check(regions.limits[i].y, field + ".y");
    }
    if (regions.shares.size() != count * count)
        throw InvalidArgument("regions.shares", "has " + std::to_string(regions.shares.size()) + " numbers; " +
                                                    std::to_string(count) + " regions need " +
                                                    std::to_string(count * count) + ", one of each on each");
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j) {
            const double share = regions.shares[i * count + j];
            const std::string field = "regions.shares[" + std::to_string(i * count + j) + "]";
            if (!(share >= 0 && share <= 1))
                throw InvalidArgument(field, "is " + number_text(share) + "; a share lies in 0 to 1");
            if (i == j && share != 1)
                throw InvalidArgument(field, "is " + number_text(share) + "; a region feels all of itself: 1");
            if (share != regions.shares[j * count + i])
                throw InvalidArgument(field, "is " + number_text(share) + ", and that of the other on this one " +
                                                 number_text(regions.shares[j * count + i]) +
                                                 "; what two regions feel of each other is the same");
        }
}

}  // namespace contactd
