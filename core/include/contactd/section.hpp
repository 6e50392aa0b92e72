// Defines the cross-section of a body that is uniform along x as a plain value: ready-made with parameters, or an
// outline.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "contactd/enum_words.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

/// Holds a point of a cross-section (mm): y to the right, z UP, x towards the reader. (Profiles have z downwards.)
struct SectionPoint {
    double y = 0, z = 0;

    bool operator==(const SectionPoint&) const = default;
};

/// Describes the position of a strip of elements on the surface: the midpoint of its arc (mm), and its axes. The
/// outward normal is n = (sin angle, cos angle) in (y, z), the tangent s = (cos angle, -sin angle); x, s, n are
/// right-handed. The angle (rad) is 0 on a flat top, positive if the normal leans towards +y, and continuous from strip
/// to strip: it grows along s where the body is convex.
struct StripFrame {
    double y = 0, z = 0;
    double angle = 0;

    bool operator==(const StripFrame&) const = default;
};

/// Each part of an outline starts at the end of the previous one.
struct LineTo {
    SectionPoint to{};

    bool operator==(const LineTo&) const = default;
};

/// Describes a circular arc of at most half a turn; use two for a longer one.
struct ArcTo {
    SectionPoint to{};
    double radius = 0;  ///< mm; positive: the body is convex, with its centre to the right; negative: concave

    bool operator==(const ArcTo&) const = default;
};

/// Describes a cubic spline from the end of the previous part, with continuous curvature, which is zero at its ends.
struct SplineTo {
    std::vector<SectionPoint> through{};  ///< in order; the last one is its end

    bool operator==(const SplineTo&) const = default;
};

struct OutlinePart {
    std::variant<LineTo, ArcTo, SplineTo> curve{};
    bool clamped = false;  ///< no displacement along it

    bool operator==(const OutlinePart&) const = default;
};

/// Describes a closed curve with the body on its right: the outside is clockwise, a hole anticlockwise.
struct Outline {
    SectionPoint start;                ///< also the end of the last part
    std::vector<OutlinePart> parts{};  ///< at least two

    bool operator==(const Outline&) const = default;
};

/// Describes a user-defined outline.
struct OutlineSection {
    Outline outside{};
    std::vector<Outline> holes{};
    /// The first strip begins at the distance `from` along the curve (mm) from the start of the part `part` of
    /// `outside`, or of a hole: carrier 0 is the outside, carrier i is holes[i - 1].
    std::size_t carrier = 0, part = 0;
    double from = 0;

    bool operator==(const OutlineSection&) const = default;
};

/// Selects the support of a rail: a cut through its web just below the head, or its foot. With the foot, the table
/// includes the rail's bending.
enum class RailSupport { cut, foot };
template <>
inline constexpr auto enum_words<RailSupport> = std::to_array<std::string_view>({"cut", "foot"});

/// Selects an upright rail 60E1, its top at the origin: arcs R300, R80, R13 and sides of 1:20. The cut is at z = -60.
struct RailSection {
    double inclination = 0;  ///< a slope, e.g. 1/40; positive: its top leans towards its gauge side at y < 0
    RailSupport support = RailSupport::cut;
    double from = 0;  ///< start of the first strip, along the outline from the top, positive towards +y (mm)

    bool operator==(const RailSection&) const = default;
};

/// Selects the rim of a wheel S1002, above its running surface: tape circle at the origin, flange at y < 0. Its inner
/// face is clamped. The outline, and s, run from the field side to the flange.
struct WheelRimSection {
    double thickness = 60;  ///< thickness of the rim, from the tape circle to its inner face (mm)
    double from = 0;        ///< start of the first strip, from the tape circle, positive towards the flange (mm)

    bool operator==(const WheelRimSection&) const = default;
};

/// Describes a block -width <= y <= 0, -height <= z <= 0, clamped at z = -height and y = -width. The edge is the
/// origin.
struct EdgeBlock {
    double width = 0, height = 0;  ///< mm
    double edge_distance = 0;      ///< distance of the outer end of the last strip from the edge (mm), >= 0

    bool operator==(const EdgeBlock&) const = default;
};

/// Describes a circular groove in the top of a block |y| <= width/2, -height <= z <= 0, clamped at z = -height. Strips
/// are centred on its bottom at (0, -depth).
struct Groove {
    double radius = 0, depth = 0;  ///< mm; depth = radius: half a circle about the origin
    double width = 0, height = 0;  ///< of the block (mm)

    bool operator==(const Groove&) const = default;
};

/// Describes a slab |y| <= radius whose top is a half circle about the origin, clamped at z = -length. Strips are
/// centred on the top.
struct RoundEnd {
    double radius = 0;  ///< mm
    double length = 0;  ///< from the centre of the half circle to the clamped end (mm)

    bool operator==(const RoundEnd&) const = default;
};

/// Describes a disc about the origin, clamped along a round core. Strips are centred on the top.
struct Disc {
    double radius = 0;  ///< mm
    double core = 0;    ///< radius of the core (mm); 0: no core, and nothing is clamped

    bool operator==(const Disc&) const = default;
};

/// Describes a round hole about the origin in a round plate with a clamped outer edge. Strips are centred on the
/// bottom.
struct PlateHole {
    double radius = 0;        ///< of the hole (mm)
    double plate_radius = 0;  ///< mm

    bool operator==(const PlateHole&) const = default;
};

/// Describes a flat layer |y| <= width/2, -thickness <= z <= 0, clamped at the bottom and at both sides. Strips are
/// centred on its top. With a thickness of 1e5 strip widths it represents a half-space.
struct Slab {
    double thickness = 0, width = 0;  ///< mm

    bool operator==(const Slab&) const = default;
};

/// Describes the body below the profile of a rail, or above that of a wheel, with vertical sides from its ends; it is
/// clamped along a level cut. The outline of a wheel runs from its field side to the flange. z of the section is -z of
/// the profile.
struct ProfileSection {
    ProfileSpec profile{};
    double depth = 0;  ///< depth of the cut below the profile's origin (above it for a wheel; mm)
    double from = 0;   ///< start of the first strip, along the outline from y = 0 (mm)

    bool operator==(const ProfileSection&) const = default;
};

using SectionShape = std::variant<OutlineSection, RailSection, WheelRimSection, EdgeBlock, Groove, RoundEnd, Disc,
                                  PlateHole, Slab, ProfileSection>;

/// Describes a shape with its scale and rotation. The number and the width of the strips are ny and dy of the grid.
struct Section {
    SectionShape shape{};
    double size = 1;  ///< factor of all lengths of the shape: 0.2 for the rail of a model
    double turn = 0;  ///< rotation about the origin (rad), positive from +z towards +y; pi: upside down
    /// If set, nothing is clamped. Coefficients then exist only above wavenumber zero, and not for contact.
    bool free = false;

    bool operator==(const Section&) const = default;
};

/// These limits apply to strips, holes, parts of all outlines and points of all splines together.
inline constexpr int most_strips = 1000;
inline constexpr std::size_t most_holes = 100, most_outline_parts = 2000;

/// Throws InvalidArgument below `field`, such as "ics.section.edge_block.width", for invalid numbers.
/// section_geometry.hpp checks the curves.
void validate(const Section& section, const char* field);

/// Returns the section with all lengths times `factor`. The factor enters `size` of shapes in millimetres (rail, rim,
/// profile), and the numbers of other shapes, so that equal bodies become equal sections.
Section scaled(const Section& section, double factor);

}  // namespace contactd
