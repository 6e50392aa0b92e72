#include "friction_bodies.hpp"

#include "contact/tangential/shift_compliance.hpp"

namespace contactd {

std::unique_ptr<Compliance> compliance_of(const FrictionBodies& bodies, const Contact& contact) {
    if (bodies.increment == nullptr) return std::make_unique<ShiftCompliance>(bodies.influence, contact);
    const RollingBodies rolling{bodies.influence, *bodies.increment, bodies.grid, bodies.step_x, bodies.step_y};
    return std::make_unique<RollingCompliance>(rolling, contact, bodies.levels);
}

}  // namespace contactd
