#include "strip_products.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "operators/convolution.hpp"

namespace contactd {
namespace {

using enum Axis;

std::vector<double> times(double factor, std::span<const double> values) {
    std::vector<double> result(values.begin(), values.end());
    for (double& value : result) value *= factor;
    return result;
}

constexpr auto copy = [](std::span<double> u, const double* values) { std::copy_n(values, u.size(), u.begin()); };
constexpr auto add = [](std::span<double> u, const double* values) {
    for (std::size_t k = 0; k < u.size(); ++k) u[k] += values[k];
};

int period_of(int offsets, double left_out) {
    if (left_out <= 0) return smooth_size(2 * offsets - 1);
    return smooth_size(static_cast<int>(PeriodicJoint::least_period(static_cast<std::size_t>(offsets))));
}

PeriodicJoint joint_of(int offsets, int period) {
    return {static_cast<std::size_t>(offsets), static_cast<std::size_t>(period)};
}

}  // namespace

StripProducts::StripProducts(std::shared_ptr<const StripTable> table, const ElementBox& box, int reach,
                             OffsetParity parity, double left_out)
    : table_(std::move(table)),
      box_(box),
      parity_(parity),
      left_out_(left_out),
      offsets_(box.nx + reach),
      period_(period_of(offsets_, left_out)),
      strips_(static_cast<std::size_t>(box.ny)),
      joint_(left_out > 0 ? joint_of(offsets_, period_) : PeriodicJoint()),
      fft_(box.nx, period_) {}

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

// Calls set(I, J, transform) of all pairs of strips of the box, where i = j of those with J <= I.
template <class Set>
void StripProducts::for_pairs(Axis i, Axis j, const Set& set) const {
    const double sign = parity(i, j).along_x;
    const bool even = (sign > 0) == (parity_ == OffsetParity::natural);
    std::vector<double> kernel(static_cast<std::size_t>(offsets_)), transform(fft_.groups() * Waves::lanes);
    StripWork work(fft_, 1);
    for (std::size_t I = 0; I < strips_; ++I)
        for (std::size_t J = 0; J < (i == j ? I + 1 : strips_); ++J) {
            const int at = box_.first_y + static_cast<int>(I), from = box_.first_y + static_cast<int>(J);
            const double* here = &table_->values[table_->index(i, j, at, from, 0)];
            const double* there = &table_->values[table_->index(j, i, from, at, 0)];
            for (std::size_t k = 0; k < kernel.size(); ++k) kernel[k] = 0.5 * (here[k] + sign * there[k]);
            fft_.symbol(kernel, even, joint_, transform, work);
            set(I, J, std::span<const double>(transform));
        }
}

// Waves of x are turned by -i on their way in and out (WavePhase). With natural parity that makes all matrices real;
// with the opposite one they are -i times real ones.
SymmetricSymbol StripProducts::normal_symbol() const {
    SymmetricSymbol symbol(fft_.groups(), strips_ + strips_ % 2);
    for_pairs(z, z, [&](std::size_t I, std::size_t J, auto transform) { symbol.set(I, J, transform); });
    symbol.trim(left_out_);
    return symbol;
}

// Entries of x and y are those of a strip in turns, so that what is left out lies far from the diagonal.
SymmetricSymbol StripProducts::tangential_symbol() const {
    SymmetricSymbol symbol(fft_.groups(), 2 * strips_);
    for_pairs(x, x, [&](std::size_t I, std::size_t J, auto transform) { symbol.set(2 * I, 2 * J, transform); });
    for_pairs(y, y, [&](std::size_t I, std::size_t J, auto transform) { symbol.set(2 * I + 1, 2 * J + 1, transform); });
    for_pairs(y, x, [&](std::size_t I, std::size_t J, auto transform) {
        symbol.set(2 * I + 1, 2 * J, times(natural() ? 1 : -1, transform));
    });
    symbol.trim(left_out_);
    return symbol;
}

RectangularSymbol StripProducts::coupling_symbol() const {
    RectangularSymbol symbol(fft_.groups(), 2 * strips_, strips_ + strips_ % 2);
    for_pairs(x, z, [&](std::size_t I, std::size_t J, auto transform) {
        symbol.set(2 * I, J, times(natural() ? -1 : 1, transform));
    });
    for_pairs(y, z, [&](std::size_t I, std::size_t J, auto transform) { symbol.set(2 * I + 1, J, transform); });
    symbol.trim(left_out_);
    return symbol;
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
    tangential_.get([this] { return tangential_symbol(); }).multiply(work.tangential_in, work.tangential_out);
    turn_back(work.tangential_out);
}

void StripProducts::coupled_waves(std::span<const double> pz, Workspace& work) const {
    normal_waves(pz, work);
    coupling_.get([this] { return coupling_symbol(); }).multiply(work.normal_in, work.tangential_out);
    turn_back(work.tangential_out);
}

void StripProducts::turn_back(Waves& waves) const {
    if (natural()) return;
    std::swap(waves.re, waves.im);
    for (double& value : waves.im) value = -value;
}

void StripProducts::read_normal(Workspace& work, std::span<double> u) const {
    const auto nx = static_cast<std::size_t>(box_.nx);
    fft_.inverse(work.normal_out, 0, 1, WavePhase::plain, nx, work.strips);
    std::copy_n(work.strips.rows.begin(), strips_ * nx, u.begin());
}

// Calls take(to, values) of each strip: the elements' displacements, and those of the first `length` of the period.
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
    const auto period = static_cast<std::size_t>(period_);
    const auto shift = static_cast<std::size_t>((ahead + period_) % period_);
    return [=](std::span<double> u, const double* values) {
        for (std::size_t k = 0; k < u.size(); ++k) u[k] = values[k] - values[(k + shift) % period];
    };
}

void StripProducts::normal(std::span<const double> pz, std::span<double> uz) const {
    const auto work = workspace();
    normal_waves(pz, *work);
    normal_.get([this] { return normal_symbol(); }).multiply((*work).normal_in, (*work).normal_out);
    read_normal(*work, uz);
}

void StripProducts::normal_of_tangential(std::span<const double> px, std::span<const double> py,
                                         std::span<double> uz) const {
    const auto work = workspace();
    in_waves(px, py, *work);
    coupling_.get([this] { return coupling_symbol(); }).multiply_transposed((*work).tangential_in, (*work).normal_out);
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
    read_tangential(*work, ux, uy, period_, difference_to(ahead));
}

void StripProducts::tangential_change_of_normal(int ahead, std::span<const double> pz, std::span<double> ux,
                                                std::span<double> uy) const {
    const auto work = workspace();
    coupled_waves(pz, *work);
    read_tangential(*work, ux, uy, period_, difference_to(ahead));
}

}  // namespace contactd
