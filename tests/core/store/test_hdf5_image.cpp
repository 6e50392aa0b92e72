// Tests untrusted files: valid HDF5 with features that could harm a reader.
#include <H5Cpp.h>

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <fstream>
#include <functional>

#include "contactd/ic_contents.hpp"
#include "ic_records.hpp"
#include "store/hdf5/hdf5_image.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

constexpr const char* table = "influence_coefficients";

/// A good file after `change`.
std::vector<unsigned char> changed(const std::function<void(H5::H5File&)>& change) {
    std::vector<unsigned char> image = to_hdf5(contents_of(record_of(fem_spec(5, 3))));
    H5::FileAccPropList in_memory;
    in_memory.setCore(1 << 16, false);
    REQUIRE(::H5Pset_file_image(in_memory.getId(), image.data(), image.size()) >= 0);
    H5::H5File file("changed", H5F_ACC_RDWR, H5::FileCreatPropList::DEFAULT, in_memory);
    change(file);
    file.flush(H5F_SCOPE_GLOBAL);
    image.resize(static_cast<std::size_t>(::H5Fget_file_image(file.getId(), nullptr, 0)));
    ::H5Fget_file_image(file.getId(), image.data(), image.size());
    return image;
}

void check_refused(const std::function<void(H5::H5File&)>& change, const std::string& says) {
    const std::vector<unsigned char> image = changed(change);
    CHECK_THROWS_MATCHES(from_hdf5(image), DamagedTable, MessageMatches(ContainsSubstring(says)));
}

/// Replaces the table.
void put_dataset(H5::H5File& file, const H5::DSetCreatPropList& how, const H5::DataType& type,
                 const std::vector<hsize_t>& shape) {
    file.unlink(table);
    file.createDataSet(table, type, H5::DataSpace(static_cast<int>(shape.size()), shape.data()), how);
}

}  // namespace

TEST_CASE("A file is read as it was written", "[hdf5]") {
    const FileContents written = contents_of(record_of(fem_spec(5, 3)));
    const FileContents read = from_hdf5(to_hdf5(written));
    CHECK(read.attributes == written.attributes);
    REQUIRE(read.datasets.size() == written.datasets.size());
    for (const auto& [path, array] : written.datasets) {
        CHECK(read.datasets.at(path).shape == array.shape);
        CHECK(read.datasets.at(path).values == array.values);
    }
}

TEST_CASE("A heap whose objects never end is refused before HDF5 sees it", "[hdf5]") {
    std::vector<unsigned char> image = to_hdf5(contents_of(record_of(fem_spec(5, 3))));
    const std::string heap{'G', 'C', 'O', 'L', 1};
    const auto at = std::search(image.begin(), image.end(), heap.begin(), heap.end());
    REQUIRE(image.end() - at > 32);
    std::fill_n(at + 16, 16, 0);  // index and size of the first object
    CHECK_THROWS_MATCHES(from_hdf5(image), DamagedTable,
                         MessageMatches(ContainsSubstring("an object of invalid size")));
}

TEST_CASE("Data in other files are not read", "[hdf5]") {
    const TemporaryFolder folder;
    const fs::path secret = folder.path() / "secret";
    std::ofstream(secret) << std::string(4096, 's');
    H5::Exception::dontPrint();
    SECTION("external storage") {
        check_refused(
            [&](H5::H5File& file) {
                H5::DSetCreatPropList how;
                how.setExternal(secret.c_str(), 0, 3 * 3 * 3 * 5 * sizeof(double));
                put_dataset(file, how, H5::PredType::IEEE_F64LE, {3, 3, 3, 5});
            },
            "in other files");
    }
    SECTION("an external link") {
        check_refused(
            [&](H5::H5File& file) {
                file.unlink(table);
                ::H5Lcreate_external(secret.c_str(), "/", file.getId(), table, H5P_DEFAULT, H5P_DEFAULT);
            },
            "is an external or soft link");
    }
    SECTION("a virtual dataset") {
        check_refused(
            [&](H5::H5File& file) {
                const std::array<hsize_t, 4> shape{3, 3, 3, 5};
                const H5::DataSpace space(4, shape.data());
                H5::DSetCreatPropList how;
                ::H5Pset_virtual(how.getId(), space.getId(), secret.c_str(), "/data", space.getId());
                put_dataset(file, how, H5::PredType::IEEE_F64LE, {3, 3, 3, 5});
            },
            "not stored contiguously");
    }
}

