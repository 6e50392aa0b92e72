// Tests that randomly damaged requests are either read or refused with a status.
#include <catch2/catch_test_macros.hpp>

#include <random>

#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "solve_replies.hpp"
#include "wire.hpp"

using namespace contactd;
using namespace contactd::proto;
using nlohmann::json;

namespace {

using Generator = std::mt19937;

std::size_t below(Generator& generator, std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(generator);
}

json given_params() {
    json params = wire::solve_params();
    const json component = {{1, 0, 0}, {0, 0, 0}};
    params["ics"] = {{"source", "table"}, {"table", json(3, json(3, component))}, {"dx", 0.06}, {"dy", 0.06}};
    return params;
}

json rolling_params() {
    json params = wire::solve_params();
    params.erase("approach");
    params["Fn"] = 9.2;
    params["model"] = "full";
    params["gap"] = {{"semi_axes", {{"a", 1}, {"b", 2}}}};
    params["bodies"]["lower"] = {{"rigid", true}};
    params["friction"] = json::parse(R"({"mu": [[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]],
        "kinetic": {"law": "linear", "mu": 0.1, "slip_velocity": 3},
        "rolling": {"xi": 1e-3, "kind": "transient", "steps": 3, "force": [null, 1.5]}})");
    params["previous"]["pressure"] = {{1, 2, 3}, {4, 5, 6}};
    return params;
}

json export_params() {
    json params = wire::ic_params();
    params["format"] = "contact";
    params["lower"] = params["material"];
    return params;
}

std::string request_text(const std::string& method, const json& params) {
    return dump({{"contactd", 1}, {"id", "7f"}, {"method", method}, {"timeout_ms", 2000}, {"params", params}});
}

/// Flips, drops, doubles or inserts a few bytes.
std::string damaged(std::string text, Generator& generator) {
    static const std::string interesting = "{}[]\",:0123456789.eE+-\\untfals \xff\xc3";
    const std::size_t times = 1 + below(generator, 4);
    for (std::size_t i = 0; i < times && !text.empty(); ++i) {
        const std::size_t at = below(generator, text.size());
        switch (below(generator, 4)) {
            case 0:
                text[at] = static_cast<char>(below(generator, 256));
                break;
            case 1:
                text.erase(at, 1 + below(generator, 8));
                break;
            case 2:
                text.insert(at, text.substr(at, 1 + below(generator, 20)));
                break;
            default:
                text.insert(at, 1, interesting[below(generator, interesting.size())]);
        }
    }
    return text;
}

json odd_value(Generator& generator) {
    static const json values = json::parse(
        R"([null, true, "", "text", -1, 0, 1, 2, 0.5, 1.5, -0.0, 1e-320, 1e300, 4000000, 5000000000, 9223372036854775807,
            [], {}, [1], [[1, 2, 3], [4, 5, 6]], {"array": [1]}, {"$array": {"frame": 1, "dtype": "<f8", "shape": [2, 3]}},
            {"$array": {"frame": 9, "dtype": "|u1", "shape": [0]}}, "analytic", "fem"])");
    return values[below(generator, values.size())];
}

/// Replaces, removes or adds a value somewhere in the document.
void damage(json& node, Generator& generator) {
    if (node.is_structured() && !node.empty() && below(generator, 4) != 0) {
        auto at = node.begin();
        std::advance(at, static_cast<std::ptrdiff_t>(below(generator, node.size())));
        if (below(generator, 10) == 0)
            node.erase(at);
        else
            damage(*at, generator);
    } else if (node.is_object() && below(generator, 2) == 0) {
        static const char* names[]{"nx",    "array",   "paraboloid", "$array",   "source",   "order",
                                   "other", "lower",   "initial",    "Fn",       "model",    "rigid",
                                   "force", "rolling", "semi_axes",  "previous", "approach", "rigid_shift"};
        node[names[below(generator, std::size(names))]] = odd_value(generator);
    } else {
        node = odd_value(generator);
    }
}

bool says_what_would_be_right(const std::string& description) {
    for (const char* phrase : {"it must", "known fields", "cannot be combined with"})
        if (description.find(phrase) != std::string::npos) return true;
    return false;
}

