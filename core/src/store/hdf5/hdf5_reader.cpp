#include "hdf5_reader.hpp"

#include <array>
#include <limits>
#include <vector>

#include "contactd/ic_store.hpp"
#include "file_format.hpp"

namespace contactd {
namespace {

constexpr int deepest_group = 3;
constexpr hsize_t most_links = 100;      // limit of a group
constexpr std::size_t most_texts = 200;  // limit of a list, because HDF5 allocates all of them at once

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
    throw DamagedTable((path.empty() ? "The file" : path + " of the file") + " " + why + ".");
}

/// Holds texts in memory that HDF5 has allocated, and always returns them to it.
class Texts {
   public:
    Texts(const H5::Attribute& at, std::size_t size)
        : type_(at.getDataType()), space_(at.getSpace()), pointers_(size, nullptr) {
        at.read(type_, pointers_.data());
    }
    ~Texts() { ::H5Dvlen_reclaim(type_.getId(), space_.getId(), H5P_DEFAULT, pointers_.data()); }
    Texts(const Texts&) = delete;
    Texts& operator=(const Texts&) = delete;
    const std::vector<char*>& pointers() const { return pointers_; }

   private:
    const H5::DataType type_;
    const H5::DataSpace space_;
    std::vector<char*> pointers_;
};

std::string name_of_link(const H5::Group& at, hsize_t index, const std::string& prefix) {
    std::array<char, longest_file_path> name{};
    const ssize_t size = ::H5Lget_name_by_idx(at.getId(), ".", H5_INDEX_NAME, H5_ITER_NATIVE, index, name.data(),
                                              name.size(), H5P_DEFAULT);
    if (size < 1 || static_cast<std::size_t>(size) + prefix.size() >= name.size())
        refuse(prefix, "has a link whose name is empty or too long");
    return {name.data(), static_cast<std::size_t>(size)};
}

/// Returns the sizes of an attribute's list; a scalar has none.
std::vector<hsize_t> extents_of(const H5::DataSpace& space, const std::string& path, int most_axes) {
    const int axes = ::H5Sget_simple_extent_ndims(space.getId());
    if (::H5Sget_simple_extent_type(space.getId()) == H5S_NULL || axes < 0 || axes > most_axes)
        refuse(path, "has more axes than tables use, or no values");
    std::vector<hsize_t> extents(static_cast<std::size_t>(axes));
    if (axes > 0) ::H5Sget_simple_extent_dims(space.getId(), extents.data(), nullptr);
    return extents;
}

bool is_of(const H5::DataType& type, const H5::PredType& ours) {
    return ::H5Tequal(type.getId(), ours.getId()) > 0;
}

}  // namespace

FileContents Hdf5Reader::read(const H5::H5File& file) {
    const H5::Group root = file.openGroup("/");
    if (!root.attrExists(format_name)) refuse("", std::string("has no ") + format_name);
    const FileContents::Value format = value(root.openAttribute(format_name), format_name);
    const auto* number = std::get_if<long long>(&format);
    if (number == nullptr) refuse(format_name, "is not a whole number");
    check_format(*number);  // The format is checked first, because other formats may contain anything.
    group(root, "", 0);
    return std::move(contents_);
}

void Hdf5Reader::group(const H5::Group& at, const std::string& prefix, int depth) {
    attributes(at, prefix);
    const hsize_t links = at.getNumObjs();
    if (links > most_links) refuse(prefix, "has more links than these files use");
    for (hsize_t index = 0; index < links; ++index) {
        const std::string name = name_of_link(at, index, prefix), path = prefix + name;
        H5L_info_t info;
        if (::H5Lget_info(at.getId(), name.c_str(), &info, H5P_DEFAULT) < 0 || info.type != H5L_TYPE_HARD)
            refuse(path, "is an external or soft link, which these files must not contain");
        take(name.size(), path);
        const H5O_type_t type = at.childObjType(name);
        if (type == H5O_TYPE_DATASET)
            dataset(at.openDataSet(name), path);
        else if (type == H5O_TYPE_GROUP && depth < deepest_group)
            group(at.openGroup(name), path + "/", depth + 1);
        else
            refuse(path, "is neither a dataset nor a group, or is nested too deeply");
    }
}

