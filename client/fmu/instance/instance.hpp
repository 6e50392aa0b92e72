// Represents one instance of an FMU, independent of the version of FMI: its values, its model, and its phase.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kind.hpp"

namespace contactd::fmu {

/// Lists phases of FMI, which determine the allowed functions.
enum class Phase { instantiated, initialization, stepping, terminated };

/// Holds a saved instance: FMI's FMU state.
struct State {
    Phase phase;
    Values values;
    Carried carried;
};

/// Lists categories of the log, as in the model descriptions.
enum class Category { errors, warnings, events };
constexpr std::string_view name_of(Category category) {
    constexpr std::string_view names[] = {"errors", "warnings", "events"};
    return names[static_cast<std::size_t>(category)];
}

/// Use it in one thread at a time, except cancel. Invalid calls throw Failure with a sentence.
class Instance {
   public:
    using Log = std::function<void(Status status, Category category, const std::string& sentence)>;

    Instance(const Kind& kind, const std::filesystem::path& resources, Log log);

    const Kind& kind() const { return kind_; }
    /// Errors are always reported, warnings and events on request. No names select all categories.
    void set_log(bool on, std::span<const std::string> categories);
    void tell(Status status, Category category, const std::string& sentence) const;

    double time() const;
    void set_start(double time, std::optional<double> stop);
    void enter_initialization();
    void exit_initialization();
    void step(double time, double size);
    void terminate();
    void reset();
    void cancel();

    /// Sets or returns numbers of any type except texts. Throws for a reference of another type and, on setting, for
    /// values that are not finite, not in the enumeration, or cannot be set now.
    double number(std::uint32_t reference, std::initializer_list<Type> types) const;
    const std::string& text(std::uint32_t reference) const;
    void set_number(std::uint32_t reference, std::initializer_list<Type> types, double value);
    void set_text(std::uint32_t reference, std::string_view value);

    std::unique_ptr<State> state();
    void set_state(const State& state);

    /// Returns d of[] = sum of derivatives times d by[].
    std::vector<double> derivative(std::span<const std::uint32_t> of, std::span<const std::uint32_t> by,
                                   std::span<const double> seed);

   private:
    const Variable& variable(std::uint32_t reference, std::initializer_list<Type> types) const;
    const Variable& settable(std::uint32_t reference, std::initializer_list<Type> types) const;
    void require(Phase phase, const char* what) const;
    /// Checks the start of a step: the end of the last one, apart from rounding, or any time after a state was set.
    /// Throws Failure for the past.
    void check_time(double time, double size) const;
    /// Uses a new model, or the running one if its parameters are the same.
    void start(const Values& values, const Carried& from, bool anew);

    const Kind& kind_;
    const std::filesystem::path resources_;
    const Log log_;
    bool tells_[3] = {true, false, false};  // by category
    Phase phase_ = Phase::instantiated;
    bool set_back_ = false;  // to a state, without a step since
    Values values_;
    std::unique_ptr<Model> model_;
};

}  // namespace contactd::fmu
