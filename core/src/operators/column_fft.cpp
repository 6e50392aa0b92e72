#include "column_fft.hpp"

#include <algorithm>
#include <map>
#include <mutex>

#include "padded_fft_plans.hpp"

namespace contactd {

ColumnFft::Row::Row(int period)
    : values(static_cast<std::size_t>(period)),
      stride((values.size() / 2 + Waves::lanes) / Waves::lanes * Waves::lanes),
      parts(2 * stride) {}

struct ColumnFft::Plans {
    int period;
    Plan forward, inverse;  // of a row, real and imaginary parts apart

    explicit Plans(int period_) : period(period_) {
        const fftw_iodim size{period, 1, 1};
        Row row(period);
        double *values = row.values.data(), *re = row.re(), *im = row.im();
        constexpr unsigned flags = FFTW_ESTIMATE | FFTW_UNALIGNED;
        forward.reset(fftw_plan_guru_split_dft_r2c(1, &size, 0, nullptr, values, re, im, flags));
        inverse.reset(fftw_plan_guru_split_dft_c2r(1, &size, 0, nullptr, re, im, values, flags));
    }

    /// Made once and shared. Plans are only ever destroyed here, under the lock.
    static std::shared_ptr<const Plans> of(int period) {
        constexpr std::size_t most_kept = 64;
        static std::map<int, std::shared_ptr<const Plans>> made;
        const std::scoped_lock lock(planner_mutex());
        if (const auto kept = made.find(period); kept != made.end()) return kept->second;
        if (made.size() >= most_kept)
            std::erase_if(made, [](const auto& entry) { return entry.second.use_count() == 1; });
        return made.emplace(period, std::make_shared<const Plans>(period)).first->second;
    }
};

Waves::Waves(std::size_t groups, std::size_t entries_)
    : entries(entries_), re(groups * entries * lanes), im(re.size()) {}

ColumnFft::ColumnFft(int nx, int period) : nx_(nx), period_(period), plans_(Plans::of(period)) {}
ColumnFft::~ColumnFft() = default;

std::size_t ColumnFft::groups() const {
    return (static_cast<std::size_t>(period_) / 2 + Waves::lanes) / Waves::lanes;
}

void ColumnFft::forward(std::span<const double> field, WavePhase phase, Waves& waves, std::size_t first) const {
    const auto nx = static_cast<std::size_t>(nx_);
    const std::size_t step = waves.entries * Waves::lanes;
    const bool turned = phase == WavePhase::along_x;
    const double sign = turned ? -1 : 1;
    Row row(period_);
    for (std::size_t column = 0; column * nx < field.size(); ++column) {
        const double* values = field.data() + column * nx;
        if (std::all_of(values, values + nx, [](double value) { return value == 0; })) {
            std::fill(row.parts.begin(), row.parts.end(), 0.0);
        } else {
            std::copy_n(values, nx, row.values.begin());
            fftw_execute_split_dft_r2c(plans_->forward.get(), row.values.data(), row.re(), row.im());
        }
        const double *re = turned ? row.im() : row.re(), *im = turned ? row.re() : row.im();
        double* to_re = &waves.re[(first + column) * Waves::lanes];
        double* to_im = &waves.im[(first + column) * Waves::lanes];
        for (std::size_t at = 0, to = 0; at < row.stride; at += Waves::lanes, to += step)
            for (std::size_t lane = 0; lane < Waves::lanes; ++lane) {
                to_re[to + lane] = re[at + lane];
                to_im[to + lane] = sign * im[at + lane];
            }
    }
}

void ColumnFft::inverse(const Waves& waves, std::size_t entry, WavePhase phase, Row& row) const {
    const std::size_t step = waves.entries * Waves::lanes;
    const double* from_re = &waves.re[entry * Waves::lanes];
    const double* from_im = &waves.im[entry * Waves::lanes];
    const bool turned = phase == WavePhase::along_x;
    const double sign = turned ? -1 : 1;
    double *re = turned ? row.im() : row.re(), *im = turned ? row.re() : row.im();
    for (std::size_t at = 0, from = 0; at < row.stride; at += Waves::lanes, from += step)
        for (std::size_t lane = 0; lane < Waves::lanes; ++lane) {
            re[at + lane] = from_re[from + lane];
            im[at + lane] = sign * from_im[from + lane];
        }
    fftw_execute_split_dft_c2r(plans_->inverse.get(), row.re(), row.im(), row.values.data());
}

void ColumnFft::symbol(std::span<const double> kernel, bool even, std::span<double> transform) const {
    Row row(period_);
    const std::size_t period = row.values.size();
    const double factor = 1.0 / period_, sign = even ? 1 : -1;
    for (std::size_t k = 0; k < kernel.size(); ++k) {
        row.values[k] = factor * kernel[k];
        if (k > 0) row.values[period - k] = sign * row.values[k];
    }
    fftw_execute_split_dft_r2c(plans_->forward.get(), row.values.data(), row.re(), row.im());
    const double* part = even ? row.re() : row.im();
    for (std::size_t at = 0; at < transform.size(); ++at) transform[at] = sign * part[at];
}

}  // namespace contactd
