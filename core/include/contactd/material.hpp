// Describes a linear elastic, homogeneous, isotropic material, and the pair of bodies in contact.
#pragma once

#include <limits>

namespace contactd {

struct Material {
    double G = 0;   ///< shear modulus, force/length^2 (N/mm^2), > 0; infinite: a rigid body
    double nu = 0;  ///< Poisson's ratio, 0 <= nu <= 0.5

    /// Creates a material from Young's modulus E = 2 G (1 + nu) (N/mm^2).
    static constexpr Material from_E(double E, double nu) { return {E / (2 * (1 + nu)), nu}; }
    static constexpr Material rigid() { return {std::numeric_limits<double>::infinity(), 0}; }
    constexpr double E() const { return 2 * G * (1 + nu); }  ///< Young's modulus (N/mm^2)
    bool is_rigid() const { return G == std::numeric_limits<double>::infinity(); }

    bool operator==(const Material&) const = default;
};

/// Holds the materials of the two bodies. A contact problem uses the difference of their surface displacements; forces
/// act on the upper one.
struct MaterialPair {
    Material upper;
    Material lower;

    /// Returns whether normal and tangential contact are independent because (1-2nu)/G is the same for both bodies
    /// ("quasi-identical", paper section 4). The xz, zx, yz, zy coefficients of the pair are then zero.
    bool quasi_identical() const;
    /// Returns the sum of (1-nu)/(2G), which is 1/E*, the only material parameter of frictionless half-space contact
    /// (mm^2/N).
    double normal_compliance() const;

    bool operator==(const MaterialPair&) const = default;
};

/// Throws InvalidArgument, which names `field`.G or `field`.nu, if the material is invalid. nu = 0.5 requires
/// `incompressible_allowed`, because displacement-based finite elements do not support it.
void validate(const Material& material, const char* field, bool incompressible_allowed);

}  // namespace contactd
