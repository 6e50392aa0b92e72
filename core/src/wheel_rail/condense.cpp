#include "wheel_rail/condense.hpp"

namespace contactd {
namespace {

void add(Wrench& sum, double factor, const Wrench& part) {
    for (double Wrench::* of : {&Wrench::Fx, &Wrench::Fy, &Wrench::Fz, &Wrench::Mx, &Wrench::My, &Wrench::Mz})
        sum.*of += factor * (part.*of);
}

Wrench negative(const Wrench& of) {
    Wrench result;
    add(result, -1, of);
    return result;
}

}  // namespace

void condense_rail_deflection(WheelRailDerivatives& derivatives, const Wrench& forces, const RailSprings& springs) {
    auto& [position, velocity] = derivatives;
    const Wrench by_y = position.y, by_z = position.z;
    Wrench by_rail_y = negative(by_y), by_rail_z = negative(by_z);
    add(by_rail_y, 1, {0, 0, 0, forces.Fz, 0, -forces.Fx});
    add(by_rail_z, 1, {0, 0, 0, -forces.Fy, forces.Fx, 0});
    // The deflection solves (K + dF/d(y, z)) deflection = dF; a direction without a spring does not deflect.
    const double yy = springs.y ? *springs.y + by_y.Fy : 1, yz = springs.y && springs.z ? by_z.Fy : 0;
    const double zy = springs.y && springs.z ? by_y.Fz : 0, zz = springs.z ? *springs.z + by_z.Fz : 1;
    const double determinant = yy * zz - yz * zy;
    for (Wrench* by : {&position.y, &position.z, &position.roll, &position.yaw, &velocity.x, &velocity.y, &velocity.z,
                       &velocity.roll, &velocity.yaw, &velocity.pitch}) {
        const double Fy = springs.y ? by->Fy : 0, Fz = springs.z ? by->Fz : 0;
        add(*by, (Fy * zz - Fz * yz) / determinant, by_rail_y);
        add(*by, (Fz * yy - Fy * zy) / determinant, by_rail_z);
    }
}

}  // namespace contactd
