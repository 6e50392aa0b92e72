// Defines transforms by FFTW in the order of lanes, for CMake's option CONTACTD_FFT=fftw.
#ifdef CONTACTD_FFTW
#define CONTACTD_LANES 4

#include <fftw3.h>

#include <mutex>

#include "lane_headers.hpp"

// Without AVX, vectors of four numbers are only arguments of inlined functions, whose ABI does not matter.
#pragma GCC diagnostic ignored "-Wpsabi"

#include "lane_makers.hpp"
#include "lanes.hpp"

namespace contactd {
namespace {

struct Column {
    Lanes r, i;

    Column() = default;
    Column(const Lanes& real, const Lanes& imag) : r(real), i(imag) {}
    friend Column operator+(const Column& a, const Column& b) { return {a.r + b.r, a.i + b.i}; }
};

// Only one thread at a time may create and free FFTW plans; several may execute them.
std::mutex& planner_mutex() {
    static std::mutex mutex;
    return mutex;
}

class Plan {
   public:
    explicit Plan(fftw_plan plan) : plan_(plan) {}
    ~Plan() {
        const std::scoped_lock lock(planner_mutex());
        fftw_destroy_plan(plan_);
    }
    Plan(const Plan&) = delete;
    Plan& operator=(const Plan&) = delete;
    operator fftw_plan() const { return plan_; }

   private:
    fftw_plan plan_;
};

// Provides an array for planning, with the same alignment to cache lines as those of transforms.
struct Sample {
    std::vector<double> numbers;
    explicit Sample(std::size_t n) : numbers(2 * (n + 4) * lane_count) {}
    double* at(std::size_t n) { return numbers.data() + n; }
};

class Passes {
   public:
    Passes(std::size_t nx, std::size_t ny)
        : nx_(nx),
          row_forward_(row_plan(nx, true)),
          row_inverse_(row_plan(nx, false)),
          column_forward_(column_plan(ny, true)),
          column_inverse_(column_plan(ny, false)) {}

    std::size_t of_row() const { return 0; }
    std::size_t of_column() const { return 0; }

    // Wave k is at 2k - 1 and 2k. FFTW puts it one position later, with an imaginary part of the mean.
    Lanes* row(Lanes* in, Lanes* other, Lanes*, bool forward) const {
        double* waves = numbers(forward ? other - 1 : in - 1);
        if (forward) {
            fftw_execute_split_dft_r2c(row_forward_, numbers(in), waves, waves + lane_count);
            other[0] = other[-1];
        } else {
            in[-1] = in[0];
            in[0] = 0.0;
            if (nx_ % 2 == 0) in[nx_] = 0.0;
            fftw_execute_split_dft_c2r(row_inverse_, waves, waves + lane_count, numbers(other));
        }
        return other;
    }
    // With real and imaginary parts exchanged, the forward transform is the inverse.
    Column* column(Column* in, Column* other, Column*, bool forward) const {
        double *from = numbers(&in->r), *to = numbers(&other->r);
        if (forward)
            fftw_execute_split_dft(column_forward_, from, from + lane_count, to, to + lane_count);
        else
            fftw_execute_split_dft(column_inverse_, from + lane_count, from, to + lane_count, to);
        return other;
    }

   private:
    // With FFTW_ESTIMATE, plans are the same in every run.
    static constexpr unsigned flags = FFTW_ESTIMATE | FFTW_UNALIGNED;

    static double* numbers(Lanes* of) { return reinterpret_cast<double*>(of); }

    static fftw_plan row_plan(std::size_t n, bool forward) {
        Sample a(n), b(n);
        constexpr int one = lane_count, two = 2 * lane_count;
        const fftw_iodim real{static_cast<int>(n), forward ? one : two, forward ? two : one}, many{lane_count, 1, 1};
        const std::scoped_lock lock(planner_mutex());
        return forward ? fftw_plan_guru_split_dft_r2c(1, &real, 1, &many, a.at(0), b.at(0), b.at(lane_count), flags)
                       : fftw_plan_guru_split_dft_c2r(1, &real, 1, &many, a.at(0), a.at(lane_count), b.at(0), flags);
    }
    static fftw_plan column_plan(std::size_t n, bool forward) {
        Sample a(n), b(n);
        const fftw_iodim along{static_cast<int>(n), 2 * lane_count, 2 * lane_count}, many{lane_count, 1, 1};
        const std::size_t real = forward ? 0 : lane_count, imaginary = lane_count - real;
        const std::scoped_lock lock(planner_mutex());
        return fftw_plan_guru_split_dft(1, &along, 1, &many, a.at(real), a.at(imaginary), b.at(real), b.at(imaginary),
                                        flags);
    }

    const std::size_t nx_;
    const Plan row_forward_, row_inverse_, column_forward_, column_inverse_;
};

}  // namespace
}  // namespace contactd

#include "lane_transforms.hpp"

namespace contactd {

std::unique_ptr<const LaneFft> make_fftw_lanes(std::size_t nx, std::size_t ny) {
    return std::make_unique<const Transforms>(nx, ny);
}

std::pair<const char*, const char*> fft_library() {
    return {"fftw", fftw_version};
}

}  // namespace contactd
#endif
