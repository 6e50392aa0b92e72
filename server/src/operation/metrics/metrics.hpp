// Collects metrics of the daemon, for server.info, server.metrics and Prometheus.
#pragma once

#include <prometheus/metric_family.h>
#include <prometheus/registry.h>

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "jobs/call.hpp"

namespace contactd::server {

using MetricFamilies = std::vector<prometheus::MetricFamily>;

/// Counts answers by method and status, and measures their times. Unknown methods and statuses count as one, so that no
/// client can make the list grow.
class RequestMetrics {
   public:
    explicit RequestMetrics(const std::vector<std::string>& methods);

    /// Counts an answer. Only one thread at a time may call it. Takes about half a microsecond.
    void record(const Answer& answer);
    /// Can be called from any thread.
    MetricFamilies collect() const { return registry_.Collect(); }

   private:
    struct Method {
        std::map<std::string, prometheus::Counter*, std::less<>> by_status;
        prometheus::Histogram* seconds;
    };
    prometheus::Registry registry_;
    prometheus::Family<prometheus::Counter>& answers_;
    prometheus::Family<prometheus::Counter>& errors_;
    std::map<std::string, Method, std::less<>> methods_;
    std::map<std::string, prometheus::Counter*, std::less<>> by_reason_;
};

/// Represents a metric with one value, or with several values of one label.
prometheus::MetricFamily counter(std::string name, std::string help, double value);
prometheus::MetricFamily gauge(std::string name, std::string help, double value);
struct LabelValue {
    std::string_view label;
    double value;
};
prometheus::MetricFamily counter(std::string name, std::string help, std::string_view label,
                                 const std::vector<LabelValue>& values);
prometheus::MetricFamily gauge(std::string name, std::string help, std::string_view label,
                               const std::vector<LabelValue>& values);

/// Returns metrics of this process, with the standard names of Prometheus (process_resident_memory_bytes, ...).
MetricFamilies process_metrics();

/// Encodes metrics as on the wire, proto/schema/server.metrics.result.json.
nlohmann::json to_json(const MetricFamilies& families);
/// Encodes metrics in the format of Prometheus.
std::string to_prometheus(const MetricFamilies& families);

}  // namespace contactd::server
