// Reads and writes the datasets of an IC file, and the attributes of its root.
#include "contactd/ic_contents.hpp"

#include <array>
#include <string>
#include <utility>

#include "contents_parts.hpp"
#include "file_format.hpp"

namespace contactd {
namespace {

constexpr std::size_t most_offsets = 1 << 22;  // limit of a table
constexpr std::size_t most_tables = 1000;      // limit of a family

constexpr const char* table_name = "influence_coefficients";
constexpr const char* family_name = "influence_coefficients_family";
constexpr const char* units = "dx/G: multiply by the element size dx and divide by the shear modulus G";
constexpr const char* units_with_dimensions = "mm^3/N, of spec/dx, spec/dy and spec/G";

std::vector<std::size_t> shape_of(const IcTable& table) {
    return {3, 3, static_cast<std::size_t>(table.ny), static_cast<std::size_t>(table.nx)};
}

void write_table(const WritableGroup& file, const IcTable& table, bool has_dimensions) {
    file.contents.datasets[table_name] = {shape_of(table), table.values};
    const WritableGroup dataset = file.below(table_name);
    put(dataset, "axes", "displacement (x, y, z), load (x, y, z), offset along y, offset along x");
    put(dataset, "units", has_dimensions ? units_with_dimensions : units);
}

/// Writes the table of the strips and offsets of a request for other programs. contactd itself reads the transform.
void write_strips(const WritableGroup& file, const IcRecord& record) {
    auto table = std::get<StripTable>(body_table(record, record.spec));
    const auto nx = static_cast<std::size_t>(table.nx), strips = static_cast<std::size_t>(table.strips);
    file.contents.datasets[table_name] = {{3, 3, strips, strips, nx}, std::move(table.values)};
    const WritableGroup dataset = file.below(table_name);
    put(dataset, "axes",
        "displacement (x, along the outline, outward), load (the same), observed column, loaded column, offset along "
        "x");
    put(dataset, "units", units_with_dimensions);
}

void write_family(const WritableGroup& file, const std::vector<IcTable>& family) {
    std::vector<std::size_t> shape = shape_of(family.front());
    shape.insert(shape.begin(), family.size());
    UnsetArray values;
    values.reserve(family.size() * family.front().values.size());
    for (const IcTable& table : family) values.insert(values.end(), table.values.begin(), table.values.end());
    file.contents.datasets[family_name] = {std::move(shape), std::move(values)};
    const WritableGroup dataset = file.below(family_name);
    put(dataset, "axes",
        "Poisson's ratio (evidence/family_nu), displacement (x, y, z), load (x, y, z), offset along y, offset along x");
    put(dataset, "units", units);
}

IcTable read_table(FileContents& contents) {
    const std::vector<std::size_t>& shape = array({contents}, table_name, 4).shape;
    if (shape[0] != 3 || shape[1] != 3 || shape[2] < 1 || shape[3] < 1 || shape[2] > most_offsets ||
        shape[3] > most_offsets / shape[2])
        throw DamagedTable("The table does not have the shape [3, 3, ny, nx].");
    IcTable table;
    table.ny = static_cast<int>(shape[2]);
    table.nx = static_cast<int>(shape[3]);
    table.values = std::move(contents.datasets[table_name].values);
    return table;
}

/// Reads `size` tables, each of the extent of `first`.
std::vector<IcTable> read_family(const FileContents& contents, std::size_t size, const IcTable& first) {
    if (!contents.datasets.contains(family_name))
        throw DamagedTable("The spec is that of a family, which the file does not contain.");
    const FileContents::Array& all = array({contents}, family_name, 5);
    std::vector<std::size_t> shape = shape_of(first);
    shape.insert(shape.begin(), size);
    if (size < 2 || size > most_tables || all.shape != shape)
        throw DamagedTable(
            "The family does not have the shape [n, 3, 3, ny, nx] with at least two tables, one for each entry of "
            "evidence/family_nu.");
    std::vector<IcTable> family;
    auto next = all.values.begin();
    for (std::size_t n = 0; n < size; ++n) {
        IcTable& table = family.emplace_back();
        table.nx = first.nx;
        table.ny = first.ny;
        const auto end = next + static_cast<std::ptrdiff_t>(first.values.size());
        table.values.assign(next, end);
        next = end;
    }
    return family;
}

}  // namespace

FileContents contents_of(const IcRecord& record) {
    FileContents contents;
    const WritableGroup file{contents};
    put(file, format_name, static_cast<long long>(format_version));
    write_spec(file.below("spec"), record.spec);
    write_evidence(file.below("evidence"), record.evidence);
    if (const auto* spectrum = std::get_if<StripSpectrum>(&record.tables)) {
        write_spectrum(file, *spectrum);
        if (!is_dimensionless(record.spec)) write_strips(file, record);
    } else if (std::holds_alternative<StripTable>(record.tables)) {
        throw StoreError(
            "Tables of longitudinally uniform bodies that are made of half-spaces are not kept in files: making one is "
            "quicker.");
    } else {
        write_table(file, record.table(), !is_dimensionless(record.spec));
    }
    if (const auto* family = std::get_if<IcFamily>(&record.tables)) write_family(file, family->tables);
    return contents;
}

void check_format(long long found) {
    if (found == format_version) return;
    const std::string text =
        "The file has format " + std::to_string(found) + ", not " + std::to_string(format_version) + ".";
    if (found > format_version) throw NewerFormat(text + " A newer version of contactd wrote it.");
    throw DamagedTable(text);
}

IcRecord record_from(FileContents contents) {
    for (const auto& [path, dataset] : contents.datasets) {
        std::size_t size = 1;
        for (const std::size_t extent : dataset.shape) size *= extent;
        if (size != dataset.values.size())
            throw DamagedTable(path + " of the file does not have the size of its shape.");
    }
    const Group file{contents};
    check_format(long_integer(file, format_name));
    IcRecord record;
    record.spec = read_spec(file.below("spec"));
    record.evidence = read_evidence(file.below("evidence"));
    if (record.spec.section) {
        record.tables = read_spectrum(file, record.spec.material.nu);
    } else {
        IcTable table = read_table(contents);
        if (record.spec.any_nu)
            record.tables = IcFamily{read_family(contents, record.evidence.family_nu.size(), table)};
        else
            record.tables = std::move(table);
    }
    record.spec.nx = extent_of(record.tables).nx;
    record.spec.ny = extent_of(record.tables).ny;
    return record;
}

}  // namespace contactd