TEST_CASE("Links lead to what the file holds itself, once and not in circles", "[hdf5]") {
    check_refused([](H5::H5File& file) { file.link(H5L_TYPE_SOFT, "/spec", "evidence/soft"); },
                  "is an external or soft link");
    check_refused([](H5::H5File& file) { file.link(H5L_TYPE_HARD, "/", "spec/circle"); }, "");
    check_refused(
        [](H5::H5File& file) {
            for (int n = 0; n < 15; ++n) file.link(H5L_TYPE_HARD, table, "copy" + std::to_string(n));
        },
        "exceeds the size of the file");
    check_refused([](H5::H5File& file) { file.createGroup("spec/a").createGroup("b").createGroup("c"); }, "too deep");
    check_refused(
        [](H5::H5File& file) {
            H5::DataType type(H5::PredType::IEEE_F64LE);
            type.commit(file, "spec/type");
        },
        "neither a dataset nor a group");
    check_refused(
        [](H5::H5File& file) {
            for (int n = 0; n < 120; ++n) file.createGroup("group" + std::to_string(n));
        },
        "more links");
}

TEST_CASE("Datasets are one piece of doubles for which the file has room", "[hdf5]") {
    const H5::PredType& doubles = H5::PredType::IEEE_F64LE;
    check_refused([&](H5::H5File& file) { put_dataset(file, {}, doubles, {3, 3, 3, 5}); }, "was not written");
    check_refused([&](H5::H5File& file) { put_dataset(file, {}, doubles, {3, 3, 20'000, 20'000}); },
                  "larger than the file");
    check_refused([&](H5::H5File& file) { put_dataset(file, {}, doubles, {3, 3, 1ULL << 40, 1ULL << 40}); },
                  "larger than the file");
    check_refused([&](H5::H5File& file) { put_dataset(file, {}, doubles, {1, 1, 1, 1, 1, 1}); }, "more axes");
    check_refused([&](H5::H5File& file) { put_dataset(file, {}, H5::PredType::IEEE_F32LE, {3, 3, 3, 5}); }, "doubles");
    check_refused(
        [&](H5::H5File& file) {
            const std::array<hsize_t, 4> chunk{1, 1, 1, 5};
            H5::DSetCreatPropList how;
            how.setChunk(4, chunk.data());
            put_dataset(file, how, doubles, {3, 3, 3, 5});
        },
        "not stored contiguously");
    check_refused(
        [&](H5::H5File& file) {
            H5::DSetCreatPropList how;
            how.setLayout(H5D_COMPACT);
            put_dataset(file, how, doubles, {3, 3, 3, 5});
        },
        "not stored contiguously");
    check_refused(
        [&](H5::H5File& file) {
            file.unlink(table);
            file.createDataSet(table, doubles, H5::DataSpace(H5S_NULL));
        },
        "no values");
}

TEST_CASE("Attributes are numbers and texts that were written", "[hdf5]") {
    const H5::StrType text(H5::PredType::C_S1, H5T_VARIABLE);
    const auto put = [](H5::H5File& file, const H5::DataType& type, const H5::DataSpace& space) {
        file.openGroup("evidence").removeAttr("version");
        return file.openGroup("evidence").createAttribute("version", type, space);
    };
    check_refused([&](H5::H5File& file) { put(file, text, H5::DataSpace(H5S_SCALAR)); }, "not written");
    check_refused([&](H5::H5File& file) { put(file, text, H5::DataSpace(H5S_NULL)); }, "no values");
    check_refused(
        [&](H5::H5File& file) {
            const hsize_t size = 50;
            put(file, H5::PredType::IEEE_F32LE, H5::DataSpace(1, &size));
        },
        "neither a number");
    check_refused(
        [&](H5::H5File& file) {
            const hsize_t size = 500;
            put(file, text, H5::DataSpace(1, &size));
        },
        "a list that is too long");
    check_refused([&](H5::H5File& file) { put(file, H5::StrType(H5::PredType::C_S1, 8), H5::DataSpace(H5S_SCALAR)); },
                  "neither a number");
    check_refused(
        [&](H5::H5File& file) { put(file, H5::VarLenType(H5::PredType::IEEE_F64LE), H5::DataSpace(H5S_SCALAR)); },
        "neither a number");
    check_refused(
        [&](H5::H5File& file) {
            for (int n = 0; n < 1100; ++n) {
                const double value = n;
                file.openGroup("spec")
                    .createAttribute("a" + std::to_string(n), H5::PredType::IEEE_F64LE, H5::DataSpace(H5S_SCALAR))
                    .write(H5::PredType::NATIVE_DOUBLE, &value);
            }
        },
        "more attributes");
}

TEST_CASE("A file of a newer format is not looked into", "[hdf5]") {
    const auto newer = [](H5::H5File& file) {
        const long long format = 3;
        file.openGroup("/").openAttribute("contactd_format").write(H5::PredType::NATIVE_LLONG, &format);
        file.link(H5L_TYPE_SOFT, "/spec", "evidence/soft");
    };
    CHECK_THROWS_AS(from_hdf5(changed(newer)), NewerFormat);
}
