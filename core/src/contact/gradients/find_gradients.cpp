#include "find_gradients.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

#include "contact/derivatives/frozen_contact.hpp"
#include "known_motion.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

// Products of the operators and of their transposes must agree to this, relative to their lengths. Tables by finite
// elements violate reciprocity by their errors, and strips that rotate by much more.
constexpr double largest_reciprocity_error = 1e-6;

// Closed forms of half-spaces and layers satisfy reciprocity.
bool have_closed_forms(const Bodies& bodies) {
    const auto is_closed = [](const Body& body) {
        const Ics* ics = body.computed();
        return body.material.is_rigid() || (ics != nullptr && ics->source == IcSource::analytic && !ics->section);
    };
    return !bodies.pair && is_closed(bodies.upper) && is_closed(bodies.lower);
}

// A prescribed force determines one of the three.
struct Constraint {
    Cotangents force;
    double GradientOfKnownMotion::* motion;
};

std::vector<Constraint> constraints_of(const ContactProblem& problem) {
    std::vector<Constraint> result;
    const auto add = [&](double Cotangents::* force, double GradientOfKnownMotion::* motion) {
        Constraint constraint{{}, motion};
        constraint.force.*force = 1;
        result.push_back(std::move(constraint));
    };
    if (problem.Fn) add(&Cotangents::Fn, &GradientOfKnownMotion::approach);
    if (!problem.friction) return result;
    const Force& force = std::visit([](const auto& motion) -> const Force& { return motion.force; }, problem.motion);
    if (force.Fx) add(&Cotangents::Fx, &GradientOfKnownMotion::along_x);
    if (force.Fy) add(&Cotangents::Fy, &GradientOfKnownMotion::along_y);
    return result;
}

class GradientFinder {
   public:
    GradientFinder(const ContactProblem& problem, const ContactInfluence& influence, const ContactSolution& solution,
                   const std::vector<GradientInput>& by, Observer& observer)
        : problem_(problem),
          influence_(influence),
          solution_(solution),
          by_(by),
          observer_(observer),
          constraints_(constraints_of(problem)) {}

    ContactGradients find(const std::vector<Cotangents>& outputs) {
        solve(outputs);
        ContactGradients result{{}, adjoints_.evidence, {}};
        for (const Cotangents& output : outputs)
            if (std::string warning = tie_warning(output, solution_); !warning.empty())
                result.warnings.push_back(std::move(warning));
        if (!adjoints_.evidence.converged) {
            result.warnings.emplace_back(
                "The transposed equations did not reach their tolerance, so there are no gradients.");
            return result;
        }
        hold_forces(outputs.size(), result);
        return result;
    }

   private:
    bool requests(GradientInput input) const { return std::ranges::find(by_, input) != by_.end(); }

    // Finds gradients of the outputs, followed by those of the prescribed forces, for a given motion.
    void solve(const std::vector<Cotangents>& outputs) {
        const auto* rolling = problem_.friction ? std::get_if<Rolling>(&problem_.motion) : nullptr;
        const double unit = rolling != nullptr ? step_length(*rolling, problem_.grid) : 1;
        std::vector<OutputWeights> weights;
        for (const Cotangents& output : outputs) weights.push_back(weights_of(output, problem_.grid, solution_, unit));
        for (const Constraint& constraint : constraints_)
            weights.push_back(weights_of(constraint.force, problem_.grid, solution_, unit));
        FrozenContact contact(problem_, influence_, solution_, FrozenContact::Equations::transposed);
        adjoints_ = solve_adjoints(contact, weights, problem_.friction.has_value(), observer_);
        if (problem_.friction && !have_closed_forms(problem_.bodies)) check_reciprocity(contact);
        for (std::size_t k = 0; k < weights.size(); ++k)
            gradients_.push_back(gradient_of(problem_, solution_, weights[k], adjoints_.outputs[k]));
        add_optional();
    }

    // Compares products with those of the transpose.
    void check_reciprocity(FrozenContact& contact) const {
        Field q, v;
        q.x = contact.crop(solution_.traction_x);
        q.y = contact.crop(solution_.traction_y);
        v.x = contact.crop(adjoints_.outputs[0].slip.x);
        v.y = contact.crop(adjoints_.outputs[0].slip.y);
        const double error = contact.reciprocity_error(q, v, contact.crop(solution_.pressure));
        if (error <= largest_reciprocity_error) return;
        throw InvalidArgument(
            "vjp",
            "requires influence coefficients that satisfy reciprocity, but two products that must be equal differ by a "
            "fraction of " +
                short_text(error) + "; use closed forms of half-spaces or layers, or finite differences of solves");
    }

    void add_optional() {
        if (requests(GradientInput::materials)) {
            const auto materials = by_materials(problem_, solution_, adjoints_.outputs, observer_);
            for (std::size_t k = 0; k < gradients_.size(); ++k) {
                gradients_[k].upper = materials[k].upper.value_or(GradientByMaterial{});
                gradients_[k].lower = materials[k].lower.value_or(GradientByMaterial{});
            }
        }
        if (requests(GradientInput::previous) && problem_.friction)
            for (std::size_t k = 0; k < gradients_.size(); ++k)
                gradients_[k].previous = by_previous(problem_, influence_, solution_, adjoints_.outputs[k].slip);
    }

