// Lists the variables of a wheel on its rail. docs/wheel-rail.md defines coordinates and signs.
#pragma once

#include "common_variables.hpp"
#include "generated/wheel_fields.hpp"

namespace contactd::fmu {

inline constexpr std::string_view coordinate_keywords[] = {"track", "rail", "wheelset"};
inline constexpr Enumeration coordinate_systems{"Coordinates", coordinate_keywords};
inline constexpr std::string_view search_keywords[] = {"locus", "mesh"};
inline constexpr Enumeration searches{"Search", search_keywords};
inline constexpr std::string_view rigid_slip_keywords[] = {"plane", "surfaces"};
inline constexpr Enumeration rigid_slips{"RigidSlip", rigid_slip_keywords};
inline constexpr std::string_view orientation_keywords[] = {"by_shape", "as_given", "turned"};
inline constexpr Enumeration orientations{"Orientation", orientation_keywords};
inline constexpr std::string_view vertical_keywords[] = {"force", "position"};
inline constexpr Enumeration verticals{"Vertical", vertical_keywords};

/// Number of patches with their own variables.
inline constexpr int patches_reported = 3;

namespace detail {
inline constexpr auto wheel_alone = std::to_array<Variable>({
    at_path("setup.side", keyword("side", enumerations::side, 1, "Side of the wheelset, in the direction of travel.")),
    number("side_number", "side", enumerations::side),
    text("wheel.profile", "S1002",
         "S1002, cone or arc, in upper or lower case, or a file (.prw, .whl, or two columns): a path, a URI, or a name "
         "in the FMU's resources."),
    real("wheel.radius", Role::parameter, "mm", -330,
         "Radius of an arc across the track; positive if it falls off to both sides."),
    real("wheel.slope", Role::parameter, "", -0.05, "Slope dz/dy of a cone, and of an arc at its origin."),
    real("wheel.from", Role::parameter, "mm", -40, "Start of a cone or an arc, across the track."),
    real("wheel.to", Role::parameter, "mm", 40, "End of a cone or an arc, across the track."),
    real("wheel.smoothing", Role::parameter, "mm", 0,
         "Wavelength at which smoothing halves the amplitude of a file's points; 0: no smoothing."),
    real("wheel.unit", Role::parameter, "", 0,
         "Length of the unit of a file's points in mm: 25.4 for inches, 1000 for metres; 0: as the file states, else "
         "1."),
    boolean("wheel.mirror_y", Role::parameter, false, "True to mirror y of a file."),
    keyword("wheel.mirror_z", orientations, 0,
            "Direction of z of a file. by_shape: as a Simpack file states, in other files as the shape of the points "
            "requires."),
    number("wheel.mirror_z_number", "wheel.mirror_z", orientations,
           "Overrides wheel.mirror_z: 0 by_shape, 1 as_given, 2 turned; -1: wheel.mirror_z applies."),
    real("wheel.shift_y", Role::parameter, "mm", 0, "Added to y of a file, after mirroring."),
    real("wheel.shift_z", Role::parameter, "mm", 0, "Added to z of a file, after mirroring."),
    real("wheel.G", Role::parameter, "N/mm2", 82000, "Shear modulus of the wheel."),
    real("wheel.nu", Role::parameter, "", 0.28, "Poisson's ratio of the wheel."),
    boolean("wheel.rigid", Role::parameter, false, "True if the wheel is rigid."),
    text(
        "wheel.slices", "",
        "File of an out-of-round wheel, which replaces wheel.profile. Each line contains an angle (rad) and the file "
        "of the profile there, named like wheel.profile, or relative to the folder of the list. Empty: a round wheel."),
    text("rail.profile", "60E1",
         "60E1 (the head of UIC60), 49E5, 54E1, 54E3, 60E2, cone or arc, in upper or lower case, or a file (.prr, "
         ".ban, or two columns): a path, a URI, or a name in the FMU's resources."),
    real("rail.inclination", Role::parameter, "", 0.025, "Slope of a rail by name, leaning inwards."),
    real("rail.radius", Role::parameter, "mm", 300,
         "Radius of an arc across the track; positive if it falls off to both sides."),
    real("rail.slope", Role::parameter, "", 0, "Slope dz/dy of a cone, and of an arc at its origin."),
    real("rail.from", Role::parameter, "mm", -40, "Start of a cone or an arc, across the track."),
    real("rail.to", Role::parameter, "mm", 40, "End of a cone or an arc, across the track."),
    real("rail.smoothing", Role::parameter, "mm", 0, "Smoothing of a file, as for the wheel."),
    real("rail.unit", Role::parameter, "", 0, "Unit of a file, as for the wheel."),
    boolean("rail.mirror_y", Role::parameter, false, "True to mirror y of a file."),
    keyword("rail.mirror_z", orientations, 0, "Direction of z of a file, as for the wheel."),
    number("rail.mirror_z_number", "rail.mirror_z", orientations,
           "Overrides rail.mirror_z: 0 by_shape, 1 as_given, 2 turned; -1: rail.mirror_z applies."),
    real("rail.shift_y", Role::parameter, "mm", 0, "Added to y of a file, after mirroring."),
    real("rail.shift_z", Role::parameter, "mm", 0, "Added to z of a file, after mirroring."),
    real("rail.G", Role::parameter, "N/mm2", 82000, "Shear modulus of the rail."),
    real("rail.nu", Role::parameter, "", 0.28, "Poisson's ratio of the rail."),
    boolean("rail.rigid", Role::parameter, false, "True if the rail is rigid."),
    text("rail.slices", "",
         "File of a rail that varies along the track, like wheel.slices with position.x (mm) instead of the angle. "
         "Requires track.by_origin."),
    integer("friction.angles", Role::parameter, 0,
            "Number of angles friction.angle[...] in use, each with its friction.mu_at[...], which replace "
            "friction.mu; 0: friction.mu everywhere."),
    at_path("setup.friction.along_profile", boolean("friction.along_profile", Role::parameter, false,
                                                    "True if the angle is that of the rail at each row of elements, "
                                                    "false if it is that of the patch. Only for model full.")),
    at_path("setup.track.gauge",
            real("track.gauge", Role::parameter, "mm", 1435, "Distance between the gauge faces of the rails.")),
    at_path("setup.track.gauge_height", real("track.gauge_height", Role::parameter, "mm", 14,
                                             "Distance below the tops of the rails at which the gauge is measured.")),
    at_path("setup.track.cant",
            real("track.cant", Role::parameter, "rad", 0, "Cant of the rail's profile, positive if leaning inwards.")),
    boolean("track.by_origin", Role::parameter, false,
            "True to position the rail by the origin of its profile instead of gauge and height."),
    real("track.origin_y", Role::parameter, "mm", 750,
         "Position of the profile's origin, from the centre of the track to the field side."),
    real("track.origin_z", Role::parameter, "mm", 0, "Position of the profile's origin, downwards."),
    absent_at_zero("setup.track.roller_radius", real("track.roller_radius", Role::parameter, "mm", 0,
                                                     "Radius of a roller instead of a rail; 0: a rail.")),
    at_path("setup.wheelset.flange_back_distance", real("wheelset.flange_back_distance", Role::parameter, "mm", 1360,
                                                        "Distance between the backs of the flanges.")),
    at_path("setup.wheelset.flange_back_position", real("wheelset.flange_back_position", Role::parameter, "mm", -70,
                                                        "y of the flange's back in the wheel's profile.")),
    at_path("setup.wheelset.nominal_radius", real("wheelset.nominal_radius", Role::parameter, "mm", 460,
                                                  "Radius of the wheel at z = 0 of its profile.")),
    at_path("setup.dx", real("elements.dx", Role::parameter, "mm", 0.2, "Size of an element along the track.")),
    at_path("setup.dy", real("elements.dy", Role::parameter, "mm", 0.2, "Size of an element across the track.")),
    at_path("setup.dq", real("elements.dq", Role::parameter, "mm", 0, "Step of rolling; 0: elements.dx.")),
    keyword_at("setup.patches.search", searches,
               boolean("mesh_search", Role::parameter, false,
                       "True to search for contacts on a mesh seen from above instead of along a locus.")),
    at_path("setup.conformal", keyword("conformal", enumerations::conformal, 0,
                                       "Curvature of contacts across the track, and the coefficients for it.")),
    number("conformal_number", "conformal", enumerations::conformal),
    keyword_at("setup.rigid_slip", rigid_slips,
               boolean("slip_of_surfaces", Role::parameter, false,
                       "True to compute the slip of elements from the motion of both surfaces instead of creepages.")),
    at_path("setup.force.tolerance", real("tolerances.force", Role::parameter, "", 1e-6,
                                          "Tolerance of the search for the height that produces load.Fz.")),
    keyword("vertical", verticals, 0,
            "Prescribed quantity: the vertical force, for which the height is computed, or the height."),
    number("vertical_number", "vertical", verticals, "Overrides vertical: 0 force, 1 position; -1: vertical applies."),
    boolean("prescribe_Fx", Role::parameter, false,
            "True to prescribe the longitudinal force. The pitch rate is then computed."),
    keyword("coordinates", coordinate_systems, 0, "Coordinate system of forces and moments."),
    number("coordinates_number", "coordinates", coordinate_systems,
           "Overrides coordinates: 0 track, 1 rail, 2 wheelset; -1: coordinates applies."),
    at_path("state.position.x",
            real("position.x", Role::input, "mm", 0,
                 "Position of the wheelset's centre along the track. It has an effect only if the rail varies.")),
    at_path("state.position.y",
            real("position.y", Role::input, "mm", 0,
                 "Lateral position of the wheelset's centre, positive to the right of the centre of the track.")),
    at_path("state.position.z", real("position.z", Role::input, "mm", 0,
                                     "Vertical position, positive down from the position with the tape circles on the "
                                     "plane of the track. An estimate if the force is prescribed.")),
    at_path("state.position.roll", real("position.roll", Role::input, "rad", 0, "Roll, from y to z.")),
    at_path("state.position.yaw", real("position.yaw", Role::input, "rad", 0, "Yaw, from x to y.")),
    at_path("state.velocity.x",
            real("velocity.x", Role::input, "mm/s", 20e3, "Forward velocity of the wheelset's centre.")),
    at_path("state.velocity.y", real("velocity.y", Role::input, "mm/s", 0,
                                     "Lateral velocity of the wheelset's centre, positive to the right.")),
    at_path("state.velocity.z",
            real("velocity.z", Role::input, "mm/s", 0, "Vertical velocity of the wheelset's centre, positive down.")),
    at_path("state.velocity.roll",
            real("velocity.roll", Role::input, "rad/s", 0, "Roll rate, about the wheelset's own axes.")),
    at_path("state.velocity.yaw",
            real("velocity.yaw", Role::input, "rad/s", 0, "Yaw rate, about the wheelset's own axes.")),
    at_path("state.velocity.pitch",
            real("velocity.pitch", Role::input, "rad/s", -43.47826086956522,
                 "Pitch rate, about the axle. Rolling forwards is near -velocity.x over the radius.")),
    real("load.Fz", Role::input, "N", 80e3, "Vertical force on the rail, if prescribed."),
    real("load.Fx", Role::input, "N", 0, "Longitudinal force on the rail, if prescribed."),
    at_path("state.rail.y", real("deviation.y", Role::input, "mm", 0,
                                 "Lateral deviation of the rail in track coordinates, positive to the right.")),
    at_path("state.rail.z",
            real("deviation.z", Role::input, "mm", 0, "Vertical deviation of the rail, positive down.")),
    at_path("state.rail.roll", real("deviation.roll", Role::input, "rad", 0, "Roll of the rail, from y to z.")),
    at_path("state.rail.y_velocity", real("deviation_rate.y", Role::input, "mm/s", 0, "Rate of deviation.y.")),
    at_path("state.rail.z_velocity", real("deviation_rate.z", Role::input, "mm/s", 0, "Rate of deviation.z.")),
    at_path("state.rail.roll_velocity",
            real("deviation_rate.roll", Role::input, "rad/s", 0, "Rate of deviation.roll.")),
    at_path("state.roller_pitch", real("roller.pitch", Role::input, "rad/s", 0, "Pitch rate of a roller.")),
    real("temperature.upper.bulk_temperature", Role::input, "degC", 0,
         "Temperature of the rail's surface before contact."),
    real("temperature.lower.bulk_temperature", Role::input, "degC", 0,
         "Temperature of the wheel's surface before contact."),
    real("Fx", Role::output, "N", 0, "Longitudinal force on the rail, the sum of all patches."),
    real("Fy", Role::output, "N", 0, "Lateral force on the rail, positive to the right."),
    real("Fz", Role::output, "N", 0, "Vertical force on the rail, positive down."),
    real("Mx", Role::output, "N.mm", 0, "Moment on the rail about x, at the origin of the coordinates."),
    real("My", Role::output, "N.mm", 0, "Moment on the rail about y."),
    real("Mz", Role::output, "N.mm", 0, "Moment on the rail about z."),
    at_path("z", real("z", Role::output, "mm", 0, "Height of the wheelset's centre, prescribed or computed.")),
    at_path("pitch_rate",
            real("pitch_rate", Role::output, "rad/s", 0, "Pitch rate of the wheelset, prescribed or computed.")),
    absent_at_zero("clearance", real("clearance", Role::output, "mm", 0,
                                     "Smallest vertical distance of wheel and rail, negative where they overlap; 0 if "
                                     "they are not above each other.")),
    real("pmax", Role::output, "N/mm2", 0, "Largest pressure of all patches."),
    real("area.contact", Role::output, "mm2", 0, "Area in contact, of all patches."),
    real("area.adhesion", Role::output, "mm2", 0, "Area of adhesion, of all patches."),
    real("area.slip", Role::output, "mm2", 0, "Area of slip, of all patches."),
    real("power", Role::output, "N.mm/s", 0, "Power that friction dissipates in all patches."),
    at_path("patches", integer("patches", Role::output, 0,
                               "Number of patches. The first three have their own variables, from right to left.")),
    at_path("converged",
            boolean("converged", Role::output, false, "True if all solvers and searches reached their tolerances.")),
});

inline constexpr std::string_view friction_names[][2] = {
    {"friction.angle[1]", "friction.mu_at[1]"}, {"friction.angle[2]", "friction.mu_at[2]"},
    {"friction.angle[3]", "friction.mu_at[3]"}, {"friction.angle[4]", "friction.mu_at[4]"},
    {"friction.angle[5]", "friction.mu_at[5]"}, {"friction.angle[6]", "friction.mu_at[6]"},
};

consteval auto friction_variables() {
    std::array<Variable, 2 * std::size(friction_names)> all;
    for (std::size_t k = 0; k < std::size(friction_names); ++k) {
        all[2 * k] = real(friction_names[k][0], Role::parameter, "rad", 0,
                          "Angle of the rail's surface from the horizontal, negative on the gauge side; ascending.");
        all[2 * k + 1] = real(
            friction_names[k][1], Role::parameter, "", 0.3,
            "Coefficient of friction at this angle, with linear interpolation, and constant beyond the last angles.");
    }
    return all;
}

inline constexpr std::string_view patch_names[][patches_reported] = {
    {"patch[1].x", "patch[2].x", "patch[3].x"},          {"patch[1].y", "patch[2].y", "patch[3].y"},
    {"patch[1].z", "patch[2].z", "patch[3].z"},          {"patch[1].angle", "patch[2].angle", "patch[3].angle"},
    {"patch[1].Fn", "patch[2].Fn", "patch[3].Fn"},       {"patch[1].Fx", "patch[2].Fx", "patch[3].Fx"},
    {"patch[1].Fs", "patch[2].Fs", "patch[3].Fs"},       {"patch[1].Mn", "patch[2].Mn", "patch[3].Mn"},
    {"patch[1].pmax", "patch[2].pmax", "patch[3].pmax"}, {"patch[1].area", "patch[2].area", "patch[3].area"},
    {"patch[1].xi", "patch[2].xi", "patch[3].xi"},       {"patch[1].eta", "patch[2].eta", "patch[3].eta"},
    {"patch[1].phi", "patch[2].phi", "patch[3].phi"},    {"patch[1].power", "patch[2].power", "patch[3].power"},
};
/// Lists the outputs of a patch, each by its path below the patch; 0 if the patch does not exist.
inline constexpr struct {
    std::string_view unit, path, says;
} patch_parts[] = {
    {"mm", "place.reference.x", "Position x of the origin of the contact coordinates, in track coordinates."},
    {"mm", "place.reference.y", "Position y of this origin, positive to the right."},
    {"mm", "place.reference.z", "Position z of this origin, positive down."},
    {"rad", "place.reference.angle", "Angle of the plane of the contact."},
    {"N", "solution.forces.Fn", "Normal force."},
    {"N", "solution.forces.Fx", "Longitudinal force, in contact coordinates."},
    {"N", "solution.forces.Fy", "Lateral force, in contact coordinates."},
    {"N.mm", "solution.forces.Mz", "Moment about the normal."},
    {"N/mm2", "solution.pmax", "Largest pressure."},
    {"mm2", "solution.area.contact", "Area in contact."},
    {"", "place.creepages.xi", "Longitudinal creepage."},
    {"", "place.creepages.eta", "Lateral creepage."},
    {"rad/mm", "place.creepages.phi", "Spin."},
    {"N.mm/s", "solution.frictional_power", "Power that friction dissipates."},
};
inline constexpr std::size_t patch_values = std::size(patch_parts);

consteval auto patch_variables() {
    std::array<Variable, patches_reported * patch_values> all;
    for (std::size_t patch = 0; patch < patches_reported; ++patch)
        for (std::size_t part = 0; part < patch_values; ++part)
            all[patch * patch_values + part] =
                real(patch_names[part][patch], Role::output, patch_parts[part].unit, 0, patch_parts[part].says);
    return all;
}
}  // namespace detail

inline constexpr auto wheel_variables = joined(
    joined(joined(joined(common_variables, detail::wheel_alone), detail::friction_variables()), detail::wheel_fields),
    detail::patch_variables());

/// Number of angles with their own coefficient of friction.
inline constexpr int most_angles = static_cast<int>(std::size(detail::friction_names));

}  // namespace contactd::fmu
