#include "operators/viscoelastic/viscoelastic_operator.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "contactd/given_ics.hpp"
#include "operators/cached_boxes.hpp"
#include "operators/coarsening.hpp"
#include "operators/coarser_with.hpp"
#include "operators/convolution.hpp"
#include "operators/fft/inverse_symbols.hpp"
#include "operators/fft/padded_fft.hpp"
#include "operators/fft/padded_size.hpp"
#include "operators/lazy.hpp"

namespace contactd {
namespace {

using enum Axis;
using Complex = std::complex<double>;

bool is_coupled(const RollingTable& table) {
    double largest = 0;
    for (const auto& [i, j] : {std::pair(x, z), std::pair(y, z), std::pair(z, x), std::pair(z, y)}) {
        const double* first = &table.values[table.index(i, j, 1 - table.nx, 1 - table.ny)];
        for (std::size_t at = 0; at < table.component_size(); ++at) largest = std::max(largest, std::abs(first[at]));
    }
    return largest > coupling_tolerance * table(z, z, 0, 0);
}

/// Returns reciprocals of the effect of creep on waves of 0 to `period`/2 periods along x.
std::vector<Complex> stiffness_of_waves(const std::vector<CreepOfWaves>& creep, Axis axis, int period, double dx) {
    std::vector<Complex> result(static_cast<std::size_t>(period / 2 + 1), 1);
    for (std::size_t number = 0; number < result.size(); ++number) {
        const double k = 2 * std::numbers::pi * static_cast<double>(number) / (period * dx);
        Complex compliance = 1;
        for (const CreepOfWaves& body : creep)
            compliance += body.share[static_cast<std::size_t>(axis)] * body.f / Complex(1, -k * body.l);
        result[number] = 1.0 / compliance;
    }
    return result;
}

}  // namespace

class ViscoelasticOperator::Boxes final : public ElementBoxes {
   public:
    explicit Boxes(const Impl& whole) : whole_(whole) {}

    ElementBox extent() const override;
    ElementBox convenient(const ElementBox& needed, bool may_grow) const override;
    std::shared_ptr<const InfluenceOperator> influence(const ElementBox& box) const override;

   private:
    const Impl& whole_;
    mutable CachedBoxes<InfluenceOperator> cache_;
};

struct ViscoelasticOperator::Impl {
    const int nx, ny;
    const IcTable elastic_table;
    const RollingTable table;
    const std::vector<CreepOfWaves> creep;
    const double dx;
    const bool coupled;
    const ConvolutionOperator elastic;  // its grids and boxes
    PaddedFft product, inverse;
    const Coarsening coarsening;

    struct Tangential {
        PaddedFft::ComplexSymbol xx, xy, yx, yy;
    };
    struct Coupling {
        PaddedFft::ComplexSymbol xz, yz, zx, zy;
    };
    struct TangentialInverses {
        PaddedFft::ComplexSymbol xx, xy, yx, yy;
    };
    Lazy<PaddedFft::ComplexSymbol> zz;
    Lazy<Tangential> tangential;
    Lazy<Coupling> coupling;
    std::array<Lazy<PaddedFft::ComplexSymbol>, 3> reciprocal;
    Lazy<TangentialInverses> tangential_inverse;
    Lazy<std::unique_ptr<CoarserGrid>> coarse;
    const Boxes boxes{*this};

    Impl(IcTable elastic_, RollingTable table_, std::vector<CreepOfWaves> creep_, double dx_)
        : nx(table_.nx),
          ny(table_.ny),
          elastic_table(std::move(elastic_)),
          table(std::move(table_)),
          creep(std::move(creep_)),
          dx(dx_),
          coupled(is_coupled(table)),
          elastic(elastic_table, nx, ny),
          product(nx, ny, padded_size(nx), padded_size(ny)),
          inverse(nx, ny, periodic_size(nx), periodic_size(ny)),
          coarsening(nx, ny) {}

    PaddedFft::ComplexSymbol symbol(Axis i, Axis j) const {
        return product.symbol(PaddedFft::SignedKernel{&table.values[table.index(i, j, 1 - nx, 1 - ny)], nx, ny});
    }

    std::vector<Complex> stiffness(Axis i) const { return stiffness_of_waves(creep, i, periodic_size(nx), dx); }

    const PaddedFft::ComplexSymbol& reciprocal_symbol(Axis i) {
        return reciprocal[static_cast<std::size_t>(i)].get([&] {
            return inverse.times_along_x(contactd::reciprocal_symbol(inverse, elastic_table, i), stiffness(i));
        });
    }

