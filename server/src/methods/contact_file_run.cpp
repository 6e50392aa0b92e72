// Implements contact_file.run and contact_file.convert: problems and answers of cases of the CONTACT program.
#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/contact_file.hpp"
#include "handlers.hpp"
#include "jobs/work_on_call.hpp"
#include "run/case_run.hpp"

namespace contactd::server {
namespace {

using nlohmann::json;

/// Solves the problems of cases with the engine of the daemon.
class EngineSolver : public cases::ProblemSolver {
   public:
    EngineSolver(const DaemonParts& parts, Observer& observer) : parts_(parts), observer_(observer) {}

    SolveReply solve(const ContactProblem& problem) override {
        ++parts_.counters.solves;
        return parts_.engine.solve(problem, observer_);
    }
    WheelRailSolution solve(const WheelRailSetup& setup, const WheelRailState& state,
                            WheelRailEstimates& estimates) override {
        ++parts_.counters.solves;
        return parts_.engine.solve(setup, state, estimates, observer_);
    }

   private:
    const DaemonParts& parts_;
    Observer& observer_;
};

std::unique_ptr<cases::CaseRun> new_run(const json& params) {
    return std::make_unique<cases::CaseRun>(proto::decode_contact_file_input(params));
}

/// A run continues with the input of its first call, except for max_elements, by which the cost of each call is known.
std::unique_ptr<cases::CaseRun> continued_run(const json& params, FileRuns& runs) {
    for (const char* name : {"name", "files", "cases", "wheel_surface"})
        if (params.contains(name))
            throw InvalidArgument(name, "is given with run, which continues with that of its first call; remove it");
    return runs.take(params.at("run").get_ref<const std::string&>());
}

constexpr std::size_t most_numbers_of_run = 4'000'000;  // for an answer with more than one case

std::size_t numbers_of_outcome(const ContactFileOutcome& outcome) {
    constexpr std::size_t arrays = 28;  // for the solution and the patch
    std::size_t count = 0;
    for (const ContactFilePatch& patch : outcome.patches) {
        count += arrays * patch.grid.size();
        for (const ContactFileBlock& block : patch.blocks) count += 9 * block.points.size();
    }
    return count;
}

}  // namespace

std::size_t max_elements_of(const json& params, const Config& config) {
    return std::min(params.value("max_elements", ContactFileInput{}.max_elements), config.max_grid_elements);
}

void run_contact_file(const CallPtr& call, const DaemonParts& parts) {
    const json& params = call->request.params;
    proto::check_frames_used(params, call->request.frames);
    const bool continues = params.contains("run");
    std::unique_ptr<cases::CaseRun> run = continues ? continued_run(params, parts.file_runs) : new_run(params);
    run->limit(max_elements_of(params, parts.config));
    const SolutionFields fields = proto::decode_fields(params, all_solution_fields);
    const bool with_arrays = params.value("arrays", true);
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(params.value("seconds", 10.0));
    WorkOnCall work(call, parts.jobs);
    EngineSolver solver(parts, work.observer());
    proto::ArrayWriter arrays(call->request.arrays);
    json result = {{"cases", json::array()}, {"warnings", json::array()}, {"errors", json::array()}};
    std::size_t numbers = 0;
    bool has_ended = false;
    do {
        const auto outcome = run->next(solver, work.observer());
        has_ended = !outcome;
        if (has_ended) break;
        numbers += numbers_of_outcome(*outcome);
        result["cases"].push_back(proto::encode_contact_outcome(*outcome, fields, with_arrays, arrays));
    } while (numbers < most_numbers_of_run && std::chrono::steady_clock::now() < end);
    if (has_ended) {
        result["warnings"] = run->warnings();
        result["errors"] = run->errors();
    } else {
        result["run"] =
            parts.file_runs.keep(std::move(run), continues ? params["run"].get<std::string>() : std::string());
    }
    work.succeed(result, arrays.take_frames());
}

void convert_contact_file(const CallPtr& call, const DaemonParts& parts) {
    const json& params = call->request.params;
    proto::check_frames_used(params, call->request.frames);
    const std::unique_ptr<cases::CaseRun> run = new_run(params);
    run->limit(max_elements_of(params, parts.config));
    WorkOnCall work(call, parts.jobs);
    EngineSolver solver(parts, work.observer());
    proto::ArrayWriter arrays(call->request.arrays);
    json result = {{"cases", json::array()}};
    while (const auto converted = run->convert_next(solver, work.observer()))
        result["cases"].push_back(proto::encode_contact_problem(*converted, arrays));
    work.succeed(result, arrays.take_frames());
}

}  // namespace contactd::server
