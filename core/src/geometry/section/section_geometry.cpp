#include "geometry/section/section_geometry.hpp"

#include <algorithm>
#include <cmath>

#include "contactd/error.hpp"
#include "geometry/section/outline_checks.hpp"
#include "geometry/section/place_text.hpp"
#include "geometry/section/ready_made.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr double rounding = 1e-9;  // rounding of a strip: ends may miss a corner by this
constexpr int looks = 8;           // evaluations of the curvature of a strip

void check_numbers(int strips, double ds, const std::string& field) {
    if (strips < 1 || strips > most_strips)
        throw InvalidArgument(
            field, "has " + std::to_string(strips) + " strips; it must have 1 to " + std::to_string(most_strips));
    if (!(ds >= 1e-9 && ds <= 1e9))
        throw InvalidArgument(
            field, "has strips of the width " + number_text(ds) + "; it must be a length between 1e-9 and 1e9 mm");
}

std::string degrees(double angle) {
    return short_text(std::abs(angle) * 180 / std::numbers::pi) + " degrees";
}

// Checks strips; each function finds one kind of mistake.
class StripCheck {
   public:
    StripCheck(const SectionGeometry& section, const std::string& field)
        : section_(section),
          curve_(section.carrier()),
          field_(field),
          begin_(section.begin_of(0) + rounding * section.ds()),
          end_(section.begin_of(section.strips()) - rounding * section.ds()) {}

    void length() const {
        const double all = section_.strips() * section_.ds();
        if (!(all <= curve_.length() * (1 + rounding)))
            throw InvalidArgument(field_, "has " + number() + " strips of " + short_text(section_.ds()) +
                                              " mm, together " + short_text(all) +
                                              " mm; their curve, which begins at " + place_text(curve_.place(0).at) +
                                              ", is only " + short_text(curve_.length()) + " mm long");
    }

    void corners() const {
        for_each_piece([&](std::size_t piece, double from, double) {
            if (from > begin_ && from < end_) corner(piece, strip_at(from));
        });
    }

    void support() const {
        for_each_piece([&](std::size_t piece, double from, double to) {
            if (curve_.pieces()[piece].clamped() && to > begin_ && from < end_) refuse_clamped(std::max(from, begin_));
        });
    }

    void curvature() const {
        const double step = section_.ds() / looks;
        for (int strip = 0; strip < section_.strips(); ++strip)
            for (int look = 0; look <= looks; ++look) {
                const double near = look == 0 ? rounding : look == looks ? -rounding : 0;
                const OutlinePlace here = curve_.place(section_.begin_of(strip) + look * step + near * section_.ds());
                if (!(std::abs(here.curvature) * section_.ds() <= most_strip_turn))
                    throw InvalidArgument(
                        field_, "has strips of " + short_text(section_.ds()) + " mm, too wide for the radius of " +
                                    short_text(1 / std::abs(here.curvature)) + " mm at " + place_text(here.at) +
                                    " in strip " + std::to_string(strip) + "; use strips of at most " +
                                    short_text(most_strip_turn / std::abs(here.curvature)) + " mm there");
            }
    }

    /// Checks the way to the first strip. `from` is counted along the curve from the start of a part. `given` is the
    /// value in the section, in a field of that name.
    void way(const OutlineSection& outline, const std::string& name, double given) const {
        const auto refuse = [&](const std::string& problem) {
            throw InvalidArgument(field_ + "." + name, "is " + number_text(given) + "; " + problem);
        };
        const double length = curve_.length();
        if (std::abs(outline.from) > length)
            refuse("it exceeds the length of the curve, " + short_text(length) +
                   " mm: reduce it by a multiple of that length");
        const double start = curve_.begin_of(outline.part), low = std::min(start, start + outline.from) + rounding,
                     high = std::max(start, start + outline.from) - rounding;
        for (const double lap : {-length, 0.0, length})
            for (std::size_t i = 0; i < curve_.pieces().size(); ++i) {
                if (!curve_.pieces()[i].clamped() || i == outline.part) continue;
                if (lap + curve_.begin_of(i) < high && lap + curve_.begin_of(i + 1) > low)
                    refuse("it crosses the clamped part at " + place_text(curve_.pieces()[i].place(0).at) +
                           ", so strips would begin on another side of the body, at " +
                           place_text(curve_.place(section_.begin_of(0)).at));
            }
    }

