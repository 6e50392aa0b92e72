#include "operation/metrics/metrics.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace contactd::server;
using Catch::Matchers::ContainsSubstring;
using nlohmann::json;

namespace {

Answer answer(const std::string& method, const std::string& status, double milliseconds,
              const std::string& reason = {}) {
    return {{"client", false}, "", {}, false, "1", method, status, milliseconds, reason, {}, 0};
}

json metric(const MetricFamilies& families, const std::string& name) {
    const json all = to_json(families);
    for (const json& each : all["metrics"])
        if (each["name"] == name) return each;
    return nullptr;
}

}  // namespace

TEST_CASE("Answers are counted by method and status, errors by reason") {
    RequestMetrics metrics({"contact.solve"});
    for (int n = 0; n < 3; ++n) metrics.record(answer("contact.solve", "OK", 1));
    metrics.record(answer("contact.solve", "RESOURCE_EXHAUSTED", 0, "QUEUE_FULL"));

    const std::string page = to_prometheus(metrics.collect());
    CHECK_THAT(page, ContainsSubstring("contactd_requests_total{method=\"contact.solve\",status=\"OK\"} 3\n"));
    CHECK_THAT(page, ContainsSubstring("{method=\"contact.solve\",status=\"RESOURCE_EXHAUSTED\"} 1\n"));
    CHECK_THAT(page, ContainsSubstring("contactd_request_errors_total{reason=\"QUEUE_FULL\"} 1\n"));
}

TEST_CASE("Methods that do not exist count as one") {
    RequestMetrics metrics({"contact.solve"});
    for (int n = 0; n < 5; ++n)
        metrics.record(answer("no.such" + std::to_string(n), "UNIMPLEMENTED", 0, "UNKNOWN_METHOD"));

    CHECK(metric(metrics.collect(), "contactd_requests_total")["samples"].size() == 3);  // OK of both, and these
    CHECK_THAT(to_prometheus(metrics.collect()),
               ContainsSubstring("{method=\"unknown\",status=\"UNIMPLEMENTED\"} 5\n"));
}

TEST_CASE("Latencies are sorted into buckets whose counts add up") {
    RequestMetrics metrics({"contact.solve"});
    for (const double milliseconds : {0.1, 3.0, 40.0, 1e9}) metrics.record(answer("contact.solve", "OK", milliseconds));

    const json family = metric(metrics.collect(), "contactd_request_duration_seconds");
    for (const json& sample : family["samples"]) {
        if (sample["labels"]["method"] != "contact.solve") continue;
        CHECK(sample["count"] == 4);
        CHECK(sample["buckets"].front()["count"] == 1);
        CHECK(sample["buckets"].back()["count"] == 3);  // 1e6 s are beyond all bounds
        return;
    }
    FAIL("no sample of contact.solve");
}

TEST_CASE("The process is measured") {
    const MetricFamilies families = process_metrics();
    CHECK(metric(families, "process_resident_memory_bytes")["samples"][0]["value"] > 1e6);
    CHECK(metric(families, "process_open_fds")["samples"][0]["value"] >= 3);
    CHECK(metric(families, "process_threads")["samples"][0]["value"] >= 1);
}
