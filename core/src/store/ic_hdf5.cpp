#include "ic_hdf5.hpp"

#include <H5Cpp.h>

#include <array>
#include <mutex>
#include <string>

#include "hdf5_attributes.hpp"
#include "ic_hdf5_parts.hpp"

namespace contactd {
namespace {

constexpr int format_version = 2;
constexpr std::size_t core_increment = 1 << 20;
constexpr hsize_t most_offsets = 1 << 22;  // of a table
constexpr std::size_t most_tables = 1000;  // of a family

/// Debian's HDF5 is not built thread-safe: one thread at a time.
std::mutex& hdf5_mutex() {
    static std::mutex mutex;
    return mutex;
}

// --- tables ---------------------------------------------------------------------------------------------------------

constexpr const char* table_name = "influence_coefficients";
constexpr const char* family_name = "influence_coefficients_family";
constexpr const char* units = "dx/G: multiply by the element size dx and divide by the shear modulus G";

using TableShape = std::array<hsize_t, 4>;
using FamilyShape = std::array<hsize_t, 5>;

TableShape shape_of(const IcTable& table) {
    return {3, 3, static_cast<hsize_t>(table.ny), static_cast<hsize_t>(table.nx)};
}

template <std::size_t axes>
H5::DataSet create(const H5::H5File& file, const char* name, const std::array<hsize_t, axes>& shape) {
    return file.createDataSet(name, H5::PredType::IEEE_F64LE, H5::DataSpace(axes, shape.data()));
}

/// The part of a family's data space that holds its table number `n`.
H5::DataSpace part_of(const H5::DataSpace& family, hsize_t n, const TableShape& table) {
    const FamilyShape start{n, 0, 0, 0, 0}, count{1, table[0], table[1], table[2], table[3]};
    H5::DataSpace part = family;
    part.selectHyperslab(H5S_SELECT_SET, count.data(), start.data());
    return part;
}

void write_table(H5::H5File& file, const IcTable& table, bool has_dimensions) {
    H5::DataSet dataset = create(file, table_name, shape_of(table));
    dataset.write(table.values.data(), H5::PredType::NATIVE_DOUBLE);
    put(dataset, "axes", "displacement (x, y, z), load (x, y, z), offset along y, offset along x");
    put(dataset, "units", has_dimensions ? std::string_view("mm^3/N, of spec/dx, spec/dy and spec/G") : units);
}

/// What a prism's transform says of the columns and offsets of a request: others read it, contactd the transform.
void write_columns(H5::H5File& file, const IcRecord& record) {
    const auto table = std::get<ColumnTable>(body_table(record, record.spec));
    const auto nx = static_cast<hsize_t>(table.nx), columns = static_cast<hsize_t>(table.columns);
    H5::DataSet dataset = create(file, table_name, FamilyShape{3, 3, columns, columns, nx});
    dataset.write(table.values.data(), H5::PredType::NATIVE_DOUBLE);
    put(dataset, "axes",
        "displacement (x, along the outline, outward), load (the same), observed column, loaded column, offset along "
        "x");
    put(dataset, "units", "mm^3/N, of spec/dx, spec/dy and spec/G");
}

void write_family(H5::H5File& file, const std::vector<IcTable>& family) {
    const TableShape shape = shape_of(family.front());
    H5::DataSet dataset = create(file, family_name, FamilyShape{family.size(), shape[0], shape[1], shape[2], shape[3]});
    const H5::DataSpace memory(shape.size(), shape.data()), space = dataset.getSpace();
    for (std::size_t n = 0; n < family.size(); ++n)
        dataset.write(family[n].values.data(), H5::PredType::NATIVE_DOUBLE, memory, part_of(space, n, shape));
    put(dataset, "axes",
        "Poisson's ratio (evidence/family_nu), displacement (x, y, z), load (x, y, z), offset along y, offset along x");
    put(dataset, "units", units);
}

IcTable read_table(const H5::H5File& file) {
    const H5::DataSet dataset = file.openDataSet(table_name);
    const H5::DataSpace space = dataset.getSpace();
    TableShape shape{};
    if (space.getSimpleExtentNdims() != static_cast<int>(shape.size()))
        throw DamagedTable("The table does not have four axes.");
    space.getSimpleExtentDims(shape.data());
    if (shape[0] != 3 || shape[1] != 3 || shape[2] < 1 || shape[3] < 1 || shape[2] > most_offsets ||
        shape[3] > most_offsets / shape[2])
        throw DamagedTable("The table does not have the shape [3, 3, ny, nx].");
    IcTable table(static_cast<int>(shape[3]), static_cast<int>(shape[2]));
    dataset.read(table.values.data(), H5::PredType::NATIVE_DOUBLE);
    return table;
}

/// As many tables as `size`, each of the extent of `first`.
std::vector<IcTable> read_family(const H5::H5File& file, std::size_t size, const IcTable& first) {
    if (!file.nameExists(family_name))
        throw DamagedTable("The spec is that of a family, which the file does not hold.");
    const H5::DataSet dataset = file.openDataSet(family_name);
    const H5::DataSpace space = dataset.getSpace();
    const TableShape shape = shape_of(first);
    FamilyShape found{};
    if (space.getSimpleExtentNdims() != static_cast<int>(found.size()))
        throw DamagedTable("The family does not have five axes.");
    space.getSimpleExtentDims(found.data());
    if (size < 2 || size > most_tables || found != FamilyShape{size, shape[0], shape[1], shape[2], shape[3]})
        throw DamagedTable(
            "The family does not have the shape [n, 3, 3, ny, nx] of two or more tables, one for each "
            "of evidence/family_nu.");
    const H5::DataSpace memory(shape.size(), shape.data());
    std::vector<IcTable> family;
    for (std::size_t n = 0; n < size; ++n) {
        IcTable& table = family.emplace_back(first.nx, first.ny);
        dataset.read(table.values.data(), H5::PredType::NATIVE_DOUBLE, memory, part_of(space, n, shape));
    }
    return family;
}

}  // namespace

std::vector<unsigned char> to_hdf5(const IcRecord& record) {
    const std::scoped_lock lock(hdf5_mutex());
    H5::Exception::dontPrint();
    try {
        H5::FileAccPropList in_memory;
        in_memory.setCore(core_increment, false);
        H5::H5File file("contactd-ic-table", H5F_ACC_TRUNC, H5::FileCreatPropList::DEFAULT, in_memory);
        put(file, "contactd_format", static_cast<long long>(format_version));
        write_spec(file.createGroup("spec"), record.spec);
        write_evidence(file.createGroup("evidence"), record.evidence);
        if (const auto* spectrum = std::get_if<ColumnSpectrum>(&record.tables)) {
            write_spectrum(file, *spectrum);
            if (!is_dimensionless(record.spec)) write_columns(file, record);
        } else if (std::holds_alternative<ColumnTable>(record.tables)) {
            throw StoreError(
                "Tables of prisms that are made of half-spaces are not kept in files: making one is quicker.");
        } else {
            write_table(file, record.table(), !is_dimensionless(record.spec));
        }
        if (const auto* family = std::get_if<IcFamily>(&record.tables)) write_family(file, family->tables);
        file.flush(H5F_SCOPE_GLOBAL);
        const ssize_t size = H5Fget_file_image(file.getId(), nullptr, 0);
        std::vector<unsigned char> image(size > 0 ? static_cast<std::size_t>(size) : 0);
        if (size <= 0 || H5Fget_file_image(file.getId(), image.data(), image.size()) != size)
            throw StoreError("HDF5 gave no image of the table.");
        return image;
    } catch (const H5::Exception& error) {
        throw StoreError("HDF5 cannot write the table: " + error.getDetailMsg() + ".");
    }
}

IcRecord from_hdf5(std::span<const unsigned char> image) {
    const std::scoped_lock lock(hdf5_mutex());
    H5::Exception::dontPrint();
    try {
        H5::FileAccPropList in_memory;
        in_memory.setCore(core_increment, false);
        // HDF5 takes a pointer to what may be changed, and copies it.
        if (H5Pset_file_image(in_memory.getId(), const_cast<unsigned char*>(image.data()), image.size()) < 0)
            throw StoreError("HDF5 does not take the image of the table.");
        const H5::H5File file("contactd-ic-table", H5F_ACC_RDONLY, H5::FileCreatPropList::DEFAULT, in_memory);
        if (integer(file, "contactd_format") != format_version)
            throw DamagedTable("The file has format " + std::to_string(integer(file, "contactd_format")) + ", not " +
                               std::to_string(format_version) + ".");
        IcRecord record;
        record.spec = read_spec(file.openGroup("spec"));
        if (record.spec.section) {
            record.evidence = read_evidence(file.openGroup("evidence"));
            record.tables = read_spectrum(file, record.spec.material.nu);
            record.spec.nx = extent_of(record.tables).nx;
            record.spec.ny = extent_of(record.tables).ny;
            return record;
        }
        IcTable table = read_table(file);
        record.spec.nx = table.nx;
        record.spec.ny = table.ny;
        record.evidence = read_evidence(file.openGroup("evidence"));
        if (record.spec.any_nu)
            record.tables = IcFamily{read_family(file, record.evidence.family_nu.size(), table)};
        else
            record.tables = std::move(table);
        return record;
    } catch (const H5::Exception& error) {
        throw DamagedTable("HDF5 cannot read the table: " + error.getDetailMsg() + ".");
    }
}

}  // namespace contactd
