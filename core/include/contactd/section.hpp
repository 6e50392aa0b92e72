// The cross-section of a body that is uniform along x, as a plain value: ready-made with parameters, or an outline.
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "contactd/enum_words.hpp"
#include "contactd/profile_spec.hpp"

namespace contactd {

/// A point of a cross-section (mm): y to the right, z UP, x towards the reader. (Profiles have z downwards.)
struct SectionPoint {
    double y = 0, z = 0;

    bool operator==(const SectionPoint&) const = default;
};

/// Where a strip of elements lies on the surface: the midpoint of its arc (mm), and its axes. The outward normal is
/// n = (sin angle, cos angle) in (y, z), the tangent s = (cos angle, -sin angle); x, s, n are right-handed. The angle
/// (rad) is 0 on a flat top, positive where the normal leans towards +y, and runs on continuously from strip to
/// strip: it grows along s where the body is convex.
struct StripFrame {
    double y = 0, z = 0;
    double angle = 0;

    bool operator==(const StripFrame&) const = default;
};

/// Parts of an outline, each from where the one before ended.
struct LineTo {
    SectionPoint to{};

    bool operator==(const LineTo&) const = default;
};

/// A circular arc of at most half a turn; what is longer takes two.
struct ArcTo {
    SectionPoint to{};
    double radius = 0;  ///< mm; positive: the body is convex there, its centre lies to the right; negative: hollow

    bool operator==(const ArcTo&) const = default;
};

/// The cubic spline with continuous curvature, and none at its ends, from where the part before ended.
struct SplineTo {
    std::vector<SectionPoint> through{};  ///< in the order of travel, the last one is its end

    bool operator==(const SplineTo&) const = default;
};

struct OutlinePart {
    std::variant<LineTo, ArcTo, SplineTo> curve{};
    bool clamped = false;  ///< no displacement along it

    bool operator==(const OutlinePart&) const = default;
};

/// A closed curve that is travelled with the body on its right: the outside clockwise, a hole anticlockwise.
struct Outline {
    SectionPoint start;                ///< where the last part must end, too
    std::vector<OutlinePart> parts{};  ///< at least two

    bool operator==(const Outline&) const = default;
};

/// An outline of one's own.
struct OutlineSection {
    Outline outside{};
    std::vector<Outline> holes{};
    /// The first strip begins at the distance `from` along the curve (mm) from the beginning of the part `part` of
    /// `outside`, or of a hole: carrier 0 is the outside, carrier i is holes[i - 1].
    std::size_t carrier = 0, part = 0;
    double from = 0;

    bool operator==(const OutlineSection&) const = default;
};

/// The support of a rail: a cut through its web just below the head, or its foot; then the table contains its bending.
enum class RailSupport { cut, foot };
template <>
inline constexpr auto enum_words<RailSupport> = std::to_array<std::string_view>({"cut", "foot"});

/// The rail 60E1 upright, its top in the origin: arcs R300, R80, R13 and sides of 1:20. The cut lies at z = -60.
struct RailSection {
    double inclination = 0;  ///< a slope, e.g. 1/40; positive: its top leans towards y < 0, where its gauge side is
    RailSupport support = RailSupport::cut;
    double from = 0;  ///< where the first strip begins, along the outline from the top, positive towards +y (mm)

    bool operator==(const RailSection&) const = default;
};

/// The rim of a wheel S1002, above its running surface: tape circle in the origin, flange at y < 0. Clamped is its
/// inner face. The outline, and s, run from the field side to the flange.
struct WheelRimSection {
    double thickness = 60;  ///< of the rim, from the tape circle to its inner face (mm)
    double from = 0;        ///< where the first strip begins, from the tape circle, positive towards the flange (mm)

    bool operator==(const WheelRimSection&) const = default;
};

/// A block -width <= y <= 0, -height <= z <= 0, clamped at z = -height and y = -width. The edge is the origin.
struct EdgeBlock {
    double width = 0, height = 0;  ///< mm
    double edge_distance = 0;      ///< of the outer end of the last strip from the edge (mm), >= 0

    bool operator==(const EdgeBlock&) const = default;
};

/// A circular groove in the top of a block |y| <= width/2, -height <= z <= 0, clamped at z = -height. Strips lie about
/// its bottom, which is at (0, -depth).
struct Groove {
    double radius = 0, depth = 0;  ///< mm; depth = radius: half a circle about the origin
    double width = 0, height = 0;  ///< of the block (mm)

    bool operator==(const Groove&) const = default;
};

/// A slab |y| <= radius that ends above in half a circle about the origin. Clamped at z = -length; strips about the
/// top.
struct RoundEnd {
    double radius = 0;  ///< mm
    double length = 0;  ///< from the centre of the half circle to where it is clamped (mm)

    bool operator==(const RoundEnd&) const = default;
};

/// A disc about the origin, clamped along a round core. Strips about the top.
struct Disc {
    double radius = 0;  ///< mm
    double core = 0;    ///< radius of the core (mm); 0: none, then nothing is clamped

    bool operator==(const Disc&) const = default;
};

/// A round hole about the origin in a round plate, clamped along its outer edge. Strips about the bottom of the hole.
struct PlateHole {
    double radius = 0;        ///< of the hole (mm)
    double plate_radius = 0;  ///< mm

    bool operator==(const PlateHole&) const = default;
};

/// A flat layer |y| <= width/2, -thickness <= z <= 0, clamped at the bottom and at both sides. Strips about the middle
/// of its top. With a thickness of 1e5 strips' widths it stands for a half-space.
struct Slab {
    double thickness = 0, width = 0;  ///< mm

    bool operator==(const Slab&) const = default;
};

/// The body below the profile of a rail, or above that of a wheel, with upright sides from its ends; clamped along a
/// level cut. The outline of a wheel runs from its field side to the flange. z = -z of the profile.
struct ProfileSection {
    ProfileSpec profile{};
    double depth = 0;  ///< of the cut below the profile's origin (of a wheel above it; mm)
    double from = 0;   ///< where the first strip begins, along the outline from where y = 0 (mm)

    bool operator==(const ProfileSection&) const = default;
};

using SectionShape = std::variant<OutlineSection, RailSection, WheelRimSection, EdgeBlock, Groove, RoundEnd, Disc,
                                  PlateHole, Slab, ProfileSection>;

/// A shape, how large it is, and how it lies. How many strips there are and how wide they are is a matter of the grid:
/// its ny and dy.
struct Section {
    SectionShape shape{};
    double size = 1;  ///< by which all lengths of the shape are multiplied: 0.2 for a rail of a model
    double turn = 0;  ///< by which it is turned about the origin (rad), positive from +z towards +y; pi: upside down
    /// Nothing is clamped, on purpose: its coefficients exist above wavenumber zero only, and serve no contact.
    bool free = false;

    bool operator==(const Section&) const = default;
};

/// How much a section may have: strips, holes, parts of all outlines and points of all splines together.
inline constexpr int most_strips = 1000;
inline constexpr std::size_t most_holes = 100, most_outline_parts = 2000;

/// Throws InvalidArgument below `field`, such as "ics.section.edge_block.width", for numbers that can not be used. What
/// takes a look at the curves is for section_geometry.hpp to refuse.
void validate(const Section& section, const char* field);

/// The section with all lengths times `factor`: in `size` where the shape is one in millimetres (rail, rim, profile),
/// in its numbers otherwise, so that equal bodies become equal sections.
Section scaled(const Section& section, double factor);

}  // namespace contactd
