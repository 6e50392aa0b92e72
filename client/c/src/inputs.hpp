// The inputs of a contact, pending until a call needs the problem that they make.
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

/// A body as it was described so far.
struct BodyInput {
    Material material = no_material;
    std::optional<Coefficients> ics{};  ///< absent: those of both bodies
    std::optional<Viscoelasticity> viscoelastic{};
};

/// In whatever order they are named: bodies, friction and motion are put together when a call needs the problem.
struct ContactInputs {
    /// But for its bodies. Its friction has no coefficient where only other fields of friction were named, and its grid
    /// is centred along an axis where x0 or y0 is `centred`.
    ContactProblem problem = centred_problem();
    BodyInput upper;
    std::optional<BodyInput> lower{};    ///< absent: as the upper one
    std::optional<Coefficients> ics{};   ///< of bodies that have none of their own; a table is that of the pair
    std::optional<MotionKind> motion{};  ///< the kind whose fields were named
    bool accept_unconverged = false;
    std::optional<double> lease_seconds{};
    SolutionFields fields{};
    std::optional<std::chrono::milliseconds> step_timeout{};

    /// Inputs that differ from what the contact was opened with: steps have to name them.
    struct Changed {
        bool gap = false, friction = false, motion = false, rigid_slip = false;
    } changed{};

    static constexpr double centred = std::numeric_limits<double>::infinity();

    static Roots roots();
    /// The struct below which the path leads to its field.
    void* at(const RootedPath& path);
    /// Throws InvalidArgument for a field of the other kind of motion than the one that was named.
    void require_motion_of(const FieldPath& path) const;
    /// Throws InvalidArgument for a field that a step of a contact which was started cannot leave out: it is as at the
    /// start then.
    static void require_clearable_between_steps(const FieldPath& path);
    /// Takes notice of a field that was set or cleared.
    void was_set(const FieldPath& path);
    void was_cleared(const FieldPath& path);

    /// Both bodies with their coefficients. Throws InvalidArgument ("bodies.upper.G") for what is missing.
    Bodies bodies() const;
    /// The section of the upper or the lower body, or null.
    const Section* section_of(bool upper) const;
    Grid grid() const;  ///< with its corner
    /// Puts together what opens the contact. Throws InvalidArgument for what cannot be solved.
    SessionSpec opening();
    /// Puts together what a step is asked. Throws InvalidArgument for what no step can solve.
    StepInput step();

    /// Takes over what a step has found under forces, as the estimate of the next: a session does so for steps that
    /// name no motion.
    void take_estimates(const std::optional<Motion>& found);
    /// Takes over the creepages that `from` has where forces are prescribed.
    void restore_estimates(const Motion& from);

   private:
    static ContactProblem centred_problem();
    void require_friction();
};

/// Returns whether a field can be set at any time, and not before contactd_start only.
bool is_load(const FieldPath& path);

}  // namespace contactd::c
