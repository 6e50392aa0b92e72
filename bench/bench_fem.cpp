// Compares tables by accuracy with the paper's method (TEST 3, L = 1024 mm, BoomerAMG, three load cases, 1e-8), and
// measures the stages of a build, for steel, h = 0.8 mm. It makes one build per configuration. Every row shows the
// time from its evidence.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <map>
#include <string>

#include "contactd/fem/ic_builder.hpp"

namespace {

using namespace contactd;
using Seconds = double BuildSeconds::*;

IcSpec steel_spec(int n) {
    IcSpec spec;
    spec.material = {82000, 0.28};
    spec.dx = spec.dy = 0.8;
    spec.nx = spec.ny = n;
    spec.source = IcSource::fem;
    return spec;
}

const IcEvidence& evidence_of(const std::string& preset) {
    static std::map<std::string, IcEvidence> built;
    auto at = built.find(preset);
    if (at == built.end()) {
        IcSpec spec = steel_spec(10);
        spec.fem = fem_preset(preset).value();
        spec.fem.L_over_h = 1024 / 0.8;
        Observer observer;
        at = built.emplace(preset, fem::build_ic_table(spec, observer).evidence).first;
    }
    return at->second;
}

void build_stage(benchmark::State& state, const std::string& preset, Seconds stage) {
    const IcEvidence& evidence = evidence_of(preset);
    for ([[maybe_unused]] const auto iteration : state) state.SetIterationTime(evidence.seconds.*stage);
    state.counters["dofs"] = static_cast<double>(evidence.dofs);
}

double peak_mebibytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// Measures one whole build. Its peak memory is that of the process so far, so cheaper builds run first.
void whole_build(benchmark::State& state, const IcSpec& spec) {
    for ([[maybe_unused]] const auto iteration : state) {
        Observer observer;
        const IcEvidence evidence = fem::build_ic_table(spec, observer).evidence;
        state.SetIterationTime(evidence.seconds.total);
        state.counters["dofs"] = static_cast<double>(evidence.dofs);
        state.counters["peak_MiB"] = peak_mebibytes();
        state.counters["error_zz"] = evidence.errors.zz->largest;
        state.counters["error_xx"] = evidence.errors.xx->largest;
    }
}

void register_accuracies() {
    constexpr int extent = 40;
    const auto row = [](const std::string& name, const IcSpec& spec) {
        benchmark::RegisterBenchmark(("table/" + name).c_str(), whole_build, spec)
            ->UseManualTime()
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    };
    for (const auto& [name, accuracy] : {std::pair{"1e-2", 1e-2}, {"1e-3", 1e-3}, {"1e-4", 1e-4}}) {
        IcSpec spec = steel_spec(extent);
        spec.accuracy = accuracy;
        row(std::string("accuracy_") + name, spec);
    }
    for (const Solver solver : {Solver::direct, Solver::amg_pcg}) {
        IcSpec spec = steel_spec(extent);
        spec.fem = fem_preset("paper-test3").value();
        spec.fem.L_over_h = 1024 / spec.dx;
        spec.fem.solver = solver;
        // With dx = dy, symmetry would replace the load along y, but the paper's method solves all three.
        spec.dy *= 1 + 1e-9;
        row(solver == Solver::direct ? "paper_direct" : "paper", spec);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const fem::Runtime runtime(argc, argv);
    benchmark::Initialize(&argc, argv);
    register_accuracies();
    for (const std::string preset : {"paper-test3", "paper-test2"}) {
        const auto row = [&](const char* name, Seconds stage) {
            benchmark::RegisterBenchmark(("build/" + preset + "/" + name).c_str(), build_stage, preset, stage)
                ->UseManualTime()
                ->Iterations(1)
                ->Unit(benchmark::kMillisecond);
        };
        row("assembly", &BuildSeconds::assembly);
        row("amg_setup", &BuildSeconds::setup);
        row("solve", &BuildSeconds::solve);
        row("total", &BuildSeconds::total);
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
