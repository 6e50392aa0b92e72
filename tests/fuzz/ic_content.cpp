// The content of an IC file behind its digest: HDF5 that is sound, but not what we wrote. Bytes are not HDF5 themselves
// (the library's own parser is not ours to test, and a file that was damaged never gets to it): they are edits of a
// good file, which remove attributes, groups and datasets or put others in their place.
#include <H5Cpp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <vector>

#include "../../core/src/store/hdf5/hdf5_image.hpp"
#include "contactd/fields/axis.hpp"
#include "contactd/ic_contents.hpp"
#include "input.hpp"

using namespace contactd;

namespace {

constexpr int most_edits = 12;
constexpr std::size_t most_axes = 7, most_extent = 6;

/// Parses the bytes of the fuzzer.
class Bytes {
   public:
    Bytes(const std::uint8_t* data, std::size_t size) : left_(fuzz::bytes_of(data, size)) {}
    bool empty() const { return left_.empty(); }
    std::size_t below(std::size_t bound) { return bound == 0 ? 0 : byte() % bound; }
    double number() {
        std::uint64_t bits = 0;
        for (int n = 0; n < 8; ++n) bits = bits << 8 | byte();
        return std::bit_cast<double>(bits);
    }
    std::string text() {
        const std::string_view taken = left_.substr(0, below(20));
        left_.remove_prefix(taken.size());
        return std::string(taken);
    }

