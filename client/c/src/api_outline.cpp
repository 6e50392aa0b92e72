// contactd.h: cross-sections by their outlines, part by part.
#include <string>
#include <utility>

#include "bodies_said.hpp"
#include "edge.hpp"

using namespace contactd::c;
using contactd::Body;
using contactd::InvalidArgument;
using contactd::Outline;
using contactd::OutlinePart;
using contactd::OutlineSection;
using contactd::SectionPoint;

namespace {

SectionPoint point(double y, double z, const std::string& field) {
    return {finite(y, (field + ".y").c_str()), finite(z, (field + ".z").c_str())};
}

OutlineSection& outline_of(Body& body) {
    auto* section = std::get_if<OutlineSection>(&prism_of(body).section->shape);
    if (section == nullptr)
        throw InvalidArgument("ics.section.outline", "was not begun; contactd_set_outline does it first");
    return *section;
}

/// Calls `change` with the outline of each body that the word names; with none of them when one has none.
template <class Change>
void each_outline(Said& said, std::int32_t body, const Change& change) {
    each_body(said, body, [](Body& changed) { (void)outline_of(changed); });
    each_body(said, body, [&](Body& changed) { change(outline_of(changed)); });
}

/// Adds the part that `make` makes, below the field of its kind, to the outside, or to the hole that was begun last.
template <class Make>
std::int32_t add(contactd_contact* contact, std::int32_t body, std::int32_t clamped, const Make& make) {
    return set_up(contact, "coefficients", [&](Said& said) {
        const OutlinePart part{make("ics.section.outline.part"), word(clamped, 1, "clamped") != 0};
        each_outline(said, body, [&](OutlineSection& section) {
            (section.holes.empty() ? section.outside : section.holes.back()).parts.push_back(part);
        });
    });
}

}  // namespace

std::int32_t contactd_set_outline(contactd_contact* contact, std::int32_t body, double y, double z) {
    return set_up(contact, "coefficients", [&](Said& said) {
        OutlineSection section;
        section.outside.start = point(y, z, "ics.section.outline.outside.start");
        set_section(said, body, section);
    });
}

std::int32_t contactd_add_hole(contactd_contact* contact, std::int32_t body, double y, double z) {
    return set_up(contact, "coefficients", [&](Said& said) {
        const Outline hole{point(y, z, "ics.section.outline.holes.start")};
        each_outline(said, body, [&](OutlineSection& section) { section.holes.push_back(hole); });
    });
}

std::int32_t contactd_add_line(contactd_contact* contact, std::int32_t body, double y, double z, std::int32_t clamped) {
    return add(contact, body, clamped,
               [&](const std::string& of) { return contactd::LineTo{point(y, z, of + ".to")}; });
}

std::int32_t contactd_add_arc(contactd_contact* contact, std::int32_t body, double y, double z, double radius,
                              std::int32_t clamped) {
    return add(contact, body, clamped, [&](const std::string& of) {
        return contactd::ArcTo{point(y, z, of + ".to"), finite(radius, (of + ".radius").c_str())};
    });
}

std::int32_t contactd_add_spline(contactd_contact* contact, std::int32_t body, const double* y, const double* z,
                                 std::int32_t count, std::int32_t clamped) {
    return add(contact, body, clamped, [&](const std::string& of) {
        const auto of_y = array(y, count, "spline.y"), of_z = array(z, count, "spline.z");
        contactd::SplineTo spline;
        for (std::size_t i = 0; i < of_y.size(); ++i)
            spline.through.push_back(point(of_y[i], of_z[i], of + ".through[" + std::to_string(i) + "]"));
        return spline;
    });
}

std::int32_t contactd_set_first_column(contactd_contact* contact, std::int32_t body, std::int32_t carrier,
                                       std::int32_t part, double from) {
    return set_up(contact, "coefficients", [&](Said& said) {
        const auto count = [](std::int32_t value, const std::string& field) {
            if (value < 0) throw InvalidArgument(field, "is " + std::to_string(value) + "; it counts from 0");
            return static_cast<std::size_t>(value);
        };
        const std::size_t curve = count(carrier, "ics.section.outline.carrier");
        const std::size_t begins = count(part, "ics.section.outline.part");
        finite(from, "ics.section.outline.from");
        each_outline(said, body, [&](OutlineSection& section) {
            section.carrier = curve;
            section.part = begins;
            section.from = from;
        });
    });
}
