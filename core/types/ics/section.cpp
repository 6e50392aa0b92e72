#include "contactd/section.hpp"

#include <cmath>
#include <initializer_list>
#include <string>
#include <type_traits>

#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

constexpr double shortest = 1e-9, longest = 1e12;  // mm
constexpr double most_inclination = 0.2;

void check_length(double value, const std::string& field) {
    if (!(value >= shortest && value <= longest))
        throw InvalidArgument(field, "is " + number_text(value) + "; it must be a length between 1e-9 and 1e12 mm");
}

void check_place(double value, const std::string& field) {
    if (!(std::abs(value) <= longest))
        throw InvalidArgument(field, "is " + number_text(value) + "; it must be a number of mm between -1e12 and 1e12");
}

void check_point(const SectionPoint& point, const std::string& field) {
    check_place(point.y, field + ".y");
    check_place(point.z, field + ".z");
}

void check_below(double value, const std::string& field, double bound, const char* bound_name) {
    if (!(value < bound))
        throw InvalidArgument(
            field, "is " + number_text(value) + "; it must be less than " + bound_name + ", " + number_text(bound));
}

// Counts the parts of outlines, and their clamped parts.
class OutlineCheck {
   public:
    void add(const Outline& outline, const std::string& field) {
        check_point(outline.start, field + ".start");
        if (outline.parts.size() < 2)
            throw InvalidArgument(field + ".parts", "has " + std::to_string(outline.parts.size()) +
                                                        "; a closed outline has at least two parts");
        for (std::size_t i = 0; i < outline.parts.size(); ++i) {
            const std::string of = field + ".parts[" + std::to_string(i) + "]";
            std::visit([&](const auto& curve) { add(curve, of); }, outline.parts[i].curve);
            clamped_ = clamped_ || outline.parts[i].clamped;
            if (count_ > most_outline_parts)
                throw InvalidArgument(of, "exceeds the limit of " + std::to_string(most_outline_parts) +
                                              " parts of outlines and points of splines together; omit some of them");
        }
    }
    bool clamped() const { return clamped_; }

   private:
    void add(const LineTo& line, const std::string& of) {
        check_point(line.to, of + ".line.to");
        ++count_;
    }
    void add(const ArcTo& arc, const std::string& of) {
        check_point(arc.to, of + ".arc.to");
        check_length(std::abs(arc.radius), of + ".arc.radius");
        ++count_;
    }
    void add(const SplineTo& spline, const std::string& of) {
        if (spline.through.empty())
            throw InvalidArgument(of + ".spline.through", "is empty; give at least the end of the spline");
        for (std::size_t i = 0; i < spline.through.size(); ++i)
            check_point(spline.through[i], of + ".spline.through[" + std::to_string(i) + "]");
        count_ += spline.through.size();
    }

    std::size_t count_ = 0;
    bool clamped_ = false;
};

// These functions return whether something is clamped.
bool check(const OutlineSection& section, const std::string& field) {
    const std::string name = field + ".outline";
    if (section.holes.size() > most_holes)
        throw InvalidArgument(name + ".holes", "has " + std::to_string(section.holes.size()) +
                                                   " entries; at most 100 holes are supported");
    OutlineCheck outlines;
    outlines.add(section.outside, name + ".outside");
    for (std::size_t i = 0; i < section.holes.size(); ++i)
        outlines.add(section.holes[i], name + ".holes[" + std::to_string(i) + "]");
    if (section.carrier > section.holes.size())
        throw InvalidArgument(name + ".carrier",
                              "is " + std::to_string(section.carrier) + ", with " +
                                  std::to_string(section.holes.size()) +
                                  " holes; it must be 0 for the outside, or the number of a hole, counted from 1");
    const Outline& carrier = section.carrier == 0 ? section.outside : section.holes[section.carrier - 1];
    if (section.part >= carrier.parts.size())
        throw InvalidArgument(name + ".part", "is " + std::to_string(section.part) + "; the curve has the parts 0 to " +
                                                  std::to_string(carrier.parts.size() - 1));
    check_place(section.from, name + ".from");
    return outlines.clamped();
}

bool check(const RailSection& rail, const std::string& field) {
    if (!(std::abs(rail.inclination) <= most_inclination))
        throw InvalidArgument(
            field + ".rail_60e1.inclination",
            "is " + number_text(rail.inclination) + "; it must be a slope between -0.2 and 0.2, such as 0.025");
    check_place(rail.from, field + ".rail_60e1.from");
    return true;
}

bool check(const WheelRimSection& rim, const std::string& field) {
    check_place(rim.from, field + ".rim_s1002.from");
    if (!(rim.thickness >= 20 && rim.thickness <= 500))
        throw InvalidArgument(field + ".rim_s1002.thickness",
                              "is " + number_text(rim.thickness) + "; it must lie between 20 and 500 mm");
    return true;
}

bool check(const EdgeBlock& block, const std::string& field) {
    check_length(block.width, field + ".edge_block.width");
    check_length(block.height, field + ".edge_block.height");
    if (!(block.edge_distance >= 0 && block.edge_distance < block.width))
        throw InvalidArgument(field + ".edge_block.edge_distance",
                              "is " + number_text(block.edge_distance) +
                                  "; it must be at least 0 mm and less than the width, " + number_text(block.width));
    return true;
}

