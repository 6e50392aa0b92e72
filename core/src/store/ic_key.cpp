#include <map>
#include <string>
#include <type_traits>

#include "contactd/fem_fields.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "contactd/ic_store.hpp"
#include "sha256.hpp"
#include "store/hdf5/section_numbers.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

/// Represents canonical JSON: members in alphabetical order, no white space, numbers by their shortest text.
class CanonicalObject {
   public:
    void add(const char* name, double number) { members_[name] = number_text(number); }
    template <HasWords Enum>
    void add(const char* name, Enum value) {
        members_[name] = '"' + std::string(name_of(value)) + '"';
    }
    void add(const char* name, const std::optional<double>& number) {
        if (number) add(name, *number);
    }
    void add_object(const char* name, const CanonicalObject& object) { members_[name] = object.text(); }
    /// Adds a list in order.
    void add_list(const char* name, const std::vector<CanonicalObject>& list) {
        std::string text;
        for (const CanonicalObject& object : list) text += (text.empty() ? "" : ",") + object.text();
        members_[name] = '[' + text + ']';
    }
    void add_numbers(const char* name, const std::vector<double>& numbers) {
        std::string text;
        for (const double number : numbers) text += (text.empty() ? "" : ",") + number_text(number);
        members_[name] = '[' + text + ']';
    }
    void add_true(const char* name) { members_[name] = "true"; }

    std::string text() const {
        std::string text;
        for (const auto& [name, value] : members_) text += (text.empty() ? "\"" : ",\"") + name + "\":" + value;
        return "{" + text + "}";
    }

   private:
    std::map<std::string, std::string> members_;
};

/// Identifies the choice of meshes for an accuracy. Increase it if tables of an earlier choice must not be used any
/// more, because they miss the accuracy or state wrong errors. Tables that are finer than necessary may remain.
constexpr int accuracy_recipe = 2;
/// Identifies the recipe of longitudinally uniform bodies. Tables before the third state errors that are only valid for
/// elements as long as the width of strips.
constexpr int uniform_recipe = 3;
/// Identifies the recipe of blocks, also on given meshes. Tables before the third do not state the modelling error.
constexpr int block_recipe = 3;

CanonicalObject canonical(const FemSpec& fem) {
    CanonicalObject json;
    for_each_fem_field([&]<class Value>(const FemField<Value>& field) {
        const Value& value = fem.*field.member;
        if (!field.in_key) return;
        if constexpr (std::is_integral_v<Value>)
            json.add(field.name, static_cast<double>(value));
        else
            json.add(field.name, value);
    });
    return json;
}

template <class Part>
CanonicalObject canonical(const Part& part) {
    CanonicalObject json;
    for_each_part_field<Part>([&](const PartField<Part>& field) { json.add(field.name, part.*field.member); });
    return json;
}

CanonicalObject canonical(const Material& material) {
    CanonicalObject json;
    json.add("G", material.G);
    json.add("nu", material.nu);
    return json;
}

CanonicalObject canonical(const Layer& layer) {
    CanonicalObject json = canonical(layer.material());
    json.add("thickness", layer.thickness);
    return json;
}

CanonicalObject canonical(const IcSpec& spec) {
    CanonicalObject json;
    if (spec.accuracy != 0) json.add("accuracy", spec.accuracy);
    if (spec.any_nu) json.add_true("any_nu");
    json.add("body", spec.body);
    json.add("dy_over_dx", spec.dy);
    if (spec.source == IcSource::fem && spec.accuracy == 0) json.add_object("fem", canonical(spec.fem));
    if (spec.accuracy != 0 && spec.body == BodyShape::block) {
        CanonicalObject size;  // size of the body; the mesh is chosen later
        size.add("L_over_h", spec.fem.L_over_h);
        json.add_object("fem", size);
    }
    for_each_ics_part([&](const auto& part) {
        if (const auto& value = spec.*part.member) json.add_object(part.name, canonical(*value));
    });
    if (spec.layered) {
        std::vector<CanonicalObject> layers;
        for (const Layer& layer : spec.layered->layers) layers.push_back(canonical(layer));
        json.add_list("layers", layers);
        if (!spec.layered->base.is_rigid()) json.add_object("base", canonical(spec.layered->base));
    }
    json.add("load_shape", spec.load_shape);
    if (spec.section) {
        json.add_numbers("section", numbers_of(*spec.section));
        json.add("columns", static_cast<double>(spec.ny));
    }
    if (!spec.any_nu) json.add("nu", spec.material.nu);
    if (spec.body == BodyShape::block)
        json.add("recipe", block_recipe);
    else if (spec.accuracy != 0)
        json.add("recipe", spec.section ? uniform_recipe : accuracy_recipe);
    json.add("source", spec.source);
    return json;
}

}  // namespace

std::string ic_key(const IcSpec& spec) {
    const std::string text = canonical(dimensionless(spec)).text();
    return sha256_hex({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

bool is_ic_key(std::string_view text) {
    return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace contactd
