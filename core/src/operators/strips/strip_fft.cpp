#include "strip_fft.hpp"

#include <algorithm>
#include <map>
#include <mutex>

#include "operators/fft/padded_fft_plans.hpp"
#include "operators/fft/spectral_products.hpp"

namespace contactd {
namespace {

constexpr std::size_t lanes = Waves::lanes;

double* parts(std::vector<Complex>& values) {
    return reinterpret_cast<double*>(values.data());
}

std::size_t groups_of(int period) {
    return (static_cast<std::size_t>(period) / 2 + lanes) / lanes;
}

}  // namespace

StripPair::StripPair(int period)
    : a(static_cast<std::size_t>(period)),
      b(a.size()),
      both_(a.size()),
      transformed_(a.size()),
      of_a_(groups_of(period) * lanes),
      of_b_(of_a_.size()) {}

struct StripFft::Plans {
    Plan forward, inverse;

    explicit Plans(int period) {
        std::vector<Complex> from(static_cast<std::size_t>(period)), to(from);
        constexpr unsigned flags = FFTW_ESTIMATE | FFTW_UNALIGNED;
        forward.reset(fftw_plan_dft_1d(period, raw(from.data()), raw(to.data()), FFTW_FORWARD, flags));
        inverse.reset(fftw_plan_dft_1d(period, raw(from.data()), raw(to.data()), FFTW_BACKWARD, flags));
    }

    /// Made once and shared. Plans are only ever destroyed here, under the lock.
    static std::shared_ptr<const Plans> of(int period) {
        constexpr std::size_t most_cached = 64;
        static std::map<int, std::shared_ptr<const Plans>> made;
        const std::scoped_lock lock(planner_mutex());
        if (const auto cached = made.find(period); cached != made.end()) return cached->second;
        if (made.size() >= most_cached)
            std::erase_if(made, [](const auto& entry) { return entry.second.use_count() == 1; });
        return made.emplace(period, std::make_shared<const Plans>(period)).first->second;
    }
};

Waves::Waves(std::size_t groups, std::size_t entries_)
    : entries(entries_), re(groups * entries * lanes), im(re.size()) {}

StripFft::StripFft(int nx, int period) : nx_(nx), period_(period), plans_(Plans::of(period)) {}
StripFft::~StripFft() = default;

std::size_t StripFft::groups() const {
    return groups_of(period_);
}

void StripFft::forward(const double* a, const double* b, WavePhase phase, Waves& waves, std::size_t first,
                       StripPair& work) const {
    const auto nx = static_cast<std::size_t>(nx_), period = static_cast<std::size_t>(period_);
    const auto is_zero = [nx](const double* values) {
        return values == nullptr || std::all_of(values, values + nx, [](double value) { return value == 0; });
    };
    const std::size_t group = waves.entries * lanes;
    double *re = &waves.re[first * lanes], *im = &waves.im[first * lanes];
    if (is_zero(a) && is_zero(b)) {
        for (std::size_t at = 0; at < work.of_a_.size(); at += lanes, re += group, im += group) {
            std::fill_n(re, 2 * lanes, 0.0);
            std::fill_n(im, 2 * lanes, 0.0);
        }
        return;
    }
    if (b == nullptr) {
        std::fill_n(work.b.begin(), nx, 0.0);
        b = work.b.data();
    }
    interleave(nx, a, b, parts(work.both_));
    std::fill(work.both_.begin() + nx_, work.both_.end(), Complex());
    fftw_execute_dft(plans_->forward.get(), raw(work.both_.data()), raw(work.transformed_.data()));
    split_transforms(period, parts(work.transformed_), parts(work.of_a_), parts(work.of_b_));
    const double *of_a = parts(work.of_a_), *of_b = parts(work.of_b_);
    const std::size_t real = phase == WavePhase::along_x ? 1 : 0;
    const double sign = phase == WavePhase::along_x ? -1 : 1;
    for (std::size_t at = 0; at < work.of_a_.size(); at += lanes, re += group, im += group)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const std::size_t k = 2 * (at + lane);
            re[lane] = of_a[k + real];
            im[lane] = sign * of_a[k + 1 - real];
            re[lanes + lane] = of_b[k];
            im[lanes + lane] = of_b[k + 1];
        }
}

void StripFft::inverse(const Waves& waves, std::size_t first, WavePhase phase, StripPair& work) const {
    const std::size_t group = waves.entries * lanes;
    const double *re = &waves.re[first * lanes], *im = &waves.im[first * lanes];
    double *of_a = parts(work.of_a_), *of_b = parts(work.of_b_);
    const std::size_t real = phase == WavePhase::along_x ? 1 : 0;
    const double sign = phase == WavePhase::along_x ? -1 : 1;
    for (std::size_t at = 0; at < work.of_a_.size(); at += lanes, re += group, im += group)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const std::size_t k = 2 * (at + lane);
            of_a[k + real] = re[lane];
            of_a[k + 1 - real] = sign * im[lane];
            of_b[k] = re[lanes + lane];
            of_b[k + 1] = im[lanes + lane];
        }
    const auto period = static_cast<std::size_t>(period_);
    join_transforms(period, of_a, of_b, parts(work.transformed_));
    fftw_execute_dft(plans_->inverse.get(), raw(work.transformed_.data()), raw(work.both_.data()));
    deinterleave(period, parts(work.both_), work.a.data(), work.b.data());
    // A zero must not get the other's rounding errors.
    const auto is_zero = [](const std::vector<Complex>& of) {
        return std::all_of(of.begin(), of.end(), [](const Complex& value) { return value == 0.0; });
    };
    if (is_zero(work.of_a_)) std::fill(work.a.begin(), work.a.end(), 0.0);
    if (is_zero(work.of_b_)) std::fill(work.b.begin(), work.b.end(), 0.0);
}

void StripFft::symbol(std::span<const double> kernel, bool even, const PeriodicJoint& joint,
                      std::span<double> transform, StripPair& work) const {
    const auto period = static_cast<std::size_t>(period_);
    const double factor = 1.0 / period_, sign = even ? 1 : -1;
    std::fill(work.a.begin(), work.a.end(), 0.0);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
        work.a[k] = factor * kernel[k];
        if (k > 0) work.a[period - k] = sign * work.a[k];
    }
    joint.fill(work.a, even);
    std::copy(work.a.begin(), work.a.end(), work.both_.begin());
    fftw_execute_dft(plans_->forward.get(), raw(work.both_.data()), raw(work.transformed_.data()));
    std::fill(transform.begin(), transform.end(), 0.0);
    for (std::size_t at = 0; at <= period / 2; ++at)
        transform[at] = even ? work.transformed_[at].real() : -work.transformed_[at].imag();
}

}  // namespace contactd
