#include "hdf5_attributes.hpp"

namespace contactd {
namespace {

constexpr hsize_t longest_list = 10'000;

const H5::DataType& text_type() {
    static const H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
    return type;
}

H5::DataSpace one_axis(std::size_t size) {
    const hsize_t extent = size;
    return H5::DataSpace(1, &extent);
}

/// The attribute `name` of one value: HDF5 would write as many as there are behind the place for one.
H5::Attribute one_value(const H5::H5Object& at, const char* name) {
    H5::Attribute attribute = at.openAttribute(name);
    if (attribute.getSpace().getSimpleExtentNpoints() != 1)
        throw DamagedTable(std::string(name) + " of the file is not one value.");
    return attribute;
}

std::size_t list_size(const H5::Attribute& list) {
    const H5::DataSpace space = list.getSpace();
    if (space.getSimpleExtentNdims() != 1) throw DamagedTable("A list of the file does not have one axis.");
    hsize_t extent = 0;
    space.getSimpleExtentDims(&extent);
    if (extent > longest_list) throw DamagedTable("A list of the file is too long.");
    return extent;
}

}  // namespace

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
void put(H5::H5Object& at, const char* name, const std::vector<double>& values) {
    if (values.empty()) return;
    at.createAttribute(name, H5::PredType::IEEE_F64LE, one_axis(values.size()))
        .write(H5::PredType::NATIVE_DOUBLE, values.data());
}
void put(H5::H5Object& at, const char* name, const std::vector<std::string>& values) {
    if (values.empty()) return;
    std::vector<const char*> pointers;
    for (const std::string& value : values) pointers.push_back(value.c_str());
    at.createAttribute(name, text_type(), one_axis(values.size())).write(text_type(), pointers.data());
}

void put(H5::H5Object& at, const char* name, int value) {
    put(at, name, static_cast<long long>(value));
}
void put(H5::H5Object& at, const char* name, const std::optional<double>& value) {
    if (value) put(at, name, *value);
}

double number(const H5::H5Object& at, const char* name) {
    double value = 0;
    one_value(at, name).read(H5::PredType::NATIVE_DOUBLE, &value);
    return value;
}
long long long_integer(const H5::H5Object& at, const char* name) {
    long long value = 0;
    one_value(at, name).read(H5::PredType::NATIVE_LLONG, &value);
    return value;
}
int integer(const H5::H5Object& at, const char* name) {
    int value = 0;
    one_value(at, name).read(H5::PredType::NATIVE_INT, &value);
    return value;
}
std::string text(const H5::H5Object& at, const char* name) {
    std::string value;
    const H5::Attribute attribute = one_value(at, name);
    if (attribute.getTypeClass() != H5T_STRING) throw DamagedTable(std::string(name) + " of the file is no text.");
    attribute.read(attribute.getDataType(), value);
    return value;
}
std::vector<double> numbers(const H5::H5Object& at, const char* name) {
    if (!at.attrExists(name)) return {};
    const H5::Attribute list = at.openAttribute(name);
    std::vector<double> values(list_size(list));
    list.read(H5::PredType::NATIVE_DOUBLE, values.data());
    return values;
}
std::vector<std::string> texts(const H5::H5Object& at, const char* name) {
    if (!at.attrExists(name)) return {};
    const H5::Attribute list = at.openAttribute(name);
    std::vector<char*> pointers(list_size(list));
    list.read(text_type(), pointers.data());
    std::vector<std::string> values;
    for (char* const pointer : pointers) values.emplace_back(pointer ? pointer : "");
    H5::DataSet::vlenReclaim(pointers.data(), text_type(), list.getSpace());
    return values;
}

void get(const H5::H5Object& at, const char* name, double& value) {
    value = number(at, name);
}
void get(const H5::H5Object& at, const char* name, int& value) {
    value = integer(at, name);
}
void get(const H5::H5Object& at, const char* name, long long& value) {
    value = long_integer(at, name);
}
void get(const H5::H5Object& at, const char* name, std::optional<double>& value) {
    if (at.attrExists(name)) value = number(at, name);
}

}  // namespace contactd
