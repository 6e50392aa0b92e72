// Transforms in lanes against sums, and against FFTW.
#include <fftw3.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "contact/contact_cases.hpp"
#include "contactd/error.hpp"
#include "fft/lane_buffer.hpp"
#include "fft/lane_fft.hpp"
#include "operators/convolution.hpp"
#include "operators/fft/padded_fft.hpp"
#include "operators/fft/padded_size.hpp"

using namespace contactd;
using namespace contactd::test;
using Catch::Matchers::ContainsSubstring;

namespace {

using Complex = std::complex<double>;
using Complexes = std::vector<Complex>;

// The transform of n numbers by its definition.
Complexes direct_sums(const Complexes& values) {
    const std::size_t n = values.size();
    Complexes sums(n);
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t j = 0; j < n; ++j)
            sums[k] += values[j] *
                       std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(j * k % n) / static_cast<double>(n));
    return sums;
}

Complexes by_fftw(Complexes values) {
    auto* raw = reinterpret_cast<fftw_complex*>(values.data());
    fftw_plan plan = fftw_plan_dft_1d(static_cast<int>(values.size()), raw, raw, FFTW_FORWARD, FFTW_ESTIMATE);
    fftw_execute(plan);
    fftw_destroy_plan(plan);
    return values;
}

double largest_difference(const Complexes& a, const Complexes& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
    return largest;
}

// Transforms of one grid, with their arrays.
struct Transformed {
    std::size_t nx, ny;
    std::unique_ptr<const LaneFft> fft;
    std::size_t lanes, height, groups;
    LaneBuffer spectrum, work, column;

    Transformed(std::size_t nx_, std::size_t ny_, std::size_t lanes_)
        : nx(nx_),
          ny(ny_),
          fft(LaneFft::make(static_cast<int>(nx), static_cast<int>(ny), lanes_)),
          lanes(fft->lanes()),
          height((ny + lanes - 1) / lanes * lanes),
          groups((nx / 2 + lanes) / lanes),
          spectrum(groups * height * 2 * lanes),
          work(fft->work_size()),
          column(fft->work_size()) {}

    LaneSpectrum whole() const { return {spectrum.get(), height}; }
    double* group(std::size_t g) const { return spectrum.get() + g * height * 2 * lanes; }
    static Complex number(const double* columns, std::size_t row, std::size_t lane, std::size_t lanes) {
        return {columns[2 * row * lanes + lane], columns[(2 * row + 1) * lanes + lane]};
    }
    Complex at(std::size_t row, std::size_t wave) const {
        return number(group(wave / lanes), row, wave % lanes, lanes);
    }
};

// Holds rows and columns, to and fro, against `transform`; differences are relative to sqrt(n) times the largest value.
template <class Transform>
void check_transforms(std::size_t nx, std::size_t ny, std::size_t lanes, const Transform& transform) {
    CAPTURE(nx, ny, lanes);
    const Transformed made(nx, ny, lanes);
    const Values rows = random_values(nx * ny, static_cast<unsigned>(nx + ny));
    made.fft->rows_forward(rows.data(), ny, nx, made.whole(), made.work.get());
    std::vector<Complexes> columns(made.groups * made.lanes, Complexes(ny));
    for (std::size_t row = 0; row < ny; ++row) {
        const Complexes expected = transform(Complexes(rows.begin() + static_cast<std::ptrdiff_t>(row * nx),
                                                       rows.begin() + static_cast<std::ptrdiff_t>((row + 1) * nx)));
        Complexes computed(nx);
        for (std::size_t wave = 0; wave < columns.size(); ++wave) {
            columns[wave][row] = made.at(row, wave);
            if (wave <= nx / 2)
                computed[wave] = columns[wave][row];
            else
                REQUIRE(columns[wave][row] == 0.0);
        }
        for (std::size_t wave = nx / 2 + 1; wave < nx; ++wave) computed[wave] = std::conj(computed[nx - wave]);
        REQUIRE(largest_difference(computed, expected) < 2e-15 * std::sqrt(static_cast<double>(nx)));
    }
    for (std::size_t g = 0; g < made.groups; ++g) {
        double* transformed = made.fft->columns_forward(made.group(g), ny, made.column.get());
        for (std::size_t lane = 0; lane < made.lanes; ++lane) {
            const Complexes expected = transform(columns[g * made.lanes + lane]);
            Complexes computed(ny);
            for (std::size_t row = 0; row < ny; ++row)
                computed[row] = Transformed::number(transformed, row, lane, made.lanes);
            REQUIRE(largest_difference(computed, expected) < 2e-15 * std::sqrt(static_cast<double>(nx * ny)));
        }
        made.fft->columns_inverse(transformed, made.column.get(), ny, made.group(g));
    }
    Values back(rows.size());
    made.fft->rows_inverse(made.whole(), ny, nx, back.data(), made.work.get());
    double largest = 0;
    for (std::size_t at = 0; at < rows.size(); ++at)
        largest = std::max(largest, std::abs(back[at] / static_cast<double>(nx * ny) - rows[at]));
    REQUIRE(largest < 2e-15);
}

std::vector<std::size_t> smooth_sizes(int from, int to) {
    std::vector<std::size_t> sizes;
    for (int n = from; n <= to; ++n)
        if (smooth_size(n) == n) sizes.push_back(static_cast<std::size_t>(n));
    return sizes;
}

}  // namespace

