#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <chrono>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "contactd/table_lock.hpp"
#include "ic_records.hpp"
#include "store/hdf5/writer.hpp"
#include "store/sha256.hpp"

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

const std::string some_key(64, 'a');

/// Stores four tables of the same size.
struct StoreOfFour {
    StoreOfFour() {
        for (const double f : {1.1, 1.2, 1.3, 1.4}) {
            specs.push_back(fem_spec(4, 4));
            specs.back().fem.f = f;
            keys.push_back(ic_key(specs.back()));
            write_ic_file(store.path_of(specs.back()), record_of(specs.back()));
        }
        size = fs::file_size(store.path_of(specs[0]));
    }
    const TemporaryFolder folder;
    const IcStore store = quiet_store(folder.path());
    std::vector<IcSpec> specs;
    std::vector<std::string> keys;
    std::uintmax_t size = 0;
};

/// Lists removed tables in the order of removal.
std::vector<std::string> evicted_keys(const IcStore& store, std::uintmax_t budget_bytes) {
    std::vector<std::string> keys;
    for (const StoredTable& table : store.evict(budget_bytes, {})) keys.push_back(table.key);
    return keys;
}

std::string content_of(const fs::path& path) {
    std::stringstream content;
    content << std::ifstream(path, std::ios::binary).rdbuf();
    return content.str();
}

