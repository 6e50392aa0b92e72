#include "ic_hdf5.hpp"

#include <H5Cpp.h>

#include <array>
#include <mutex>
#include <string>

namespace contactd {
namespace {

constexpr int format_version = 1;
constexpr std::size_t core_increment = 1 << 20;

/// Debian's HDF5 is not built thread-safe: one thread at a time.
std::mutex& hdf5_mutex() {
    static std::mutex mutex;
    return mutex;
}

const H5::DataType& text_type() {
    static const H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
    return type;
}

// --- attributes -----------------------------------------------------------------------------------------------------

void put(H5::H5Object& at, const char* name, double value) {
    at.createAttribute(name, H5::PredType::IEEE_F64LE, H5::DataSpace(H5S_SCALAR))
        .write(H5::PredType::NATIVE_DOUBLE, &value);
}
void put(H5::H5Object& at, const char* name, long long value) {
    at.createAttribute(name, H5::PredType::STD_I64LE, H5::DataSpace(H5S_SCALAR))
        .write(H5::PredType::NATIVE_LLONG, &value);
}
void put(H5::H5Object& at, const char* name, std::string_view value) {
    at.createAttribute(name, text_type(), H5::DataSpace(H5S_SCALAR)).write(text_type(), std::string(value));
}

double number(const H5::H5Object& at, const char* name) {
    double value = 0;
    at.openAttribute(name).read(H5::PredType::NATIVE_DOUBLE, &value);
    return value;
}
int integer(const H5::H5Object& at, const char* name) {
    int value = 0;
    at.openAttribute(name).read(H5::PredType::NATIVE_INT, &value);
    return value;
}
long long long_integer(const H5::H5Object& at, const char* name) {
    long long value = 0;
    at.openAttribute(name).read(H5::PredType::NATIVE_LLONG, &value);
    return value;
}
std::string text(const H5::H5Object& at, const char* name) {
    std::string value;
    const H5::Attribute attribute = at.openAttribute(name);
    attribute.read(attribute.getDataType(), value);
    return value;
}
template <class Enum>
Enum named(const H5::H5Object& at, const char* name) {
    Enum value{};
    if (!from_name(text(at, name), value)) throw DamagedTable(std::string(name) + " of the file is not known.");
    return value;
}

// --- spec -----------------------------------------------------------------------------------------------------------

void write_spec(H5::Group group, const IcSpec& spec) {
    put(group, "body", "half_space");
    put(group, "source", name_of(spec.source));
    put(group, "load_shape", name_of(spec.load_shape));
    put(group, "nu", spec.material.nu);
    put(group, "dy_over_dx", spec.dy);
    if (spec.source != IcSource::fem) return;
    const FemSpec& fem = spec.fem;
    put(group, "mesh", name_of(fem.mesh));
    put(group, "order", static_cast<long long>(fem.order));
    put(group, "l_over_h", fem.l_over_h);
    put(group, "h_over_hs", fem.h_over_hs);
    put(group, "f", fem.f);
    put(group, "L_over_h", fem.L_over_h);
    put(group, "far_boundary", name_of(fem.far_boundary));
    put(group, "sampling", name_of(fem.sampling));
    put(group, "tolerance", fem.tolerance);
    put(group, "max_iterations", static_cast<long long>(fem.max_iterations));
    put(group, "strength_threshold", fem.strength_threshold);
}

IcSpec read_spec(const H5::Group& group) {
    IcSpec spec;
    spec.material = {1, number(group, "nu")};
    spec.dx = 1;
    spec.dy = number(group, "dy_over_dx");
    spec.source = named<IcSource>(group, "source");
    spec.load_shape = named<LoadShape>(group, "load_shape");
    if (spec.source != IcSource::fem) return spec;
    spec.fem.mesh = named<MeshKind>(group, "mesh");
    spec.fem.order = integer(group, "order");
    spec.fem.l_over_h = number(group, "l_over_h");
    spec.fem.h_over_hs = number(group, "h_over_hs");
    spec.fem.f = number(group, "f");
    spec.fem.L_over_h = number(group, "L_over_h");
    spec.fem.far_boundary = named<FarBoundary>(group, "far_boundary");
    spec.fem.sampling = named<Sampling>(group, "sampling");
    spec.fem.tolerance = number(group, "tolerance");
    spec.fem.max_iterations = integer(group, "max_iterations");
    spec.fem.strength_threshold = number(group, "strength_threshold");
    return spec;
}

// --- evidence -------------------------------------------------------------------------------------------------------

struct ErrorName {
    const char* origin;
    const char* largest;
    std::optional<ComponentError> IcEvidence::* member;
};
constexpr std::array<ErrorName, 3> error_names{{{"error_xx_origin", "error_xx_largest", &IcEvidence::error_xx},
                                                {"error_yy_origin", "error_yy_largest", &IcEvidence::error_yy},
                                                {"error_zz_origin", "error_zz_largest", &IcEvidence::error_zz}}};

void write_evidence(H5::Group group, const IcEvidence& evidence) {
    put(group, "source", evidence.source);
    put(group, "version", evidence.version);
    put(group, "elements", evidence.elements);
    put(group, "dofs", evidence.dofs);
    put(group, "processes", static_cast<long long>(evidence.processes));
    put(group, "assembly_seconds", evidence.assembly_seconds);
    put(group, "setup_seconds", evidence.setup_seconds);
    put(group, "solve_seconds", evidence.solve_seconds);
    put(group, "total_seconds", evidence.total_seconds);
    for (const ErrorName& name : error_names)
        if (const auto& error = evidence.*name.member) {
            put(group, name.origin, error->origin);
            put(group, name.largest, error->largest);
        }
    if (evidence.scaled_error_xy) put(group, "scaled_error_xy", *evidence.scaled_error_xy);
    if (evidence.scaled_error_xz) put(group, "scaled_error_xz", *evidence.scaled_error_xz);
    for (std::size_t n = 0; n < evidence.load_cases.size(); ++n) {
        const LoadCaseEvidence& load_case = evidence.load_cases[n];
        H5::Group at = group.createGroup("load_case_" + std::to_string(n));
        put(at, "load_axis", static_cast<long long>(load_case.load));
        put(at, "iterations", static_cast<long long>(load_case.iterations));
        put(at, "residual", load_case.residual);
        put(at, "converged", static_cast<long long>(load_case.converged));
        put(at, "seconds", load_case.seconds);
    }
}

IcEvidence read_evidence(const H5::Group& group) {
    IcEvidence evidence;
    evidence.source = text(group, "source");
    evidence.version = text(group, "version");
    evidence.elements = long_integer(group, "elements");
    evidence.dofs = long_integer(group, "dofs");
    evidence.processes = integer(group, "processes");
    evidence.assembly_seconds = number(group, "assembly_seconds");
    evidence.setup_seconds = number(group, "setup_seconds");
    evidence.solve_seconds = number(group, "solve_seconds");
    evidence.total_seconds = number(group, "total_seconds");
    for (const ErrorName& name : error_names)
        if (group.attrExists(name.origin))
            evidence.*name.member = ComponentError{number(group, name.origin), number(group, name.largest)};
    if (group.attrExists("scaled_error_xy")) evidence.scaled_error_xy = number(group, "scaled_error_xy");
    if (group.attrExists("scaled_error_xz")) evidence.scaled_error_xz = number(group, "scaled_error_xz");
    for (int n = 0; group.nameExists("load_case_" + std::to_string(n)); ++n) {
        const H5::Group at = group.openGroup("load_case_" + std::to_string(n));
        evidence.load_cases.push_back({static_cast<Axis>(integer(at, "load_axis")), integer(at, "iterations"),
                                       number(at, "residual"), integer(at, "converged") != 0, number(at, "seconds")});
    }
    return evidence;
}

// --- table ----------------------------------------------------------------------------------------------------------

void write_table(H5::H5File& file, const IcTable& table) {
    const std::array<hsize_t, 4> shape{3, 3, static_cast<hsize_t>(table.ny), static_cast<hsize_t>(table.nx)};
    H5::DataSet dataset = file.createDataSet("influence_coefficients", H5::PredType::IEEE_F64LE,
                                             H5::DataSpace(static_cast<int>(shape.size()), shape.data()));
    dataset.write(table.values.data(), H5::PredType::NATIVE_DOUBLE);
    put(dataset, "axes", "displacement (x, y, z), load (x, y, z), offset along y, offset along x");
    put(dataset, "units", "dx/G: multiply by the element size dx and divide by the shear modulus G");
}

IcTable read_table(const H5::H5File& file) {
    const H5::DataSet dataset = file.openDataSet("influence_coefficients");
    const H5::DataSpace space = dataset.getSpace();
    std::array<hsize_t, 4> shape{};
    if (space.getSimpleExtentNdims() != static_cast<int>(shape.size()))
        throw DamagedTable("The table does not have four axes.");
    space.getSimpleExtentDims(shape.data());
    constexpr hsize_t most = 1 << 22;
    if (shape[0] != 3 || shape[1] != 3 || shape[2] < 1 || shape[3] < 1 || shape[2] > most || shape[3] > most / shape[2])
        throw DamagedTable("The table does not have the shape [3, 3, ny, nx].");
    IcTable table(static_cast<int>(shape[3]), static_cast<int>(shape[2]));
    dataset.read(table.values.data(), H5::PredType::NATIVE_DOUBLE);
    return table;
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
        write_table(file, record.table);
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
        std::vector<unsigned char> copy(image.begin(), image.end());  // HDF5 copies it again, but wants it writable
        if (H5Pset_file_image(in_memory.getId(), copy.data(), copy.size()) < 0)
            throw StoreError("HDF5 does not take the image of the table.");
        const H5::H5File file("contactd-ic-table", H5F_ACC_RDONLY, H5::FileCreatPropList::DEFAULT, in_memory);
        if (integer(file, "contactd_format") != format_version)
            throw DamagedTable("The file has format " + std::to_string(integer(file, "contactd_format")) + ", not " +
                               std::to_string(format_version) + ".");
        IcRecord record;
        record.spec = read_spec(file.openGroup("spec"));
        record.table = read_table(file);
        record.spec.nx = record.table.nx;
        record.spec.ny = record.table.ny;
        record.evidence = read_evidence(file.openGroup("evidence"));
        return record;
    } catch (const H5::Exception& error) {
        throw DamagedTable("HDF5 cannot read the table: " + error.getDetailMsg() + ".");
    }
}

}  // namespace contactd
