#include "metrics.hpp"

#include <prometheus/counter.h>
#include <prometheus/histogram.h>
#include <prometheus/text_serializer.h>

#include <cmath>
#include <utility>

namespace contactd::server {

using nlohmann::json;
using prometheus::ClientMetric;
using prometheus::MetricFamily;
using prometheus::MetricType;

namespace {

constexpr std::string_view unknown = "unknown";

/// Upper bounds (s): from an answer without work to a build.
const prometheus::Histogram::BucketBoundaries latency_bounds{2.5e-4, 5e-4, 1e-3, 2.5e-3, 5e-3, 0.01, 0.025, 0.05, 0.1,
                                                             0.25,   0.5,  1,    2.5,    5,    10,   30,    60,   300};

ClientMetric sample(MetricType type, double value) {
    ClientMetric metric;
    (type == MetricType::Counter ? metric.counter.value : metric.gauge.value) = value;
    return metric;
}

MetricFamily family(MetricType type, std::string name, std::string help, std::string_view label,
                    const std::vector<LabelValue>& values) {
    MetricFamily made{std::move(name), std::move(help), type, {}};
    for (const auto& [text, value] : values) {
        made.metric.push_back(sample(type, value));
        made.metric.back().label.push_back({std::string(label), std::string(text)});
    }
    return made;
}

json sample_of(MetricType type, const ClientMetric& metric) {
    json sample{{"labels", json::object()}};
    for (const auto& label : metric.label) sample["labels"][label.name] = label.value;
    if (type != MetricType::Histogram) {
        sample["value"] = type == MetricType::Counter ? metric.counter.value : metric.gauge.value;
        return sample;
    }
    sample["count"] = metric.histogram.sample_count;
    sample["sum"] = metric.histogram.sample_sum;
    sample["buckets"] = json::array();
    for (const auto& bucket : metric.histogram.bucket)
        if (std::isfinite(bucket.upper_bound))
            sample["buckets"].push_back({{"le", bucket.upper_bound}, {"count", bucket.cumulative_count}});
    return sample;
}

const char* name_of(MetricType type) {
    if (type == MetricType::Histogram) return "histogram";
    return type == MetricType::Counter ? "counter" : "gauge";
}

}  // namespace

RequestMetrics::RequestMetrics(const std::vector<std::string>& methods)
    : answers_(prometheus::BuildCounter()
                   .Name("contactd_requests_total")
                   .Help("Requests answered, by method and status.")
                   .Register(registry_)),
      errors_(prometheus::BuildCounter()
                  .Name("contactd_request_errors_total")
                  .Help("Requests answered with a status other than OK, by reason.")
                  .Register(registry_)) {
    auto& seconds = prometheus::BuildHistogram()
                        .Name("contactd_request_duration_seconds")
                        .Help("Time from receiving a request to its answer, by method.")
                        .Register(registry_);
    const auto add = [&](std::string_view name) {
        const std::string method(name);
        methods_[method] = {{{"OK", &answers_.Add({{"method", method}, {"status", "OK"}})}},
                            &seconds.Add({{"method", method}}, latency_bounds)};
    };
    for (const std::string& name : methods) add(name);
    add(unknown);
    // Defined from the start, so that the first event is visible as a change.
    for (const auto reason : {proto::reason::queue_full, proto::reason::stopping})
        by_reason_.emplace(reason, &errors_.Add({{"reason", std::string(reason)}}));
}

void RequestMetrics::record(const Answer& answer) {
    auto method = methods_.find(answer.method);
    if (method == methods_.end()) method = methods_.find(unknown);
    auto& by_status = method->second.by_status;
    auto count = by_status.find(answer.status);
    if (count == by_status.end())
        count = by_status.emplace(answer.status, &answers_.Add({{"method", method->first}, {"status", answer.status}}))
                    .first;
    count->second->Increment();
    method->second.seconds->Observe(answer.milliseconds / 1000);
    if (answer.reason.empty()) return;
    auto error = by_reason_.find(answer.reason);
    if (error == by_reason_.end())
        error = by_reason_.emplace(answer.reason, &errors_.Add({{"reason", answer.reason}})).first;
    error->second->Increment();
}

MetricFamily counter(std::string name, std::string help, double value) {
    return {std::move(name), std::move(help), MetricType::Counter, {sample(MetricType::Counter, value)}};
}

MetricFamily gauge(std::string name, std::string help, double value) {
    return {std::move(name), std::move(help), MetricType::Gauge, {sample(MetricType::Gauge, value)}};
}

MetricFamily counter(std::string name, std::string help, std::string_view label,
                     const std::vector<LabelValue>& values) {
    return family(MetricType::Counter, std::move(name), std::move(help), label, values);
}

MetricFamily gauge(std::string name, std::string help, std::string_view label, const std::vector<LabelValue>& values) {
    return family(MetricType::Gauge, std::move(name), std::move(help), label, values);
}

json to_json(const MetricFamilies& families) {
    json metrics = json::array();
    for (const MetricFamily& each : families) {
        json samples = json::array();
        for (const ClientMetric& metric : each.metric) samples.push_back(sample_of(each.type, metric));
        metrics.push_back(
            {{"name", each.name}, {"type", name_of(each.type)}, {"help", each.help}, {"samples", std::move(samples)}});
    }
    return {{"metrics", std::move(metrics)}};
}

std::string to_prometheus(const MetricFamilies& families) {
    return prometheus::TextSerializer().Serialize(families);
}

}  // namespace contactd::server
