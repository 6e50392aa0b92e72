#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <limits>

#include "contactd/proto/message.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;

namespace {

struct Refusal {
    Status status;
    std::string id;

    std::string field() const { return status.violations.empty() ? "" : status.violations[0].field; }
};

Refusal refusal_of(const std::string& text, Frames frames = {}, const MessageLimits& limits = {}) {
    std::string id = "left over";
    const auto status = wire::status_thrown_by([&] { parse_request(text, std::move(frames), limits, id); });
    REQUIRE(status);
    CHECK(status->code == StatusCode::invalid_argument);
    CHECK_FALSE(status->message.empty());
    return {*status, id};
}

std::string envelope_with(const std::string& member) {
    return R"({"contactd": 1, "id": "7f", "method": "server.health", )" + member + "}";
}

}  // namespace

TEST_CASE("A request is read with its defaults", "[message]") {
    std::string id;
    const Request request = parse_request(R"({"contactd": 1, "id": "7f", "method": "server.info"})", {}, {}, id);

    CHECK(id == "7f");
    CHECK(request.id == "7f");
    CHECK(request.method == "server.info");
    CHECK(request.params == json::object());
    CHECK(request.metadata == json::object());
    CHECK(request.timeout_ms == 0);
    CHECK(request.arrays == ArrayEncoding::frame);
    CHECK_FALSE(request.priority);
}

TEST_CASE("A request is read with all its fields", "[message]") {
    std::string id;
    const Request request = parse_request(
        envelope_with(
            R"("timeout_ms": 2000, "arrays": "list", "metadata": {"a": 1}, "priority": "high", "params": {"b": 0.1})"),
        {"first", "second"}, {}, id);

    CHECK(request.timeout_ms == 2000);
    CHECK(request.arrays == ArrayEncoding::list);
    CHECK(request.metadata == json{{"a", 1}});
    CHECK(request.priority == Priority::high);
    CHECK(request.params == json{{"b", 0.1}});
    CHECK(request.frames == Frames{"first", "second"});
}

TEST_CASE("Another version of the protocol is told which side to upgrade", "[message]") {
    const auto status_of = [](const std::string& version) {
        std::string id;
        const auto status = wire::status_thrown_by([&] {
            parse_request(R"({"contactd": )" + version + R"(, "id": "7f", "call": "what 2 may call it"})", {}, {}, id);
        });
        REQUIRE(status);
        CHECK(status->code == StatusCode::unimplemented);
        CHECK(status->reason == "PROTOCOL_VERSION");
        CHECK(status->versions == std::vector<int>{1});
        CHECK(id == "7f");
        return *status;
    };
    CHECK_THAT(status_of("2").message, ContainsSubstring("version 2") && ContainsSubstring("upgrade the daemon"));
    CHECK_THAT(status_of("0").message, ContainsSubstring("upgrade the client"));
    CHECK(status_from_json(to_json(status_of("9999999999"))).versions == std::vector<int>{1});
    CHECK(refusal_of(R"({"contactd": "2", "id": "7f", "method": "a"})").status.reason == "ENVELOPE_INVALID");
}

TEST_CASE("Metadata are few and plain", "[message]") {
    std::string many;
    for (int n = 0; n < 17; ++n) many += (n ? ", \"" : "\"") + std::to_string(n) + "\": 1";
    const auto [metadata, field] =
        GENERATE_COPY(table<std::string, std::string>({{R"({"a": [1]})", "metadata.a"},
                                                       {R"({"a": null})", "metadata.a"},
                                                       {R"({"client": 1})", "metadata.client"},
                                                       {R"({"a": ")" + std::string(257, 'x') + "\"}", "metadata.a"},
                                                       {"{" + many + "}", "metadata"},
                                                       {R"({")" + std::string(65, 'x') + "\": 1}", "metadata"}}));
    CAPTURE(metadata);
    const Refusal refusal = refusal_of(envelope_with(R"("metadata": )" + metadata));
    CHECK(refusal.status.reason == "ENVELOPE_INVALID");
    CHECK(refusal.field() == field);
}