bool check(const Groove& groove, const std::string& field) {
    const std::string name = field + ".groove";
    check_length(groove.radius, name + ".radius");
    check_length(groove.depth, name + ".depth");
    check_length(groove.width, name + ".width");
    check_length(groove.height, name + ".height");
    if (groove.depth > groove.radius)
        throw InvalidArgument(name + ".depth", "is " + number_text(groove.depth) + "; it must not exceed the radius, " +
                                                   number_text(groove.radius));
    check_below(groove.depth, name + ".depth", groove.height, "the height");
    const double opening = 2 * std::sqrt(groove.depth * (2 * groove.radius - groove.depth));
    if (!(opening < groove.width))
        throw InvalidArgument(name + ".width", "is " + number_text(groove.width) + "; the groove alone is " +
                                                   short_text(opening) + " mm wide, and the block must be wider");
    return true;
}

bool check(const RoundEnd& end, const std::string& field) {
    check_length(end.radius, field + ".round_end.radius");
    check_length(end.length, field + ".round_end.length");
    return true;
}

bool check(const Disc& disc, const std::string& field) {
    check_length(disc.radius, field + ".disc.radius");
    if (disc.core == 0) return false;
    check_length(disc.core, field + ".disc.core");
    check_below(disc.core, field + ".disc.core", disc.radius, "the radius");
    return true;
}

bool check(const PlateHole& hole, const std::string& field) {
    check_length(hole.radius, field + ".plate_hole.radius");
    check_length(hole.plate_radius, field + ".plate_hole.plate_radius");
    check_below(hole.radius, field + ".plate_hole.radius", hole.plate_radius, "plate_radius");
    return true;
}

bool check(const Slab& slab, const std::string& field) {
    check_length(slab.thickness, field + ".slab.thickness");
    check_length(slab.width, field + ".slab.width");
    return true;
}

bool check(const ProfileSection& section, const std::string& field) {
    if (std::holds_alternative<ProfileFile>(section.profile.shape))
        throw InvalidArgument(field + ".profile_section.profile.file",
                              "is a file, but tables are identified by points; give the result of with_points");
    validate_below(field + ".profile_section", section.profile);
    check_length(section.depth, field + ".profile_section.depth");
    check_place(section.from, field + ".profile_section.from");
    return true;
}

void scale_lengths(std::initializer_list<double*> lengths, double factor) {
    for (double* length : lengths) *length = rounded(*length * factor);
}

void scale(SectionPoint& point, double factor) {
    scale_lengths({&point.y, &point.z}, factor);
}
void scale(LineTo& line, double factor) {
    scale(line.to, factor);
}
void scale(ArcTo& arc, double factor) {
    scale(arc.to, factor);
    scale_lengths({&arc.radius}, factor);
}
void scale(SplineTo& spline, double factor) {
    for (SectionPoint& point : spline.through) scale(point, factor);
}
void scale(Outline& outline, double factor) {
    scale(outline.start, factor);
    for (OutlinePart& part : outline.parts) std::visit([&](auto& curve) { scale(curve, factor); }, part.curve);
}
void scale(OutlineSection& section, double factor) {
    scale(section.outside, factor);
    for (Outline& hole : section.holes) scale(hole, factor);
    scale_lengths({&section.from}, factor);
}
void scale(EdgeBlock& block, double factor) {
    scale_lengths({&block.width, &block.height, &block.edge_distance}, factor);
}
void scale(Groove& groove, double factor) {
    scale_lengths({&groove.radius, &groove.depth, &groove.width, &groove.height}, factor);
}
void scale(RoundEnd& end, double factor) {
    scale_lengths({&end.radius, &end.length}, factor);
}
void scale(Disc& disc, double factor) {
    scale_lengths({&disc.radius, &disc.core}, factor);
}
void scale(PlateHole& hole, double factor) {
    scale_lengths({&hole.radius, &hole.plate_radius}, factor);
}
void scale(Slab& slab, double factor) {
    scale_lengths({&slab.thickness, &slab.width}, factor);
}

}  // namespace

void validate(const Section& section, const char* field) {
    const std::string name = field;
    if (!(section.size >= 1e-6 && section.size <= 1e6))
        throw InvalidArgument(name + ".size",
                              "is " + number_text(section.size) + "; it must be a factor between 1e-6 and 1e6");
    if (!(std::abs(section.turn) <= 10))
        throw InvalidArgument(name + ".turn", "is " + number_text(section.turn) + "; it must be a finite angle in rad");
    const bool clamped = std::visit([&](const auto& shape) { return check(shape, name); }, section.shape);
    if (!clamped && !section.free)
        throw InvalidArgument(name,
                              "has no clamped part and would move freely under any load; clamp a part, or set `free` "
                              "for coefficients above wavenumber zero only");
    if (clamped && section.free)
        throw InvalidArgument(name + ".free", "is true, but a part is clamped; remove one of them");
}

Section scaled(const Section& section, double factor) {
    Section result = section;
    std::visit(
        [&](auto& shape) {
            using Shape = std::decay_t<decltype(shape)>;
            if constexpr (std::is_same_v<Shape, RailSection> || std::is_same_v<Shape, WheelRimSection> ||
                          std::is_same_v<Shape, ProfileSection>) {
                result.size = rounded(section.size * factor);
            } else {
                result.size = 1;
                scale(shape, section.size * factor);
            }
        },
        result.shape);
    return result;
}

}  // namespace contactd
