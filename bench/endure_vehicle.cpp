// Checks that memory and answers stay stable over many steps of a vehicle (vehicle.hpp). At regular intervals it
// prints the resident memory, and the largest difference of a wheel's forces, over its load, from reference forces.
// The reference wheels are created for one step, at the same heights and with tolerances a hundred times smaller. The
// exit code is 1 if a difference exceeds the accuracy, or if memory has grown by a tenth since the first tenth of the
// steps.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <string>

#include "vehicle.hpp"

namespace {

using namespace contactd::bench;

double resident_mebibytes() {
    std::ifstream of_process("/proc/self/statm");
    double all = 0, resident = 0;
    of_process >> all >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

double difference(const Vehicle& vehicle, Run run, int k, const char* model, double accuracy) {
    Vehicle fresh(model, 0.01 * accuracy);
    fresh.step(run, k, 1, &vehicle.heights());
    double largest = 0;
    for (std::size_t wheel = 0; wheel < vehicle.forces().size(); ++wheel)
        for (std::size_t i = 0; i < 3; ++i)
            largest = std::max(largest, std::abs(vehicle.forces()[wheel][i] - fresh.forces()[wheel][i]) / static_Fz);
    return largest;
}

int endure(const std::string& model, int steps, int threads, double accuracy) {
    constexpr int rows = 100;
    Vehicle vehicle(model.c_str(), accuracy);
    const int between = std::max(1, steps / rows);
    double first = 0, memory = 0, worst = 0;
    std::printf("step,run,resident_mebibytes,difference\n");
    for (int k = 0; k < steps; ++k) {
        // Both runs alternate, so that flange contact starts and ends again.
        const Run run = k / 700 % 2 == 0 ? Run::hunting : Run::curving;
        vehicle.step(run, k, threads);
        if ((k + 1) % between != 0) continue;
        const double off = difference(vehicle, run, k, model.c_str(), accuracy);
        worst = std::max(worst, off);
        memory = resident_mebibytes();
        if (k < steps / 10) first = memory;  // caches fill during these steps
        std::printf("%d,%s,%.1f,%.2e\n", k + 1, run == Run::hunting ? "hunting" : "curving", memory, off);
        std::fflush(stdout);
    }
    std::printf("# largest difference %.2e of %.0e; memory %.1f to %.1f MiB\n", worst, accuracy, first, memory);
    return worst <= accuracy && memory <= 1.1 * first ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 5) {
        std::fprintf(stderr, "usage: endure_vehicle MODEL STEPS THREADS ACCURACY (such as full 1000000 2 1e-4)\n");
        return 2;
    }
    return endure(argv[1], std::atoi(argv[2]), std::atoi(argv[3]), std::atof(argv[4]));
} catch (const std::exception& error) {
    std::fprintf(stderr, "endure_vehicle: %s\n", error.what());
    return 2;
}