struct Outcome {
    int read = 0;
    int refused = 0;
};

void decode_all(const Request& request) {
    check_referred_elements(request.params.at("problems"));
    for (const auto& problem : request.params.at("problems")) decode_problem(problem, request.frames);
}

/// Handles a message as the server does before it works on it.
void handle(const std::string& text, const Frames& frames, Outcome& outcome) {
    std::string id;
    try {
        const Request request = parse_request(text, frames, {}, id);
        check_params(request.method, request.params);
        check_frames_used(request.params, request.frames);
        if (request.method == "ic.get") decode_ic_spec(request.params);
        if (request.method == "ic.export") decode_ic_export(request.params);
        if (request.method == "contact.solve") decode_problem(request.params, request.frames);
        if (request.method == "contact.solve_many") decode_all(request);
        if (request.method == "contact.subsurface") decode_subsurface_request(request.params, request.frames);
        if (request.method == "contact.temperature") decode_temperature_request(request.params, request.frames);
        ++outcome.read;
    } catch (const StatusError& error) {
        CHECK_FALSE(error.status().ok());
        CHECK_FALSE(error.status().message.empty());
        CHECK(error.status().message.size() < 10'000);
        dump(to_json(error.status()));
        ++outcome.refused;
    }
}

}  // namespace

TEST_CASE("Damaged text is read or refused", "[fuzz]") {
    Generator generator(20240229);
    Outcome outcome;
    for (int i = 0; i < 10'000; ++i) {
        const bool solve = i % 2 == 0;
        const std::string text =
            solve ? request_text("contact.solve", wire::solve_params()) : request_text("ic.get", wire::ic_params());
        handle(damaged(text, generator), {}, outcome);
    }
    CHECK(outcome.read + outcome.refused == 10'000);
    CHECK(outcome.read > 50);
    CHECK(outcome.refused > 1000);
}

TEST_CASE("Damaged parameters are read or refused, with a field where a schema is broken", "[fuzz]") {
    Generator generator(4711);
    Outcome outcome;
    const std::pair<std::string, json> requests[]{
        {"contact.solve", wire::solve_params()},
        {"contact.solve", given_params()},
        {"contact.solve", rolling_params()},
        {"contact.solve_many", {{"problems", json::array({rolling_params(), given_params()})}}},
        {"contact.subsurface", wire::subsurface_params()},
        {"contact.temperature", wire::temperature_params()},
        {"ic.get", wire::ic_params()},
        {"ic.export", export_params()}};
    for (int i = 0; i < 4'000; ++i) {
        const auto [method, original] = requests[below(generator, std::size(requests))];
        json params = original;
        const std::size_t times = 1 + below(generator, 3);
        for (std::size_t n = 0; n < times; ++n) damage(params, generator);
        if (params.is_object())
            for (const Violation& violation : violations_of(method + ".params", params)) {
                CAPTURE(params.dump(), violation.field, violation.description);
                CHECK_FALSE(violation.field.empty());
                CHECK(says_what_would_be_right(violation.description));
            }
        const Frames frames(below(generator, 2), std::string(48, '\0'));
        handle(request_text(method, params), frames, outcome);
    }
    CHECK(outcome.read + outcome.refused == 4'000);
    CHECK(outcome.read > 100);
    CHECK(outcome.refused > 1000);
}

TEST_CASE("Damaged answers are read or refused", "[fuzz]") {
    Generator generator(99);
    ArrayWriter arrays(ArrayEncoding::frame);
    const json result = encode_solve_reply(wire::solve_reply(), Grid::of_elements(3, 2, 1, 1), arrays);
    const auto frames = arrays.take_frames();
    int read = 0;
    for (int i = 0; i < 2'000; ++i) {
        json bad = result;
        damage(bad, generator);
        if (!violations_of("contact.solve.result", bad).empty()) continue;
        try {
            decode_solve_reply(bad, frames);
            ++read;
        } catch (const StatusError&) {
        }
    }
    CHECK(read > 0);
}
