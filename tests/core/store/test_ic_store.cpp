#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "../../../core/src/store/sha256.hpp"
#include "../../../core/src/store/writer.hpp"
#include "contactd/table_lock.hpp"
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
    const IcStore store = quiet_store(folder.path());
    write_ic_file(store.path_of(fem_spec(40, 40)), record_of(fem_spec(40, 40)));
    write_ic_file(store.path_of(fem_spec(10, 12)), record_of(fem_spec(10, 12)));

    CHECK(store.find(fem_spec(9, 9))->table.nx == 10);
    CHECK(store.find(fem_spec(11, 9))->table.nx == 40);
    CHECK_FALSE(store.find(fem_spec(41, 1)).has_value());

    store.remove_covered_by(fem_spec(40, 40));
    CHECK(store.find(fem_spec(9, 9))->table.nx == 40);
    CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("A damaged table is set aside, reported and not served") {
    const TemporaryFolder folder;
    std::vector<std::string> reports;
    const IcStore store(folder.path(), [&](const std::string& text) { reports.push_back(text); });
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
    CHECK(files_in(folder.path() / "quarantine") == 1);
}

TEST_CASE("Sweeping removes what a killed writer left, nothing else") {
    const TemporaryFolder folder;
    const IcStore store = quiet_store(folder.path());
    write_ic_file(store.path_of(fem_spec(4, 4)), record_of(fem_spec(4, 4)));
    std::ofstream(folder.path() / "left.over.tmp") << "half a table";
    std::ofstream(folder.path() / "notes.txt") << "mine";

    CHECK(store.sweep() == 1);
    CHECK(files_in(folder.path()) == 2);
}

TEST_CASE("Sweeping leaves what a living writer, or one on another machine, may still be writing") {
    const TemporaryFolder folder;
    const IcStore store = quiet_store(folder.path());
    const std::string mine = writer_name();
    const std::string boot = mine.substr(0, mine.find('-'));
    std::ofstream(folder.path() / ("k.4x4.h5." + boot + "-4194304-1-" + "here.0.tmp")) << "its writer is dead";
    std::ofstream(folder.path() / "k.4x4.h5.000000000000-77-1-elsewhere.0.tmp") << "who knows";
    const fs::path locked = folder.path() / ("k.4x4.h5." + mine + ".0.tmp");
    std::ofstream(locked) << "being written";
    const int fd = ::open(locked.c_str(), O_RDONLY);
    REQUIRE(::flock(fd, LOCK_EX) == 0);

    CHECK(store.sweep() == 1);
    CHECK(fs::exists(locked));
    CHECK(fs::exists(folder.path() / "k.4x4.h5.000000000000-77-1-elsewhere.0.tmp"));
    ::close(fd);
}

TEST_CASE("A lock of a build is had once, and its file goes with it") {
    const TemporaryFolder folder;
    const IcStore store = quiet_store(folder.path());
    {
        TableLock first(store.lock_of("key")), second(store.lock_of("key"));
        CHECK(first.try_lock() == TableLock::State::held);
        CHECK(second.try_lock() == TableLock::State::busy);
        CHECK(store.sweep() == 0);
    }
    CHECK(files_in(folder.path()) == 0);
    TableLock nowhere(folder.path() / "missing" / "key.lock");
    CHECK(nowhere.try_lock() == TableLock::State::unavailable);
}

TEST_CASE("Eviction takes damaged tables, then those unused for longest, and never those to be kept") {
    const TemporaryFolder folder;
    const IcStore store = quiet_store(folder.path());
    std::vector<IcSpec> specs;
    for (const double f : {1.1, 1.2, 1.3, 1.4}) {
        specs.push_back(fem_spec(4, 4));
        specs.back().fem.f = f;
        write_ic_file(store.path_of(specs.back()), record_of(specs.back()));
    }
    const std::uintmax_t size = fs::file_size(store.path_of(specs[0]));
    fs::create_directories(folder.path() / "quarantine");
    std::ofstream(folder.path() / "quarantine" / "k.4x4.h5.1") << std::string(size, ' ');
    // Clocks that were ahead once and are not any more must not turn the order round.
    const auto ahead = fs::file_time_type::clock::now() + std::chrono::hours(24 * 365);
    for (const IcSpec& spec : specs) fs::last_write_time(store.path_of(spec), ahead);

    CHECK(store.evict(4 * size, {}, {}).empty());
    CHECK(files_in(folder.path() / "quarantine") == 0);

    store.note_use(store.path_of(specs[0]));
    CHECK(store.find(specs[1]).has_value());
    const auto evicted = store.evict(2 * size, {ic_key(specs[3])}, {});
    REQUIRE(evicted.size() == 2);
    CHECK(evicted[0].key == ic_key(specs[2]));
    CHECK(evicted[1].key == ic_key(specs[0]));
    CHECK(store.evict(0, {}, {ic_key(specs[1])}).size() == 1);
    CHECK(store.list().size() == 1);
}
