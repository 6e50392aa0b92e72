// Reads metrics of this process from the kernel.
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "metrics.hpp"

namespace contactd::server {
namespace {

/// Holds pages of memory: all mapped ones, and the resident ones.
std::pair<double, double> memory_bytes() {
    std::ifstream file("/proc/self/statm");
    double total = 0, resident = 0;
    file >> total >> resident;
    const auto page = static_cast<double>(::sysconf(_SC_PAGESIZE));
    return {total * page, resident * page};
}

double processor_seconds() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double entries_of(const char* folder) {
    std::error_code error;
    double count = 0;
    for (auto entry = std::filesystem::directory_iterator(folder, error);
         !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
        ++count;
    return count;
}

double most_descriptors() {
    rlimit limit{};
    ::getrlimit(RLIMIT_NOFILE, &limit);
    return static_cast<double>(limit.rlim_cur);
}

}  // namespace

MetricFamilies process_metrics() {
    const auto [mapped, resident] = memory_bytes();
    return {
        gauge("process_resident_memory_bytes", "Resident memory of the daemon, without builders.", resident),
        gauge("process_virtual_memory_bytes", "Memory mapped by the daemon.", mapped),
        counter("process_cpu_seconds_total", "Processor time of the daemon, without builders.", processor_seconds()),
        gauge("process_open_fds", "Open file descriptors.", entries_of("/proc/self/fd") - 1),
        gauge("process_max_fds", "File descriptors that may be open.", most_descriptors()),
        gauge("process_threads", "Threads of the daemon.", entries_of("/proc/self/task"))};
}

}  // namespace contactd::server
