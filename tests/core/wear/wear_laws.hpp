// Provides laws of wear for tests. Their coefficients are round numbers, or those of the original papers.
#pragma once

#include "contactd/wear.hpp"

namespace contactd::test {

inline WearLaw law_of(const char* name, WearRange range) {
    WearLaw law;
    law.name = name;
    law.source = "a test";
    law.body = WornBody::lower;
    law.range = range;
    return law;
}

inline WearLaw archard_law(double k, double hardness) {
    WearLaw law = law_of("archard", {0, 1000});
    law.archard = ArchardWear{.hardness = hardness, .mild = k};
    return law;
}

inline WearLaw energy_law(double coefficient) {
    WearLaw law = law_of("energy", {0, 100});
    law.energy = EnergyWear{coefficient};
    return law;
}

inline WearLaw usfd_law() {
    WearLaw law = law_of("usfd", {0, 100});
    law.usfd = UsfdWear{{{0, 0, 5.3}, {10.4, 55, 0}, {77.2, 55, 61.9}}, 7850};
    return law;
}

inline WearLaw usfd_mild_law() {
    WearLaw law = law_of("usfd", {0, 100});
    law.usfd = UsfdWear{{{0, 0, 5.3}}, 7850};
    return law;
}

inline WearLaw br_mild_law() {
    WearLaw law = law_of("br", {0, 1000});
    law.br = BrWear{{{0, 0, 0.25}}};
    return law;
}

inline WearLaw zobory_mild_law() {
    WearLaw law = law_of("zobory", {0, 1000});
    law.zobory = ZoboryWear{{{0, 7e-10, 0}}, 7850};
    return law;
}

}  // namespace contactd::test