TEST_CASE("transforms in lanes equal sums", "[fft]") {
    for (const std::size_t lanes : possible_lanes()) {
        for (std::size_t n = 1; n <= 40; ++n) check_transforms(n, 1 + (n * 7) % 13, lanes, direct_sums);
        for (std::size_t n = 1; n <= 40; ++n) check_transforms(1 + (n * 7) % 13, n, lanes, direct_sums);
        check_transforms(97, 5, lanes, direct_sums);
        check_transforms(3, 121, lanes, direct_sums);
        check_transforms(127, 113, lanes, direct_sums);
    }
}

TEST_CASE("transforms in lanes of all sizes that products take equal those of FFTW", "[fft]") {
    for (const std::size_t lanes : possible_lanes())
        for (const std::size_t n : smooth_sizes(1, 1350)) {
            check_transforms(n, 2, lanes, by_fftw);
            check_transforms(2, n, lanes, by_fftw);
        }
}

TEST_CASE("transforms of more than ten thousand numbers equal those of FFTW", "[fft]") {
    for (const std::size_t lanes : possible_lanes()) {
        check_transforms(12500, 2, lanes, by_fftw);
        check_transforms(2, 12500, lanes, by_fftw);
    }
}

TEST_CASE("rows that are shorter than the period and columns that are shorter, too, are followed by zeros", "[fft]") {
    for (const std::size_t lanes : possible_lanes()) {
        const std::size_t nx = 24, ny = 20, length = 13, count = 11;
        const Transformed part(nx, ny, lanes), whole(nx, ny, lanes);
        const Values rows = random_values(length * count, 3);
        Values padded(nx * ny);
        for (std::size_t row = 0; row < count; ++row) std::copy_n(&rows[row * length], length, &padded[row * nx]);
        part.fft->rows_forward(rows.data(), count, length, part.whole(), part.work.get());
        whole.fft->rows_forward(padded.data(), ny, nx, whole.whole(), whole.work.get());
        for (std::size_t g = 0; g < part.groups; ++g) {
            const double* a = part.fft->columns_forward(part.group(g), count, part.column.get());
            const double* b = whole.fft->columns_forward(whole.group(g), ny, whole.column.get());
            CHECK(Values(a, a + 2 * ny * part.lanes) == Values(b, b + 2 * ny * whole.lanes));
        }
    }
}

TEST_CASE("products of any number of lanes equal those by FFTW", "[fft]") {
    const auto [nx, ny] = GENERATE(std::pair{25, 25}, std::pair{50, 50}, std::pair{100, 100}, std::pair{36, 160},
                                   std::pair{320, 320}, std::pair{1, 27}, std::pair{13, 1});
    CAPTURE(nx, ny);
    const int px = padded_size(nx), py = padded_size(ny);
    const auto size = static_cast<std::size_t>(nx * ny), period = static_cast<std::size_t>(px * py);
    const Values kernel = random_values(static_cast<std::size_t>((2 * nx - 1) * (2 * ny - 1)), 5),
                 p = random_values(size, 6);
    // Kernel and field on the periodic grid, their transforms multiplied.
    Complexes a(period), b(period);
    const auto place = [&](int ix, int iy) { return static_cast<std::size_t>((iy + py) % py * px + (ix + px) % px); };
    for (int l = 1 - ny; l < ny; ++l)
        for (int k = 1 - nx; k < nx; ++k)
            a[place(k, l)] = kernel[static_cast<std::size_t>((l + ny - 1) * (2 * nx - 1) + k + nx - 1)];
    for (int iy = 0; iy < ny; ++iy)
        for (int ix = 0; ix < nx; ++ix) b[place(ix, iy)] = p[static_cast<std::size_t>(iy * nx + ix)];
    const auto transform = [&](Complexes& values, int sign) {
        auto* raw = reinterpret_cast<fftw_complex*>(values.data());
        fftw_plan plan = fftw_plan_dft_2d(py, px, raw, raw, sign, FFTW_ESTIMATE);
        fftw_execute(plan);
        fftw_destroy_plan(plan);
    };
    transform(a, FFTW_FORWARD);
    transform(b, FFTW_FORWARD);
    for (std::size_t at = 0; at < period; ++at) b[at] *= a[at] / static_cast<double>(period);
    transform(b, FFTW_BACKWARD);
    Values expected(size);
    for (int iy = 0; iy < ny; ++iy)
        for (int ix = 0; ix < nx; ++ix) expected[static_cast<std::size_t>(iy * nx + ix)] = b[place(ix, iy)].real();
    for (const std::size_t lanes : possible_lanes()) {
        const PaddedFft fft(nx, ny, px, py, lanes);
        Values u(size);
        fft.apply(fft.symbol(PaddedFft::SignedKernel{kernel.data(), nx, ny}), p, u);
        double difference = 0;
        for (std::size_t at = 0; at < size; ++at) difference = std::max(difference, std::abs(u[at] - expected[at]));
        CHECK(difference < 1e-14 * largest(expected));
    }
}

TEST_CASE("the environment chooses among the lanes of the processor", "[fft]") {
    const std::vector<std::size_t> possible = possible_lanes();
    CHECK(lanes_by_name(nullptr) == possible.back());
    CHECK(lanes_by_name("") == possible.back());
    for (const std::size_t lanes : possible) CHECK(lanes_by_name(std::to_string(lanes).c_str()) == lanes);
    for (const char* asked : {"3", "two", "-1", "16", " 2"}) {
        CAPTURE(asked);
        CHECK_THROWS_AS(lanes_by_name(asked), InvalidArgument);
    }
    CHECK_THROWS_WITH(lanes_by_name("3"),
                      ContainsSubstring("CONTACTD_LANES in the environment is '3'; on this processor it must be"));
}
