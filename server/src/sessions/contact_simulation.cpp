// Sessions of a contact.
#include <utility>

#include "contactd/contact_influence.hpp"
#include "contactd/proto/codec.hpp"
#include "engine/ics/problem_tables.hpp"
#include "simulation.hpp"
#include "solves/small_solve.hpp"

namespace contactd::server {
namespace {

// Counts, beside the operators, the gap, friction and tractions of the problem as opened and as solved, and of the
// current and the previous state, including the state of layers and memory.
constexpr std::size_t bytes_per_element_problem = 400, bytes_per_element_state = 184, bytes_beside = 8192;
constexpr std::size_t bytes_per_element_table = 2 * 9 * sizeof(double);

class ContactSimulation final : public Simulation {
   public:
    explicit ContactSimulation(std::unique_ptr<engine::ContactSteps> steps) : steps_(std::move(steps)) {}

    engine::StepState start() const override { return steps_->start(); }

    Solved solve(const engine::StepState& before, const StepRequest& request, proto::ArrayWriter& arrays,
                 Observer& observer, engine::Engine& engine) override {
        if (proto::is_of_wheel_rail(request.params))
            throw proto::invalid_field("wheelrail", "is given, but this is the session of a contact");
        const auto set_inputs = [&](const std::optional<Motion>& last, ContactProblem& problem) {
            proto::apply_step(request.params, request.call->request.frames, last, problem);
            if (request.check_rest) request.check_rest();
        };
        const auto begun = RecentSolves::Clock::now();
        ContactSolution solution = engine.solve(*steps_, before, set_inputs, observer);
        request.recent.add(*request.call, begun, solution, opened().grid);
        std::string text = proto::dump(proto::encode_step_reply(before.step + 1, solution, opened().grid,
                                                                proto::decode_fields(request.params, {}), arrays));
        return {std::move(text), engine::ContactSteps::after(before, std::move(solution))};
    }

    SessionInfo common() const override {
        SessionInfo info;
        info.grid = opened().grid;
        if (opened().friction)
            info.motion = std::holds_alternative<Rolling>(opened().motion) ? MotionKind::rolling : MotionKind::shift;
        info.ics = engine::uses_of(opened(), steps_->ics());
        return info;
    }
    std::size_t elements(const engine::StepState&) const override { return opened().grid.size(); }
    bool is_small() const override { return is_small_solve(opened().model, opened().grid.size()); }
    std::size_t bytes() const override { return session_bytes(opened()); }
    std::size_t state_bytes(const engine::StepState&) const override {
        return bytes_beside + opened().grid.size() * bytes_per_element_state;
    }

   private:
    const ContactProblem& opened() const { return steps_->opened; }

    const std::unique_ptr<engine::ContactSteps> steps_;
};

}  // namespace

std::size_t session_bytes(const ContactSetup& setup) {
    std::size_t per_element = bytes_per_element_problem + bytes_per_element_state;
    if (setup.bodies.any_given()) per_element += bytes_per_element_table;
    const std::size_t operators = setup.model == Model::full ? influence_bytes(setup.grid, setup.bodies) : 0;
    return bytes_beside + setup.grid.size() * per_element + operators;
}

std::unique_ptr<Simulation> simulation_of(std::unique_ptr<engine::ContactSteps> steps) {
    return std::make_unique<ContactSimulation>(std::move(steps));
}

}  // namespace contactd::server
