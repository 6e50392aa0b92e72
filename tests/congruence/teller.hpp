// Prints the results of a step for the driver in C++, in the order of telling.py.
#pragma once

#include <bit>
#include <cinttypes>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "contactd/session.hpp"

namespace contactd {

/// Prints a step like driver.py.
class Teller {
   public:
    void tell(const StepReply& reply, const Grid& grid) {
        const ContactSolution& s = reply.solution;
        whole(reply.step);
        numbers({s.forces.Fn, s.forces.Fx, s.forces.Fy, s.forces.Mz, s.approach, s.pmax, s.area.contact,
                 s.area.adhesion, s.area.slip, s.area.flow});
        for (const int n : {s.elements.contact, s.elements.adhesion, s.elements.slip, s.elements.border}) whole(n);
        motion(s.motion);
        maybe(s.frictional_work);
        maybe(s.frictional_power);
        whole(s.converged());
        solver(s.evidence.normal);
        for (const auto& evidence : {s.evidence.tangential, s.evidence.outer, s.evidence.force})
            evidence ? solver(*evidence) : nothing(3);
        discretisation(s.evidence.discretisation);
        const Derivatives derivatives = s.derivatives.value_or(Derivatives{});
        for (const auto& of : {derivatives.Fx, derivatives.Fy, derivatives.Mz, derivatives.Fn, derivatives.approach})
            by_inputs(of.value_or(DerivativesOfAnswer{}));
        std::string warnings;
        for (const std::string& warning : s.warnings) warnings += warning;
        whole(static_cast<long long>(s.warnings.size()));
        digest(warnings, [](char c) { return std::vector<std::uint64_t>{static_cast<unsigned char>(c)}; });
        digest(s.element_division, [](ElementState e) { return std::vector{static_cast<std::uint64_t>(e)}; });
        for (const auto* array :
             {&s.pressure, &s.traction_x, &s.traction_y, &s.slip_x, &s.slip_y, &s.pressure_by_approach})
            digest(array->empty() ? std::vector<double>(grid.size()) : *array, [](double value) {
                const auto bits = std::bit_cast<std::uint64_t>(value);
                return std::vector{bits >> 32u, bits & 0xFFFFFFFFu};
            });
        const std::optional<Resultant>& r = s.resultant;
        r ? numbers({r->Fx, r->Fy, r->Fz, r->Mx, r->My, r->Mz}) : nothing(6);
    }

   private:
    static void whole(long long value) { std::printf(" %lld", value); }
    static void number(double value) { std::printf(" %016" PRIX64, std::bit_cast<std::uint64_t>(value)); }
    static void numbers(const std::vector<double>& values) {
        for (const double value : values) number(value);
    }
    static void nothing(int count = 1) {
        for (int i = 0; i < count; ++i) std::printf(" -");
    }
    static void maybe(const std::optional<double>& value) { value ? number(*value) : nothing(); }
    static void motion(const std::optional<Motion>& motion) {
        if (!motion) return nothing(3);
        if (const auto* rolling = std::get_if<Rolling>(&*motion))
            return numbers({rolling->xi, rolling->eta, rolling->phi});
        const auto& shift = std::get<Shift>(*motion);
        numbers({shift.rigid_shift.x, shift.rigid_shift.y, shift.rotation});
    }
    static void solver(const SolverEvidence& evidence) {
        whole(evidence.iterations);
        number(evidence.residual);
        whole(evidence.converged);
    }
    static void discretisation(const std::optional<Discretisation>& fine) {
        if (!fine) return nothing(4);
        whole(fine->elements_across);
        numbers({fine->force_error, fine->pmax_error, fine->rolling_error.value_or(0)});
    }
    static void by_inputs(const DerivativesOfAnswer& by) {
        const auto shift = by.rigid_shift;
        maybe(shift ? shift->x : by.xi);
        maybe(shift ? shift->y : by.eta);
        maybe(by.phi ? by.phi : by.rotation);
        maybe(by.approach ? by.approach : by.Fn);
        maybe(by.mu);
    }
    template <class Values, class Parts>
    static void digest(const Values& values, const Parts& parts) {
        std::uint64_t sum = 0;
        for (const auto& value : values)
            for (const std::uint64_t part : parts(value)) sum = (sum * 65599 + part) % 4294967291u;
        std::printf(" %" PRIu64, sum);
    }
};

}  // namespace contactd
