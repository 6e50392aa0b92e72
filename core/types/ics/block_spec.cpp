#include "block_spec.hpp"

#include <algorithm>
#include <cstdio>
#include <string>

#include "contactd/error.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

/// This is the paper's criterion (3.1).
constexpr double largest_unremarked_error = 0.01;

[[noreturn]] void refuse(const IcSpec& spec, const std::string& what) {
    throw InvalidArgument("ics.L_over_h", "is " + number_text(spec.fem.L_over_h) + "; " + what);
}

}  // namespace

void validate_room_on_block(const IcSpec& spec) {
    const double L = spec.fem.L_over_h * std::max(spec.dx, spec.dy);
    const double share = spec.load_shape == LoadShape::constant ? 0.5 : 1;
    const double load = share * std::max(spec.dx, spec.dy);
    if (!(load < L))
        refuse(spec, "the load of one element reaches " + number_text(load) +
                         " from its centre and must lie on the block, whose sides are " + number_text(L) +
                         " from its middle");
    const double reach = std::max((share + (spec.nx - 1) / 2.0) * spec.dx, (share + (spec.ny - 1) / 2.0) * spec.dy);
    if (!(reach < L))
        refuse(spec, "loads on " + std::to_string(spec.nx) + " x " + std::to_string(spec.ny) +
                         " elements about the middle of the block reach " + number_text(reach) +
                         ", and its sides are at " + number_text(L));
}

std::vector<std::string> modelling_warnings(const IcSpec& spec, double error) {
    const bool chosen = spec.accuracy > 0;
    const double most = chosen ? spec.accuracy : largest_unremarked_error;
    if (error <= most) return {};
    char text[400];
    std::snprintf(text, sizeof text,
                  "The displacements of a block depend on the position of the load. The table is for a load in the "
                  "middle; for one in the corner of %d x %d elements they differ by up to %.2g %%, which exceeds %s "
                  "%g. Use a larger L_over_h, fewer elements, or a half-space.",
                  spec.nx, spec.ny, 100 * error, chosen ? "the requested accuracy," : "the paper's aim,", most);
    return {text};
}

}  // namespace contactd