    const TangentialInverses& tangential_inverses() {
        return tangential_inverse.get([&] {
            const TangentialInverse of_elastic = contactd::tangential_inverse(inverse, elastic_table);
            const std::vector<Complex> along_x = stiffness(x), along_y = stiffness(y);
            return TangentialInverses{
                inverse.times_along_x(of_elastic.xx, along_x), inverse.times_along_x(of_elastic.xy, along_x),
                inverse.times_along_x(of_elastic.xy, along_y), inverse.times_along_x(of_elastic.yy, along_y)};
        });
    }
};

ViscoelasticOperator::ViscoelasticOperator(IcTable elastic, RollingTable table, std::vector<CreepOfWaves> creep,
                                           double dx)
    : impl_(std::make_unique<Impl>(std::move(elastic), std::move(table), std::move(creep), dx)) {}

ViscoelasticOperator::~ViscoelasticOperator() = default;

std::size_t ViscoelasticOperator::size() const {
    return static_cast<std::size_t>(impl_->nx) * static_cast<std::size_t>(impl_->ny);
}

void ViscoelasticOperator::normal(std::span<const double> pz, std::span<double> uz) const {
    Impl& impl = *impl_;
    impl.product.apply(impl.zz.get([&] { return impl.symbol(z, z); }), pz, uz);
}

void ViscoelasticOperator::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                      std::span<double> uy) const {
    Impl& impl = *impl_;
    const auto& made = impl.tangential.get(
        [&] { return Impl::Tangential{impl.symbol(x, x), impl.symbol(x, y), impl.symbol(y, x), impl.symbol(y, y)}; });
    impl.product.apply(PaddedFft::ComplexPairSymbols{made.xx, made.xy, made.yx, made.yy}, px, py, ux, uy);
}

bool ViscoelasticOperator::coupled() const {
    return impl_->coupled;
}

void ViscoelasticOperator::normal_of_tangential(std::span<const double> px, std::span<const double> py,
                                                std::span<double> uz) const {
    if (!coupled()) return InfluenceOperator::normal_of_tangential(px, py, uz);
    Impl& impl = *impl_;
    const auto& made = impl.coupling.get(
        [&] { return Impl::Coupling{impl.symbol(x, z), impl.symbol(y, z), impl.symbol(z, x), impl.symbol(z, y)}; });
    impl.product.gather(made.zx, made.zy, px, py, uz);
}

void ViscoelasticOperator::tangential_of_normal(std::span<const double> pz, std::span<double> ux,
                                                std::span<double> uy) const {
    if (!coupled()) return InfluenceOperator::tangential_of_normal(pz, ux, uy);
    Impl& impl = *impl_;
    const auto& made = impl.coupling.get(
        [&] { return Impl::Coupling{impl.symbol(x, z), impl.symbol(y, z), impl.symbol(z, x), impl.symbol(z, y)}; });
    impl.product.spread(made.xz, made.yz, pz, ux, uy);
}

std::vector<double> ViscoelasticOperator::diagonal(Axis i) const {
    return std::vector<double>(size(), impl_->table(i, i, 0, 0));
}

void ViscoelasticOperator::precondition(Axis i, std::span<const double> r, std::span<double> z) const {
    impl_->inverse.apply(impl_->reciprocal_symbol(i), r, z);
}

void ViscoelasticOperator::precondition_tangential(std::span<const double> rx, std::span<const double> ry,
                                                   std::span<double> zx, std::span<double> zy) const {
    const auto& made = impl_->tangential_inverses();
    impl_->inverse.apply(PaddedFft::ComplexPairSymbols{made.xx, made.xy, made.yx, made.yy}, rx, ry, zx, zy);
}

const CoarserGrid* ViscoelasticOperator::coarser() const {
    Impl& impl = *impl_;
    const CoarserGrid* grid = impl.elastic.coarser();
    if (grid == nullptr) return nullptr;
    return impl.coarse
        .get([&] {
            return std::make_unique<CoarserWith>(
                *grid, std::make_unique<ViscoelasticOperator>(impl.coarsening.coarse(impl.elastic_table, impl.coupled),
                                                              impl.coarsening.coarse(impl.table, impl.coupled),
                                                              impl.creep, impl.dx * impl.coarsening.along_x()));
        })
        .get();
}

const ElementBoxes* ViscoelasticOperator::boxes() const {
    return &impl_->boxes;
}

ElementBox ViscoelasticOperator::Boxes::extent() const {
    return {0, 0, whole_.nx, whole_.ny};
}

ElementBox ViscoelasticOperator::Boxes::convenient(const ElementBox& needed, bool may_grow) const {
    return whole_.elastic.boxes()->convenient(needed, may_grow);
}

std::shared_ptr<const InfluenceOperator> ViscoelasticOperator::Boxes::influence(const ElementBox& box) const {
    // Its position does not matter.
    return cache_.get({0, 0, box.nx, box.ny}, [&] {
        return std::make_shared<const ViscoelasticOperator>(cropped(whole_.elastic_table, box.nx, box.ny),
                                                            cropped(whole_.table, box.nx, box.ny), whole_.creep,
                                                            whole_.dx);
    });
}

}  // namespace contactd
