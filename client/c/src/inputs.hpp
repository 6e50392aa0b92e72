// Collects the inputs of a contact until a call needs the problem.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contactd/session.hpp"
#include "material_fields.hpp"
#include "paths.hpp"

namespace contactd::c {

/// Holds the description of a body so far.
struct BodyInput {
    Material material = no_material;
    std::optional<Coefficients> ics{};  ///< absent: the common ones
    std::optional<Viscoelasticity> viscoelastic{};
};

/// Accepts inputs in any order: a call that needs the problem combines bodies, friction and motion.
struct ContactInputs {
    /// Holds the problem without its bodies. Its friction has no coefficient if only other fields were set, and its
    /// grid is centred along an axis if x0 or y0 is `centred`.
    ContactProblem problem = centred_problem();
    BodyInput upper;
    std::optional<BodyInput> lower{};    ///< absent: equal to the upper one
    std::optional<Coefficients> ics{};   ///< for bodies without their own; a table is that of the pair
    std::optional<MotionKind> motion{};  ///< the kind whose fields were set
    bool accept_unconverged = false;
    std::optional<double> lease_seconds{};
    SolutionFields fields{};
    std::optional<std::chrono::milliseconds> step_timeout{};

    /// Holds inputs that differ from those of the opening; steps must contain them.
    struct Changed {
        bool gap = false, friction = false, motion = false, rigid_slip = false;
    } changed{};

    static constexpr double centred = std::numeric_limits<double>::infinity();

    static Roots roots();
    /// Returns the struct that contains the field of the path.
    void* at(const RootedPath& path);
    /// Throws InvalidArgument for a field of the other kind of motion.
    void require_motion_of(const FieldPath& path) const;
    /// Throws InvalidArgument for a field that cannot be removed after the start, because steps use its initial
    /// value.
    static void require_clearable_between_steps(const FieldPath& path);
    /// Records that a field was set or cleared.
    void was_set(const FieldPath& path);
    void was_cleared(const FieldPath& path);

    /// Returns both bodies with their coefficients. Throws InvalidArgument ("bodies.upper.G") for missing values.
    Bodies bodies() const;
    /// Returns the section of the upper or the lower body, or null.
    const Section* section_of(bool upper) const;
    Grid grid() const;  ///< with its corner
    /// Returns the parameters that open the contact. Throws InvalidArgument for invalid inputs.
    SessionSpec opening();
    /// Returns the parameters of a step. Throws InvalidArgument for invalid inputs.
    StepInput step();

    /// Uses the motion computed for prescribed forces as the estimate of the next step, like a session for steps
    /// without a motion.
    void take_estimates(const std::optional<Motion>& found);
    /// Copies the creepages of `from` for prescribed forces.
    void restore_estimates(const Motion& from);

   private:
    static ContactProblem centred_problem();
    void require_friction();
};

/// Returns whether a field can be set at any time, not only before contactd_start.
bool is_load(const FieldPath& path);

}  // namespace contactd::c
