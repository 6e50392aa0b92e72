#include "shifted_operator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cached_boxes.hpp"
#include "coarsening.hpp"
#include "contactd/given_ics.hpp"
#include "lazy.hpp"
#include "operators/fft/padded_fft.hpp"
#include "operators/fft/padded_size.hpp"
#include "operators/fft/periodic_inverse.hpp"
#include "operators/fft/tangential_symbols.hpp"

namespace contactd {
namespace {

using enum Axis;

bool is_coupled(const ShiftedTable& table) {
    const auto largest = [&](Axis i, Axis j) {
        const double* first = &table.values[table.index(i, j, 1 - table.nx, 1 - table.ny)];
        return std::abs(*std::max_element(first, first + table.component_size(), [](double lesser, double greater) {
            return std::abs(lesser) < std::abs(greater);
        }));
    };
    return std::max(largest(x, z), largest(y, z)) > coupling_tolerance * largest(x, x);
}

}  // namespace

struct ShiftedOperator::Impl {
    int nx, ny;
    PaddedFft product;
    const ShiftedTable table;
    const bool coupled;
    Coarsening coarsening;

    struct Coupling {
        PaddedFft::ComplexSymbol xz, yz;
    };
    Lazy<TangentialSymbols> tangential;
    Lazy<Coupling> coupling;
    Lazy<std::unique_ptr<ShiftedOperator>> coarse;
    Lazy<std::unique_ptr<PeriodicInverses>> inverses;
    CachedBoxes<StepOperator> boxes;

    explicit Impl(ShiftedTable table_)
        : nx(table_.nx),
          ny(table_.ny),
          product(nx, ny, padded_size(nx), padded_size(ny)),
          table(std::move(table_)),
          coupled(is_coupled(table)),
          coarsening(nx, ny) {}

    PaddedFft::ComplexSymbol symbol(Axis i, Axis j) const {
        return product.symbol(PaddedFft::SignedKernel{&table.values[table.index(i, j, 1 - nx, 1 - ny)], nx, ny});
    }
};

ShiftedOperator::ShiftedOperator(ShiftedTable table) : impl_(std::make_unique<Impl>(std::move(table))) {}
ShiftedOperator::~ShiftedOperator() = default;
ShiftedOperator::ShiftedOperator(ShiftedOperator&&) noexcept = default;
ShiftedOperator& ShiftedOperator::operator=(ShiftedOperator&&) noexcept = default;

std::size_t ShiftedOperator::size() const {
    return static_cast<std::size_t>(impl_->nx) * static_cast<std::size_t>(impl_->ny);
}

void ShiftedOperator::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                 std::span<double> uy) const {
    Impl& impl = *impl_;
    const TangentialSymbols& symbols =
        impl.tangential.get([&] { return TangentialSymbols::of(impl.product, impl.table); });
    impl.product.apply(symbols.pair(), px, py, ux, uy);
}

bool ShiftedOperator::coupled() const {
    return impl_->coupled;
}

void ShiftedOperator::tangential_of_normal(std::span<const double> pz, std::span<double> ux,
                                           std::span<double> uy) const {
    Impl& impl = *impl_;
    if (coupled()) {
        const auto& symbols = impl.coupling.get([&] { return Impl::Coupling{impl.symbol(x, z), impl.symbol(y, z)}; });
        return impl.product.spread(symbols.xz, symbols.yz, pz, ux, uy);
    }
    std::fill(ux.begin(), ux.end(), 0.0);
    std::fill(uy.begin(), uy.end(), 0.0);
}

std::shared_ptr<const StepInverse> ShiftedOperator::inverse(double added) const {
    return impl_->inverses.get([&] { return std::make_unique<PeriodicInverses>(impl_->table); })->get(added);
}

std::shared_ptr<const StepOperator> ShiftedOperator::on(const ElementBox& box) const {
    return impl_->boxes.get({0, 0, box.nx, box.ny}, [&] {
        return std::make_shared<const ShiftedOperator>(cropped(impl_->table, box.nx, box.ny));
    });
}

const StepOperator* ShiftedOperator::coarser() const {
    Impl& impl = *impl_;
    if (!impl.coarsening.useful()) return nullptr;
    return impl.coarse.get([&] { return std::make_unique<ShiftedOperator>(impl.coarsening.coarse(impl.table)); }).get();
}

}  // namespace contactd
