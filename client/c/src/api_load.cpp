// contactd.h: the load of a contact, before and between its steps.
#include <algorithm>

#include "edge.hpp"

using namespace contactd::c;
using contactd::Gap;
using contactd::KineticFriction;
using contactd::MotionKind;

namespace {

void set_gap(Said& said, Gap gap) {
    said.problem.gap = std::move(gap);
    said.changed.gap = true;
}

void set_mu(Said& said, std::vector<double> mu) {
    said.mu = std::move(mu);
    said.changed.friction = true;
}

/// Of either motion; `change` may throw before it has changed anything.
template <class Change>
std::int32_t motion(contactd_contact* contact, const Change& change) {
    return load(contact, [&](Said& said) {
        change(said);
        said.changed.motion = true;
    });
}

}  // namespace

std::int32_t contactd_set_approach(contactd_contact* contact, double approach) {
    return load(contact, [&](Said& said) {
        said.problem.approach = finite(approach, "approach");
        said.problem.Fn.reset();
    });
}

std::int32_t contactd_set_Fn(contactd_contact* contact, double Fn) {
    return load(contact, [&](Said& said) {
        said.problem.Fn = finite(Fn, "Fn");
        said.problem.approach.reset();
    });
}

std::int32_t contactd_set_paraboloid(contactd_contact* contact, double Rx, double Ry) {
    return load(contact, [&](Said& said) {
        set_gap(said, contactd::Paraboloid{number(Rx, "gap.paraboloid.Rx"), number(Ry, "gap.paraboloid.Ry")});
    });
}

std::int32_t contactd_set_semi_axes(contactd_contact* contact, double a, double b) {
    return load(contact, [&](Said& said) {
        set_gap(said, contactd::SemiAxes{finite(a, "gap.semi_axes.a"), finite(b, "gap.semi_axes.b")});
    });
}

std::int32_t contactd_set_gap(contactd_contact* contact, const double* gap, std::int32_t count) {
    return load(contact, [&](Said& said) { set_gap(said, array(gap, count, "gap.array")); });
}

std::int32_t contactd_set_mu(contactd_contact* contact, double mu) {
    return load(contact, [&](Said& said) { set_mu(said, {finite(mu, "friction.mu")}); });
}

std::int32_t contactd_set_mu_array(contactd_contact* contact, const double* mu, std::int32_t count) {
    return load(contact, [&](Said& said) { set_mu(said, array(mu, count, "friction.mu")); });
}

std::int32_t contactd_set_kinetic(contactd_contact* contact, std::int32_t law, double mu, double slip_velocity) {
    return load(contact, [&](Said& said) {
        word(law, CONTACTD_EXPONENTIAL, "friction.kinetic.law");
        said.kinetic = KineticFriction{static_cast<contactd::SlipLaw>(law), finite(mu, "friction.kinetic.mu"),
                                       finite(slip_velocity, "friction.kinetic.slip_velocity")};
        said.changed.friction = true;
    });
}

std::int32_t contactd_set_shift(contactd_contact* contact, double x, double y, double rotation) {
    return motion(contact, [&](Said& said) {
        const contactd::RigidShift shift{finite(x, "friction.rigid_shift"), finite(y, "friction.rigid_shift")};
        said.shift.rotation = finite(rotation, "friction.rotation");
        said.shift.rigid_shift = shift;
        said.kind = MotionKind::shift;
    });
}

std::int32_t contactd_set_duration(contactd_contact* contact, double duration) {
    return motion(contact, [&](Said& said) { said.shift.duration = finite(duration, "friction.duration"); });
}

std::int32_t contactd_set_rolling(contactd_contact* contact, std::int32_t kind, double xi, double eta, double phi) {
    return motion(contact, [&](Said& said) {
        word(kind, CONTACTD_TRANSIENT, "friction.rolling.kind");
        finite(xi, "friction.rolling.xi");
        finite(eta, "friction.rolling.eta");
        said.rolling.phi = finite(phi, "friction.rolling.phi");
        said.rolling.xi = xi;
        said.rolling.eta = eta;
        said.rolling.kind = static_cast<contactd::RollingKind>(kind);
        said.kind = MotionKind::rolling;
    });
}

std::int32_t contactd_set_direction(contactd_contact* contact, double chi, double dq) {
    return motion(contact, [&](Said& said) {
        finite(dq, "friction.rolling.dq");
        said.rolling.chi = finite(chi, "friction.rolling.chi");
        said.rolling.dq = dq;
    });
}

std::int32_t contactd_set_spin_offset(contactd_contact* contact, double spin_offset) {
    return motion(contact,
                  [&](Said& said) { said.rolling.spin_offset = finite(spin_offset, "friction.rolling.spin_offset"); });
}

std::int32_t contactd_set_rolling_steps(contactd_contact* contact, std::int32_t steps) {
    return motion(contact, [&](Said& said) { said.rolling.steps = steps; });
}

std::int32_t contactd_set_velocity(contactd_contact* contact, double velocity) {
    return motion(contact, [&](Said& said) { said.rolling.velocity = finite(velocity, "friction.rolling.velocity"); });
}

std::int32_t contactd_set_Fx(contactd_contact* contact, double Fx) {
    return motion(contact, [&](Said& said) { said.force.Fx = finite(Fx, "friction.force"); });
}

std::int32_t contactd_set_Fy(contactd_contact* contact, double Fy) {
    return motion(contact, [&](Said& said) { said.force.Fy = finite(Fy, "friction.force"); });
}

std::int32_t contactd_clear_forces(contactd_contact* contact) {
    return motion(contact, [](Said& said) { said.force = {}; });
}

std::int32_t contactd_set_rigid_slip(contactd_contact* contact, const double* x, const double* y, std::int32_t count) {
    return load(contact, [&](Said& said) {
        said.problem.rigid_slip = {array(x, count, "friction.rigid_slip.x"), array(y, count, "friction.rigid_slip.y")};
        said.changed.rigid_slip = true;
    });
}

std::int32_t contactd_want_derivatives(contactd_contact* contact, std::int32_t wanted) {
    return load(contact, [&](Said& said) { said.problem.derivatives = word(wanted, 1, "wanted") != 0; });
}
