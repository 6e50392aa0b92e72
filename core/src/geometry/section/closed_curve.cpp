#include "geometry/section/closed_curve.hpp"

#include <algorithm>
#include <cmath>

#include "contactd/error.hpp"
#include "geometry/section/place_text.hpp"
#include "types/number_text.hpp"

namespace contactd::geometry {
namespace {

constexpr double closed_within = 1e-9;  // largest gap, over its length

}  // namespace

ClosedCurve::ClosedCurve(const Outline& outline, const std::string& field) : begin_{0} {
    SectionPoint from = outline.start;
    for (std::size_t i = 0; i < outline.parts.size(); ++i) {
        pieces_.emplace_back(from, outline.parts[i], field + ".parts[" + std::to_string(i) + "]");
        begin_.push_back(begin_.back() + pieces_.back().length());
        from = end_of(outline.parts[i]);
    }
    const double open = std::hypot(from.y - outline.start.y, from.z - outline.start.z);
    if (!(open <= closed_within * length()))
        throw InvalidArgument(field, "is not closed: it ends at " + place_text(from) + ", " + short_text(open) +
                                         " mm from its start at " + place_text(outline.start) +
                                         "; add a line to its start");
}

double ClosedCurve::reduced(double s) const {
    s = std::fmod(s, length());
    if (s < 0) s += length();
    return s < length() ? s : 0;
}

std::size_t ClosedCurve::piece_at(double s) const {
    const auto behind = std::upper_bound(begin_.begin(), begin_.end() - 1, s);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(behind - begin_.begin() - 1, 0));
}

OutlinePlace ClosedCurve::place(double s) const {
    s = reduced(s);
    const std::size_t piece = piece_at(s);
    return pieces_[piece].place(std::min(s - begin_[piece], pieces_[piece].length()));
}

double ClosedCurve::turn_before(std::size_t piece) const {
    const OutlinePiece& before = pieces_[(piece + pieces_.size() - 1) % pieces_.size()];
    return principal(pieces_[piece].place(0).angle - before.place(before.length()).angle);
}

std::vector<SectionPoint> ClosedCurve::points() const {
    std::vector<SectionPoint> all;
    for (const OutlinePiece& piece : pieces_) {
        const auto points = piece.points();
        all.insert(all.end(), points.begin(), points.end());
    }
    return all;
}

}  // namespace contactd::geometry