   private:
    // Visits pieces with the arc lengths of their ends, at most twice, if strips pass the start of the curve.
    template <class Visit>
    void for_each_piece(const Visit& visit) const {
        for (const double lap : {0.0, curve_.length()})
            for (std::size_t i = 0; i < curve_.pieces().size(); ++i)
                visit(i, lap + curve_.begin_of(i), lap + curve_.begin_of(i + 1));
    }
    std::string number() const { return std::to_string(section_.strips()); }
    int strip_at(double s) const {
        const int strip = static_cast<int>((s - section_.begin_of(0)) / section_.ds());
        return std::clamp(strip, 0, section_.strips() - 1);
    }
    void corner(std::size_t piece, int strip) const {
        const double turn = curve_.turn_before(piece);
        if (std::abs(turn) <= least_corner) return;
        throw InvalidArgument(field_, "has a corner of " + degrees(turn) + " at " +
                                          place_text(curve_.pieces()[piece].place(0).at) + " in strip " +
                                          std::to_string(strip) + " of " + number() +
                                          "; strips must end at a corner: use fewer of them, or change their start");
    }
    void refuse_clamped(double s) const {
        throw InvalidArgument(field_, "is clamped at " + place_text(curve_.place(s).at) + " in its strip " +
                                          std::to_string(strip_at(s)) + " of " + number() +
                                          "; strips must lie on parts that are free to move");
    }

    const SectionGeometry& section_;
    const ClosedCurve& curve_;
    const std::string field_;
    const double begin_, end_;  // ends of all strips, except for rounding
};

/// Describes a field of the section that states where strips begin.
struct StatedFrom {
    const char* name = nullptr;
    double value = 0;
};

StatedFrom stated_from(const SectionShape& shape) {
    if (const auto* own = std::get_if<OutlineSection>(&shape)) return {"outline.from", own->from};
    if (const auto* rail = std::get_if<RailSection>(&shape)) return {"rail_60e1.from", rail->from};
    if (const auto* rim = std::get_if<WheelRimSection>(&shape)) return {"rim_s1002.from", rim->from};
    if (const auto* profile = std::get_if<ProfileSection>(&shape)) return {"profile_section.from", profile->from};
    return {};
}

}  // namespace

SectionGeometry::SectionGeometry(const Section& section, int strips, double ds, const std::string& field)
    : strips_(strips), ds_(ds) {
    validate(section, field.c_str());
    check_numbers(strips, ds, field);
    const OutlineSection outline = outline_of(section, strips * ds, field);
    const bool own = std::holds_alternative<OutlineSection>(section.shape);
    std::vector<std::string> names{own ? field + ".outline.outside" : field};
    curves_.emplace_back(outline.outside, names[0]);
    for (std::size_t i = 0; i < outline.holes.size(); ++i) {
        names.push_back(own ? field + ".outline.holes[" + std::to_string(i) + "]" : field);
        curves_.emplace_back(outline.holes[i], names.back());
    }
    check_outlines(curves_, names);
    carrier_ = outline.carrier;
    // A strip that begins at a corner, except for rounding, begins exactly there.
    const double first = carrier().reduced(carrier().begin_of(outline.part) + outline.from);
    first_ = carrier().length() - first < rounding * ds ? 0 : first;
    const StripCheck check(*this, field);
    check.length();
    check.corners();
    check.support();
    check.curvature();
    if (const StatedFrom from = stated_from(section.shape); from.name != nullptr)
        check.way(outline, from.name, from.value);
}

double SectionGeometry::perimeter() const {
    for (std::size_t piece = 0; piece < carrier().pieces().size(); ++piece)
        if (std::abs(carrier().turn_before(piece)) > least_corner) return 0;
    return carrier().length();
}

bool SectionGeometry::is_edge(double s) const {
    constexpr double near = 1e-6;  // of a strip
    for (std::size_t piece = 0; piece < carrier().pieces().size(); ++piece) {
        const double apart = carrier().reduced(s - carrier().begin_of(piece) + near * ds_);
        if (apart < 2 * near * ds_ && carrier().turn_before(piece) > least_corner) return true;
    }
    return false;
}

std::vector<StripFrame> SectionGeometry::frames() const {
    std::vector<StripFrame> frames;
    for (int strip = 0; strip < strips_; ++strip) {
        const OutlinePlace middle = carrier().place(begin_of(strip) + ds_ / 2);
        const double before = frames.empty() ? 0 : frames.back().angle;
        frames.push_back({middle.at.y, middle.at.z, before + principal(middle.angle - before)});
    }
    return frames;
}

}  // namespace contactd::geometry
