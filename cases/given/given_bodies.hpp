// Bodies, the layer between them, their heat and the solvers, from the numbers in which CONTACT takes them.
#pragma once

#include <vector>

#include "given/given.hpp"
#include "given/units.hpp"

namespace contactd::cases {

/// Methods of materials: the digit M.
namespace material {
inline constexpr int elastic = 0, viscoelastic = 1, fastsim = 3, layered = 4, fastrip = 5;
}  // namespace material

/// Returns how many numbers a method has; nothing of others.
std::optional<int> material_numbers(int method);
/// Sets materials by POISS1, POISS2, GG1, GG2, and behind them FG1, FG2, TC1, TC2 of viscoelastic bodies, K0, ALFA,
/// BETA of FASTSIM and FaStrip, or GG3, LAYTHK, TAU_C0, K_TAU of a layer. Throws NotCovered.
void set_material(Given& given, int method, const std::vector<double>& numbers, const Units& units);
/// Throws NotCovered where there is damping, CDAMPN or CDAMPT: contactd has none.
void require_undamped(double normal, double tangential);

/// 4 numbers of each body: bulk temperature, heat capacity (J/(kg K)), conductivity (W/(length K)) and density
/// (kg/length^3); then the share of plastic work that becomes heat, or nothing.
ThermalBodies thermal_bodies(const std::vector<double>& numbers, const Units& units);

/// Tolerances and limits by EPS, MAXGS and MAXOUT. Solvers are contactd's own, whichever is named: a tolerance makes
/// theirs smaller, never larger. MAXGS bounds the iterations of both solvers, MAXOUT the outer iterations. Programs
/// with quasi-identical bodies set MAXOUT to 1, and contactd's outer iterations serve friction laws, too: so 1 leaves
/// their bound. MAXIN and MAXNR are of loops that contactd does not have. Throws NotCovered.
ContactSettings solver_settings(double eps, int maxgs, int maxout);

}  // namespace contactd::cases
