// Reads metrics of this process from Windows.
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include <psapi.h>

#include "operation/metrics/metrics.hpp"

namespace contactd::server {
namespace {

double processor_seconds() {
    FILETIME start{}, end{}, kernel{}, user{};
    if (!::GetProcessTimes(::GetCurrentProcess(), &start, &end, &kernel, &user)) return 0;
    const auto seconds = [](const FILETIME& time) {
        return (static_cast<double>(time.dwHighDateTime) * 4294967296.0 + static_cast<double>(time.dwLowDateTime)) *
               1e-7;
    };
    return seconds(kernel) + seconds(user);
}

}  // namespace

MetricFamilies process_metrics() {
    PROCESS_MEMORY_COUNTERS memory{};
    ::GetProcessMemoryInfo(::GetCurrentProcess(), &memory, sizeof memory);
    return {gauge("process_resident_memory_bytes", "Resident memory of the process.",
                  static_cast<double>(memory.WorkingSetSize)),
            gauge("process_virtual_memory_bytes", "Memory that the process has reserved for itself.",
                  static_cast<double>(memory.PagefileUsage)),
            counter("process_cpu_seconds_total", "Processor time of the process.", processor_seconds())};
}

}  // namespace contactd::server
