// One instance of an FMU, in words of neither version of FMI: its values, its model, and where it is in its life.
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

/// Those phases of FMI that decide which functions may be called.
enum class Phase { instantiated, initialization, stepping, terminated };

/// An instance as it was: FMI's FMU state.
struct State {
    Phase phase;
    Values values;
    Carried carried;
};

/// Categories of the log, as in the model descriptions.
enum class Category { errors, warnings, events };
constexpr std::string_view name_of(Category category) {
    constexpr std::string_view names[] = {"errors", "warnings", "events"};
    return names[static_cast<std::size_t>(category)];
}

/// For one thread at a time, but for cancel. What cannot be done throws Failure with a sentence.
class Instance {
   public:
    using Log = std::function<void(Status status, Category category, const std::string& sentence)>;

    Instance(const Kind& kind, const std::filesystem::path& resources, Log log);

    const Kind& kind() const { return kind_; }
    /// Errors are always told; warnings and events when they are asked for. No names: all.
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

    /// Numbers of any type but texts. Throws for a reference of another type, and on setting for what is not finite,
    /// no word of its enumeration, or not to be set now.
    double number(std::uint32_t reference, std::initializer_list<Type> types) const;
    const std::string& text(std::uint32_t reference) const;
    void set_number(std::uint32_t reference, std::initializer_list<Type> types, double value);
    void set_text(std::uint32_t reference, std::string_view value);

    std::unique_ptr<State> state();
    void set_state(const State& state);

    /// d of[] = sum of derivatives times d by[].
    std::vector<double> derivative(std::span<const std::uint32_t> of, std::span<const std::uint32_t> by,
                                   std::span<const double> seed);

   private:
    const Variable& variable(std::uint32_t reference, std::initializer_list<Type> types) const;
    const Variable& settable(std::uint32_t reference, std::initializer_list<Type> types) const;
    void require(Phase phase, const char* what) const;
    /// Where a step may start: where the last one ended, but for rounding, or anywhere after a state was set. Throws
    /// Failure for the past.
    void check_time(double time, double size) const;
    /// With a model of its own, or with the one that runs, whose parameters are the same.
    void start(const Values& values, const Carried& from, bool anew);

    const Kind& kind_;
    const std::filesystem::path resources_;
    const Log log_;
    bool tells_[3] = {true, false, false};  // by category
    Phase phase_ = Phase::instantiated;
    bool set_back_ = false;  // to a state, by which no step was made yet
    Values values_;
    std::unique_ptr<Model> model_;
};

}  // namespace contactd::fmu
