// The stages of a build: the paper's TEST 3 for steel, h = 0.8 mm, L = 1024 mm. One build a configuration; every row
// shows one of its stages, as its evidence has it.
#include <benchmark/benchmark.h>

#include <map>
#include <string>

#include "contactd/fem/ic_builder.hpp"

namespace {

using namespace contactd;
using Seconds = double IcEvidence::*;

const IcEvidence& evidence_of(const std::string& preset) {
    static std::map<std::string, IcEvidence> built;
    auto at = built.find(preset);
    if (at == built.end()) {
        IcSpec spec;
        spec.material = {82000, 0.28};
        spec.dx = spec.dy = 0.8;
        spec.nx = spec.ny = 10;
        spec.source = IcSource::fem;
        spec.fem = fem_preset(preset).value();
        spec.fem.L_over_h = 1024 / 0.8;
        Observer observer;
        at = built.emplace(preset, fem::build_ic_table(spec, observer).evidence).first;
    }
    return at->second;
}

void build_stage(benchmark::State& state, const std::string& preset, Seconds stage) {
    const IcEvidence& evidence = evidence_of(preset);
    for ([[maybe_unused]] const auto iteration : state) state.SetIterationTime(evidence.*stage);
    state.counters["dofs"] = static_cast<double>(evidence.dofs);
}

}  // namespace

int main(int argc, char** argv) {
    const fem::Runtime runtime(argc, argv);
    benchmark::Initialize(&argc, argv);
    for (const std::string preset : {"paper-test3", "paper-test2"}) {
        const auto row = [&](const char* name, Seconds stage) {
            benchmark::RegisterBenchmark(("build/" + preset + "/" + name).c_str(), build_stage, preset, stage)
                ->UseManualTime()
                ->Iterations(1)
                ->Unit(benchmark::kMillisecond);
        };
        row("assembly", &IcEvidence::assembly_seconds);
        row("amg_setup", &IcEvidence::setup_seconds);
        row("solve", &IcEvidence::solve_seconds);
        row("total", &IcEvidence::total_seconds);
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
