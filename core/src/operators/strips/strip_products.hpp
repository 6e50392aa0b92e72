// Products with a strip table, or with some strips and offsets of it, by FFTs along x.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "contactd/element_box.hpp"
#include "contactd/strip_table.hpp"
#include "operators/fft/workspaces.hpp"
#include "operators/lazy.hpp"
#include "strip_fft.hpp"
#include "strip_symbols.hpp"

namespace contactd {

/// Whether the components of a table are even and odd in the offset as those of StripTable, or the other way round.
enum class OffsetParity { natural, opposite };

/// On the elements of a box of a grid whose rows are strips of the table. Arrays are in the element order of the box.
/// The symmetric part of the table counts (see symmetrised); with the opposite parity it is the antisymmetric one.
/// Symbols are made when they are first needed; safe to use from several threads at once.
class StripProducts {
   public:
    /// Reads displacements at elements up to `reach` elements ahead of the box and behind it, for which the table has
    /// box.nx + reach offsets. Where the box lies along x does not matter. No coefficient (mm^3/N) is changed by more
    /// than `left_out`: the effect of large wavenumbers on strips far away is less, and need not be read. The matrices
    /// stay symmetric.
    StripProducts(std::shared_ptr<const StripTable> table, const ElementBox& box, int reach, OffsetParity parity,
                  double left_out);
    ~StripProducts();

    /// These two of natural parity only.
    void normal(std::span<const double> pz, std::span<double> uz) const;
    void normal_of_tangential(std::span<const double> px, std::span<const double> py, std::span<double> uz) const;
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const;
    void tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const;
    /// Adds them to what ux and uy hold.
    void add_tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                        std::span<double> uy) const;
    void add_tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const;
    /// Less the displacements at the points that lie `ahead` elements further along x, |ahead| <= reach.
    void tangential_change(int ahead, std::span<const double> px, std::span<const double> py, std::span<double> ux,
                           std::span<double> uy) const;
    void tangential_change_of_normal(int ahead, std::span<const double> pz, std::span<double> ux,
                                     std::span<double> uy) const;

   private:
    SymmetricSymbol normal_symbol() const;
    SymmetricSymbol tangential_symbol() const;
    RectangularSymbol coupling_symbol() const;
    template <class Set>
    void for_pairs(Axis i, Axis j, const Set& set) const;
    struct Workspace;
    Workspaces<Workspace>::Lease workspace() const;
    void normal_waves(std::span<const double> pz, Workspace& work) const;
    void in_waves(std::span<const double> px, std::span<const double> py, Workspace& work) const;
    void tangential_waves(std::span<const double> px, std::span<const double> py, Workspace& work) const;
    void coupled_waves(std::span<const double> pz, Workspace& work) const;
    void turn_back(Waves& waves) const;
    bool natural() const { return parity_ == OffsetParity::natural; }
    void read_normal(Workspace& work, std::span<double> u) const;
    template <class Take>
    void read_tangential(Workspace& work, std::span<double> ux, std::span<double> uy, int length,
                         const Take& take) const;
    auto difference_to(int ahead) const;

    const std::shared_ptr<const StripTable> table_;
    const ElementBox box_;
    const OffsetParity parity_;
    const double left_out_;
    const int offsets_, period_;
    const std::size_t strips_;
    const PeriodicJoint joint_;
    const StripFft fft_;
    mutable Lazy<SymmetricSymbol> normal_, tangential_;
    mutable Lazy<RectangularSymbol> coupling_;
    mutable Workspaces<Workspace> idle_;
};

}  // namespace contactd
