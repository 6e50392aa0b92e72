// contactd.h: derivatives of the last step.
#include <optional>

#include "edge.hpp"

using namespace contactd::c;
using contactd::Derivatives;
using contactd::DerivativesOfAnswer;

namespace {

const std::optional<DerivativesOfAnswer>& answer_of(const Derivatives& all, std::int32_t of) {
    switch (of) {
        case CONTACTD_OF_FX:
            return all.Fx;
        case CONTACTD_OF_FY:
            return all.Fy;
        case CONTACTD_OF_MZ:
            return all.Mz;
        case CONTACTD_OF_FN:
            return all.Fn;
        default:
            return all.approach;
    }
}

std::optional<double> by_input(const DerivativesOfAnswer& of, std::int32_t by) {
    switch (by) {
        case CONTACTD_BY_X:
            return of.rigid_shift ? of.rigid_shift->x : of.xi;
        case CONTACTD_BY_Y:
            return of.rigid_shift ? of.rigid_shift->y : of.eta;
        case CONTACTD_BY_TURN:
            return of.rotation ? of.rotation : of.phi;
        case CONTACTD_BY_LOAD:
            return of.approach ? of.approach : of.Fn;
        default:
            return of.mu;
    }
}

}  // namespace

std::int32_t contactd_get_derivative(contactd_contact* contact, std::int32_t of, std::int32_t by, double* value) {
    return with(contact, [&](Contact& asked) {
        given(value, "value");
        word(of, CONTACTD_OF_APPROACH, "of");
        word(by, CONTACTD_BY_MU, "by");
        const auto& all = asked.result().reply.solution.derivatives;
        if (!all)
            throw nothing_of(
                "derivatives: contactd_want_derivatives asks for them before, and without contact or convergence there "
                "are none");
        const auto& answer = answer_of(*all, of);
        const std::optional<double> found = answer ? by_input(*answer, by) : std::nullopt;
        if (!found) throw nothing_of("derivative of this kind: the answer is an input, or there was no friction");
        *value = *found;
    });
}
