#include "strip_fft.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <type_traits>
#include <utility>

namespace contactd {
namespace {

// Returns transforms, which are created once and shared. Unused ones are kept up to a bound.
std::shared_ptr<const LaneFft> transforms_of(int period, std::size_t lanes) {
    constexpr std::size_t most_cached = 64;
    static std::map<std::pair<int, std::size_t>, std::shared_ptr<const LaneFft>> made;
    static std::mutex mutex;
    const std::scoped_lock lock(mutex);
    const std::pair size(period, lanes);
    if (const auto cached = made.find(size); cached != made.end()) return cached->second;
    if (made.size() >= most_cached)
        std::erase_if(made, [](const auto& entry) { return entry.second.use_count() == 1; });
    return made.emplace(size, LaneFft::make(period, 1, lanes)).first->second;
}

std::size_t groups_by(std::size_t lanes, int period) {
    return (static_cast<std::size_t>(period) / 2 + lanes) / lanes;
}

std::size_t filled_up(std::size_t n, std::size_t lanes) {
    return (n + lanes - 1) / lanes * lanes;
}

template <std::size_t n>
void copy(const double* from, double* to) {
    for (std::size_t i = 0; i < n; ++i) to[i] = from[i];
}
template <std::size_t n>
void copy_negative(const double* from, double* to) {
    for (std::size_t i = 0; i < n; ++i) to[i] = -from[i];
}

// Calls each(numbers of the spectrum, re, im) for each group of lanes and each row, in groups of four wavenumbers.
template <std::size_t n, class Number, class Each>
void for_lanes(double* spectrum, std::size_t groups, std::size_t height, std::size_t rows, std::size_t step,
               std::size_t next_group, Number* re, Number* im, const Each& each) {
    for (std::size_t g = 0; g < groups; ++g) {
        double* values = spectrum + g * height * 2 * n;
        const std::size_t first = g * n / Waves::lanes * next_group + g * n % Waves::lanes;
        for (std::size_t row = 0; row < rows; ++row, values += 2 * n)
            each(values, re + first + row * step, im + first + row * step);
    }
}

}  // namespace

StripWork::StripWork(const StripFft& fft, std::size_t strips)
    : rows(strips * static_cast<std::size_t>(fft.period_)),
      height_(filled_up(strips, fft.fft_->lanes())),
      spectrum_(groups_by(fft.fft_->lanes(), fft.period_) * height_ * 2 * fft.fft_->lanes()),
      work_(fft.fft_->work_size()) {}

Waves::Waves(std::size_t groups, std::size_t entries_)
    : entries(entries_), re(groups * entries * lanes), im(re.size()) {}

StripFft::StripFft(int nx, int period, std::size_t lanes)
    : nx_(nx), period_(period), fft_(transforms_of(period, lanes)) {}
StripFft::StripFft(int nx, int period) : StripFft(nx, period, default_lanes()) {}
StripFft::~StripFft() = default;

std::size_t StripFft::groups() const {
    return groups_by(Waves::lanes, period_);
}

// Calls visit(std::integral_constant of the lanes).
template <class Visit>
void StripFft::by_lanes(const Visit& visit) const {
    if (fft_->lanes() == 4)
        visit(std::integral_constant<std::size_t, 4>());
    else
        visit(std::integral_constant<std::size_t, 2>());
}

void StripFft::forward(std::span<const double> strips, WavePhase phase, Waves& waves, std::size_t first,
                       std::size_t step, StripWork& work) const {
    const auto nx = static_cast<std::size_t>(nx_);
    const std::size_t rows = strips.size() / nx;
    fft_->rows_forward(strips.data(), rows, nx, {work.spectrum_.get(), work.height_}, work.work_.get());
    by_lanes([&](auto lanes) {
        constexpr std::size_t n = lanes;
        for_lanes<n>(work.spectrum_.get(), groups_by(n, period_), work.height_, rows, step * Waves::lanes,
                     waves.entries * Waves::lanes, &waves.re[first * Waves::lanes], &waves.im[first * Waves::lanes],
                     [phase](const double* values, double* re, double* im) {
                         if (phase == WavePhase::plain) {
                             copy<n>(values, re);
                             copy<n>(values + n, im);
                         } else {
                             copy<n>(values + n, re);
                             copy_negative<n>(values, im);
                         }
                     });
    });
}

void StripFft::inverse(const Waves& waves, std::size_t first, std::size_t step, WavePhase phase, std::size_t length,
                       StripWork& work) const {
    const std::size_t rows = work.rows.size() / static_cast<std::size_t>(period_);
    by_lanes([&](auto lanes) {
        constexpr std::size_t n = lanes;
        for_lanes<n>(work.spectrum_.get(), groups_by(n, period_), work.height_, rows, step * Waves::lanes,
                     waves.entries * Waves::lanes, &waves.re[first * Waves::lanes], &waves.im[first * Waves::lanes],
                     [phase](double* values, const double* re, const double* im) {
                         if (phase == WavePhase::plain) {
                             copy<n>(re, values);
                             copy<n>(im, values + n);
                         } else {
                             copy_negative<n>(im, values);
                             copy<n>(re, values + n);
                         }
                     });
    });
    fft_->rows_inverse({work.spectrum_.get(), work.height_}, rows, length, work.rows.data(), work.work_.get());
}

void StripFft::symbol(std::span<const double> kernel, bool even, const PeriodicJoint& joint,
                      std::span<double> transform, StripWork& work) const {
    const auto period = static_cast<std::size_t>(period_);
    const double factor = 1.0 / period_, sign = even ? 1 : -1;
    const std::span row(work.rows.data(), period);
    std::fill(row.begin(), row.end(), 0.0);
    for (std::size_t k = 0; k < kernel.size(); ++k) {
        row[k] = factor * kernel[k];
        if (k > 0) row[period - k] = sign * row[k];
    }
    joint.fill(row, even);
    fft_->rows_forward(row.data(), 1, period, {work.spectrum_.get(), work.height_}, work.work_.get());
    std::fill(transform.begin(), transform.end(), 0.0);
    const std::size_t lanes = fft_->lanes();
    for (std::size_t wave = 0; wave <= period / 2; ++wave) {
        const double* value = work.spectrum_.get() + wave / lanes * work.height_ * 2 * lanes + wave % lanes;
        transform[wave] = even ? value[0] : -value[lanes];
    }
}

std::vector<double> StripFft::transform(std::span<const double> rows, bool even) const {
    const auto period = static_cast<std::size_t>(period_), count = rows.size() / period, lanes = fft_->lanes();
    const std::size_t height = filled_up(count, lanes), waves = period / 2 + 1;
    const LaneBuffer spectrum(groups_by(lanes, period_) * height * 2 * lanes), work(fft_->work_size());
    fft_->rows_forward(rows.data(), count, period, {spectrum.get(), height}, work.get());
    std::vector<double> result(groups() * count * Waves::lanes);
    for (std::size_t wave = 0; wave < waves; ++wave) {
        const double* from = spectrum.get() + wave / lanes * height * 2 * lanes + wave % lanes + (even ? 0 : lanes);
        double* to = &result[wave / Waves::lanes * count * Waves::lanes + wave % Waves::lanes];
        for (std::size_t row = 0; row < count; ++row, from += 2 * lanes, to += Waves::lanes)
            *to = even ? *from : -*from;
    }
    return result;
}

}  // namespace contactd
