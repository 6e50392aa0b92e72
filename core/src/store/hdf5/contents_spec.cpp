// Reads and writes the group `spec`: the identity of a table.
#include "contactd/fem_fields.hpp"
#include "contactd/fields/ic_spec.hpp"
#include "contents_parts.hpp"
#include "section_numbers.hpp"

namespace contactd {

void write_fem(const WritableGroup& group, const FemSpec& fem) {
    for_each_fem_field([&](const auto& field) { put(group, field.name, fem.*field.member); });
}

FemSpec read_fem(const Group& group) {
    FemSpec fem;
    for_each_fem_field([&](const auto& field) { get(group, field.name, fem.*field.member); });
    return fem;
}

namespace {

void write_layers(const WritableGroup& group, const Layers& body) {
    std::vector<double> thickness, G, nu;
    for (const Layer& layer : body.layers) {
        thickness.push_back(layer.thickness);
        G.push_back(layer.G);
        nu.push_back(layer.nu);
    }
    put(group, "thickness", thickness);
    put(group, "G", G);
    put(group, "nu", nu);
    if (body.base.is_rigid()) return;
    put(group, "base_G", body.base.G);
    put(group, "base_nu", body.base.nu);
}

Layers read_layers(const Group& group) {
    Layers body;
    const std::vector<double> thickness = numbers(group, "thickness"), G = numbers(group, "G"),
                              nu = numbers(group, "nu");
    if (thickness.empty() || thickness.size() != G.size() || G.size() != nu.size())
        throw DamagedTable("The layers of the file are incomplete.");
    for (std::size_t i = 0; i < G.size(); ++i) body.layers.push_back({thickness[i], G[i], nu[i]});
    body.base = group.has("base_G") ? Material{number(group, "base_G"), number(group, "base_nu")} : Material::rigid();
    return body;
}

/// Writes a dataset, because attributes must be small.
void write_section(const WritableGroup& group, const Section& section, bool has_dimensions) {
    const std::vector<double> numbers = numbers_of(section);
    group.contents.datasets[group.prefix + "section"] = {{numbers.size()}, UnsetArray(numbers.begin(), numbers.end())};
    put(group.below("section"), "units", has_dimensions ? "lengths in mm" : "lengths over the width of a column");
}

Section read_section(const Group& group) {
    const UnsetArray& values = array(group, "section", 1).values;
    return section_from({values.begin(), values.end()});
}

}  // namespace

void write_spec(const WritableGroup& group, const IcSpec& spec) {
    put(group, "body", spec.body);
    put(group, "source", spec.source);
    put(group, "load_shape", spec.load_shape);
    put(group, "dy_over_dx", spec.dy / spec.dx);
    if (!is_dimensionless(spec)) {
        put(group, "dx", spec.dx);
        put(group, "dy", spec.dy);
        put(group, "G", spec.material.G);
    }
    put(group, "any_nu", static_cast<long long>(spec.any_nu));
    if (!spec.any_nu) put(group, "nu", spec.material.nu);
    for_each_ics_part([&]<class Part>(const IcsPart<Part>& part) {
        const std::optional<Part>& value = spec.*part.member;
        if (!value) return;
        const WritableGroup object = group.below(part.name);
        for_each_part_field<Part>(
            [&](const PartField<Part>& field) { put(object, field.name, (*value).*field.member); });
    });
    if (spec.section) write_section(group, *spec.section, !is_dimensionless(spec));
    if (spec.layered) write_layers(group.below("layers"), *spec.layered);
    if (spec.accuracy != 0) {
        put(group, "accuracy", spec.accuracy);
        if (spec.body == BodyShape::block) put(group, "L_over_h", spec.fem.L_over_h);
    } else if (spec.source == IcSource::fem) {
        write_fem(group, spec.fem);
    }
}

IcSpec read_spec(const Group& group) {
    IcSpec spec;
    const bool has_dimensions = group.has("dx");
    spec.dx = has_dimensions ? number(group, "dx") : 1;
    spec.dy = number(group, has_dimensions ? "dy" : "dy_over_dx");
    spec.body = named<BodyShape>(group, "body");
    spec.source = named<IcSource>(group, "source");
    spec.load_shape = named<LoadShape>(group, "load_shape");
    spec.any_nu = integer(group, "any_nu") != 0;
    spec.material = {has_dimensions ? number(group, "G") : 1, spec.any_nu ? 0 : number(group, "nu")};
    for_each_ics_part([&]<class Part>(const IcsPart<Part>& part) {
        if (!group.has_group(part.name)) return;
        const Group object = group.below(part.name);
        Part& value = (spec.*part.member).emplace();
        for_each_part_field<Part>([&](const PartField<Part>& field) { get(object, field.name, value.*field.member); });
    });
    if (group.contents.datasets.contains(group.prefix + "section")) spec.section = read_section(group);
    if (group.has_group("layers")) spec.layered = read_layers(group.below("layers"));
    if (group.has("accuracy")) {
        spec.accuracy = number(group, "accuracy");
        spec.fem.L_over_h = spec.body == BodyShape::block ? number(group, "L_over_h") : 0;
    } else if (spec.source == IcSource::fem) {
        spec.fem = read_fem(group);
    }
    return spec;
}

}  // namespace contactd
