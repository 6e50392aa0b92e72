// Creates rails of slices with edges, for tests of searches.
#pragma once

#include <functional>
#include <vector>

#include "contactd/make_profile.hpp"
#include "wheel_rail/wheel_rail_cases.hpp"

namespace contactd::test {

/// Creates a cylinder of 450 mm on an arc of 300 mm by slices; `height` is positive where the rail is higher.
inline WheelRailSetup on_rail_of(const std::vector<double>& places,
                                 const std::function<double(double x, double y)>& height) {
    WheelRailSetup setup = cylinder_on_arc(300);
    const ProfileCurve arc = make_profile(setup.rail).curve;
    for (const double x : places) {
        ProfilePoints points;
        for (const ProfilePoint& point : arc.points()) points.points.push_back({point.y, point.z - height(x, point.y)});
        setup.rail_slices.push_back({x, {ProfileKind::rail, points}});
    }
    setup.dx = setup.dy = 0.4;
    return setup;
}

}  // namespace contactd::test
