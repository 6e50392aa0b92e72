
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <filesystem>
#include <fstream>

#include "access/curve_keys.hpp"
#include "contactd/error.hpp"
#include "contactd/proto/key_file.hpp"
#include "support/temporary_folder.hpp"

namespace fs = std::filesystem;
using namespace contactd::server;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using contactd::proto::parse_key_file;

namespace {

void replace_content(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::trunc) << text;
}

}  // namespace

TEST_CASE("Keys that were made are read back, the public one as the secret file has it") {
    const contactd::TemporaryFolder folder;
    const NewKeys made = generate_keys(folder.path(), "alice");
    const auto secret_file = contactd::proto::read_key_file(made.secret_file);
    const auto public_file = contactd::proto::read_key_file(made.public_file);

    CHECK(public_file.public_key == secret_file.public_key);
    CHECK(public_file.secret_key.empty());
    CHECK(read_secret_key(made.secret_file) == secret_file.secret_key);
    CHECK((fs::status(made.secret_file).permissions() & fs::perms::all) ==
          (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("The name of a file in the folder is the user, and other files do not count") {
    const contactd::TemporaryFolder folder;
    const NewKeys alice = generate_keys(folder.path(), "alice");
    generate_keys(folder.path(), "bob");
    replace_content(folder.path() / "README", "who is who");
    std::vector<std::string> problems;
    const AllowedKeys keys = AllowedKeys::read(folder.path(), problems);

    CHECK(problems.empty());
    CHECK(keys.size() == 2);
    CHECK(keys.user_of(contactd::proto::read_key_file(alice.public_file).public_key) == "alice");
    CHECK(keys.user_of("").empty());
    CHECK(keys.has_user("bob"));
    CHECK_FALSE(keys.has_user("mallory"));
}

TEST_CASE("A secret key that others can read is refused") {
    const contactd::TemporaryFolder folder;
    const NewKeys made = generate_keys(folder.path(), "server");
    fs::permissions(made.secret_file, fs::perms::group_read, fs::perm_options::add);
    CHECK_THROWS_MATCHES(read_secret_key(made.secret_file), contactd::Error,
                         MessageMatches(ContainsSubstring("chmod 600")));
}

TEST_CASE("A file without keys is refused without quoting it") {
    const std::string text =
        GENERATE("", "public-key", "public-key = ", "public-key = \"sesame\"", "curve\n public-key = 'a b'",
                 "secret-key = \"sesame\"", "# public-key = \"rq:rM>}U?@Lns47E1%kR.o@n%FcmmsL/@{H8]yf7\"");
    CHECK_THROWS_MATCHES(parse_key_file(text), contactd::Error, !MessageMatches(ContainsSubstring("sesame")));
}

TEST_CASE("Lines may end as on Windows and be indented as one likes") {
    CHECK(parse_key_file("curve\r\n\tpublic-key=\"rq:rM>}U?@Lns47E1%kR.o@n%FcmmsL/@{H8]yf7\"\r\n").public_key ==
          "rq:rM>}U?@Lns47E1%kR.o@n%FcmmsL/@{H8]yf7");
}
