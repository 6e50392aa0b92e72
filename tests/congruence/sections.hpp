// Reads cross-sections and curved columns, for the driver in C++.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "contactd/client/client.hpp"
#include "words.hpp"

namespace contactd {

inline SectionShape ready_made(const Words& w) {
    const auto n = [&](std::size_t i) { return number(w[3 + i]); };
    const std::string& shape = w[2];
    if (shape == "rail_60e1") return RailSection{n(0), n(1) == 0 ? RailSupport::cut : RailSupport::foot, n(2)};
    if (shape == "rim_s1002") return WheelRimSection{n(0), n(1)};
    if (shape == "edge_block") return EdgeBlock{n(0), n(1), n(2)};
    if (shape == "groove") return Groove{n(0), n(1), n(2), n(3)};
    if (shape == "round_end") return RoundEnd{n(0), n(1)};
    if (shape == "disc") return Disc{n(0), n(1)};
    if (shape == "plate_hole") return PlateHole{n(0), n(1)};
    return Slab{n(0), n(1)};
}

/// Reads "body kind curvature smoothing depth from": a parabola.
inline SectionShape profile(const Words& w) {
    ProfilePoints points;
    for (int y = -34; y <= 34; ++y) points.points.push_back({double(y), y * y * number(w[3])});
    points.smoothing_length = number(w[4]);
    const ProfileKind kind = w[2] == "rail" ? ProfileKind::rail : ProfileKind::wheel;
    return ProfileSection{{kind, points}, number(w[5]), number(w[6])};
}

inline SectionPoint point(const Words& w, std::size_t at) {
    return {number(w[at]), number(w[at + 1])};
}

/// Adds a part, or another element of an outline.
inline void change_outline(OutlineSection& section, const Words& w) {
    auto& parts = (section.holes.empty() ? section.outside : section.holes.back()).parts;
    if (w[0] == "line") parts.push_back({LineTo{point(w, 2)}, w[4] == "1"});
    if (w[0] == "arc") parts.push_back({ArcTo{point(w, 2), number(w[4])}, w[5] == "1"});
    if (w[0] == "spline") {
        SplineTo spline;
        for (std::size_t at = 3; at + 1 < w.size(); at += 2) spline.through.push_back(point(w, at));
        parts.push_back({spline, w[2] == "1"});
    }
    if (w[0] == "hole") section.holes.push_back({point(w, 2)});
    if (w[0] == "first_column") {
        section.carrier = std::stoul(w[2]);
        section.part = std::stoul(w[3]);
        section.from = number(w[4]);
    }
}

/// Reads "direction origin": those of the lower body's section, or of a plane.
inline ContactColumns columns(const Words& w, const ContactSetup& setup, client::Client& client) {
    ContactColumns result;
    result.direction = number(w[1]);
    result.origin = point(w, 2);
    if (w[0] == "flat_columns") {
        for (int row = 0; row < setup.grid.ny; ++row) result.frames.push_back({double(row), 0, 0});
        return result;
    }
    IcSpec spec;
    spec.body = BodyShape::longitudinally_uniform;
    spec.section = setup.bodies.lower.computed()->section;
    spec.material = {1, 0.25};
    spec.dx = spec.dy = setup.grid.dy;
    spec.nx = 1;
    spec.ny = setup.grid.ny;
    result.frames = client.get_ic(spec).frames;
    return result;
}

/// Applies a word to a body; returns false if the word does not concern sections.
inline bool change_section(Body& body, const Words& w) {
    const auto begin = [&](SectionShape shape) {
        Ics ics;
        ics.source = IcSource::fem;
        ics.body = BodyShape::longitudinally_uniform;
        ics.accuracy = 1e-3;
        ics.section = Section{std::move(shape)};
        body.ics = ics;
        return true;
    };
    if (w[0] == "section") return begin(ready_made(w));
    if (w[0] == "profile") return begin(profile(w));
    if (w[0] == "outline") return begin(OutlineSection{.outside = {point(w, 2)}});
    auto* ics = std::get_if<Ics>(&body.ics);
    if (ics == nullptr || !ics->section) return false;
    if (w[0] == "section_place") {
        std::tie(ics->section->size, ics->section->turn) = std::pair(number(w[2]), number(w[3]));
    } else if (w[0] == "section_accuracy") {
        ics->accuracy = number(w[2]);
        ics->source = ics->accuracy == 0 ? IcSource::analytic : IcSource::fem;
    } else if (auto* outline = std::get_if<OutlineSection>(&ics->section->shape)) {
        change_outline(*outline, w);
    }
    return true;
}

inline bool is_of_sections(const std::string& word) {
    for (const char* known : {"section", "section_place", "section_accuracy", "profile", "outline", "line", "arc",
                              "spline", "hole", "first_column"})
        if (word == known) return true;
    return false;
}

}  // namespace contactd
