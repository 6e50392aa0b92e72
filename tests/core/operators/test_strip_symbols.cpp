#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <numbers>

#include "operators/strips/strip_fft.hpp"
#include "operators/strips/strip_symbols.hpp"

using namespace contactd;

namespace {

/// Uses 1/r with r = (offset, across), which is smoother at a larger distance across.
std::vector<double> kernel(int n, double across) {
    std::vector<double> values;
    for (int k = 0; k < n; ++k) values.push_back(1 / std::hypot(k, across));
    return values;
}

}  // namespace

TEST_CASE("a kernel that goes on smoothly has small wavenumbers only", "[strips]") {
    constexpr int n = 40;
    const int period = static_cast<int>(PeriodicJoint::least_period(n));
    const StripFft fft(n, period);
    StripWork work(fft, 1);
    std::vector<double> smooth(4 * fft.groups()), abrupt(smooth);
    fft.symbol(kernel(n, 10), true, PeriodicJoint(n, static_cast<std::size_t>(period)), smooth, work);
    fft.symbol(kernel(n, 10), true, PeriodicJoint(), abrupt, work);
    const auto half = static_cast<std::size_t>(period / 2);
    CHECK(std::abs(smooth[half]) < 1e-6 * smooth[0]);
    CHECK(std::abs(abrupt[half]) > 1e-4 * abrupt[0]);
}

TEST_CASE("what lies between the largest offsets is even or odd as the kernel", "[strips]") {
    const bool even = GENERATE(true, false);
    const std::size_t n = GENERATE(1, 2, 5, 20), period = 2 * n + 7 + n % 3;
    CAPTURE(even, n, period);
    std::vector<double> values(period);
    for (std::size_t k = even ? 0 : 1; k < n; ++k) {
        values[k] = std::cos(0.1 * static_cast<double>(k)) + static_cast<double>(k);
        if (k > 0) values[period - k] = even ? values[k] : -values[k];
    }
    const std::vector<double> given = values;
    PeriodicJoint(n, period).fill(values, even);
    for (std::size_t k = 1; k < period; ++k) {
        CHECK(std::abs(values[k] - (even ? 1 : -1) * values[period - k]) < 1e-9);
        if (k < n || k > period - n) CHECK(values[k] == given[k]);
    }
}

TEST_CASE("a symbol keeps fewer numbers the more may be left out", "[strips]") {
    constexpr int n = 60;
    constexpr std::size_t columns = 30;
    const int period = static_cast<int>(PeriodicJoint::least_period(n));
    const StripFft fft(n, period);
    const PeriodicJoint joint(n, static_cast<std::size_t>(period));
    StripWork work(fft, 1);
    std::vector<double> transform(4 * fft.groups());
    const auto numbers = [&](double left_out) {
        SymmetricSymbol symbol(fft.groups(), columns);
        RectangularSymbol full(fft.groups(), columns, columns);
        for (std::size_t I = 0; I < columns; ++I)
            for (std::size_t J = 0; J < columns; ++J) {
                fft.symbol(kernel(n, 0.5 + std::abs(static_cast<double>(I) - static_cast<double>(J))), true, joint,
                           transform, work);
                if (J <= I) symbol.set(I, J, transform);
                full.set(I, J, transform);
            }
        symbol.trim(left_out);
        full.trim(left_out);
        return std::pair(symbol.numbers(), full.numbers());
    };
    const auto all = numbers(0), most = numbers(1e-8), few = numbers(1e-4);
    CHECK(all.first == 4 * fft.groups() * columns * (columns + 1) / 2);
    CHECK(all.second == 4 * fft.groups() * columns * columns);
    CHECK(most.first < all.first);
    CHECK(2 * few.first < all.first);
    CHECK(most.second < all.second);
    CHECK(2 * few.second < all.second);
}
