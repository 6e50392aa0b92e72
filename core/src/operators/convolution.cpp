#include "convolution.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <utility>

#include "cached_boxes.hpp"
#include "coarsening.hpp"
#include "contactd/error.hpp"
#include "contactd/given_ics.hpp"
#include "contactd/grid.hpp"
#include "lazy.hpp"
#include "operators/fft/inverse_symbols.hpp"
#include "operators/fft/padded_fft.hpp"
#include "operators/fft/padded_size.hpp"

namespace contactd {
namespace {

bool is_zero(const IcTable& table, Axis i, Axis j) {
    const double* values = &table.values[table.index(i, j, 0, 0)];
    return std::all_of(values, values + table.component_size(), [](double value) { return value == 0; });
}

// A separate transform of a box pays if the box has at most this fraction of the elements. The fraction is larger if
// the contact, and so its box, does not change during a solve.
constexpr double small_box = 0.7, small_lasting_box = 0.95;
// Describes columns or rows first .. first + n - 1 with a margin, shifted into 0 .. all - 1.
struct Interval {
    int first, n;
};
Interval convenient_interval(Interval needed, int all, int margin) {
    const int n = std::min(convenient_size(std::max(needed.n + margin, 1)), all);
    return {std::clamp(needed.first - (n - needed.n) / 2, 0, all - n), n};
}

}  // namespace

int padded_size(int n) {
    if (n == 1) return 1;
    return smooth_size(n) == n ? 2 * n : smooth_size(2 * n - 1);
}

// The inverse of a convolution with the coefficients of elastic bodies decays as rho^-3.
int periodic_size(int n) {
    return n == 1 ? 1 : 2 * smooth_size((n + 1) / 2);
}

/// Represents elements of twice the size.
class ConvolutionOperator::Coarser final : public CoarserGrid {
   public:
    Coarser(const Coarsening& coarsening, IcTable table) : coarsening_(coarsening), influence_(std::move(table)) {}

    const InfluenceOperator& influence() const override { return influence_; }
    int along_x() const override { return coarsening_.along_x(); }
    int along_y() const override { return coarsening_.along_y(); }
    void average(std::span<const double> fine, std::span<double> coarse) const override {
        coarsening_.average(fine, coarse);
    }
    void interpolate(std::span<const double> coarse, std::span<double> fine) const override {
        coarsening_.interpolate(coarse, fine);
    }
    void copy(std::span<const double> coarse, std::span<double> fine) const override { coarsening_.copy(coarse, fine); }

   private:
    const Coarsening coarsening_;
    const ConvolutionOperator influence_;
};

class ConvolutionOperator::Boxes final : public ElementBoxes {
   public:
    explicit Boxes(const Impl& whole) : whole_(whole) {}

    ElementBox extent() const override;
    ElementBox convenient(const ElementBox& needed, bool may_grow) const override;
    std::shared_ptr<const InfluenceOperator> influence(const ElementBox& box) const override;

   private:
    const Impl& whole_;
    mutable CachedBoxes<InfluenceOperator> cache_;
};

struct ConvolutionOperator::Impl {
    int nx, ny;
    PaddedFft product, inverse;
    const IcTable table;
    const bool coupled;
    Coarsening coarsening;

    struct Tangential {
        PaddedFft::Symbol xx, yy, xy, yx;  // xy and yx are empty if both are zero
    };
    struct Coupling {
        PaddedFft::Symbol xz, yz, zx, zy;
    };
    Lazy<PaddedFft::Symbol> zz;
    Lazy<Tangential> tangential;
    Lazy<Coupling> coupling;
    Lazy<TangentialInverse> tangential_inverse;
    std::array<Lazy<PaddedFft::Symbol>, 3> reciprocal;
    Lazy<std::unique_ptr<CoarserGrid>> coarse;
    const Boxes boxes{*this};

    explicit Impl(IcTable table_)
        : nx(table_.nx),
          ny(table_.ny),
          product(nx, ny, padded_size(nx), padded_size(ny)),
          inverse(nx, ny, periodic_size(nx), periodic_size(ny)),
          table(std::move(table_)),
          coupled(contactd::coupling(table) > coupling_tolerance),
          coarsening(nx, ny) {}

    const Tangential& tangential_symbols() {
        return tangential.get([&] {
            using enum Axis;
            Tangential made{symbol(x, x), symbol(y, y), {}, {}};
            if (is_zero(table, x, y) && is_zero(table, y, x)) return made;
            made.xy = symbol(x, y);
            made.yx = symbol(y, x);
            return made;
        });
    }

    const Coupling& coupling_symbols() {
        using enum Axis;
        return coupling.get([&] { return Coupling{symbol(x, z), symbol(y, z), symbol(z, x), symbol(z, y)}; });
    }

    const PaddedFft::Symbol& reciprocal_symbol(Axis i) {
        return reciprocal[static_cast<std::size_t>(i)].get(
            [&] { return contactd::reciprocal_symbol(inverse, table, i); });
    }

    const TangentialInverse& tangential_inverse_symbols() {
        return tangential_inverse.get([&] { return contactd::tangential_inverse(inverse, table); });
    }

