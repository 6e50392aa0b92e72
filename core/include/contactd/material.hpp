// Linear elastic, homogeneous, isotropic material, and the pair of bodies in contact.
#pragma once

namespace contactd {

struct Material {
    double G = 0;   ///< shear modulus, force/length^2 (N/mm^2), > 0
    double nu = 0;  ///< Poisson's ratio, 0 <= nu <= 0.5

    bool operator==(const Material&) const = default;
};

/// The two bodies. The contact problem uses the difference of their surface displacements; forces act on the upper one.
struct BodyPair {
    Material upper;
    Material lower;

    /// True when normal and tangential contact do not influence each other: (1-2nu)/G is the same for both bodies
    /// ("quasi-identical", paper section 4). The pair's xz, zx, yz, zy coefficients vanish then.
    bool quasi_identical() const;

    bool operator==(const BodyPair&) const = default;
};

/// Throws InvalidArgument naming `field`.G or `field`.nu when the material cannot be used.
/// nu = 0.5 is allowed only where `incompressible_allowed`: displacement-based finite elements cannot take it.
void validate(const Material& material, const char* field, bool incompressible_allowed);

}  // namespace contactd
