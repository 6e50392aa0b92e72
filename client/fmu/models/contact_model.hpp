// A plain contact, step by step.
#pragma once

#include <optional>

#include "handles.hpp"

namespace contactd::fmu {

class ContactModel final : public Model {
   public:
    explicit ContactModel(Tell tell) : tell_(std::move(tell)) {}

    void start(const Values& values, const Carried& from) override;
    void solve_start(Values& values) override;
    void step(Values& values, double size) override;
    Carried carried() override;
    const DerivativePlaces& derivative_places() const override;
    std::vector<double> derivatives() override;
    void cancel() override;

   private:
    /// Sets what differs from step to step: the inputs, and the parameters that may change. Without a size nothing has
    /// moved yet; transient rolling takes steps of an element then. `motion` is one of motion_keywords.
    static void set_load(contactd_contact* c, const Values& values, int motion, std::optional<double> size);
    static void set_shift(contactd_contact* c, const Values& values, std::optional<double> size);
    static void set_rolling(contactd_contact* c, const Values& values, bool is_steady, std::optional<double> size);
    static void read(contactd_contact* c, Values& values);
    ContactHandle made(const Values& values) const;
    std::vector<double> array(const char* which);
    /// The arrays that a step leaves to the next.
    bool carries(std::size_t array) const;
    /// The last step, solved anew for what it has to bring along. `what` for the sentence when that cannot be.
    void step_again(const char* what);

    Tell tell_;  // outlives the handles
    ConnectionHandle connection_;
    ContactHandle contact_;
    std::size_t elements_ = 0;
    bool has_history_ = false;                  // simplified models have none
    bool hardens_ = false, remembers_ = false;  // what particles carry beside tractions, but in steady rolling
    bool requests_arrays_ = false, requests_derivatives_ = false;
    bool by_force_ = true, shifts_ = false, force_is_prescribed_ = false;
    double step_size_ = 0;
    Carried from_;
    bool made_ = false, failed_ = false;  // a step since the start; the last one
};

}  // namespace contactd::fmu