   private:
    unsigned char byte() {
        if (left_.empty()) return 0;
        const char first = left_.front();
        left_.remove_prefix(1);
        return static_cast<unsigned char>(first);
    }
    std::string_view left_;
};

IcRecord good_record(bool family) {
    IcRecord record{{}, IcTable(3, 2), {}};
    record.spec.nx = 3;
    record.spec.ny = 2;
    record.spec.source = IcSource::fem;
    record.spec.any_nu = family;
    record.spec.material = {1, family ? 0 : 0.3};
    record.evidence.source = "fem";
    record.evidence.version = "1";
    record.evidence.solver = "direct";
    record.evidence.warnings = {"a", ""};
    record.evidence.mesh = FemSpec{};
    record.evidence.errors.zz = ComponentError{-1e-3, 1e-2};
    record.evidence.load_cases = {{Axis::z, 13, 3e-9, true, 0.5, {}}, {Axis::x, 12, 2e-9, true, 0.4, 7e-10}};
    if (family) {
        record.evidence.family_nu = {0, 0.3};
        record.tables = IcFamily{{IcTable(3, 2), IcTable(3, 2)}};
    }
    return record;
}

constexpr std::array<const char*, 7> objects{
    "/", "spec", "evidence", "evidence/mesh", "evidence/load_case_0", "evidence/load_case_1", "influence_coefficients"};
constexpr std::array<const char*, 6> links{"spec",
                                           "evidence",
                                           "evidence/mesh",
                                           "evidence/load_case_0",
                                           "influence_coefficients",
                                           "influence_coefficients_family"};

H5::DataSpace space_of(Bytes& bytes) {
    const std::size_t axes = bytes.below(most_axes + 1);
    if (axes == most_axes) return H5::DataSpace(H5S_NULL);
    std::array<hsize_t, most_axes> extents{};
    for (std::size_t n = 0; n < axes; ++n) extents[n] = bytes.below(most_extent);
    return axes == 0 ? H5::DataSpace(H5S_SCALAR) : H5::DataSpace(static_cast<int>(axes), extents.data());
}

/// Creates values of some type and shape; `write` makes an attribute or a dataset of them.
template <class Write>
void put_values(Bytes& bytes, const Write& write) {
    const std::size_t kind = bytes.below(5);
    const H5::DataSpace space = space_of(bytes);
    const auto points = static_cast<std::size_t>(std::max<hssize_t>(space.getSimpleExtentNpoints(), 0));
    if (kind < 2) {
        const std::vector<double> values(points + 1, kind == 0 ? bytes.number() : double(bytes.below(256)));
        const H5::PredType& type = kind == 0 ? H5::PredType::IEEE_F64LE : H5::PredType::STD_I16BE;
        write(type, space, H5::PredType::NATIVE_DOUBLE, values.data());
    } else if (kind == 2) {
        const H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
        const std::string text = bytes.text();
        const std::vector<const char*> values(points + 1, text.c_str());
        write(type, space, type, values.data());
    } else if (kind == 3) {
        std::string text = bytes.text();
        text.resize(20);
        std::string values;
        for (std::size_t n = 0; n <= points; ++n) values += text;
        const H5::StrType type(H5::PredType::C_S1, text.size());
        write(type, space, type, values.data());
    } else {
        H5::CompType pair(2 * sizeof(double));
        pair.insertMember("a", 0, H5::PredType::NATIVE_DOUBLE);
        pair.insertMember("b", sizeof(double), H5::PredType::NATIVE_DOUBLE);
        const std::vector<double> values(2 * points + 2);
        write(pair, space, pair, values.data());
    }
}

void edit_attribute(H5::H5File& file, Bytes& bytes) {
    const std::string path = objects[bytes.below(objects.size())];
    const hid_t id = ::H5Oopen(file.getId(), path.c_str(), H5P_DEFAULT);
    if (id < 0) return;
    ::H5Oclose(id);
    const auto edit = [&](H5::H5Object&& object) {
        const int count = object.getNumAttrs();
        if (count == 0) return;
        const unsigned index = static_cast<unsigned>(bytes.below(static_cast<std::size_t>(count)));
        const std::string name = object.openAttribute(index).getName();
        object.removeAttr(name);
        if (bytes.below(4) == 0) return;
        put_values(bytes, [&](const H5::DataType& type, const H5::DataSpace& space, const H5::DataType& memory,
                              const void* values) { object.createAttribute(name, type, space).write(memory, values); });
    };
    if (file.childObjType(path) == H5O_TYPE_GROUP)
        edit(file.openGroup(path));
    else
        edit(file.openDataSet(path));
}

void edit_link(H5::H5File& file, Bytes& bytes) {
    const std::string path = links[bytes.below(links.size())];
    if (file.nameExists(path)) file.unlink(path);
    switch (bytes.below(3)) {
        case 0:
            return;
        case 1:
            file.createGroup(path);
            return;
        default:
            put_values(bytes, [&](const H5::DataType& type, const H5::DataSpace& space, const H5::DataType& memory,
                                  const void* values) { file.createDataSet(path, type, space).write(values, memory); });
    }
}

std::vector<unsigned char> edited(std::vector<unsigned char> image, Bytes& bytes) {
    H5::FileAccPropList in_memory;
    in_memory.setCore(1 << 16, false);
    fuzz::require(::H5Pset_file_image(in_memory.getId(), image.data(), image.size()) >= 0, "the good file is taken");
    H5::H5File file("fuzz", H5F_ACC_RDWR, H5::FileCreatPropList::DEFAULT, in_memory);
    for (int n = 0; n < most_edits && !bytes.empty(); ++n) {
        try {
            bytes.below(4) == 0 ? edit_link(file, bytes) : edit_attribute(file, bytes);
        } catch (const H5::Exception&) {
            // Reports an edit that HDF5 does not allow, such as a value that does not fit its type.
        }
    }
    file.flush(H5F_SCOPE_GLOBAL);
    image.resize(static_cast<std::size_t>(::H5Fget_file_image(file.getId(), nullptr, 0)));
    ::H5Fget_file_image(file.getId(), image.data(), image.size());
    return image;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    H5::Exception::dontPrint();
    Bytes bytes(data, size);
    const std::vector<unsigned char> image = edited(to_hdf5(contents_of(good_record(bytes.below(2) == 1))), bytes);
    try {
        const IcRecord record = record_from(from_hdf5(image));
        const auto whole = [&](const IcTable& table) {
            return table.nx == record.spec.nx && table.ny == record.spec.ny &&
                   table.values.size() == 9 * static_cast<std::size_t>(table.nx) * static_cast<std::size_t>(table.ny);
        };
        const auto* family = std::get_if<IcFamily>(&record.tables);
        fuzz::require(family ? std::all_of(family->tables.begin(), family->tables.end(), whole) : whole(record.table()),
                      "tables have the extent that the spec says");
        for (const LoadCaseEvidence& load_case : record.evidence.load_cases)
            fuzz::require(!name_of(load_case.load).empty(), "a load has an axis");
        (void)record_from(from_hdf5(to_hdf5(contents_of(record))));  // a read record can be written and read
    } catch (const StoreError&) {
    }
    return 0;
}
