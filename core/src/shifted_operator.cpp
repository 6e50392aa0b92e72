#include "contactd/shifted_operator.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "coarsening.hpp"
#include "contactd/given_ics.hpp"
#include "padded_fft.hpp"
#include "padded_size.hpp"

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
    PaddedFft::ComplexSymbol xx, xy, yx, yy, xz, yz;
    bool coupled;
    Coarsening coarsening;
    ShiftedTable table;  // until the coarser operator is made
    std::once_flag coarse_made;
    std::unique_ptr<ShiftedOperator> coarse;

    explicit Impl(ShiftedTable table_)
        : nx(table_.nx),
          ny(table_.ny),
          product(nx, ny, padded_size(nx), padded_size(ny)),
          coupled(is_coupled(table_)),
          coarsening(nx, ny),
          table(std::move(table_)) {
        xx = symbol(x, x);
        xy = symbol(x, y);
        yx = symbol(y, x);
        yy = symbol(y, y);
        if (coupled) {
            xz = symbol(x, z);
            yz = symbol(y, z);
        }
        if (!coarsening.useful()) table = {};
    }

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
    impl_->product.apply(PaddedFft::ComplexPairSymbols{impl_->xx, impl_->xy, impl_->yx, impl_->yy}, px, py, ux, uy);
}

bool ShiftedOperator::coupled() const {
    return impl_->coupled;
}

void ShiftedOperator::tangential_of_normal(std::span<const double> pz, std::span<double> ux,
                                           std::span<double> uy) const {
    if (coupled()) return impl_->product.spread(impl_->xz, impl_->yz, pz, ux, uy);
    std::fill(ux.begin(), ux.end(), 0.0);
    std::fill(uy.begin(), uy.end(), 0.0);
}

const ShiftedOperator* ShiftedOperator::coarser() const {
    Impl& impl = *impl_;
    if (!impl.coarsening.useful()) return nullptr;
    std::call_once(impl.coarse_made, [&] {
        impl.coarse = std::make_unique<ShiftedOperator>(impl.coarsening.coarse(impl.table));
        impl.table = {};
    });
    return impl.coarse.get();
}

}  // namespace contactd
