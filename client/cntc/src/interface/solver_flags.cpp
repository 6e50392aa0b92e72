// Sets tolerances and iteration limits of the solvers.
#include "given/given_bodies.hpp"
#include "interface/entry.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

enum Method { usual = 0, keep = 1, convex = 2, with_slip_velocity = 4, of_sensitivities = 6 };

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
        if (method == of_sensitivities) return;  // contactd uses its own settings for these
        settings.solvers = solver_settings(reals[0], ints[0], ints[3]);
        settings.one_outer_iteration = false;
        if (method >= convex && method <= with_slip_velocity)
            settings.starts_in_slip = ints.size() > 4 && ints[4] < 0;  // inislp
    });
}
CONTACTD_FORTRAN_NAME(cntc_setsolverflags)
