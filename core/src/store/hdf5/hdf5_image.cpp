#include "hdf5_image.hpp"

#include <H5Cpp.h>

#include <mutex>
#include <string>

#include "contactd/ic_store.hpp"
#include "global_heap.hpp"
#include "hdf5_reader.hpp"

namespace contactd {
namespace {

constexpr std::size_t core_increment = 1 << 20;

/// Only one thread at a time may call Debian's HDF5, which is not built thread-safe.
std::mutex& hdf5_mutex() {
    static std::mutex mutex;
    return mutex;
}

std::vector<hsize_t> extents_of(const std::vector<std::size_t>& shape) {
    return {shape.begin(), shape.end()};
}

/// Writes attributes and datasets below the groups of their paths, which it creates.
class Writer {
   public:
    explicit Writer(H5::H5File& file) : file_(file) {}

    void dataset(const std::string& path, const FileContents::Array& array) {
        make_groups(path);
        const std::vector<hsize_t> extents = extents_of(array.shape);
        const H5::DataSpace space(static_cast<int>(extents.size()), extents.data());
        file_.createDataSet(path, H5::PredType::IEEE_F64LE, space)
            .write(array.values.data(), H5::PredType::NATIVE_DOUBLE);
    }

    void attribute(const std::string& path, const FileContents::Value& value) {
        make_groups(path);
        const std::size_t slash = path.rfind('/');
        const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
        const std::string parent = slash == std::string::npos ? "/" : path.substr(0, slash);
        const auto write = [&](const auto& at) { std::visit([&](const auto& given) { put(at, name, given); }, value); };
        if (parent != "/" && file_.childObjType(parent) == H5O_TYPE_DATASET)
            write(file_.openDataSet(parent));
        else
            write(file_.openGroup(parent));
    }

   private:
    void make_groups(const std::string& path) {
        for (std::size_t slash = path.find('/'); slash != std::string::npos; slash = path.find('/', slash + 1))
            if (const std::string group = path.substr(0, slash); !file_.nameExists(group)) file_.createGroup(group);
    }

    static H5::DataSpace list_of(std::size_t size) {
        const hsize_t extent = size;
        return H5::DataSpace(1, &extent);
    }
    static void put(const H5::H5Object& at, const std::string& name, double value) {
        at.createAttribute(name, H5::PredType::IEEE_F64LE, H5::DataSpace(H5S_SCALAR))
            .write(H5::PredType::NATIVE_DOUBLE, &value);
    }
    static void put(const H5::H5Object& at, const std::string& name, long long value) {
        at.createAttribute(name, H5::PredType::STD_I64LE, H5::DataSpace(H5S_SCALAR))
            .write(H5::PredType::NATIVE_LLONG, &value);
    }
    static void put(const H5::H5Object& at, const std::string& name, const std::string& value) {
        at.createAttribute(name, text(), H5::DataSpace(H5S_SCALAR)).write(text(), value);
    }
    static void put(const H5::H5Object& at, const std::string& name, const std::vector<double>& values) {
        at.createAttribute(name, H5::PredType::IEEE_F64LE, list_of(values.size()))
            .write(H5::PredType::NATIVE_DOUBLE, values.data());
    }
    static void put(const H5::H5Object& at, const std::string& name, const std::vector<std::string>& values) {
        std::vector<const char*> pointers;
        for (const std::string& value : values) pointers.push_back(value.c_str());
        at.createAttribute(name, text(), list_of(values.size())).write(text(), pointers.data());
    }

    /// The type is created on first use, because HDF5's own types may be created after a global of ours if both are in
    /// one library.
    static const H5::StrType& text() {
        static const H5::StrType type{H5::PredType::C_S1, H5T_VARIABLE};
        return type;
    }
    H5::H5File& file_;
};

}  // namespace

std::vector<unsigned char> to_hdf5(const FileContents& contents) {
    const std::scoped_lock lock(hdf5_mutex());
    H5::Exception::dontPrint();
    try {
        H5::FileAccPropList in_memory;
        in_memory.setCore(core_increment, false);
        H5::H5File file("contactd-ic-table", H5F_ACC_TRUNC, H5::FileCreatPropList::DEFAULT, in_memory);
        Writer writer(file);
        for (const auto& [path, array] : contents.datasets) writer.dataset(path, array);
        for (const auto& [path, value] : contents.attributes) writer.attribute(path, value);
        file.flush(H5F_SCOPE_GLOBAL);
        const ssize_t size = H5Fget_file_image(file.getId(), nullptr, 0);
        std::vector<unsigned char> image(size > 0 ? static_cast<std::size_t>(size) : 0);
        if (size <= 0 || H5Fget_file_image(file.getId(), image.data(), image.size()) != size)
            throw StoreError("HDF5 did not return an image of the table.");
        return image;
    } catch (const H5::Exception& error) {
        throw StoreError("HDF5 cannot write the table: " + error.getDetailMsg() + ".");
    }
}

FileContents from_hdf5(std::span<const unsigned char> image) {
    check_global_heaps(image);
    const std::scoped_lock lock(hdf5_mutex());
    H5::Exception::dontPrint();
    try {
        H5::FileAccPropList in_memory;
        in_memory.setCore(core_increment, false);
        // HDF5 takes a pointer to non-const data, and copies the data.
        if (H5Pset_file_image(in_memory.getId(), const_cast<unsigned char*>(image.data()), image.size()) < 0)
            throw StoreError("HDF5 did not accept the image of the table.");
        const H5::H5File file("contactd-ic-table", H5F_ACC_RDONLY, H5::FileCreatPropList::DEFAULT, in_memory);
        return Hdf5Reader(image.size()).read(file);
    } catch (const H5::Exception& error) {
        throw DamagedTable("HDF5 cannot read the table: " + error.getDetailMsg() + ".");
    }
}

}  // namespace contactd
