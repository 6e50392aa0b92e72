// Evaluates tables of creep forces: the full theory of steady rolling over elliptic contacts, for any creepages and
// spin.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

namespace contactd {

/// Describes a Hertzian contact of quasi-identical bodies with one coefficient of friction. All values are positive.
struct CreepContact {
    double a = 0;   ///< semi-axis along the rolling direction (mm)
    double b = 0;   ///< semi-axis across (mm)
    double G = 0;   ///< shear modulus of the combined material (N/mm^2)
    double mu = 0;  ///< coefficient of friction
    double Fn = 0;  ///< normal force (N)
};

/// Holds the forces on the upper body, in the order Fx, Fy (N) and Mz (N mm): the signs of contact.solve.
struct CreepForces {
    std::array<double, 3> forces{};
    std::array<std::array<double, 3>, 3> by_creepage{};  ///< rows by xi, eta and phi (1/mm)
    std::array<std::array<double, 5>, 3> by_contact{};   ///< rows by a, b, G, mu and Fn at constant creepages
    /// Bounds of the errors of each of Fx and Fy (N), and of Mz (N mm), or NaN if the table states none.
    double force_bound = 0, moment_bound = 0;
};

/// Holds one table at one Poisson's ratio. Copies share it, and any thread may evaluate it.
///
/// The forces over mu Fn depend on a/b and on (xi, eta, phi c) G c^2/(mu Fn), c^2 = ab. A table interpolates them by
/// cubic B-splines, and is built and read in these variables. Forces exceed mu Fn by the bound of the table at most.
class CreepTable {
   public:
    /// Maps the file at `path`, checks its digest, and reduces tables of several Poisson's ratios to `nu`; without it,
    /// to the first of the file. The file must not change while a table is open; to replace it, rename another one over
    /// it. Throws InvalidArgument ("nu"), DamagedTable, NewerFormat, and StoreError if the file cannot be read.
    explicit CreepTable(const std::filesystem::path& path, std::optional<double> nu = std::nullopt);

    /// Returns the forces in steady rolling along +x for creepages xi, eta and spin phi (1/mm), without allocation or
    /// locks. Throws InvalidArgument ("a", "b", "G", "mu", "Fn", "creepages"), also if the table does not hold a/b.
    CreepForces forces(const CreepContact& contact, const std::array<double, 3>& creepages) const;

    /// Returns the range of a/b.
    std::array<double, 2> ratios() const;
    double nu() const;
    /// Returns the JSON text of the file: versions, recipe, seed, points and the statement about errors.
    std::string_view description() const;

    struct Contents;

   private:
    std::shared_ptr<const Contents> contents_;
};

}  // namespace contactd
