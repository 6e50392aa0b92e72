#include "codec_section.hpp"

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "codec_parts.hpp"
#include "codec_profile.hpp"
#include "contactd/below.hpp"
#include "contactd/fields/profile_spec.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/status.hpp"
#include "contactd/read_profile.hpp"
#include "contactd/section_fields.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

template <class Value>
json encode(const Value& value);
json encode(const ProfileSection& section);

/// Writes a value under its name; an alternative of a variant has its own name, which replaces that of the field.
template <class Value>
void put(json& object, const char* name, const Value& value) {
    object[name] = encode(value);
}
template <class... Alternatives>
void put(json& object, const char*, const std::variant<Alternatives...>& value) {
    constexpr auto& names = alternative_names<std::variant<Alternatives...>>;
    std::visit([&](const auto& alternative) { object[names[value.index()]] = encode(alternative); }, value);
}

/// Encodes a profile with the fields of wheels and rails, and the kind of its body.
json encode(const ProfileSection& section) {
    ArrayWriter plain_lists(ArrayEncoding::list);
    return object({{"kind", name_of(section.profile.kind)},
                   {"profile", encode_profile(section.profile, plain_lists)},
                   {"depth", finite_field(section.depth, "ics.section.profile_section.depth")},
                   {"from", finite_field(section.from, "ics.section.profile_section.from")}});
}

template <class Value>
json encode_list(const std::vector<Value>& list) {
    json result = json::array();
    for (const Value& value : list) result.push_back(encode(value));
    return result;
}

template <class Value>
json encode(const Value& value) {
    if constexpr (HasWords<Value>) {
        return name_of(value);
    } else if constexpr (std::is_floating_point_v<Value>) {
        return finite_field(value, "ics.section");
    } else if constexpr (std::is_arithmetic_v<Value>) {
        return value;
    } else if constexpr (requires { value.begin(); }) {
        return encode_list(value);
    } else {
        json object = json::object();
        for_each_named_member(value, [&](const char* name, const auto& field) { put(object, name, field); });
        return object;
    }
}

class Reader {
   public:
    explicit Reader(const Frames& frames) : frames_(frames) {}

    void get(const json& source, const std::string& field, ProfileSection& section) const {
        read_name(source["kind"], section.profile.kind);
        decode_profile(source["profile"], section.profile, frames_, field + ".profile");
        section.profile =
            renaming(in_place_of("profile", field + ".profile"), [&] { return with_points(section.profile); });
        section.depth = source["depth"].get<double>();
        section.from = source.value("from", section.from);
    }
    template <class Value>
    void get(const json& source, const std::string& field, Value& value) const {
        if constexpr (HasWords<Value>)
            read_name(source, value);
        else if constexpr (std::is_arithmetic_v<Value>)
            value = source.get<Value>();
        else
            for_each_named_member(value,
                                  [&](const char* name, auto& member) { get_member(source, field, name, member); });
    }
    template <class Value>
    void get(const json& source, const std::string& field, std::vector<Value>& list) const {
        for (std::size_t i = 0; i < source.size(); ++i)
            get(source[i], field + "[" + std::to_string(i) + "]", list.emplace_back());
    }

   private:
    template <class Value>
    void get_member(const json& source, const std::string& field, const char* name, Value& value) const {
        if (source.contains(name)) get(source[name], field + "." + name, value);
    }
    template <class... Alternatives>
    void get_member(const json& source, const std::string& field, const char*,
                    std::variant<Alternatives...>& value) const {
        constexpr auto& names = alternative_names<std::variant<Alternatives...>>;
        std::size_t found = 0;
        std::string all;
        for (const auto& name : names) {
            found += source.contains(name);
            all += (all.empty() ? "" : ", ") + std::string(name);
        }
        if (found != 1)
            throw invalid_field(field,
                                "has " + std::to_string(found) + " of the following fields; give exactly one: " + all);
        std::size_t index = 0;
        const auto read = [&]<class Alternative>(std::type_identity<Alternative>) {
            const std::string name(names[index++]);
            if (source.contains(name)) get(source[name], field + "." + name, value.template emplace<Alternative>());
        };
        (read(std::type_identity<Alternatives>()), ...);
    }

    const Frames& frames_;
};

}  // namespace

json encode_section(const Section& section) {
    return encode(section);
}

Section decode_section(const json& source, const Frames& frames, const std::string& field) {
    Section section;
    Reader(frames).get(source, field, section);
    return section;
}

}  // namespace contactd::proto
