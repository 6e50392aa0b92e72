#include "strip_products.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "operators/convolution.hpp"

namespace contactd {
namespace {

constexpr auto copy = [](std::span<double> u, const double* values) { std::copy_n(values, u.size(), u.begin()); };
constexpr auto add = [](std::span<double> u, const double* values) {
    for (std::size_t k = 0; k < u.size(); ++k) u[k] += values[k];
};

int period_of(int offsets, double left_out) {
    if (left_out <= 0) return smooth_size(2 * offsets - 1);
    return smooth_size(static_cast<int>(PeriodicJoint::least_period(static_cast<std::size_t>(offsets))));
}

PeriodicJoint joint_of(int offsets, int period, double left_out) {
    if (left_out <= 0) return {};
    return {static_cast<std::size_t>(offsets), static_cast<std::size_t>(period)};
}

SymbolExtent extent_of(const ElementBox& box, int reach, OffsetParity parity, double left_out) {
    const int offsets = box.nx + reach, period = period_of(offsets, left_out);
    return {box.first_y, box.ny, offsets, period, parity, joint_of(offsets, period, left_out), left_out};
}

}  // namespace

StripProducts::StripProducts(std::shared_ptr<const StripCoefficients> coefficients, const ElementBox& box, int reach,
                             OffsetParity parity, double left_out)
    : coefficients_(std::move(coefficients)),
      box_(box),
      extent_(extent_of(box, reach, parity, left_out)),
      strips_(static_cast<std::size_t>(box.ny)),
      fft_(box.nx, extent_.period) {}

StripProducts::~StripProducts() = default;

struct StripProducts::Workspace {
    Waves normal_in, normal_out, tangential_in, tangential_out;
    StripWork strips;

    Workspace(const StripFft& fft, std::size_t count, std::size_t groups)
        : normal_in(groups, count + count % 2),
          normal_out(normal_in),
          tangential_in(groups, 2 * count),
          tangential_out(tangential_in),
          strips(fft, count) {}
};

Workspaces<StripProducts::Workspace>::Lease StripProducts::workspace() const {
    return idle_.take([this] { return std::make_unique<Workspace>(fft_, strips_, fft_.groups()); });
}

void StripProducts::normal_waves(std::span<const double> pz, Workspace& work) const {
    fft_.forward(pz, WavePhase::plain, work.normal_in, 0, 1, work.strips);
}

void StripProducts::in_waves(std::span<const double> px, std::span<const double> py, Workspace& work) const {
    fft_.forward(px, WavePhase::along_x, work.tangential_in, 0, 2, work.strips);
    fft_.forward(py, WavePhase::plain, work.tangential_in, 1, 2, work.strips);
}

void StripProducts::tangential_waves(std::span<const double> px, std::span<const double> py, Workspace& work) const {
    in_waves(px, py, work);
    tangential_symbol().multiply(work.tangential_in, work.tangential_out);
    turn_back(work.tangential_out);
}

void StripProducts::coupled_waves(std::span<const double> pz, Workspace& work) const {
    normal_waves(pz, work);
    coupling_symbol().multiply(work.normal_in, work.tangential_out);
    turn_back(work.tangential_out);
}

const SymmetricSymbol& StripProducts::tangential_symbol() const {
    return tangential_.get([this] { return coefficients_->tangential(extent_, fft_); });
}

const RectangularSymbol& StripProducts::coupling_symbol() const {
    return coupling_.get([this] { return coefficients_->coupling(extent_, fft_); });
}

// With the opposite parity, matrices are -i times real ones.
void StripProducts::turn_back(Waves& waves) const {
    if (extent_.natural()) return;
    std::swap(waves.re, waves.im);
    for (double& value : waves.im) value = -value;
}

void StripProducts::read_normal(Workspace& work, std::span<double> u) const {
    const auto nx = static_cast<std::size_t>(box_.nx);
    fft_.inverse(work.normal_out, 0, 1, WavePhase::plain, nx, work.strips);
    std::copy_n(work.strips.rows.begin(), strips_ * nx, u.begin());
}

// Calls take(to, values) for each strip with the elements' displacements, and with those of the first `length` of the
// period.
template <class Take>
void StripProducts::read_tangential(Workspace& work, std::span<double> ux, std::span<double> uy, int length,
                                    const Take& take) const {
    const auto nx = static_cast<std::size_t>(box_.nx), read = static_cast<std::size_t>(length);
    const auto component = [&](std::size_t first, WavePhase phase, std::span<double> u) {
        fft_.inverse(work.tangential_out, first, 2, phase, read, work.strips);
        for (std::size_t I = 0; I < strips_; ++I) take(u.subspan(I * nx, nx), &work.strips.rows[I * read]);
    };
    component(0, WavePhase::along_x, ux);
    component(1, WavePhase::plain, uy);
}

auto StripProducts::difference_to(int ahead) const {
    const auto period = static_cast<std::size_t>(extent_.period);
    const auto shift = static_cast<std::size_t>((ahead + extent_.period) % extent_.period);
    return [=](std::span<double> u, const double* values) {
        for (std::size_t k = 0; k < u.size(); ++k) u[k] = values[k] - values[(k + shift) % period];
    };
}

void StripProducts::normal(std::span<const double> pz, std::span<double> uz) const {
    const auto work = workspace();
    normal_waves(pz, *work);
    normal_.get([this] { return coefficients_->normal(extent_, fft_); })
        .multiply((*work).normal_in, (*work).normal_out);
    read_normal(*work, uz);
}

void StripProducts::normal_of_tangential(std::span<const double> px, std::span<const double> py,
                                         std::span<double> uz) const {
    const auto work = workspace();
    in_waves(px, py, *work);
    coupling_symbol().multiply_transposed((*work).tangential_in, (*work).normal_out);
    read_normal(*work, uz);
}

void StripProducts::tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                               std::span<double> uy) const {
    const auto work = workspace();
    tangential_waves(px, py, *work);
    read_tangential(*work, ux, uy, box_.nx, copy);
}

void StripProducts::tangential_of_normal(std::span<const double> pz, std::span<double> ux, std::span<double> uy) const {
    const auto work = workspace();
    coupled_waves(pz, *work);
    read_tangential(*work, ux, uy, box_.nx, copy);
}

void StripProducts::add_tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                   std::span<double> uy) const {
    const auto work = workspace();
    tangential_waves(px, py, *work);
    read_tangential(*work, ux, uy, box_.nx, add);
}

void StripProducts::add_tangential_of_normal(std::span<const double> pz, std::span<double> ux,
                                             std::span<double> uy) const {
    const auto work = workspace();
    coupled_waves(pz, *work);
    read_tangential(*work, ux, uy, box_.nx, add);
}

void StripProducts::tangential_change(int ahead, std::span<const double> px, std::span<const double> py,
                                      std::span<double> ux, std::span<double> uy) const {
    const auto work = workspace();
    tangential_waves(px, py, *work);
    read_tangential(*work, ux, uy, extent_.period, difference_to(ahead));
}

void StripProducts::tangential_change_of_normal(int ahead, std::span<const double> pz, std::span<double> ux,
                                                std::span<double> uy) const {
    const auto work = workspace();
    coupled_waves(pz, *work);
    read_tangential(*work, ux, uy, extent_.period, difference_to(ahead));
}

}  // namespace contactd
