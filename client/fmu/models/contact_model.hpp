// Simulates a plain contact, step by step.
#pragma once

#include <array>
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
    /// Sets the inputs, and the parameters that may change between steps. Without a size there is no motion yet;
    /// transient rolling then uses steps of one element. `motion` is one of motion_keywords.
    static void set_load(contactd_contact* c, const Values& values, int motion, std::optional<double> size);
    static void set_shift(contactd_contact* c, const Values& values, std::optional<double> size);
    static void set_rolling(contactd_contact* c, const Values& values, bool is_steady, std::optional<double> size);
    static void read(contactd_contact* c, Values& values);
    ContactHandle made(const Values& values) const;
    std::vector<double> array(const char* which);
    /// Solves the last step again to obtain further results; `what` names them in error messages.
    void step_again(const char* what);

    Tell tell_;  // outlives the handles
    ConnectionHandle connection_;
    ContactHandle contact_;
    std::size_t elements_ = 0;
    bool has_history_ = false;                           // simplified models have none
    std::array<bool, history_arrays.size()> carries_{};  // steady rolling carries tractions only
    bool requests_arrays_ = false, requests_derivatives_ = false;
    bool by_force_ = true, shifts_ = false, force_is_prescribed_ = false;
    double step_size_ = 0;
    Carried from_;
    bool made_ = false, failed_ = false;  // a step since the start; the last one
};

}  // namespace contactd::fmu
