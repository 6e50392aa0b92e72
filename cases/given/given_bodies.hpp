// Determines bodies, the layer between them, their heat and the solvers, from CONTACT's numbers.
#pragma once

#include <vector>

#include "given/given.hpp"
#include "given/units.hpp"

namespace contactd::cases {

/// Names methods of materials, the values of the digit M.
namespace material {
inline constexpr int elastic = 0, viscoelastic = 1, fastsim = 3, layered = 4, fastrip = 5;
}  // namespace material

/// Returns the number of values of a method, or nothing for an unknown method.
std::optional<int> material_numbers(int method);
/// Sets materials by POISS1, POISS2, GG1, GG2, followed by FG1, FG2, TC1, TC2 of viscoelastic bodies, K0, ALFA, BETA of
/// FASTSIM and FaStrip, or GG3, LAYTHK, TAU_C0, K_TAU of a layer. Throws NotCovered.
void set_material(Given& given, int method, const std::vector<double>& numbers, const Units& units);
/// Throws NotCovered unless the damping CDAMPN and CDAMPT is 0.
void require_undamped(double normal, double tangential);

/// Reads 4 numbers of each body: bulk temperature, heat capacity (J/(kg K)), conductivity (W/(length K)) and density
/// (kg/length^3), and optionally the fraction of plastic work that becomes heat.
ThermalBodies thermal_bodies(const std::vector<double>& numbers, const Units& units);

/// Returns tolerances and limits by EPS, MAXGS and MAXOUT. contactd always uses its own solvers. EPS can decrease their
/// tolerances, but not increase them. MAXGS limits the iterations of both solvers, and MAXOUT the outer iterations.
/// MAXOUT = 1 leaves contactd's own limit, because programs set it for quasi-identical bodies, while contactd also
/// needs outer iterations for friction laws. contactd has no loops that MAXIN and MAXNR could limit. Throws NotCovered.
ContactSettings solver_settings(double eps, int maxgs, int maxout);

}  // namespace contactd::cases