TEST_CASE("A key that is given twice in one object is refused with its place", "[message]") {
    struct Case {
        const char* member;
        const char* field;
    };
    const auto [member, field] =
        GENERATE(Case{R"("id": "80")", "id"}, Case{R"("params": {}, "params": {})", "params"},
                 Case{R"("params": {"grid": {"nx": 3, "ny": 3, "nx": 4}})", "grid.nx"},
                 Case{R"("params": {"a": {"b": 1}, "a": {"b": 1}})", "a"},
                 Case{R"("params": {"a": {"b": 1, "c": [{"d": 1}, {"e": [], "e": []}]}})", "a.c[1].e"},
                 Case{R"("metadata": {"x\u0061": 1, "xa": 2})", "metadata.xa"});

    const Refusal refusal = refusal_of(envelope_with(member));

    CHECK(refusal.status.reason == reason::not_json);
    CHECK(refusal.field() == field);
    CHECK(refusal.status.message == std::string(field) + " is given twice; keys of an object must be unique");
    CHECK(refusal.id == "7f");
}

TEST_CASE("The same key may stand in several objects", "[message]") {
    std::string id;
    CHECK(parse_request(envelope_with(R"("params": {"a": {"a": [{"a": 1}, {"a": 2}]}})"), {}, {}, id)
              .params["a"]["a"][1]["a"] == 2);
}

TEST_CASE("What is not JSON is refused as NOT_JSON", "[message]") {
    const std::string text = GENERATE(as<std::string>{}, "", " ", "{", "hello", "{\"a\": 1,}", "{'a': 1}", "{} {}",
                                      "[1, 2", "\"open", "{\"a\" 1}", "\xff\xfe", "{\"a\": \"\xc3\x28\"}", "nul",
                                      "{\"a\": 01}", "{\"a\": \"\\x\"}", "// comment\n{}");
    CAPTURE(text);
    CHECK(refusal_of(text).status.reason == "NOT_JSON");
}

TEST_CASE("The id is found before the mistake", "[message]") {
    CHECK(refusal_of(R"({"contactd": 1, "id": "7f", "method": oops})").id == "7f");
    CHECK(refusal_of(R"({"contactd": oops, "id": "7f"})").id.empty());
    CHECK(refusal_of(R"({"contactd": "1", "id": "7f", "method": "a"})").id == "7f");
    CHECK(refusal_of(R"([{"id": "7f"}])").id.empty());
    CHECK(refusal_of(R"({"contactd": 1, "id": 7, "method": "a"})").id.empty());
}

TEST_CASE("Numbers that are not finite are refused by field", "[message]") {
    const std::string token =
        GENERATE(as<std::string>{}, "NaN", "nan", "Infinity", "-Infinity", "inf", "-inf", "1e400", "-1e999999999");
    CAPTURE(token);
    const Refusal refusal = refusal_of(envelope_with(R"("params": {"grid": {"dx": )" + token + "}}"));

    CHECK(refusal.status.reason == "NOT_JSON");
    CHECK(refusal.field() == "grid.dx");
    CHECK_THAT(refusal.status.message, ContainsSubstring(token) && ContainsSubstring("finite"));
    CHECK(refusal.id == "7f");
}

TEST_CASE("A number that is not finite is named inside a list", "[message]") {
    CHECK(refusal_of(envelope_with(R"("params": {"gap": {"array": [[1, 2], [3, NaN]]}})")).field() ==
          "gap.array[1][1]");
}

TEST_CASE("Deep nesting is refused without exhausting the stack", "[message]") {
    for (const char* bracket : {"[", "{\"a\":"}) {
        std::string text = R"({"contactd": 1, "id": "7f", "method": "a", "params": )";
        for (int i = 0; i < 1'000'000; ++i) text += bracket;
        const Refusal refusal = refusal_of(text);
        CHECK(refusal.status.reason == "NOT_JSON");
        CHECK_THAT(refusal.status.message, ContainsSubstring("64 levels"));
        CHECK(refusal.status.message.size() < 1000);
        CHECK(refusal.id == "7f");
    }
}

TEST_CASE("JSON that is no object is refused as NOT_AN_OBJECT", "[message]") {
    const std::string text = GENERATE(as<std::string>{}, "[]", "null", "1", "\"text\"", "true", "[{}]");
    CHECK(refusal_of(text).status.reason == "NOT_AN_OBJECT");
}

