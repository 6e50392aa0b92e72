// contactd.h: the patches of a wheel on its rail.
#include <algorithm>

#include "edge.hpp"

using namespace contactd::c;
using contactd::SolutionField;
using contactd::WheelRailPatch;

namespace {

template <class Body>
std::int32_t read(contactd_wheel* wheel, std::int32_t patch, const Body& body) {
    return with(wheel, [&](Wheel& asked) { body(asked.patch(patch)); });
}

}  // namespace

std::int32_t contactd_wheel_get_place(contactd_wheel* wheel, std::int32_t patch, double* x, double* y, double* z,
                                      double* angle) {
    return read(wheel, patch, [&](const WheelRailPatch& one) {
        given(x, "x"), given(y, "y"), given(z, "z"), given(angle, "angle");
        const contactd::ContactReference& at = one.place.reference;
        *x = at.x;
        *y = at.y;
        *z = at.z;
        *angle = at.angle;
    });
}

std::int32_t contactd_wheel_get_grid(contactd_wheel* wheel, std::int32_t patch, std::int32_t* nx, std::int32_t* ny,
                                     double* dx, double* dy, double* x0, double* y0) {
    return read(wheel, patch, [&](const WheelRailPatch& one) {
        given(nx, "nx"), given(ny, "ny"), given(dx, "dx"), given(dy, "dy"), given(x0, "x0"), given(y0, "y0");
        const contactd::Grid& grid = one.place.grid;
        *nx = grid.nx;
        *ny = grid.ny;
        *dx = grid.dx;
        *dy = grid.dy;
        *x0 = grid.x0;
        *y0 = grid.y0;
    });
}

std::int32_t contactd_wheel_get_rows(contactd_wheel* wheel, std::int32_t patch, double* y, double* z, double* angle,
                                     std::int32_t length) {
    return read(wheel, patch, [&](const WheelRailPatch& one) {
        given(y, "y"), given(z, "z"), given(angle, "angle");
        const std::vector<contactd::ContactRow>& rows = one.place.rows;
        if (rows.empty()) throw nothing_of("rows: the contact lies in a plane");
        if (length < 0 || static_cast<std::size_t>(length) != rows.size())
            throw contactd::InvalidArgument(
                "length", "is " + std::to_string(length) + "; the grid has " + std::to_string(rows.size()) + " rows");
        for (std::size_t row = 0; row < rows.size(); ++row) {
            y[row] = rows[row].y;
            z[row] = rows[row].z;
            angle[row] = rows[row].angle;
        }
    });
}

std::int32_t contactd_wheel_get_creepages(contactd_wheel* wheel, std::int32_t patch, double* xi, double* eta,
                                          double* phi, double* velocity) {
    return read(wheel, patch, [&](const WheelRailPatch& one) {
        given(xi, "xi"), given(eta, "eta"), given(phi, "phi"), given(velocity, "velocity");
        const contactd::Creepages& creepages = one.place.creepages;
        *xi = creepages.xi;
        *eta = creepages.eta;
        *phi = creepages.phi;
        *velocity = creepages.velocity;
    });
}

std::int32_t contactd_wheel_get_radii(contactd_wheel* wheel, std::int32_t patch, double* wheel_along,
                                      double* wheel_across, double* rail_along, double* rail_across) {
    return read(wheel, patch, [&](const WheelRailPatch& one) {
        given(wheel_along, "wheel_along"), given(wheel_across, "wheel_across");
        given(rail_along, "rail_along"), given(rail_across, "rail_across");
        const contactd::ContactRadii& radii = one.place.radii;
        *wheel_along = radii.wheel_along;
        *wheel_across = radii.wheel_across;
        *rail_along = radii.rail_along;
        *rail_across = radii.rail_across;
    });
}

std::int32_t contactd_wheel_get_contact_forces(contactd_wheel* wheel, std::int32_t patch, double* Fn, double* Fx,
                                               double* Fs, double* Mn) {
    return read(wheel, patch, [&](const WheelRailPatch& one) {
        given(Fn, "Fn"), given(Fx, "Fx"), given(Fs, "Fs"), given(Mn, "Mn");
        const contactd::Forces& forces = one.solution.forces;
        *Fn = forces.Fn;
        *Fx = forces.Fx;
        *Fs = forces.Fy;
        *Mn = forces.Mz;
    });
}

std::int32_t contactd_wheel_get_pressure(contactd_wheel* wheel, std::int32_t patch, double* approach, double* pmax) {
    return read(wheel, patch, [&](const WheelRailPatch& one) {
        given(approach, "approach"), given(pmax, "pmax");
        *approach = one.solution.approach;
        *pmax = one.solution.pmax;
    });
}

std::int32_t contactd_wheel_get_areas(contactd_wheel* wheel, std::int32_t patch, double* in_contact, double* adhesion,
                                      double* slip) {
    return read(wheel, patch,
                [&](const WheelRailPatch& one) { put_areas(one.solution.area, in_contact, adhesion, slip); });
}

std::int32_t contactd_wheel_get_frictional_power(contactd_wheel* wheel, std::int32_t patch, double* power) {
    return read(wheel, patch, [&](const WheelRailPatch& one) {
        given(power, "power");
        if (!one.solution.frictional_power) throw nothing_of("frictional power: without friction");
        *power = *one.solution.frictional_power;
    });
}

std::int32_t contactd_wheel_get_counts(contactd_wheel* wheel, std::int32_t patch, std::int32_t* in_contact,
                                       std::int32_t* adhesion, std::int32_t* slip, std::int32_t* border) {
    return read(wheel, patch, [&](const WheelRailPatch& one) {
        put_counts(one.solution.elements, in_contact, adhesion, slip, border);
    });
}

std::int32_t contactd_wheel_get_array(contactd_wheel* wheel, std::int32_t patch, std::int32_t array, double* values,
                                      std::int32_t length) {
    return with(wheel, [&](Wheel& asked) {
        given(values, "values");
        word(array, CONTACTD_GAP, "array");
        const WheelRailPatch& one = asked.patch(patch);
        if (array == CONTACTD_GAP) {
            asked.require_gap();
            if (one.gap.empty()) throw nothing_of("undeformed distances: a quick model solved it");
            put_array(one.gap, one.place.grid, values, length);
            return;
        }
        const SolutionField field = double_field(array, "contactd_wheel_get_division");
        asked.require(field);
        put_array(array_of(one.solution, field), one.place.grid, values, length);
    });
}

std::int32_t contactd_wheel_get_division(contactd_wheel* wheel, std::int32_t patch, std::int32_t* division,
                                         std::int32_t length) {
    return with(wheel, [&](Wheel& asked) {
        given(division, "division");
        const WheelRailPatch& one = asked.patch(patch);
        asked.require(SolutionField::element_division);
        put_division(one.solution, one.place.grid, division, length);
    });
}