void Hdf5Reader::dataset(const H5::DataSet& at, const std::string& path) {
    if (contents_.datasets.size() == most_file_datasets) refuse(path, "exceeds the largest number of datasets");
    const H5::DSetCreatPropList how = at.getCreatePlist();
    if (::H5Pget_external_count(how.getId()) != 0) refuse(path, "stores its data in other files");
    if (how.getLayout() != H5D_CONTIGUOUS || how.getNfilters() != 0)
        refuse(path, "is not stored contiguously; chunks, filters and virtual datasets are not supported");
    if (!is_of(at.getDataType(), H5::PredType::IEEE_F64LE)) refuse(path, "does not contain doubles");
    const std::vector<hsize_t> extents = extents_of(at.getSpace(), path, static_cast<int>(most_file_axes));
    hsize_t size = 1;
    for (const hsize_t extent : extents) {
        if (extent < 1 || extent > bytes_ / size) refuse(path, "has a shape larger than the file");
        size *= extent;
    }
    if (extents.empty() || size > bytes_ / sizeof(double)) refuse(path, "has a shape larger than the file");
    const hsize_t bytes = size * sizeof(double);
    const haddr_t offset = ::H5Dget_offset(at.getId());
    if (offset == HADDR_UNDEF || at.getStorageSize() != bytes || offset > bytes_ || bytes > bytes_ - offset)
        refuse(path, "was not written, or lies outside the file");
    take(bytes, path);
    attributes(at, path + "/");
    FileContents::Array& array = contents_.datasets[path];
    array.shape.assign(extents.begin(), extents.end());
    array.values = UnsetArray(size);
    at.read(array.values.data(), H5::PredType::NATIVE_DOUBLE);
}

void Hdf5Reader::attributes(const H5::H5Object& at, const std::string& prefix) {
    const int count = at.getNumAttrs();
    for (int index = 0; index < count; ++index) {
        if (contents_.attributes.size() == most_file_attributes)
            refuse(prefix, "has more attributes than these files use");
        const H5::Attribute attribute = at.openAttribute(static_cast<unsigned>(index));
        const std::string path = prefix + attribute.getName();
        if (path.size() > longest_file_path) refuse(prefix, "has an attribute whose name is too long");
        contents_.attributes[path] = value(attribute, path);
    }
}

FileContents::Value Hdf5Reader::value(const H5::Attribute& at, const std::string& path) {
    const std::vector<hsize_t> extents = extents_of(at.getSpace(), path, 1);
    const bool is_list = !extents.empty();
    const std::size_t size = is_list ? extents[0] : 1;
    if (size < 1 || size > longest_file_list) refuse(path, "is a list that is empty or too long");
    take(size * sizeof(double), path);
    const H5::DataType type = at.getDataType();
    if (is_of(type, H5::PredType::STD_I64LE) && !is_list) {
        long long number = 0;
        at.read(H5::PredType::NATIVE_LLONG, &number);
        return number;
    }
    if (is_of(type, H5::PredType::IEEE_F64LE)) {
        std::vector<double> numbers(size);
        at.read(H5::PredType::NATIVE_DOUBLE, numbers.data());
        if (is_list) return numbers;
        return numbers.front();
    }
    if (type.getClass() != H5T_STRING || ::H5Tis_variable_str(type.getId()) <= 0)
        refuse(path, "is neither a number, a string, nor a supported list of them");
    return texts(at, path, is_list, size);
}

FileContents::Value Hdf5Reader::texts(const H5::Attribute& at, const std::string& path, bool is_list,
                                      std::size_t size) {
    if (size > most_texts) refuse(path, "is a list that is too long");
    const Texts read(at, size);
    std::vector<std::string> result;
    for (const char* text : read.pointers()) {
        if (text == nullptr) refuse(path, "is a string that was not written");
        result.emplace_back(text);
        if (result.back().size() > longest_file_text) refuse(path, "is a string that is too long");
        take(result.back().size(), path);
    }
    if (is_list) return result;
    return result.front();
}

/// Data that several links or texts share are counted each time they are read.
void Hdf5Reader::take(std::size_t bytes, const std::string& path) {
    if (bytes > bytes_ - taken_) refuse(path, "exceeds the size of the file");
    taken_ += bytes;
}

}  // namespace contactd
