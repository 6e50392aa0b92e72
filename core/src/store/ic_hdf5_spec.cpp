// Group `spec`: what a table is.
#include "contactd/fem_fields.hpp"
#include "hdf5_attributes.hpp"
#include "ic_hdf5_parts.hpp"
#include "section_numbers.hpp"

namespace contactd {

void write_fem(H5::Group& group, const FemSpec& fem) {
    for_each_fem_field([&](const auto& field) { put(group, field.name, fem.*field.member); });
}

FemSpec read_fem(const H5::Group& group) {
    FemSpec fem;
    for_each_fem_field([&](const auto& field) { get(group, field.name, fem.*field.member); });
    return fem;
}

namespace {

void write_layers(H5::Group group, const Layers& body) {
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

Layers read_layers(const H5::Group& group) {
    Layers body;
    const std::vector<double> thickness = numbers(group, "thickness"), G = numbers(group, "G"),
                              nu = numbers(group, "nu");
    if (thickness.empty() || thickness.size() != G.size() || G.size() != nu.size())
        throw DamagedTable("The layers of the file are not complete.");
    for (std::size_t i = 0; i < G.size(); ++i) body.layers.push_back({thickness[i], G[i], nu[i]});
    body.base =
        group.attrExists("base_G") ? Material{number(group, "base_G"), number(group, "base_nu")} : Material::rigid();
    return body;
}

/// A dataset: attributes are small.
void write_section(H5::Group& group, const Section& section, bool has_dimensions) {
    const std::vector<double> numbers = numbers_of(section);
    const hsize_t size = numbers.size();
    H5::DataSet dataset = group.createDataSet("section", H5::PredType::IEEE_F64LE, H5::DataSpace(1, &size));
    dataset.write(numbers.data(), H5::PredType::NATIVE_DOUBLE);
    put(dataset, "units", has_dimensions ? "lengths in mm" : "lengths over the width of a column");
}

Section read_section(const H5::DataSet& dataset) {
    constexpr hssize_t most = 1 << 20;
    const hssize_t size = dataset.getSpace().getSimpleExtentNpoints();
    if (size < 1 || size > most) throw DamagedTable("The section of the file has too many numbers, or none.");
    std::vector<double> values(static_cast<std::size_t>(size));
    dataset.read(values.data(), H5::PredType::NATIVE_DOUBLE);
    return section_from(values);
}

}  // namespace

void write_spec(H5::Group group, const IcSpec& spec) {
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
        H5::Group object = group.createGroup(part.name);
        for_each_part_field<Part>(
            [&](const PartField<Part>& field) { put(object, field.name, (*value).*field.member); });
    });
    if (spec.section) write_section(group, *spec.section, !is_dimensionless(spec));
    if (spec.layered) write_layers(group.createGroup("layers"), *spec.layered);
    if (spec.accuracy != 0) {
        put(group, "accuracy", spec.accuracy);
        if (spec.body == BodyShape::block) put(group, "L_over_h", spec.fem.L_over_h);
    } else if (spec.source == IcSource::fem) {
        write_fem(group, spec.fem);
    }
}

IcSpec read_spec(const H5::Group& group) {
    IcSpec spec;
    const bool has_dimensions = group.attrExists("dx");
    spec.dx = has_dimensions ? number(group, "dx") : 1;
    spec.dy = number(group, has_dimensions ? "dy" : "dy_over_dx");
    spec.body = named<BodyShape>(group, "body");
    spec.source = named<IcSource>(group, "source");
    spec.load_shape = named<LoadShape>(group, "load_shape");
    spec.any_nu = integer(group, "any_nu") != 0;
    spec.material = {has_dimensions ? number(group, "G") : 1, spec.any_nu ? 0 : number(group, "nu")};
    for_each_ics_part([&]<class Part>(const IcsPart<Part>& part) {
        if (!group.nameExists(part.name)) return;
        const H5::Group object = group.openGroup(part.name);
        Part& value = (spec.*part.member).emplace();
        for_each_part_field<Part>([&](const PartField<Part>& field) { get(object, field.name, value.*field.member); });
    });
    if (group.nameExists("section")) spec.section = read_section(group.openDataSet("section"));
    if (group.nameExists("layers")) spec.layered = read_layers(group.openGroup("layers"));
    if (group.attrExists("accuracy")) {
        spec.accuracy = number(group, "accuracy");
        spec.fem.L_over_h = spec.body == BodyShape::block ? number(group, "L_over_h") : 0;
    } else if (spec.source == IcSource::fem) {
        spec.fem = read_fem(group);
    }
    return spec;
}

}  // namespace contactd
