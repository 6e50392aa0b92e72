// Solves steps of sessions of a wheel on its rail.
#include <algorithm>
#include <utility>

#include "below_wheel_rail.hpp"
#include "contactd/proto/codec.hpp"
#include "simulation.hpp"

namespace contactd::server {
namespace {

// These are bytes of a point of a profile, as given and in its curves, and bytes of an element of a patch, in a state
// with its answer and in the previous state.
constexpr std::size_t bytes_per_point = 400, bytes_per_element_state = 184, bytes_beside = 65536;
constexpr std::size_t points_of_formulae = 2000;  // of what is generated

/// Estimates the number of points. Those of a file are unknown before it is read, but a point has at least four bytes.
/// Its text is also kept.
std::size_t points_of(const ProfileSpec& profile) {
    constexpr std::size_t least_bytes = 4;
    if (const auto* file = std::get_if<ProfileFile>(&profile.shape))
        return std::min(file->text.size() / least_bytes, most_profile_points) + file->text.size() / bytes_per_point;
    const auto* given = std::get_if<ProfilePoints>(&profile.shape);
    return given ? given->points.size() : points_of_formulae;
}

class WheelRailSimulation final : public Simulation {
   public:
    explicit WheelRailSimulation(std::unique_ptr<engine::WheelRailSteps> steps) : steps_(std::move(steps)) {}

    engine::StepState start() const override { return {}; }

    Solved solve(const engine::StepState& before, const StepRequest& request, proto::ArrayWriter& arrays,
                 Observer& observer, engine::Engine& engine) override {
        if (!proto::is_of_wheel_rail(request.params))
            throw proto::invalid_field("wheelrail", "is missing; every step of a wheel on its rail requires it");
        if (request.check_rest) request.check_rest();
        const WheelRailStepInput input = proto::decode_wheel_rail_step(request.params);
        Solved solved;
        const auto begun = RecentSolves::Clock::now();
        const WheelRailSolution solution =
            below_wheel_rail([&] { return engine.solve(*steps_, before, input, solved.after, observer); });
        request.recent.add(*request.call, begun, solution);
        solved.text =
            proto::write_step_reply(before.step + 1, solution, {input.fields, input.gap, input.patches}, arrays);
        return solved;
    }

    SessionInfo common() const override {
        SessionInfo info;
        info.side = steps_->setup().side;
        return info;
    }
    std::size_t elements(const engine::StepState& state) const override {
        std::size_t sum = 0;
        for (const WheelRailEstimates::Patch& patch : state.wheel_rail.patches) sum += patch.grid.size();
        return sum;
    }
    // Searches for contacts and heights take several times as long.
    bool is_small() const override { return false; }
    std::size_t bytes() const override { return session_bytes(steps_->setup()); }
    std::size_t state_bytes(const engine::StepState& state) const override {
        return bytes_beside + elements(state) * bytes_per_element_state;
    }

   private:
    const std::unique_ptr<engine::WheelRailSteps> steps_;
};

}  // namespace

std::size_t session_bytes(const WheelRailSetup& setup) {
    std::size_t points = points_of(setup.wheel);
    if (setup.rail_slices.empty()) points += points_of(setup.rail);
    for (const RailSlice& slice : setup.rail_slices) points += points_of(slice.profile);
    for (const WheelSlice& slice : setup.wheel_slices) points += points_of(slice.profile);
    return bytes_beside + points * bytes_per_point;
}

std::unique_ptr<Simulation> simulation_of(std::unique_ptr<engine::WheelRailSteps> steps) {
    return std::make_unique<WheelRailSimulation>(std::move(steps));
}

}  // namespace contactd::server
