// Creates ready-made sections with strips on them.
#pragma once

#include <catch2/generators/catch_generators_range.hpp>
#include <string>
#include <vector>

#include "geometry/section/section_geometry.hpp"

namespace contactd::test {

struct SectionCase {
    std::string name;
    Section section;
    int strips;
    double ds;

    geometry::SectionGeometry geometry() const { return {section, strips, ds}; }
};

inline std::vector<SectionCase> ready_made_cases() {
    return {{"60E1 head", {RailSection{1.0 / 40, RailSupport::cut, 2}}, 80, 0.5},
            {"60E1 on its foot", {RailSection{0, RailSupport::foot, -10}}, 40, 0.5},
            {"rim", {WheelRimSection{}}, 50, 0.5},
            {"model rim", {WheelRimSection{60, -10}, 0.2}, 50, 0.1},
            {"edge", {EdgeBlock{100, 50, 0.25}}, 20, 0.5},
            {"groove", {Groove{10, 10, 120, 70}}, 41, 0.5},
            {"shallow groove", {Groove{10, 4, 120, 70}}, 30, 0.5},
            {"round end", {RoundEnd{9.7, 60}, 1, 3.14159}, 41, 0.5},
            {"disc", {Disc{10, 0.05}}, 40, 0.5},
            {"cylinder", {Disc{10, 0}, 1, 0, true}, 40, 20 * 3.14159265358979323846 / 40},
            {"hole", {PlateHole{10, 500}}, 60, 0.5},
            {"layer", {Slab{0.5, 60}}, 20, 0.5},
            {"half-space", {Slab{5e4, 1e5}}, 20, 0.5},
            {"arc", {ProfileSection{{ProfileKind::rail, ArcProfile{300, 0, -30, 30}}, 40, -5}}, 20, 0.5},
            {"roller", {ProfileSection{{ProfileKind::wheel, ArcProfile{-100, 0, -30, 30}}, 60, -5}}, 20, 0.5}};
}

inline auto ready_made() {
    return Catch::Generators::from_range(ready_made_cases());
}

}  // namespace contactd::test
