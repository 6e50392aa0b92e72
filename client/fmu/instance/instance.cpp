#include "instance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace contactd::fmu {
namespace {

constexpr std::size_t time_reference = 0;  // the first of every list

std::string quoted(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

/// Throws Failure naming the variable if the number is not one of its values.
void validate(const Variable& of, double value) {
    if (!std::isfinite(value))
        throw Failure(std::string(of.name) + " is " + quoted(value) + "; it must be a finite number.");
    const double least = of.same_as.empty() ? 0 : as_the_enumeration;
    if (!of.enumeration || (value >= least && value < static_cast<double>(of.enumeration->keywords.size()))) return;
    std::string keywords;
    for (std::size_t k = 0; k < of.enumeration->keywords.size(); ++k)
        keywords += (k ? ", " : "") + std::to_string(k) + " (" + std::string(of.enumeration->keywords[k]) + ")";
    throw Failure(std::string(of.name) + " is " + quoted(value) + "; it must be one of " + keywords + ".");
}

/// Integers that represent enumerations take precedence, whichever was set last, because importers set all parameters
/// in any order. Both are equal from then on.
void choose_keywords(std::span<const Variable> list, Values& values) {
    for (std::size_t at = 0; at < list.size(); ++at) {
        if (list[at].same_as.empty()) continue;
        const std::size_t enumeration = reference_in(list, list[at].same_as);
        if (values[at] >= 0) values[enumeration] = values[at];
        values[at] = values[enumeration];
    }
}

}  // namespace

Instance::Instance(const Kind& kind, const std::filesystem::path& resources, Log log)
    : kind_(kind), resources_(resources), log_(std::move(log)), values_(kind.variables) {}

void Instance::set_log(bool on, std::span<const std::string> categories) {
    for (const Category category : {Category::warnings, Category::events})
        tells_[static_cast<int>(category)] =
            on && (categories.empty() || std::ranges::find(categories, name_of(category)) != categories.end());
}

void Instance::tell(Status status, Category category, const std::string& sentence) const {
    if (tells_[static_cast<int>(category)]) log_(status, category, sentence);
}

void Instance::require(Phase phase, const char* what) const {
    constexpr const char* names[] = {"instantiated", "in its initialization", "initialized", "terminated"};
    if (phase_ == phase) return;
    throw Failure(std::string(what) + " belongs to an instance that is " + names[static_cast<int>(phase)] +
                  "; this one is " + names[static_cast<int>(phase_)] + ".");
}

double Instance::time() const {
    return values_[time_reference];
}

void Instance::set_start(double time, std::optional<double> stop) {
    require(Phase::instantiated, "The start time");
    if (!std::isfinite(time)) throw Failure("The start time is " + quoted(time) + "; it must be a finite number.");
    if (stop && !(*stop >= time))
        throw Failure("The stop time is " + quoted(*stop) + "; it must not lie before the start time, " + quoted(time) +
                      " s.");
    values_[time_reference] = time;
}

void Instance::enter_initialization() {
    require(Phase::instantiated, "Entering the initialization");
    phase_ = Phase::initialization;
}

void Instance::exit_initialization() {
    require(Phase::initialization, "Leaving the initialization");
    Values first = values_;
    choose_keywords(kind_.variables, first);
    start(first, {}, true);
    try {
        model_->solve_start(first);
    } catch (...) {
        model_.reset();
        throw;
    }
    values_ = std::move(first);
    phase_ = Phase::stepping;
}

void Instance::start(const Values& values, const Carried& from, bool anew) {
    if (!anew) return model_->start(values, from);
    auto made = kind_.make(
        [this](Status status, const std::string& sentence) {
            tell(status, status == Status::warning ? Category::warnings : Category::events, sentence);
        },
        resources_);
    made->start(values, from);
    model_ = std::move(made);
}

void Instance::step(double time, double size) {
    require(Phase::stepping, "A step");
    if (!std::isfinite(time) || !std::isfinite(size) || !(size > 0))
        throw Failure("A step from " + quoted(time) + " by " + quoted(size) +
                      " s is invalid: both must be finite, and the size positive.");
    check_time(time, size);
    Values after = values_;
    model_->step(after, size);
    after[time_reference] = time + size;
    values_ = std::move(after);
    set_back_ = false;
}

void Instance::check_time(double time, double size) const {
    if (set_back_) return;
    const double now = this->time(), rounding = 1e-6 * size + 1e-9 * std::abs(now);
    if (time < now - rounding)
        throw Failure("A step from " + quoted(time) + " s lies in the past: the last one ended at " + quoted(now) +
                      " s. To go back, set an FMU state that was taken there.");
    if (time > now + rounding)
        tell(Status::warning, Category::warnings,
             "A step from " + quoted(time) + " s leaves a gap behind the last one, which ended at " + quoted(now) +
                 " s: nothing moves between them.");
}

void Instance::terminate() {
    require(Phase::stepping, "Terminating");
    phase_ = Phase::terminated;
}

void Instance::reset() {
    model_.reset();
    values_ = Values(kind_.variables);
    phase_ = Phase::instantiated;
    set_back_ = false;
}

void Instance::cancel() {
    if (model_) model_->cancel();
}

const Variable& Instance::variable(std::uint32_t reference, std::initializer_list<Type> types) const {
    if (reference >= kind_.variables.size())
        throw Failure("There is no variable " + std::to_string(reference) + "; value references go up to " +
                      std::to_string(kind_.variables.size() - 1) + ".");
    const Variable& found = kind_.variables[reference];
    if (std::ranges::find(types, found.type) == types.end())
        throw Failure(std::string(found.name) + " does not have the requested type.");
    return found;
}

const Variable& Instance::settable(std::uint32_t reference, std::initializer_list<Type> types) const {
    const Variable& found = variable(reference, types);
    const bool before = phase_ == Phase::instantiated || phase_ == Phase::initialization;
    const bool any_time = found.role == Role::input || found.role == Role::tunable;
    if (found.role == Role::output || found.role == Role::time)
        throw Failure(std::string(found.name) + " cannot be set; the FMU computes it.");
    if (phase_ == Phase::terminated || (!before && !any_time))
        throw Failure(std::string(found.name) + " can no longer be set; it is fixed after the initialization.");
    return found;
}

double Instance::number(std::uint32_t reference, std::initializer_list<Type> types) const {
    variable(reference, types);
    return values_[reference];
}

const std::string& Instance::text(std::uint32_t reference) const {
    variable(reference, {Type::text});
    return values_.text(reference);
}

void Instance::set_number(std::uint32_t reference, std::initializer_list<Type> types, double value) {
    validate(settable(reference, types), value);
    values_[reference] = value;
}

void Instance::set_text(std::uint32_t reference, std::string_view value) {
    settable(reference, {Type::text});
    values_.texts[reference] = value;
}

}  // namespace contactd::fmu
