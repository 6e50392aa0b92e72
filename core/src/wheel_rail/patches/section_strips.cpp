#include "section_strips.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "contactd/count_of.hpp"
#include "geometry/section/ready_made.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

constexpr double accuracy = 1e-2;  // for coefficients: the sections hardly affect pressures of conformal contact
constexpr int block = 32;          // tables begin and end at multiples of this number of strips
constexpr int margin = 2;          // additional strips of a table beside a patch
constexpr int most_stations = 100'000'000;

/// Represents a profile that carries strips. Stations are multiples of dy along it, from its origin on, and each strip
/// is centred at one.
class StripCarrier {
   public:
    StripCarrier(const ProfileSpec& profile, const ProfileCurve& curve, double ds)
        : profile_(profile),
          ds_(ds),
          zero_(is_60e1() ? curve.arc_length(curve.end()) / 2 : curve.arc_length(curve.s_at_y(0))) {
        const double length = curve.arc_length(curve.end());
        count_of(length / ds, {"dy", "is " + number_text(ds) + " mm along a profile of " + short_text(length) + " mm",
                               "strips", "use longer elements, or conformal rotated", most_stations});
        first_ = static_cast<int>(std::ceil(-zero_ / ds + 0.5));
        last_ = static_cast<int>(std::floor((length - zero_) / ds - 0.5));
        double lowest = 0;
        for (const ProfilePoint& point : curve.points()) lowest = std::max(lowest, is_wheel() ? -point.z : point.z);
        depth_ = lowest + (curve.points().back().y - curve.points().front().y) / 2;
    }

    /// Returns the strips below `rows` rows, the first of which lies at this arc length from the beginning of the
    /// profile.
    BodyStrips below(double first_row, int rows, const Material& material, const Grid& grid) const {
        const int nearest = static_cast<int>(std::lround((first_row - zero_) / ds_));
        const int begin = std::clamp(nearest, first_, std::max(first_, last_ + 1 - rows)), end = begin + rows;
        if (std::abs(begin - nearest) > margin || end - 1 > last_)
            throw InvalidArgument("conformal", "is fem, but the contact reaches the end of the profile of the " +
                                                   name() + ", where its section has a corner: use rotated");
        const int low = std::max(first_, floored(begin - margin)), high = std::min(last_ + 1, ceiled(end + margin));
        BodyStrips strips;
        static_cast<Ics&>(strips.spec) = ics(is_wheel() ? 0.5 - high : low - 0.5);
        strips.spec.material = material;
        strips.spec.dx = grid.dx;
        strips.spec.dy = ds_;
        strips.spec.nx = grid.nx;
        strips.spec.ny = high - low;
        strips.first = is_wheel() ? high - end : begin - low;
        return strips;
    }

   private:
    bool is_wheel() const { return profile_.kind == ProfileKind::wheel; }
    std::string name() const { return is_wheel() ? "wheel" : "rail"; }
    template <class Shape>
    bool is(StandardName name) const {
        const auto* standard = std::get_if<StandardProfile>(&profile_.shape);
        return std::holds_alternative<Shape>(profile_.shape) || (standard != nullptr && standard->name == name);
    }
    bool is_60e1() const { return is<Rail60E1>(StandardName::UIC60); }
    static int floored(int station) { return block * static_cast<int>(std::floor(station / double{block})); }
    static int ceiled(int station) { return block * static_cast<int>(std::ceil(station / double{block})); }

    /// Returns the coefficients of strips that begin `from` strip widths from the origin, along the outline: for a
    /// wheel, towards its flange.
    Ics ics(double from) const {
        Ics ics;
        ics.source = IcSource::fem;
        ics.body = BodyShape::longitudinally_uniform;
        ics.accuracy = accuracy;
        ics.section.emplace();
        if (is_60e1())
            ics.section->shape = RailSection{.from = from * ds_};
        else if (is<S1002>(StandardName::S1002))
            ics.section->shape = WheelRimSection{.from = from * ds_};
        else
            ics.section->shape = outline({profile_, depth_, from * ds_});
        return ics;
    }
    /// Returns an outline that any client could provide.
    OutlineSection outline(const ProfileSection& section) const {
        try {
            return geometry::outline_of(section, 0, "section");
        } catch (const InvalidArgument& error) {
            throw InvalidArgument(
                "conformal", "is fem, but the cross-section of the " + name() + " cannot be used: " + error.what());
        }
    }

    const ProfileSpec& profile_;
    double ds_, zero_;
    int first_ = 0, last_ = 0;  // stations whose strips lie on the profile
    double depth_ = 0;          // depth of the cut: half of the profile's width below it
};

}  // namespace

PatchStrips strips_of(const WheelRailSetup& setup, const geometry::Profiles& profiles,
                      const geometry::CandidatePatch& found) {
    PatchStrips strips;
    const bool along_loaded_row = setup.conformal == Conformal::rotated_displacements,
               rotated = along_loaded_row || setup.conformal == Conformal::rotated,
               fem = setup.conformal == Conformal::fem;
    if (found.place.rows.empty() || !(rotated || fem)) return strips;
    strips.frames = strips_of(found.place).frames;
    strips.along_loaded_row = along_loaded_row;
    if (rotated) return strips;
    const Grid& grid = found.place.grid;
    const auto& [rail, wheel, pair] = setup.bodies;
    if (!rail.material.is_rigid())
        strips.rail =
            StripCarrier(setup.rail, profiles.rail, setup.dy).below(found.row_on_rail, grid.ny, rail.material, grid);
    if (!wheel.material.is_rigid())
        strips.wheel = StripCarrier(setup.wheel, profiles.wheel, setup.dy)
                           .below(found.row_on_wheel, grid.ny, wheel.material, grid);
    return strips;
}

}  // namespace contactd
