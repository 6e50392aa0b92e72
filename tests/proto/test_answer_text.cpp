// Compares a client's reader of answers with nlohmann's: both read the same documents and values.
#include <catch2/catch_test_macros.hpp>

#include <bit>
#include <random>
#include <string>

#include "contactd/proto/answer_text.hpp"
#include "contactd/proto/message.hpp"
#include "contactd/proto/schema.hpp"

using namespace contactd::proto;
using nlohmann::json;

namespace {

using Generator = std::mt19937;

std::size_t below(Generator& generator, std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(generator);
}

/// Flips, drops, doubles or inserts a few bytes.
std::string damaged(std::string text, Generator& generator) {
    static const std::string interesting = "{}[]\",:0123456789.eE+-\\untfals \xff\xc3\x01/b";
    for (std::size_t times = 1 + below(generator, 3); times > 0 && !text.empty(); --times) {
        const std::size_t at = below(generator, text.size());
        const char other = interesting[below(generator, interesting.size())];
        switch (below(generator, 4)) {
            case 0:
                text[at] = other;
                break;
            case 1:
                text.erase(at, 1 + below(generator, 3));
                break;
            case 2:
                text.insert(at, text.substr(at, 1 + below(generator, 4)));
                break;
            default:
                text.insert(at, 1, other);
        }
    }
    return text;
}

void compare(const std::string& text) {
    CAPTURE(text);
    const json expected = json::parse(text, nullptr, false);
    const auto parsed = AnswerText::parsed(text);
    if (expected.is_discarded() != !parsed) CHECK(expected.is_discarded() == !parsed);
    if (!expected.is_discarded() && parsed && parsed->root().json() != expected)
        CHECK(parsed->root().json() == expected);
}

}  // namespace

TEST_CASE("Answers are read as nlohmann reads them, whole and damaged") {
    Generator generator(3);
    for (const std::string& method : method_names())
        for (const char* part : {".params", ".result"})
            for (const json& example : schema(method + part).value("examples", json::array())) {
                const std::string text = dump(example);
                compare(text);
                compare(example.dump(2));
                for (int i = 0; i < 200; ++i) compare(damaged(text, generator));
            }
}

TEST_CASE("Numbers of answers are read to the last bit") {
    Generator generator(5);
    for (int i = 0; i < 20'000; ++i) {
        const auto number = std::bit_cast<double>((std::uint64_t{generator()} << 32U) | generator());
        if (!std::isfinite(number)) continue;
        const auto parsed = AnswerText::parsed(dump(json(number)));
        REQUIRE(parsed);
        if (std::bit_cast<std::uint64_t>(parsed->root().number()) != std::bit_cast<std::uint64_t>(number))
            CHECK(parsed->root().number() == number);
    }
    for (const char* text : {"0",
                             "-0",
                             "-0.0",
                             "1e-400",
                             "1e400",
                             "-1e400",
                             "9223372036854775807",
                             "9223372036854775808",
                             "-9223372036854775808",
                             "18446744073709551616",
                             "1E5",
                             "1e+5",
                             "4.9e-324",
                             "2e-324",
                             "01",
                             "1.",
                             ".5",
                             "+1",
                             "-",
                             "1e",
                             "NaN",
                             "Infinity",
                             "-Infinity",
                             "nan",
                             "0x10",
                             "1_0"})
        compare(text);
}

TEST_CASE("Texts and structures of answers are read as by nlohmann") {
    for (const char* text : {R"("")",
                             R"("a\nb")",
                             R"("\u00b5m")",
                             R"("\ud83d\ude00")",
                             R"("\ud83d")",
                             R"("\x")",
                             "\"\xc2\xb5\"",
                             "\"\xff\"",
                             "\"a\x01\"",
                             "\"",
                             "\"\\",
                             "\"\\\"",
                             "[",
                             "]",
                             "[1,]",
                             "[,1]",
                             "{\"a\":}",
                             "{\"a\" 1}",
                             "{a:1}",
                             "{\"a\":1,}",
                             "{,}",
                             "[1 2]",
                             "[] []",
                             "null",
                             "nul",
                             "true",
                             "tru",
                             "false",
                             " [ 1 , 2 ] ",
                             "{ \"a\" : [ ] , \"b\" : { } }",
                             "",
                             " ",
                             "\xef\xbb\xbf{}",
                             "{\"a\\u0062\":1}"})
        compare(text);
}

TEST_CASE("An answer that is nested without end is refused") {
    const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    CHECK(AnswerText::parsed(nested(200)));
    CHECK_FALSE(AnswerText::parsed(nested(100'000)));
}

TEST_CASE("Members of answers are found by name") {
    const auto parsed =
        AnswerText::parsed(R"({"b": [1, {"c": 2.5}], "a": {"d": "text", "e": [], "f": true}, "g": null})");
    REQUIRE(parsed);
    const AnswerValue root = parsed->root();
    CHECK(root.size() == 3);
    CHECK(root["a"]["d"].text() == "text");
    CHECK(root["a"]["f"].flag());
    CHECK(root["a"]["e"].size() == 0);
    CHECK(root["g"].is_null());
    CHECK_FALSE(root.find("c"));
    CHECK_FALSE(root["b"].find("c"));
    CHECK_FALSE(AnswerText::parsed("[[1, 2]]")->root().find("ab"));
    CHECK_THROWS_AS(root["c"], contactd::Error);
    double sum = 0;
    for (const AnswerValue element : root["b"]) sum += element.is_object() ? element["c"].number() : element.number();
    CHECK(sum == 3.5);
}