    PaddedFft::Symbol symbol(Axis i, Axis j) const { return product.symbol(kernel_of(table, i, j)); }
};

ConvolutionOperator::ConvolutionOperator(const IcTable& table, int nx, int ny) {
    if (nx < 1 || ny < 1)
        throw InvalidArgument("grid", "is " + std::to_string(nx) + " x " + std::to_string(ny) +
                                          " elements; both numbers must be at least 1");
    if (table.nx < nx || table.ny < ny)
        throw InvalidArgument("grid", "needs offsets up to " + std::to_string(nx) + " x " + std::to_string(ny) +
                                          "; the table contains " + std::to_string(table.nx) + " x " +
                                          std::to_string(table.ny));
    impl_ = std::make_unique<Impl>(cropped(table, nx, ny));
}

ConvolutionOperator::ConvolutionOperator(IcTable table) : impl_(std::make_unique<Impl>(std::move(table))) {}

ConvolutionOperator::~ConvolutionOperator() = default;
ConvolutionOperator::ConvolutionOperator(ConvolutionOperator&&) noexcept = default;
ConvolutionOperator& ConvolutionOperator::operator=(ConvolutionOperator&&) noexcept = default;

std::size_t ConvolutionOperator::size() const {
    return static_cast<std::size_t>(impl_->nx) * static_cast<std::size_t>(impl_->ny);
}

void ConvolutionOperator::normal(std::span<const double> pz, std::span<double> uz) const {
    Impl& impl = *impl_;
    impl.product.apply(impl.zz.get([&] { return impl.symbol(Axis::z, Axis::z); }), pz, uz);
}

void ConvolutionOperator::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                     std::span<double> uy) const {
    const auto& symbols = impl_->tangential_symbols();
    impl_->product.apply({symbols.xx, symbols.xy, symbols.yx, symbols.yy}, px, py, ux, uy);
}

bool ConvolutionOperator::coupled() const {
    return impl_->coupled;
}

void ConvolutionOperator::normal_of_tangential(std::span<const double> px, std::span<const double> py,
                                               std::span<double> uz) const {
    if (!coupled()) return InfluenceOperator::normal_of_tangential(px, py, uz);
    const auto& symbols = impl_->coupling_symbols();
    impl_->product.gather(symbols.zx, symbols.zy, px, py, uz);
}

void ConvolutionOperator::tangential_of_normal(std::span<const double> pz, std::span<double> ux,
                                               std::span<double> uy) const {
    if (!coupled()) return InfluenceOperator::tangential_of_normal(pz, ux, uy);
    const auto& symbols = impl_->coupling_symbols();
    impl_->product.spread(symbols.xz, symbols.yz, pz, ux, uy);
}

std::vector<double> ConvolutionOperator::diagonal(Axis i) const {
    return std::vector<double>(size(), impl_->table(i, i, 0, 0));
}

void ConvolutionOperator::precondition(Axis i, std::span<const double> r, std::span<double> z) const {
    impl_->inverse.apply(impl_->reciprocal_symbol(i), r, z);
}

void ConvolutionOperator::precondition_tangential(std::span<const double> rx, std::span<const double> ry,
                                                  std::span<double> zx, std::span<double> zy) const {
    const auto& symbols = impl_->tangential_inverse_symbols();
    impl_->inverse.apply({symbols.xx, symbols.xy, symbols.xy, symbols.yy}, rx, ry, zx, zy);
}

const CoarserGrid* ConvolutionOperator::coarser() const {
    Impl& impl = *impl_;
    if (!impl.coarsening.useful()) return nullptr;
    const auto make = [&] {
        return std::make_unique<Coarser>(impl.coarsening, impl.coarsening.coarse(impl.table, impl.coupled));
    };
    return impl.coarse.get(make).get();
}

const ElementBoxes* ConvolutionOperator::boxes() const {
    return &impl_->boxes;
}

ElementBox ConvolutionOperator::Boxes::extent() const {
    return {0, 0, whole_.nx, whole_.ny};
}

ElementBox ConvolutionOperator::Boxes::convenient(const ElementBox& needed, bool may_grow) const {
    const int margin = may_grow ? 2 : 0;
    const Interval columns = convenient_interval({needed.first_x, needed.nx}, whole_.nx, margin);
    const Interval rows = convenient_interval({needed.first_y, needed.ny}, whole_.ny, margin);
    const ElementBox box{columns.first, rows.first, columns.n, rows.n};
    const double part = may_grow ? small_box : small_lasting_box;
    return static_cast<double>(box.size()) <= part * static_cast<double>(extent().size()) ? box : extent();
}

std::shared_ptr<const InfluenceOperator> ConvolutionOperator::Boxes::influence(const ElementBox& box) const {
    // Its position does not matter.
    return cache_.get({0, 0, box.nx, box.ny},
                      [&] { return std::make_shared<const ConvolutionOperator>(whole_.table, box.nx, box.ny); });
}

int smooth_size(int n) {
    const auto smooth = [](int m) {
        for (const int prime : {2, 3, 5})
            while (m % prime == 0) m /= prime;
        return m == 1;
    };
    while (!smooth(n)) ++n;
    return n;
}

}  // namespace contactd
