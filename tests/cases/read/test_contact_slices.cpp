// Tests lists of slices: values and refusals.
#include "contactd/read_contact_slices.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "contactd/error.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

/// Returns the folder of profiles of the CONTACT program, outside the repository.
const std::filesystem::path folder = std::filesystem::path(SHARED_FILES) / "contact";

struct Slices {
    std::string head = "0.5 1000. U_OFFSET U_SCALE\n3 NSLC\n4 1 1 NFEAT, NKINK, NACCEL\n1 U_INTPOL\n";
    std::string slices = "-1. 'a/1.prr'\n0. 'a/2.prr' second\n2. 'a/3.prr'\n";
    std::string parts = "1\n2\n";
    std::string features = "-1. 0. 1. 2. 3.\n0. -1 1. 2. 999.\n2. 0. 1. -1. -1.\n";

    std::string text() const { return head + slices + parts + features; }
};

void refused(const Slices& slices, const std::string& what) {
    CHECK_THROWS_MATCHES(read_contact_slices(slices.text(), "a.slcs"), InvalidArgument,
                         MessageMatches(ContainsSubstring(what)));
}

}  // namespace

TEST_CASE("a list of slices has places, profiles, features and parts", "[contact_files]") {
    const ContactSlices read = read_contact_slices(Slices{}.text(), "a.slcs");
    REQUIRE(read.slices.size() == 3);
    CHECK(read.slices[0].u == -500);
    CHECK(read.slices[2].u == 2500);
    CHECK(read.slices[1].file == "a/2.prr");
    CHECK(read.slices[1].features == std::vector<double>{-1, 1, 2, 999});
    CHECK(read.kinks == std::vector<int>{1});
    CHECK(read.accelerations == std::vector<int>{2});
    CHECK_FALSE(read.is_approximated);
}

TEST_CASE("profiles of one part have no features", "[contact_files]") {
    Slices slices;
    slices.head = "0. 1.\n3\n0 0 0\n2\n";
    slices.parts = slices.features = "";
    const ContactSlices read = read_contact_slices(slices.text(), "a.slcw");
    CHECK(read.is_approximated);
    CHECK(read.slices[0].features.empty());
}

TEST_CASE("mistakes in a list of slices are told by file, line and column", "[contact_files]") {
    Slices slices;
    slices.slices = "-1. 'a/1.prr'\n0. a/2.prr\n2. 'a/3.prr'\n";
    refused(slices, "a.slcs, line 6, column 4, has \"a/2.prr\" where FNAME, a name in single quotation marks,");
    slices.slices = "-1. 'a/1.prr'\n-1. 'a/2.prr'\n2. 'a/3.prr'\n";
    refused(slices, "line 6, column 1, has the slice at -500");
    slices = {};
    slices.parts = "3\n2\n";
    refused(slices, "has P_KINK = 3");
    slices = {};
    slices.features = "-1. 0. 1. 2. 3.\n1. 0. 1. 2. 3.\n2. 0. 1. 2. 3.\n";
    refused(slices, "line 11, column 1, has the features at 1.0");
    slices.features = "-1. 0. 2. 1. 3.\n0. 0. 1. 2. 3.\n2. 0. 1. 2. 3.\n";
    refused(slices, "features must ascend");
    slices.features = "-1. 0. -1. 1. 3.\n0. 0. 1. 2. 3.\n2. 0. 1. 2. 3.\n";
    refused(slices, "after a missing one");
    slices.features = "-1. 0. 1. 2. 3.\n";
    refused(slices, "is the end of the file");
    slices.head = "0. 1000.\n3\n1 1 0\n1\n";
    refused(slices, "has NKINK = 1; here it must be 0 to 0");
    slices.head = "0. 1000.\n5000\n";
    refused(slices, "has NSLC = 5000");
    slices.head = "0. 1000.\n3\n0 0\n1\n";
    refused(slices, "line 4, column 1, has NACCEL = 1; here it must be 0 to 0");
}

TEST_CASE("the public lists of slices are read, and their profiles are there", "[contact_files]") {
    if (!std::filesystem::exists(folder)) SKIP("there is no " + folder.string());
    std::size_t lists = 0, slices = 0, interrupted = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.path().extension().string().starts_with(".slc")) continue;
        INFO(entry.path());
        std::ostringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        const ContactSlices read = read_contact_slices(text.str(), entry.path().filename().string());
        ++lists;
        slices += read.slices.size();
        for (const ContactSlice& slice : read.slices) {
            CHECK(std::filesystem::exists(entry.path().parent_path() / slice.file));
            for (const double feature : slice.features) interrupted += feature < 0;
        }
    }
    CHECK(lists == 9);
    CHECK(slices > 300);
    CHECK(interrupted > 0);
}
