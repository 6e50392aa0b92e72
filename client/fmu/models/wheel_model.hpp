// Simulates a wheel on its rail in a sequence of positions, without state between steps.
#pragma once

#include "handles.hpp"

namespace contactd::fmu {

class WheelModel final : public Model {
   public:
    /// `resources` is the folder of profile files named without a folder.
    WheelModel(Tell tell, std::filesystem::path resources) : tell_(std::move(tell)), resources_(std::move(resources)) {}

    void start(const Values& values, const Carried& from) override;
    void solve_start(Values& values) override;
    void step(Values& values, double size) override;
    Carried carried() override { return {.solved = solved_}; }
    const DerivativePlaces& derivative_places() const override;
    std::vector<double> derivatives() override;
    void cancel() override;

   private:
    void say(const Values& values);
    /// Solves and stores outputs in `values`. Returns whether it converged.
    bool solved(Values& values);
    /// Returns the reason why the last step is discarded.
    std::string quality_flags(const Values& values) const;
    void read(Values& values);
    void read_patches(Values& values);

    Tell tell_;  // outlives the handles
    const std::filesystem::path resources_;
    ConnectionHandle connection_;
    WheelHandle wheel_;
    std::vector<double> solved_;  // the numbers of the last step
    bool requests_derivatives_ = false;
    bool has_derivatives_ = false;  // of the numbers above
};

}  // namespace contactd::fmu