/// Changes the data after the header, and corrects the digest.
void rewrite(const fs::path& path, const std::function<void(std::string&)>& change) {
    constexpr std::size_t header_size = 512, digest_size = 64;
    const std::string content = content_of(path);
    std::string header = content.substr(0, header_size), image = content.substr(header_size);
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

    CHECK(store.find(fem_spec(9, 9))->table().nx == 10);
    CHECK(store.find(fem_spec(11, 9))->table().nx == 40);
    CHECK_FALSE(store.find(fem_spec(41, 1)).has_value());

    store.remove_covered_by(fem_spec(40, 40));
    CHECK(store.find(fem_spec(9, 9))->table().nx == 40);
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
            // The value, 64 bits, follows the name, its type and its extent.
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

TEST_CASE("A file of a newer version is left alone, and what is built lies beside it") {
    const TemporaryFolder folder;
    std::vector<std::string> reports;
    const IcStore store(folder.path(), [&](const std::string& text) { reports.push_back(text); });
    const IcSpec spec = fem_spec(6, 6);
    const fs::path path = store.path_of(spec);
    write_ic_file(path, record_of(spec));
    SECTION("of the image") {
        rewrite(path, [](std::string& image) {
            const std::string name = "contactd_format";
            const std::size_t at = image.find(std::string("\2\0\0\0\0\0\0\0", 8), image.find(name));
            REQUIRE(at < image.find(name) + 100);
            image[at] = 3;
        });
    }
    SECTION("of the block before it") {
        std::fstream(path) << "contactd ic table, format 2, whatever";
    }
    const std::string before = content_of(path);

    CHECK_FALSE(store.find(spec).has_value());
    CHECK(reports.size() == 1);
    const fs::path beside = store.path_to_write(ic_key(spec), 6, 6);
    CHECK(beside != path);
    write_ic_file(beside, record_of(spec));
    store.remove_covered_by(fem_spec(9, 9));
    CHECK(content_of(path) == before);
    write_ic_file(beside, record_of(spec));
    CHECK(store.find(spec)->table().nx == 6);
    CHECK_FALSE(fs::exists(folder.path() / "quarantine"));
}

TEST_CASE("Of an owner's tables nobody else is served") {
    const TemporaryFolder folder;
    const IcStore store = quiet_store(folder.path());
    const IcSpec spec = fem_spec(5, 5);
    for (const TableOwner owner : {"uid:1000", "alice", "[::1]", "a=b/../c"}) {
        const fs::path path = store.path_of(ic_key(spec), 5, 5, owner);
        CHECK(path.parent_path() == folder.path());
        write_ic_file(path, record_of(spec));
        CHECK(store.find(spec, owner).has_value());
        CHECK(store.may_have(spec, owner));
        CHECK_FALSE(store.may_have(spec));
        CHECK_FALSE(store.find(spec, "bob").has_value());
        CHECK_FALSE(store.find(spec).has_value());
        CHECK(store.list().back().owner == owner);
        CHECK(store.remove(ic_key(spec), "bob") == 0);
        CHECK(store.remove(ic_key(spec), owner) == 1);
    }
}

TEST_CASE("What is no file under the name of a table is passed over") {
    const TemporaryFolder folder;
    std::vector<std::string> reports;
    const IcStore store(folder.path(), [&](const std::string& text) { reports.push_back(text); });
    const IcSpec spec = fem_spec(6, 6);
    const fs::path path = store.path_of(spec), elsewhere = folder.path() / "elsewhere";
    write_ic_file(elsewhere, record_of(spec));
    SECTION("a FIFO") {
        REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
        REQUIRE(::mkfifo(store.lock_of(ic_key(spec)).c_str(), 0600) == 0);
        CHECK_THROWS_AS(read_ic_file(path), StoreError);
        CHECK(TableLock(store.lock_of(ic_key(spec))).try_lock() == TableLock::State::unavailable);
    }
    SECTION("a link to a table") {
        fs::create_symlink(elsewhere, path);
        CHECK_THROWS_AS(read_ic_file(path), StoreError);
    }
    SECTION("a link to nothing") {
        fs::create_symlink(folder.path() / "nowhere", path);
    }
    SECTION("a folder") {
        fs::create_directory(path);
        CHECK_THROWS_AS(read_ic_file(path), StoreError);
    }

    CHECK_FALSE(store.find(spec).has_value());
    CHECK(store.list().empty());
    CHECK(store.sweep() == 0);
    CHECK(fs::symlink_status(path).type() != fs::file_type::not_found);
    CHECK(reports.empty());
}

TEST_CASE("Sweeping removes what a killed writer left, nothing else") {
    const TemporaryFolder folder;
    const IcStore store = quiet_store(folder.path());
    write_ic_file(store.path_of(fem_spec(4, 4)), record_of(fem_spec(4, 4)));
    std::ofstream(folder.path() / (some_key + ".4x4.h5.tmp")) << "half a table";
    std::ofstream(store.lock_of(some_key)) << "";
    for (const char* name : {"notes.txt", "notes.tmp", "Cargo.lock"}) std::ofstream(folder.path() / name) << "mine";

    CHECK(store.sweep() == 2);
    CHECK(files_in(folder.path()) == 4);
}

TEST_CASE("Files that others left in the store's folder are neither listed nor evicted") {
    const TemporaryFolder folder;
    const IcStore store = quiet_store(folder.path());
    fs::create_directories(folder.path() / "quarantine");
    for (const char* name : {"mine.4x4.h5", "mine.h5", "quarantine/mine.h5.1"})
        std::ofstream(folder.path() / name) << "mine";

    CHECK(store.list().empty());
    CHECK(store.evict(0, {}).empty());
    CHECK(files_in(folder.path()) == 3);
    CHECK(files_in(folder.path() / "quarantine") == 1);
}

TEST_CASE("Sweeping leaves what a living writer, or one on another machine, may still be writing") {
    const TemporaryFolder folder;
    const IcStore store = quiet_store(folder.path());
    const std::string mine = writer_name(), table = some_key + ".4x4.h5.";
    const std::string boot = mine.substr(0, mine.find('-'));
    std::ofstream(folder.path() / (table + boot + "-4194304-1-" + "here.0.tmp")) << "its writer is dead";
    const fs::path elsewhere = folder.path() / (table + "000000000000-77-1-elsewhere.0.tmp");
    std::ofstream(elsewhere) << "who knows";
    const fs::path locked = folder.path() / (table + mine + ".0.tmp");
    std::ofstream(locked) << "being written";
    const int fd = ::open(locked.c_str(), O_RDONLY);
    REQUIRE(::flock(fd, LOCK_EX) == 0);

    CHECK(store.sweep() == 1);
    CHECK(fs::exists(locked));
    CHECK(fs::exists(elsewhere));
    ::close(fd);
}

TEST_CASE("A lock of a build is had once, and its file goes with it") {
    const TemporaryFolder folder;
    const IcStore store = quiet_store(folder.path());
    {
        TableLock first(store.lock_of(some_key)), second(store.lock_of(some_key));
        CHECK(first.try_lock() == TableLock::State::held);
        CHECK(second.try_lock() == TableLock::State::busy);
        CHECK(store.sweep() == 0);
    }
    CHECK(files_in(folder.path()) == 0);
    TableLock nowhere(folder.path() / "missing" / "key.lock");
    CHECK(nowhere.try_lock() == TableLock::State::unavailable);
}

TEST_CASE("Eviction takes damaged tables, then those unused for longest, and never those to be kept") {
    const StoreOfFour four;
    const IcStore& store = four.store;
    fs::create_directories(store.folder() / "quarantine");
    std::ofstream(store.folder() / "quarantine" / (some_key + ".4x4.h5.1")) << std::string(four.size, ' ');

    CHECK(store.evict(4 * four.size, {}).empty());
    CHECK(files_in(store.folder() / "quarantine") == 0);

    for (const std::size_t n : {2, 0, 1, 3}) CHECK(store.find(four.specs[n]).has_value());
    CHECK(evicted_keys(store, 2 * four.size) == std::vector{four.keys[2], four.keys[0]});
    CHECK(store.evict(0, {four.keys[1]}).size() == 1);
    CHECK(store.list().size() == 1);
}

TEST_CASE("A use is noted as of the time it happens at") {
    const StoreOfFour four;
    const auto before = fs::file_time_type::clock::now();
    REQUIRE(four.store.find(four.specs[0]).has_value());
    const auto used = fs::last_write_time(four.store.path_of(four.specs[0]));

    CHECK(used >= before);
    CHECK(used <= fs::file_time_type::clock::now() + std::chrono::milliseconds(1));
}

TEST_CASE("What two stores on one folder use is evicted in the order of its use") {
    const StoreOfFour four;
    const IcStore other = quiet_store(four.store.folder());
    for (const std::size_t n : {0, 2}) {
        CHECK(four.store.find(four.specs[n]).has_value());
        CHECK(other.find(four.specs[n + 1]).has_value());
    }
    CHECK(other.find(four.specs[0]).has_value());

    CHECK(evicted_keys(four.store, 1) == std::vector{four.keys[1], four.keys[2], four.keys[3], four.keys[0]});
}

TEST_CASE("A use that is noted late does not undo a later one") {
    const StoreOfFour four;
    const auto early = four.store.time_of_use();
    for (const std::size_t n : {1, 2, 3, 0}) CHECK(four.store.find(four.specs[n]).has_value());
    four.store.note_use(four.store.path_of(four.specs[0]), early);

    CHECK(evicted_keys(four.store, 1).back() == four.keys[0]);
}

TEST_CASE("Times of use in the future are brought back in their order, and what is used afterwards counts as later") {
    const StoreOfFour four;
    const auto ahead = GENERATE(fs::file_time_type{},  // the year 2174, where an earlier version started to count
                                fs::file_time_type::clock::now() + std::chrono::hours(1));
    for (const std::size_t n : {0, 1, 2, 3})
        fs::last_write_time(four.store.path_of(four.specs[n]), ahead - std::chrono::microseconds(n));

    SECTION("at the start") {
        four.store.settle_times();
        for (const StoredTable& table : four.store.list()) CHECK(table.last_use <= fs::file_time_type::clock::now());
        const IcStore restarted = quiet_store(four.store.folder());
        CHECK(restarted.find(four.specs[3]).has_value());
        CHECK(restarted.find(four.specs[1]).has_value());
        CHECK(evicted_keys(restarted, 1) == std::vector{four.keys[2], four.keys[0], four.keys[3], four.keys[1]});
    }
    SECTION("at an eviction") {
        CHECK(evicted_keys(four.store, 1) == std::vector{four.keys[3], four.keys[2], four.keys[1], four.keys[0]});
    }
}
