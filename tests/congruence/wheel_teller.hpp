// Prints the results of a wheel on its rail for the driver in C++, in the order of wheel_telling.py.
#pragma once

#include <bit>
#include <cinttypes>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "contactd/wheel_rail_solution.hpp"

namespace contactd {

class WheelTeller {
   public:
    void tell(const WheelRailSolution& wheel) const {
        numbers({wheel.z, wheel.pitch_rate});
        maybe(wheel.clearance);
        forces(wheel.forces);
        derivatives(wheel.derivatives);
        whole(wheel.converged());
        wheel.rail_deflection ? numbers({wheel.rail_deflection->y, wheel.rail_deflection->z}) : nothing(2);
        for (const auto& search : {wheel.force, wheel.pitch_search, wheel.rail_search}) {
            if (!search) {
                nothing(3);
                continue;
            }
            whole(search->iterations);
            numbers({search->residual});
            whole(search->converged);
        }
        warnings(wheel.warnings);
        whole(static_cast<long long>(wheel.patches.size()));
        for (const WheelRailPatch& patch : wheel.patches) tell(patch);
    }

    void tell(const WheelRailGeometry& geometry) const {
        numbers({geometry.z});
        maybe(geometry.clearance);
        warnings(geometry.warnings);
        whole(static_cast<long long>(geometry.places.size()));
        for (const ContactPlace& place : geometry.places) {
            tell(place);
            numbers({place.approach});
        }
    }

   private:
    static void whole(long long value) { std::printf(" %lld", value); }
    static void numbers(const std::vector<double>& values) {
        for (const double value : values) std::printf(" %016" PRIX64, std::bit_cast<std::uint64_t>(value));
    }
    static void nothing(int count) {
        for (int i = 0; i < count; ++i) std::printf(" -");
    }
    static void maybe(const std::optional<double>& value) { value ? numbers({*value}) : nothing(1); }
    static void wrench(const Wrench& w) { numbers({w.Fx, w.Fy, w.Fz, w.Mx, w.My, w.Mz}); }
    static void forces(const WheelRailForces& forces) {
        wrench(forces.track);
        wrench(forces.rail);
        wrench(forces.wheelset);
    }
    static void derivatives(const std::optional<WheelRailDerivatives>& known) {
        if (!known) return nothing(60);
        const auto& [position, velocity] = *known;
        for (const Wrench& by : {position.y, position.z, position.roll, position.yaw, velocity.x, velocity.y,
                                 velocity.z, velocity.roll, velocity.yaw, velocity.pitch})
            wrench(by);
    }
    static void warnings(const std::vector<std::string>& warnings) {
        std::string together;
        for (const std::string& warning : warnings) together += warning;
        whole(static_cast<long long>(warnings.size()));
        std::uint64_t sum = 0;
        for (const char c : together) digest(sum, static_cast<unsigned char>(c));
        std::printf(" %" PRIu64, sum);
    }
    static void tell(const ContactPlace& place) {
        const auto& [x, y, z, angle] = place.reference;
        numbers({x, y, z, angle});
        whole(place.grid.nx);
        whole(place.grid.ny);
        numbers({place.grid.dx, place.grid.dy, place.grid.x0, place.grid.y0});
        numbers({place.creepages.xi, place.creepages.eta, place.creepages.phi, place.creepages.velocity});
        numbers({place.radii.wheel_along, place.radii.wheel_across, place.radii.rail_along, place.radii.rail_across});
    }
    static void tell(const WheelRailPatch& patch) {
        const ContactSolution& s = patch.solution;
        tell(patch.place);
        numbers({s.forces.Fn, s.forces.Fx, s.forces.Fy, s.forces.Mz});
        forces(patch.forces);
        numbers({s.approach, s.pmax, s.area.contact, s.area.adhesion, s.area.slip, s.area.flow});
        for (const int count : {s.elements.contact, s.elements.adhesion, s.elements.slip, s.elements.border})
            whole(count);
        std::uint64_t sum = 0;
        for (const ElementState state : s.element_division) digest(sum, static_cast<std::uint64_t>(state));
        std::printf(" %" PRIu64, sum);
        for (const auto* array :
             {&s.pressure, &s.traction_x, &s.traction_y, &s.slip_x, &s.slip_y, &s.pressure_by_approach, &patch.gap}) {
            sum = 0;
            for (const double value : array->empty() ? std::vector<double>(patch.place.grid.size()) : *array) {
                const auto bits = std::bit_cast<std::uint64_t>(value);
                digest(sum, bits >> 32u);
                digest(sum, bits & 0xFFFFFFFFu);
            }
            std::printf(" %" PRIu64, sum);
        }
    }
    static void digest(std::uint64_t& sum, std::uint64_t more) { sum = (sum * 65599 + more) % 4294967291u; }
};

}  // namespace contactd
