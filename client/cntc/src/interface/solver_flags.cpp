// Tolerances and bounds of the solvers.
#include <algorithm>

#include "interface/entry.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

enum Method { usual = 0, keep = 1, convex = 2, with_slip_velocity = 4, of_sensitivities = 6 };

/// Solvers are contactd's own, whichever is named. A tolerance makes theirs smaller, never larger: it is one of other
/// stopping criteria, and contactd's own cost little.
ContactSettings with_tolerance(ContactSettings settings, double eps) {
    if (!(eps > 0 && eps < 1)) throw Refused(error_code::input, "eps must lie between 0 and 1.");
    const ContactSettings own;
    settings.normal.tolerance = std::min(own.normal.tolerance, eps);
    settings.tangential.tolerance = std::min(own.tangential.tolerance, eps);
    settings.outer.tolerance = std::min(own.outer.tolerance, eps);
    return settings;
}

/// maxgs bounds the iterations of both solvers, maxout the outer iterations. Programs with quasi-identical bodies set
/// maxout to 1, and contactd's outer iterations serve friction laws, too: so 1 leaves their bound. maxin and maxnr are
/// of loops that contactd does not have.
ContactSettings with_bounds(ContactSettings settings, int maxgs, int maxout) {
    if (maxgs < 1 || maxout < 1)
        throw Refused(error_code::input, "maxgs and maxout are " + std::to_string(maxgs) + " and " +
                                             std::to_string(maxout) + "; they must be at least 1.");
    settings.normal.max_iterations = settings.tangential.max_iterations = maxgs;
    settings.outer.max_iterations = maxout == 1 ? ContactSettings{}.outer.max_iterations : maxout;
    return settings;
}

}  // namespace

extern "C" void cntc_setsolverflags(int* ire, int* icp, int* gdigit, int* nints, int* iparam, int* nreals,
                                    double* rparam) {
    set("cntc_setsolverflags", ire, icp, "solver flags", [&](Settings& settings) {
        const int method = integer(gdigit, "gdigit");
        if (method < usual || method > of_sensitivities)
            throw Refused(error_code::input, "gdigit is " + std::to_string(method) + "; it must be 0 to 6.");
        if (method == keep) return;
        const auto ints = integers(iparam, nints, method == of_sensitivities ? 1 : 4, "iparam");
        const auto reals = list(rparam, nreals, 1, "rparam");
        if (method == of_sensitivities) return;  // theirs are contactd's own
        settings.solvers = with_bounds(with_tolerance(settings.solvers, reals[0]), ints[0], ints[3]);
        settings.one_outer_iteration = false;
        if (method >= convex && method <= with_slip_velocity)
            settings.starts_in_slip = ints.size() > 4 && ints[4] < 0;  // inislp
    });
}
CONTACTD_FORTRAN_NAME(cntc_setsolverflags)
