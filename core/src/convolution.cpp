#include "contactd/convolution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <string>

#include "coarsening.hpp"
#include "contactd/error.hpp"
#include "padded_fft.hpp"

namespace contactd {
namespace {

// 2n where n has small prime factors only; for other n a smaller smooth number is several times faster.
int padded_size(int n) {
    if (n == 1) return 1;
    return smooth_size(n) == n ? 2 * n : smooth_size(2 * n - 1);
}

// The inverse of a convolution decays as rho^-3, so opposite edges hardly feel each other without any padding.
int preconditioner_size(int n) {
    return n == 1 ? 1 : 2 * smooth_size((n + 1) / 2);
}

// The symbol of a half-space stays above 0.08 times the diagonal even for elements of 1:1000. This part of the diagonal
// is its least value here: the reciprocal stays positive where truncation or errors of the table made it negative.
constexpr double smallest_symbol = 0.02;

}  // namespace

struct ConvolutionOperator::Impl {
    int nx, ny;
    PaddedFft product, inverse;
    PaddedFft::Symbol xx, yy, zz, xy, yx;
    std::array<PaddedFft::Symbol, 3> reciprocal;
    std::array<double, 3> diagonal;
    Coarsening coarsening;
    IcTable coarse_table;
    std::once_flag coarse_made;
    std::unique_ptr<ConvolutionOperator> coarse;

    Impl(const IcTable& larger_table, int nx_, int ny_)
        : nx(nx_),
          ny(ny_),
          product(nx, ny, padded_size(nx), padded_size(ny)),
          inverse(nx, ny, preconditioner_size(nx), preconditioner_size(ny)),
          coarsening(nx, ny) {
        const IcTable table = cropped(larger_table, nx, ny);
        using enum Axis;
        xx = symbol(table, x, x);
        yy = symbol(table, y, y);
        zz = symbol(table, z, z);
        xy = symbol(table, x, y);
        yx = symbol(table, y, x);
        for (const Axis i : {x, y, z}) {
            reciprocal[static_cast<std::size_t>(i)] = reciprocal_symbol(table, i);
            diagonal[static_cast<std::size_t>(i)] = table(i, i, 0, 0);
        }
        if (coarsening.useful()) coarse_table = coarsening.coarse(table);
    }

    static PaddedFft::Kernel kernel(const IcTable& table, Axis i, Axis j) {
        return {&table.values[table.index(i, j, 0, 0)], table.nx, table.ny, i != j};
    }

    PaddedFft::Symbol symbol(const IcTable& table, Axis i, Axis j) const { return product.symbol(kernel(table, i, j)); }

    PaddedFft::Symbol reciprocal_symbol(const IcTable& table, Axis i) const {
        PaddedFft::Symbol symbol = inverse.symbol(kernel(table, i, i));
        const double factor = inverse.norm_factor();
        const double least = smallest_symbol * table(i, i, 0, 0) * factor;
        for (double& value : symbol) value = factor * factor / std::max(value, least);
        return symbol;
    }
};

ConvolutionOperator::ConvolutionOperator(const IcTable& table, int nx, int ny) {
    if (nx < 1 || ny < 1)
        throw InvalidArgument("grid", "is " + std::to_string(nx) + " x " + std::to_string(ny) +
                                          " elements; both numbers must be at least 1");
    if (table.nx < nx || table.ny < ny)
        throw InvalidArgument("grid", "needs offsets up to " + std::to_string(nx) + " x " + std::to_string(ny) +
                                          "; the table holds " + std::to_string(table.nx) + " x " +
                                          std::to_string(table.ny));
    impl_ = std::make_unique<Impl>(table, nx, ny);
}

ConvolutionOperator::~ConvolutionOperator() = default;
ConvolutionOperator::ConvolutionOperator(ConvolutionOperator&&) noexcept = default;
ConvolutionOperator& ConvolutionOperator::operator=(ConvolutionOperator&&) noexcept = default;

std::size_t ConvolutionOperator::size() const {
    return static_cast<std::size_t>(impl_->nx) * static_cast<std::size_t>(impl_->ny);
}

void ConvolutionOperator::normal(std::span<const double> pz, std::span<double> uz) const {
    impl_->product.apply(impl_->zz, pz, uz);
}

void ConvolutionOperator::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                     std::span<double> uy) const {
    impl_->product.apply({impl_->xx, impl_->xy, impl_->yx, impl_->yy}, px, py, ux, uy);
}

double ConvolutionOperator::diagonal(Axis i) const {
    return impl_->diagonal[static_cast<std::size_t>(i)];
}

void ConvolutionOperator::precondition(Axis i, std::span<const double> r, std::span<double> z) const {
    impl_->inverse.apply(impl_->reciprocal[static_cast<std::size_t>(i)], r, z);
}

const InfluenceOperator* ConvolutionOperator::coarser() const {
    Impl& impl = *impl_;
    if (!impl.coarsening.useful()) return nullptr;
    std::call_once(impl.coarse_made, [&] {
        impl.coarse =
            std::make_unique<ConvolutionOperator>(impl.coarse_table, impl.coarse_table.nx, impl.coarse_table.ny);
    });
    return impl.coarse.get();
}

void ConvolutionOperator::to_coarser(std::span<const double> fine, std::span<double> coarse) const {
    impl_->coarsening.average(fine, coarse);
}

void ConvolutionOperator::from_coarser(std::span<const double> coarse, std::span<double> fine) const {
    impl_->coarsening.interpolate(coarse, fine);
}

int smooth_size(int n) {
    const auto smooth = [](int m) {
        for (const int prime : {2, 3, 5, 7})
            while (m % prime == 0) m /= prime;
        return m == 1;
    };
    while (!smooth(n)) ++n;
    return n;
}

}  // namespace contactd
