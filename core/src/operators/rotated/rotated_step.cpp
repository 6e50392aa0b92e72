#include "rotated_step.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "contactd/error.hpp"
#include "influence/shifted_half_space.hpp"
#include "operators/fft/padded_size.hpp"

namespace contactd {
namespace {

std::size_t offsets(int nx, int ny) {
    return static_cast<std::size_t>(2 * nx - 1) * static_cast<std::size_t>(2 * ny - 1);
}

}  // namespace

NormalIncrement::NormalIncrement(int nx, int ny, std::vector<double> kernels)
    : nx_(nx),
      ny_(ny),
      kernels_(std::move(kernels)),
      fft_(nx, ny, padded_size(nx), padded_size(ny)),
      x_(symbol(0)),
      y_(symbol(1)),
      z_(symbol(2)) {}

PaddedFft::ComplexSymbol NormalIncrement::symbol(std::size_t load) const {
    return fft_.symbol(PaddedFft::SignedKernel{&kernels_[load * offsets(nx_, ny_)], nx_, ny_});
}

std::shared_ptr<const NormalIncrement> NormalIncrement::on(int nx, int ny) const {
    std::vector<double> part;
    part.reserve(3 * offsets(nx, ny));
    const std::ptrdiff_t along_row = 2 * nx_ - 1, high = 2 * ny_ - 1;
    for (std::ptrdiff_t load = 0; load < 3; ++load)
        for (std::ptrdiff_t l = ny_ - ny; l < ny_ + ny - 1; ++l) {
            const auto row = kernels_.begin() + (load * high + l) * along_row;
            part.insert(part.end(), row + (nx_ - nx), row + (nx_ + nx - 1));
        }
    return std::make_shared<const NormalIncrement>(nx, ny, std::move(part));
}

std::shared_ptr<const NormalIncrement> normal_increment(const MaterialPair& bodies, const Grid& grid, double shift,
                                                        const Observer& observer) {
    const HalfSpaceModel model(HalfSpaces{bodies});
    std::vector<double> kernels(3 * offsets(grid.nx, grid.ny));
    const auto add = [&](double step, double sign) {
        const Lattice points{grid.dx, grid.dy, 1 - grid.nx, grid.nx - 1, 1 - grid.ny, grid.ny - 1, step / grid.dx, 0};
        for_lattice(model, points, observer, [&](int k, int l, const KernelIntegrals& integrals) {
            const std::size_t at =
                static_cast<std::size_t>(l + grid.ny - 1) * static_cast<std::size_t>(2 * grid.nx - 1) +
                static_cast<std::size_t>(k + grid.nx - 1);
            const std::size_t n = offsets(grid.nx, grid.ny);
            // By Betti's theorem, the normal displacement by a load along x equals the displacement along -x by a
            // normal load in the opposite direction.
            kernels[at] -= sign * model.coefficient(Axis::x, Axis::z, integrals);
            kernels[n + at] -= sign * model.coefficient(Axis::y, Axis::z, integrals);
            kernels[2 * n + at] += sign * model.a * (integrals.xx + integrals.yy) / (2 * std::numbers::pi);
        });
    };
    add(0, 1);
    add(shift, -1);
    return std::make_shared<const NormalIncrement>(grid.nx, grid.ny, std::move(kernels));
}

RotatedStep::RotatedStep(std::shared_ptr<const StepOperator> flat, std::shared_ptr<const NormalIncrement> along_normal,
                         RowRotations rotations)
    : flat_(std::move(flat)), along_normal_(std::move(along_normal)), rotations_(std::move(rotations)) {
    if (flat_->size() != rotations_.size() || flat_->size() != along_normal_->size())
        throw InvalidArgument("flat", "has a different number of elements");
}

RowComponents RotatedStep::of_tangential(std::span<const double> px, std::span<const double> py,
                                         std::span<double> ux) const {
    RowComponents u(size());
    flat_->tangential(px, py, ux, u.s);
    if (flat_->coupled()) along_normal_->of_tangential(px, py, u.z);
    return u;
}

RowComponents RotatedStep::of_normal(std::span<const double> pz, std::span<double> ux) const {
    RowComponents u(size());
    flat_->tangential_of_normal(pz, ux, u.s);
    along_normal_->of_normal(pz, u.z);
    return u;
}

void RotatedStep::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                             std::span<double> uy) const {
    const RowComponents of_cosine = of_tangential(rotations_.times_cosine(px), rotations_.times_cosine(py), ux),
                        of_sine = of_tangential(rotations_.times_sine(px), rotations_.times_sine(py), ux);
    rotations_.along_s(of_cosine, of_sine, uy);
    of_tangential(px, py, ux);
}

void RotatedStep::tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const {
    const RowComponents of_cosine = of_normal(rotations_.times_cosine(pz), ux),
                        of_sine = of_normal(rotations_.times_sine(pz), ux);
    rotations_.along_s(of_cosine, of_sine, uy);
    of_normal(pz, ux);
}

std::shared_ptr<const StepOperator> RotatedStep::on(const ElementBox& box) const {
    auto flat = flat_->on(box);
    if (!flat) return nullptr;
    return std::make_shared<const RotatedStep>(std::move(flat), along_normal_->on(box.nx, box.ny),
                                               rotations_.on(box.first_y, box.ny, box.nx));
}

}  // namespace contactd
