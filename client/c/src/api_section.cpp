// contactd.h: bodies by their cross-sections, ready-made or of a profile.
#include <string>
#include <type_traits>
#include <utility>

#include "bodies_said.hpp"
#include "contactd/read_profile.hpp"
#include "contactd/section_fields.hpp"
#include "edge.hpp"

using namespace contactd::c;
using contactd::Body;
using contactd::InvalidArgument;
using contactd::ProfileKind;
using contactd::Section;
using contactd::SectionShape;

namespace {

constexpr const char* profile_field = "ics.section.profile_section";

/// A ready-made shape of as many numbers as it has fields, in their order.
template <class Shape>
Shape shape_of(const std::vector<double>& numbers, const std::string& name) {
    Shape shape;
    std::string fields;
    std::size_t count = 0;
    contactd::for_each_named_member(
        shape, [&](const char* field, auto&) { fields += (count++ == 0 ? "" : ", ") + std::string(field); });
    if (numbers.size() != count)
        throw InvalidArgument("count", "is " + std::to_string(numbers.size()) + "; " + name + " takes " +
                                           std::to_string(count) + ": " + fields);
    std::size_t at = 0;
    contactd::for_each_named_member(shape, [&]<class Field>(const char* field, Field& value) {
        const std::string of = "ics.section." + name + "." + field;
        [[maybe_unused]] const double number = finite(numbers[at++], of.c_str());
        if constexpr (std::is_same_v<Field, double>) {
            value = number;
        } else if constexpr (std::is_enum_v<Field>) {
            constexpr double cut = CONTACTD_CUT, foot = CONTACTD_FOOT;
            if (number != cut && number != foot) throw InvalidArgument(of, "must be CONTACTD_CUT or CONTACTD_FOOT");
            value = static_cast<Field>(static_cast<int>(number));
        }
    });
    return shape;
}

/// Of the words CONTACTD_RAIL_60E1 to CONTACTD_SLAB, which count as the alternatives behind the outline do.
template <std::size_t... index>
SectionShape ready_made(std::int32_t shape, const std::vector<double>& numbers, std::index_sequence<index...>) {
    SectionShape result;
    const auto take = [&]<std::size_t which>(std::integral_constant<std::size_t, which>) {
        if (static_cast<std::size_t>(shape) == which)
            result = shape_of<std::variant_alternative_t<which, SectionShape>>(
                numbers, std::string(contactd::alternative_names<SectionShape>[which]));
    };
    (take(std::integral_constant<std::size_t, index + CONTACTD_RAIL_60E1>()), ...);
    return result;
}

void set_profile(Said& said, std::int32_t body, contactd::ProfileSpec profile, double smoothing_length, double depth,
                 double from) {
    const std::string field = profile_field;
    std::get<contactd::ProfilePoints>(profile.shape).smoothing_length =
        finite(smoothing_length, (field + ".profile.smoothing_length").c_str());
    const SectionShape shape = contactd::ProfileSection{std::move(profile), finite(depth, (field + ".depth").c_str()),
                                                        finite(from, (field + ".from").c_str())};
    validate(Section{shape}, "ics.section");
    set_section(said, body, shape);
}

}  // namespace

std::int32_t contactd_set_section(contactd_contact* contact, std::int32_t body, std::int32_t shape,
                                  const double* numbers, std::int32_t count) {
    return set_up(contact, "coefficients", [&](Said& said) {
        if (shape < CONTACTD_RAIL_60E1 || shape > CONTACTD_SLAB)
            throw InvalidArgument("shape", "is " + std::to_string(shape) +
                                               "; it must be one of the words CONTACTD_RAIL_60E1 to CONTACTD_SLAB");
        const SectionShape made =
            ready_made(shape, array(numbers, count, "numbers"), std::make_index_sequence<CONTACTD_SLAB>());
        validate(Section{made}, "ics.section");
        set_section(said, body, made);
    });
}

std::int32_t contactd_set_profile_points(contactd_contact* contact, std::int32_t body, std::int32_t kind,
                                         const double* y, const double* z, std::int32_t count, double smoothing_length,
                                         double depth, double from) {
    return set_up(contact, "coefficients", [&](Said& said) {
        const auto of_y = array(y, count, "profile.y"), of_z = array(z, count, "profile.z");
        contactd::ProfilePoints points;
        for (std::size_t i = 0; i < of_y.size(); ++i) {
            const std::string field = std::string(profile_field) + ".profile.points[" + std::to_string(i) + "]";
            points.points.push_back({finite(of_y[i], field.c_str()), finite(of_z[i], field.c_str())});
        }
        const auto of = static_cast<ProfileKind>(word(kind, CONTACTD_RAIL, "kind"));
        set_profile(said, body, {of, std::move(points)}, smoothing_length, depth, from);
    });
}

std::int32_t contactd_set_profile_file(contactd_contact* contact, std::int32_t body, std::int32_t kind,
                                       const char* path, double smoothing_length, double depth, double from) {
    return set_up(contact, "coefficients", [&](Said& said) {
        const auto of = static_cast<ProfileKind>(word(kind, CONTACTD_RAIL, "kind"));
        set_profile(said, body, contactd::read_profile(std::filesystem::path(given(path, "path")), of),
                    smoothing_length, depth, from);
    });
}

std::int32_t contactd_set_section_place(contactd_contact* contact, std::int32_t body, double size, double turn) {
    return set_up(contact, "coefficients", [&](Said& said) {
        finite(size, "ics.section.size");
        finite(turn, "ics.section.turn");
        each_body(said, body, [&](Body& changed) { (void)prism_of(changed); });
        each_body(said, body, [&](Body& changed) {
            Section& section = *prism_of(changed).section;
            section.size = size;
            section.turn = turn;
        });
    });
}

std::int32_t contactd_set_section_accuracy(contactd_contact* contact, std::int32_t body, double accuracy) {
    return set_up(contact, "coefficients", [&](Said& said) {
        if (!(accuracy == 0 || (accuracy >= contactd::finest_accuracy && accuracy <= contactd::coarsest_accuracy)))
            throw InvalidArgument("ics.accuracy", "must lie in [1e-4, 0.1], or be 0: half-spaces that turn");
        each_body(said, body, [&](Body& changed) { (void)prism_of(changed); });
        each_body(said, body, [&](Body& changed) {
            contactd::Ics& ics = prism_of(changed);
            ics.accuracy = accuracy;
            ics.source = accuracy == 0 ? contactd::IcSource::analytic : contactd::IcSource::fem;
        });
    });
}
