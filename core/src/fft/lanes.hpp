// Defines a vector register of CONTACTD_LANES doubles as a number. Each source that includes this has its own type,
// because code compiled for different instruction sets must not be merged.
#pragma once

#include <cstddef>

namespace contactd {
namespace {

constexpr std::size_t lane_count = CONTACTD_LANES;
using Register [[gnu::vector_size(8 * CONTACTD_LANES)]] = double;
using LooseRegister [[gnu::vector_size(8 * CONTACTD_LANES), gnu::aligned(8), gnu::may_alias]] = double;

struct Lanes {
    Register v;

    Lanes() = default;
    Lanes(const Register& of) : v(of) {}
    Lanes(double of) {
        for (std::size_t lane = 0; lane < lane_count; ++lane) v[lane] = of;
    }
    static constexpr std::size_t size() { return lane_count; }
    Lanes operator-() const { return -v; }
    Lanes& operator+=(const Lanes& b) { return v += b.v, *this; }
    Lanes& operator-=(const Lanes& b) { return v -= b.v, *this; }
    Lanes& operator*=(const Lanes& b) { return v *= b.v, *this; }
    friend Lanes operator+(const Lanes& a, const Lanes& b) { return a.v + b.v; }
    friend Lanes operator-(const Lanes& a, const Lanes& b) { return a.v - b.v; }
    friend Lanes operator*(const Lanes& a, const Lanes& b) { return a.v * b.v; }
    double& operator[](std::size_t lane) { return reinterpret_cast<double*>(&v)[lane]; }
    double operator[](std::size_t lane) const { return v[lane]; }
};

inline Lanes load(const double* from) {
    return Register(*reinterpret_cast<const LooseRegister*>(from));
}
inline void store(const Lanes& value, double* to) {
    *reinterpret_cast<LooseRegister*>(to) = value.v;
}

/// Transposes a square of registers: lane j of register i becomes lane i of register j.
inline void transpose(Lanes (&a)[lane_count]) {
#if CONTACTD_LANES == 2
    const Register b = a[0].v, c = a[1].v;
    a[0] = Register(__builtin_shufflevector(b, c, 0, 2));
    a[1] = Register(__builtin_shufflevector(b, c, 1, 3));
#else
    const Register b = __builtin_shufflevector(a[0].v, a[1].v, 0, 4, 2, 6),
                   c = __builtin_shufflevector(a[0].v, a[1].v, 1, 5, 3, 7),
                   d = __builtin_shufflevector(a[2].v, a[3].v, 0, 4, 2, 6),
                   e = __builtin_shufflevector(a[2].v, a[3].v, 1, 5, 3, 7);
    a[0] = Register(__builtin_shufflevector(b, d, 0, 1, 4, 5));
    a[1] = Register(__builtin_shufflevector(c, e, 0, 1, 4, 5));
    a[2] = Register(__builtin_shufflevector(b, d, 2, 3, 6, 7));
    a[3] = Register(__builtin_shufflevector(c, e, 2, 3, 6, 7));
#endif
}

}  // namespace
}  // namespace contactd