TEST_CASE("A bad envelope is refused by field", "[message]") {
    struct Case {
        const char* text;
        const char* field;
        const char* says;
    };
    const Case c = GENERATE(
        Case{R"({"id": "1", "method": "a"})", "contactd", "is missing"},
        Case{R"({"contactd": 1.5, "id": "1", "method": "a"})", "contactd", "is 1.5; it must be 1"},
        Case{R"({"contactd": "1", "id": "1", "method": "a"})", "contactd", "is \"1\"; it must be 1"},
        Case{R"({"contactd": 1, "method": "a"})", "id", "is missing"},
        Case{R"({"contactd": 1, "id": "", "method": "a"})", "id", "0 characters; it must have at least 1"},
        Case{R"({"contactd": 1, "id": "\u0000a", "method": "a"})", "id", "begins with a zero byte"},
        Case{R"({"contactd": 1, "id": null, "method": "a"})", "id", "is null; it must be a text"},
        Case{R"({"contactd": 1, "id": "1"})", "method", "is missing"},
        Case{R"({"contactd": 1, "id": "1", "method": 5})", "method", "is 5; it must be a text"},
        Case{R"({"contactd": 1, "id": "1", "method": "a", "params": []})", "params", "is a list without values"},
        Case{R"({"contactd": 1, "id": "1", "method": "a", "timeout_ms": 0})", "timeout_ms",
             "is 0; it must be at least 1"},
        Case{R"({"contactd": 1, "id": "1", "method": "a", "timeout_ms": 1.5})", "timeout_ms",
             "is 1.5; it must be an integer"},
        Case{R"({"contactd": 1, "id": "1", "method": "a", "timeout_ms": 99999999999999999999})", "timeout_ms",
             "integer"},
        Case{R"({"contactd": 1, "id": "1", "method": "a", "timeout_ms": 18446744073709551615})", "timeout_ms",
             "integer"},
        Case{R"({"contactd": 1, "id": "1", "method": "a", "arrays": "csv"})", "arrays", "one of \"frame\", \"list\""},
        Case{R"({"contactd": 1, "id": "1", "method": "a", "metadata": 1})", "metadata", "is 1; it must be an object"},
        Case{R"({"contactd": 1, "id": "1", "method": "a", "extra": 1})", "extra", "is not a field of the envelope"});
    CAPTURE(c.text);
    const Refusal refusal = refusal_of(c.text);

    CHECK(refusal.status.reason == "ENVELOPE_INVALID");
    CHECK(refusal.field() == c.field);
    CHECK_THAT(refusal.status.message, ContainsSubstring(c.says));
}

TEST_CASE("An id of 128 characters is the longest", "[message]") {
    std::string umlauts;
    for (int i = 0; i < 128; ++i) umlauts += "\u00fc";
    std::string id;
    const auto envelope = [](const std::string& text) {
        return dump({{"contactd", 1}, {"id", text}, {"method", "a"}});
    };

    CHECK(parse_request(envelope(umlauts), {}, {}, id).id == umlauts);
    const Refusal refusal = refusal_of(envelope(umlauts + "x"));
    CHECK(refusal.field() == "id");
    CHECK(refusal.id.empty());
}

TEST_CASE("Messages beyond the limits are refused", "[message]") {
    const MessageLimits limits{
        .max_frame_bytes = 100, .max_frames = 3, .max_message_bytes = 200, .max_array_elements = 5};
    const std::string text = R"({"contactd": 1, "id": "7f", "method": "server.info"})";
    const std::string large(100, 'x');
    const auto reason_of = [&](Frames frames) {
        const Refusal refusal = refusal_of(text, std::move(frames), limits);
        CHECK(refusal.id == "7f");
        return refusal.status.reason;
    };

    CHECK(reason_of({"a", "b", "c"}) == "LIMIT_EXCEEDED");
    CHECK(reason_of({large + "x"}) == "LIMIT_EXCEEDED");
    CHECK(reason_of({large, large}) == "LIMIT_EXCEEDED");
    CHECK(refusal_of(text + std::string(100, ' '), {}, limits).status.reason == "LIMIT_EXCEEDED");
    std::string id;
    CHECK(parse_request(text, {large, "b"}, limits, id).frames.size() == 2);
}

TEST_CASE("Lists beyond the limit of elements are refused", "[message]") {
    std::string list = "[0";
    for (int i = 0; i < 20'000; ++i) list += ",0";
    const Refusal refusal =
        refusal_of(envelope_with(R"("params": {"gap": )" + list + "]}"), {}, {.max_array_elements = 1000});
    CHECK(refusal.status.reason == "LIMIT_EXCEEDED");
    CHECK(refusal.id == "7f");
}

TEST_CASE("dump writes whatever it is given as UTF-8", "[message]") {
    CHECK(dump(json{{"a", "\xc3\x28"}}) == "{\"a\":\"\xef\xbf\xbd(\"}");
    CHECK(json::parse(dump(json{{"pi", 3.141592653589793}}))["pi"] == 3.141592653589793);
    CHECK_THAT(dump(json{{"a", std::numeric_limits<double>::quiet_NaN()}}), !ContainsSubstring("NaN"));
}
