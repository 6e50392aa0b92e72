#include <catch2/catch_test_macros.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>

#include "engine/ics/store/use_notes.hpp"
#include "support/temporary_folder.hpp"

using namespace contactd;
using namespace contactd::engine;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

/// Creates a store with a file that was last used an hour ago.
struct OldFile {
    OldFile() {
        std::ofstream(path) << "table";
        fs::last_write_time(path, old);
    }
    fs::file_time_type time() const { return fs::last_write_time(path); }

    const TemporaryFolder folder;
    const IcStore store{folder.path(), [](const std::string&) {}};
    const fs::path path = store.path_of(std::string(64, 'a'), 3, 3);
    const fs::file_time_type old = fs::file_time_type::clock::now() - 1h;
};

}  // namespace

TEST_CASE("A use from memory comes into the file's time by itself") {
    const OldFile file;
    UseNotes notes(file.store);
    const auto before = fs::file_time_type::clock::now();
    notes.note(file.path);

    while (file.time() == file.old) std::this_thread::sleep_for(10ms);
    CHECK(file.time() >= before);
    CHECK(file.time() <= fs::file_time_type::clock::now());
}

TEST_CASE("Uses are written when asked for, and at the end") {
    const OldFile file;
    std::optional<UseNotes> notes(std::in_place, file.store);
    SECTION("when asked for") {
        notes->note(file.path);
        notes->write();
    }
    SECTION("at the end") {
        notes->note(file.path);
        notes.reset();
    }
    CHECK(file.time() > file.old);
}

TEST_CASE("A file that is not there is none of the uses' business") {
    const OldFile file;
    fs::remove(file.path);
    UseNotes notes(file.store);
    notes.note(file.path);
    CHECK_NOTHROW(notes.write());
    CHECK_FALSE(fs::exists(file.path));
}
