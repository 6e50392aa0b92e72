#include <catch2/catch_test_macros.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "contactd/ic_store.hpp"

namespace fs = std::filesystem;
using namespace contactd;

namespace {

/// A folder of its own that goes away with the test.
class TemporaryFolder {
   public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "contactd-store-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path = name;
    }
    ~TemporaryFolder() { fs::remove_all(path); }
    fs::path path;
};

IcSpec fem_spec(int nx, int ny) {
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.8;
    spec.nx = nx;
    spec.ny = ny;
    spec.source = IcSource::fem;
    return spec;
}

IcRecord record_of(const IcSpec& spec) {
    IcRecord record{dimensionless(spec), IcTable(spec.nx, spec.ny), {}};
    for (std::size_t n = 0; n < record.table.values.size(); ++n) record.table.values[n] = 1.0 / (1.0 + double(n));
    record.evidence.source = "fem";
    record.evidence.version = "test";
    record.evidence.elements = 1840;
    record.evidence.load_cases = {{Axis::z, 13, 3e-9, true, 0.5}, {Axis::x, 12, 2e-9, true, 0.4}};
    record.evidence.error_zz = ComponentError{-1.2e-3, 1.4e-2};
    record.evidence.scaled_error_xz = 2e-4;
    return record;
}

IcStore quiet_store(const fs::path& folder) {
    return IcStore(folder, [](const std::string&) {});
}

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

void flip_bit(const fs::path& path, std::streamoff at) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(at);
    const char byte = static_cast<char>(file.get() ^ 0x10);
    file.seekp(at);
    file.put(byte);
}

}  // namespace

TEST_CASE("The key is the same for every shear modulus, element size and extent") {
    const IcSpec spec = fem_spec(10, 10);
    IcSpec other = fem_spec(7, 9);
    other.material.G = 200;
    other.dx = other.dy = 0.1 * 3;
    other.fem.max_iterations = 99;

    CHECK(ic_key(other) == ic_key(spec));
    CHECK(ic_key(spec).size() == 64);
}

TEST_CASE("The key depends on everything that changes the numbers") {
    const std::string key = ic_key(fem_spec(10, 10));
    const auto changed = [&](auto change) {
        IcSpec spec = fem_spec(10, 10);
        change(spec);
        return ic_key(spec) != key;
    };

    CHECK(changed([](IcSpec& s) { s.material.nu = 0.3; }));
    CHECK(changed([](IcSpec& s) { s.dy = 0.4; }));
    CHECK(changed([](IcSpec& s) { s.source = IcSource::analytic; }));
    CHECK(changed([](IcSpec& s) { s.fem.order = 1; }));
    CHECK(changed([](IcSpec& s) { s.fem.L_over_h = 641; }));
    CHECK(changed([](IcSpec& s) { s.fem.l_over_h = 2; }));
    CHECK(changed([](IcSpec& s) { s.fem.h_over_hs = 8; }));
    CHECK(changed([](IcSpec& s) { s.fem.f = 1.3; }));
    CHECK(changed([](IcSpec& s) { s.fem.sampling = Sampling::linear; }));
    CHECK(changed([](IcSpec& s) { s.fem.tolerance = 1e-9; }));
    CHECK(changed([](IcSpec& s) { s.fem.strength_threshold = 0.6; }));
}

TEST_CASE("A written table reads back as it was") {
    const TemporaryFolder folder;
    const IcRecord written = record_of(fem_spec(5, 3));

    write_ic_file(folder.path / "table.h5", written);
    const IcRecord read = read_ic_file(folder.path / "table.h5");

    CHECK(read.spec == written.spec);
    CHECK(read.table.nx == 5);
    CHECK(read.table.ny == 3);
    CHECK(read.table.values == written.table.values);
    CHECK(read.evidence.elements == 1840);
    REQUIRE(read.evidence.load_cases.size() == 2);
    CHECK(read.evidence.load_cases[1].load == Axis::x);
    CHECK(read.evidence.load_cases[1].iterations == 12);
    CHECK(read.evidence.error_zz->origin == -1.2e-3);
    CHECK_FALSE(read.evidence.error_xx.has_value());
    CHECK(read.evidence.scaled_error_xz == 2e-4);
    CHECK(files_in(folder.path) == 1);
}

TEST_CASE("Writing where nothing can be written is an error that names the file") {
    CHECK_THROWS_AS(write_ic_file("/proc/no-such-folder/table.h5", record_of(fem_spec(2, 2))), StoreError);
    CHECK_THROWS_AS(read_ic_file("/proc/no-such-folder/table.h5"), StoreError);
}

TEST_CASE("A larger table serves a smaller extent, the smallest that covers it is taken") {
    const TemporaryFolder folder;
    const IcStore store = quiet_store(folder.path);
    write_ic_file(store.path_of(fem_spec(40, 40)), record_of(fem_spec(40, 40)));
    write_ic_file(store.path_of(fem_spec(10, 12)), record_of(fem_spec(10, 12)));

    CHECK(store.find(fem_spec(9, 9))->table.nx == 10);
    CHECK(store.find(fem_spec(11, 9))->table.nx == 40);
    CHECK_FALSE(store.find(fem_spec(41, 1)).has_value());

    store.remove_covered_by(fem_spec(40, 40));
    CHECK(store.find(fem_spec(9, 9))->table.nx == 40);
    CHECK(files_in(folder.path) == 1);
}

TEST_CASE("A damaged table is set aside, reported and not served") {
    const TemporaryFolder folder;
    std::vector<std::string> reports;
    const IcStore store(folder.path, [&](const std::string& text) { reports.push_back(text); });
    const IcSpec spec = fem_spec(6, 6);
    const fs::path path = store.path_of(spec);
    write_ic_file(path, record_of(spec));

    SECTION("truncated") {
        fs::resize_file(path, fs::file_size(path) - 100);
    }
    SECTION("truncated to nothing") {
        fs::resize_file(path, 0);
    }
    SECTION("a bit flipped in the table") {
        flip_bit(path, 2500);
    }
    SECTION("a bit flipped in the digest") {
        flip_bit(path, 80);
    }
    SECTION("a bit flipped in the last byte") {
        flip_bit(path, static_cast<std::streamoff>(fs::file_size(path)) - 1);
    }
    SECTION("something else under its name") {
        std::ofstream(path) << "no table";
    }
    SECTION("another table under its name") {
        IcSpec other = spec;
        other.fem.f = 1.5;
        write_ic_file(path, record_of(other));
    }

    CHECK_FALSE(store.find(spec).has_value());
    CHECK(reports.size() == 1);
    CHECK_FALSE(fs::exists(path));
    CHECK(files_in(folder.path / "quarantine") == 1);
}

TEST_CASE("Sweeping removes what a killed writer left, nothing else") {
    const TemporaryFolder folder;
    const IcStore store = quiet_store(folder.path);
    write_ic_file(store.path_of(fem_spec(4, 4)), record_of(fem_spec(4, 4)));
    std::ofstream(folder.path / "left.over.tmp") << "half a table";
    std::ofstream(folder.path / "notes.txt") << "mine";

    CHECK(store.sweep() == 1);
    CHECK(files_in(folder.path) == 2);
}
