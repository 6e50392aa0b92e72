// Defines Gauss's rules on [-1, 1] whose weights sum to one, for the mean over an interval, and for the mean weighted
// with a hat function, 1 - |t|. A rule of n points is exact for polynomials of degree 2n - 1.
#pragma once

#include <array>
#include <cstddef>

namespace contactd {

struct GaussPoint {
    double node;
    double weight;
};

template <std::size_t n>
using GaussRule = std::array<GaussPoint, n>;

/// Returns the whole rule from its nodes >= 0, ascending.
template <std::size_t n>
constexpr GaussRule<n> symmetric(const GaussRule<(n + 1) / 2>& half) {
    GaussRule<n> rule{};
    for (std::size_t i = 0; i < half.size(); ++i) {
        rule[n / 2 + i] = half[i];
        rule[(n - 1) / 2 - i] = {-half[i].node, half[i].weight};
    }
    if (n % 2 == 1) rule[n / 2].node = 0;
    return rule;
}

inline constexpr auto legendre3 =
    symmetric<3>({{{0, 0.4444444444444444444}, {0.7745966692414833770, 0.2777777777777777778}}});
inline constexpr auto legendre6 = symmetric<6>({{{0.2386191860831969086, 0.2339569672863455237},
                                                 {0.6612093864662645137, 0.1803807865240693038},
                                                 {0.9324695142031520278, 0.0856622461895851725}}});

inline constexpr auto hat3 =
    symmetric<3>({{{0, 0.5833333333333333333}, {0.6324555320336758664, 0.2083333333333333333}}});
inline constexpr auto hat5 = symmetric<5>({{{0, 0.4177370030581039755},
                                            {0.4499203524598419633, 0.2394732407054573904},
                                            {0.8214405997383815279, 0.0516582577654906218}}});
inline constexpr auto hat10 = symmetric<10>({{{0.1285736813316395223, 0.2294499953289039394},
                                              {0.3883513213345513313, 0.1538370641981887023},
                                              {0.6237843136334670790, 0.0812306244549692892},
                                              {0.8140532886558227179, 0.0301132562934665704},
                                              {0.9431663817256676998, 0.0053690597244715987}}});

}  // namespace contactd