    // Returns the derivatives of each prescribed force by the motions that the forces determine, in columns.
    Eigen::MatrixXd derivatives_of_forces(std::size_t outputs) const {
        const auto count = static_cast<Eigen::Index>(constraints_.size());
        Eigen::MatrixXd forces(count, count);
        for (Eigen::Index c = 0; c < count; ++c)
            for (Eigen::Index k = 0; k < count; ++k)
                forces(k, c) = gradients_[outputs + static_cast<std::size_t>(c)].*motion(k);
        return forces;
    }

    // Returns the derivatives of the outputs with respect to the prescribed forces, one column per output; no columns
    // if the forces do not determine the motion.
    Eigen::MatrixXd by_forces(std::size_t outputs) const {
        const auto count = static_cast<Eigen::Index>(constraints_.size()), columns = static_cast<Eigen::Index>(outputs);
        if (count == 0) return Eigen::MatrixXd(0, columns);
        Eigen::MatrixXd forces = derivatives_of_forces(outputs), by_motion(count, columns);
        for (Eigen::Index c = 0; c < count; ++c)
            for (Eigen::Index k = 0; k < columns; ++k)
                by_motion(c, k) = gradients_[static_cast<std::size_t>(k)].*motion(c);
        const Eigen::VectorXd unit = forces.cwiseAbs().rowwise().maxCoeff();
        if (!(unit.minCoeff() > 0)) return Eigen::MatrixXd(count, 0);
        forces.array().colwise() /= unit.array();
        by_motion.array().colwise() /= unit.array();
        const Eigen::FullPivLU<Eigen::MatrixXd> solver(forces);
        if (!solver.isInvertible()) return Eigen::MatrixXd(count, 0);
        return solver.solve(by_motion);
    }

    // Subtracts from each gradient the part along the gradients of the prescribed forces, so that these do not change.
    void hold_forces(std::size_t outputs, ContactGradients& result) {
        const Eigen::MatrixXd shares = by_forces(outputs);
        if (shares.cols() == 0) {
            result.warnings.emplace_back(
                "The prescribed forces do not change with the motion that they determine, so there are no gradients.");
            return;
        }
        for (std::size_t k = 0; k < outputs; ++k) {
            const Eigen::VectorXd share = shares.col(static_cast<Eigen::Index>(k));
            for (std::size_t c = 0; c < constraints_.size(); ++c)
                gradients_[k].add(gradients_[outputs + c], -share[static_cast<Eigen::Index>(c)]);
            result.outputs.push_back(named(std::move(gradients_[k]), share));
        }
    }

    double GradientOfKnownMotion::* motion(Eigen::Index constraint) const {
        return constraints_[static_cast<std::size_t>(constraint)].motion;
    }

    // Names the derivatives; those with respect to prescribed forces are the shares.
    Gradient named(GradientOfKnownMotion from, const Eigen::VectorXd& shares) const {
        Gradient to;
        Eigen::Index next = 0;
        if (problem_.Fn)
            to.Fn = shares[next++];
        else
            to.approach = from.approach;
        if (requests(GradientInput::gap)) to.gap = std::move(from.gap);
        if (requests(GradientInput::materials)) {
            if (!problem_.bodies.upper.material.is_rigid()) to.upper = from.upper;
            if (!problem_.bodies.lower.material.is_rigid()) to.lower = from.lower;
        }
        if (!problem_.friction) return to;
        const bool rotates = !is_line_contact(problem_);
        if (const auto* rolling = std::get_if<Rolling>(&problem_.motion)) {
            if (!rolling->force.Fx) to.xi = from.along_x;
            if (!rolling->force.Fy) to.eta = from.along_y;
            if (rotates) to.phi = from.about_z;
            if (rolling->force.Fx) to.Fx = shares[next++];
            if (rolling->force.Fy) to.Fy = shares[next++];
        } else {
            const Force& force = std::get<Shift>(problem_.motion).force;
            to.rigid_shift = DerivativesByShift{force.Fx ? 0 : from.along_x, force.Fy ? 0 : from.along_y};
            if (rotates) to.rotation = from.about_z;
            if (force.Fx) to.Fx = shares[next++];
            if (force.Fy) to.Fy = shares[next++];
        }
        if (requests(GradientInput::mu)) to.mu = std::move(from.mu);
        if (requests(GradientInput::rigid_slip))
            to.rigid_slip = {std::move(from.rigid_slip.x), std::move(from.rigid_slip.y)};
        if (requests(GradientInput::previous)) to.previous = std::move(from.previous);
        return to;
    }

    const ContactProblem& problem_;
    const ContactInfluence& influence_;
    const ContactSolution& solution_;
    const std::vector<GradientInput>& by_;
    Observer& observer_;
    const std::vector<Constraint> constraints_;
    Adjoints adjoints_;
    std::vector<GradientOfKnownMotion> gradients_;
};

}  // namespace

ContactGradients find_gradients(const ContactProblem& problem, const ContactInfluence& influence,
                                const ContactSolution& solution, const std::vector<Cotangents>& outputs,
                                const std::vector<GradientInput>& by, Observer& observer) {
    return GradientFinder(problem, influence, solution, by, observer).find(outputs);
}

}  // namespace contactd
