#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "../../core/src/sha256.hpp"
#include "ic_records.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;

namespace {

IcStore quiet_store(const fs::path& folder) {
    return IcStore(folder, [](const std::string&) {});
}

void flip_bit(const fs::path& path, std::streamoff at) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(at);
    const char byte = static_cast<char>(file.get() ^ 0x10);
    file.seekp(at);
    file.put(byte);
}

/// Changes what stands behind the header, and makes the digest right again.
void rewrite(const fs::path& path, const std::function<void(std::string&)>& change) {
    constexpr std::size_t header_size = 512, digest_size = 64;
    std::stringstream content;
    content << std::ifstream(path, std::ios::binary).rdbuf();
    std::string header = content.str().substr(0, header_size), image = content.str().substr(header_size);
    change(image);
    const std::string digest = sha256_hex({reinterpret_cast<const unsigned char*>(image.data()), image.size()});
    header.replace(header.find('\n') - digest_size, digest_size, digest);
    std::ofstream(path, std::ios::binary) << header << image;
}

}  // namespace

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
    SECTION("a table of the format before") {
        rewrite(path, [](std::string& image) {
            const std::string name = "contactd_format";
            // The value, 64 bits, stands behind the name, its type and its extent.
            const std::size_t at = image.find(std::string("\2\0\0\0\0\0\0\0", 8), image.find(name));
            REQUIRE(at < image.find(name) + 100);
            image[at] = 1;
        });
        CHECK_THROWS_WITH(read_ic_file(path), ContainsSubstring("format 1, not 2"));
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
