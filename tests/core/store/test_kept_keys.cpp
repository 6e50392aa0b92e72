// Tests keys of all kinds of tables against recorded ones. A changed key makes every store build its tables again, so
// ic_keys.json may only grow.
#include <catch2/catch_test_macros.hpp>

#include <fstream>
#include <set>
#include <string>

#include "contactd/ic_store.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"

using namespace contactd;
using nlohmann::json;

TEST_CASE("Every table keeps its key") {
    const json list = json::parse(std::ifstream(CONTACTD_IC_KEYS));
    std::set<std::string> keys;
    for (const auto& entry : list) {
        const json& params = entry["params"];
        CAPTURE(params.dump());
        REQUIRE(proto::violations_of("ic.get.params", params).empty());
        const IcSpec spec = proto::decode_ic_spec(params);
        REQUIRE_NOTHROW(validate(spec));
        CHECK(ic_key(spec) == entry["key"].get<std::string>());
        keys.insert(entry["key"]);
    }
    CHECK(keys.size() > 30);
}
