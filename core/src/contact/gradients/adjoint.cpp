#include "adjoint.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/derivatives/krylov_space.hpp"
#include "contact/support/solver_support.hpp"

namespace contactd {
namespace {

using Vector = KrylovSpace::Vector;
using Values = std::vector<double>;
using Right = KrylovSpace::Right;

// These residuals are relative to the right-hand sides. Gradients by single elements have larger errors than sums.
constexpr double tangential_tolerance = 1e-5, normal_tolerance = 1e-6, symmetric_tolerance = 1e-7,
                 coupled_tolerance = 3e-7;

Eigen::MatrixXd no_sums(Eigen::Index size) {
    return Eigen::MatrixXd(size, 0);
}

// Holds an output on the box of the contact, zero elsewhere, with the effects of its slip added to the others.
struct BoxWeights {
    Values pressure;
    Field traction, slip;
};

class AdjointSolver {
   public:
    AdjointSolver(FrozenContact& contact, const std::vector<OutputWeights>& outputs, bool has_friction,
                  const Observer& observer)
        : contact_(contact), has_friction_(has_friction), observer_(observer) {
        for (const OutputWeights& output : outputs) weights_.push_back(on_box(output));
    }

    Adjoints solve(std::size_t size) {
        if (has_friction_ && contact_.coupled())
            solve_together();
        else
            solve_one_by_one();
        Adjoints result;
        result.evidence = {iterations_, residual_, converged_, stopwatch_.seconds()};
        for (std::size_t k = 0; k < weights_.size(); ++k) result.outputs.push_back(whole(k, size));
        return result;
    }

   private:
    BoxWeights on_box(const OutputWeights& output) {
        BoxWeights box{masked(output.pressure), Field(contact_.grid().size()), Field(contact_.grid().size())};
        if (!has_friction_) return box;
        box.traction.x = masked(output.traction.x);
        box.traction.y = masked(output.traction.y);
        box.slip.x = masked(output.slip.x);
        box.slip.y = masked(output.slip.y);
        if (!any(box.slip)) return box;
        add(box.traction, contact_.transposed_slip(box.slip));
        if (!contact_.coupled()) return box;
        const Values pressed = contact_.transposed_coupling(box.slip);
        for (std::size_t i = 0; i < pressed.size(); ++i) box.pressure[i] += pressed[i];
        return box;
    }

    Values masked(const Values& whole) const {
        const Values box = contact_.crop(whole);
        Values result(box.size());
        for (const std::size_t i : contact_.pressed().elements) result[i] = box[i];
        return result;
    }

    Vector pressed(const Values& box) const {
        Vector result(contact_.pressures());
        Eigen::Index e = 0;
        for (const std::size_t i : contact_.pressed().elements) result[e++] = box[i];
        return result;
    }

    // Returns n . (q - the given slip), the derivative with respect to the bound.
    Values bound_of(const Field& traction, const Field& slip) const {
        const Field& n = contact_.direction();
        Values bound(slip.x.size());
        for (const std::size_t i : contact_.pressed().elements)
            bound[i] = n.x[i] * (traction.x[i] - slip.x[i]) + n.y[i] * (traction.y[i] - slip.y[i]);
        return bound;
    }

    void solve_one_by_one() {
        if (has_friction_) find_tractions();
        std::vector<Right> rights;
        for (std::size_t k = 0; k < weights_.size(); ++k) {
            Values right = weights_[k].pressure;
            for (std::size_t i = 0; has_friction_ && i < right.size(); ++i)
                right[i] += contact_.mu()[i] * bounds_[k][i];
            const Vector values = pressed(right);
            rights.push_back({values, values.norm(), Vector(0)});
        }
        const KrylovSpace space =
            solve({[this](const Vector& p, Vector& u) { contact_.normal(p, u); },
                   [this](const Vector& r, Vector& z, int) { contact_.precondition_normal(r, z); }, true,
                   Vector::Ones(contact_.pressures()), no_sums(contact_.pressures())},
                  rights, normal_tolerance);
        for (std::size_t k = 0; k < weights_.size(); ++k) normals_.push_back(on_pressed(space.solution(k)));
    }

    Values on_pressed(const Vector& values) const {
        Values box(contact_.grid().size());
        Eigen::Index e = 0;
        for (const std::size_t i : contact_.pressed().elements) box[i] = values[e++];
        return box;
    }

    void find_tractions() {
        std::vector<Right> rights;
        for (const BoxWeights& weights : weights_) {
            if (contact_.tractions() == 0) break;
            const FrozenContact::Right right = contact_.of_tractions(weights.traction);
            rights.push_back({right.values, right.size, Vector(0)});
        }
        if (!rights.empty()) {
            const KrylovSpace space =
                solve({[this](const Vector& p, Vector& u) { contact_.tangential(p, u); },
                       [this](const Vector& r, Vector& z, int step) { contact_.precondition_tangential(r, z, step); },
                       contact_.symmetric(), contact_.weights(), no_sums(contact_.tractions()), contact_.tractions()},
                      rights, contact_.symmetric() ? symmetric_tolerance : tangential_tolerance);
            for (std::size_t k = 0; k < weights_.size(); ++k)
                tractions_.push_back(contact_.tractions_of(space.solution(k)));
        }
        for (std::size_t k = 0; k < weights_.size(); ++k) {
            if (rights.empty()) tractions_.emplace_back(contact_.grid().size());
            bounds_.push_back(bound_of(weights_[k].traction, contact_.transposed_slip(tractions_[k])));
        }
    }

    void solve_together() {
        const Eigen::Index pressures = contact_.pressures(), tractions = contact_.tractions();
        std::vector<Right> rights;
        for (const BoxWeights& weights : weights_) {
            const FrozenContact::Right tangential = contact_.of_tractions(weights.traction);
            Values right = bound_of(weights.traction, Field(contact_.grid().size()));
            for (std::size_t i = 0; i < right.size(); ++i) right[i] = weights.pressure[i] + contact_.mu()[i] * right[i];
            const Vector normal = pressed(right);
            Vector all(pressures + tractions);
            all << normal, tangential.values;
            rights.push_back({all, std::hypot(normal.norm(), tangential.size), Vector(0)});
        }
        const KrylovSpace space =
            solve({[this](const Vector& p, Vector& u) { contact_.all(p, u); },
                   [this](const Vector& r, Vector& z, int step) { contact_.precondition_all(r, z, step); }, false,
                   contact_.weights_of_all(), no_sums(pressures + tractions), pressures + tractions},
                  rights, coupled_tolerance);
        for (std::size_t k = 0; k < weights_.size(); ++k) {
            const Vector both = space.solution(k);
            normals_.push_back(on_pressed(both.head(pressures)));
            tractions_.push_back(contact_.tractions_of(both.tail(tractions)));
            Field slip = contact_.slip_of_normal(normals_[k]);
            add(slip, contact_.transposed_slip(tractions_[k]));
            bounds_.push_back(bound_of(weights_[k].traction, slip));
        }
    }

    KrylovSpace solve(LinearEquations equations, const std::vector<Right>& rights, double tolerance) {
        KrylovSpace space(std::move(equations));
        space.solve(rights, {tolerance}, observer_);
        iterations_ += space.steps();
        residual_ = std::max(residual_, space.residual());
        converged_ = converged_ && space.converged();
        return space;
    }

    Adjoint whole(std::size_t k, std::size_t size) const {
        Adjoint result{contact_.paste(normals_[k], size), Values(size), Field(size)};
        if (!has_friction_) return result;
        result.bound = contact_.paste(bounds_[k], size);
        Field v = weights_[k].slip;
        add(v, tractions_[k], -1);
        result.slip.x = contact_.paste(v.x, size);
        result.slip.y = contact_.paste(v.y, size);
        return result;
    }

    FrozenContact& contact_;
    const bool has_friction_;
    const Observer& observer_;
    std::vector<BoxWeights> weights_;
    std::vector<Values> normals_, bounds_;  // l and dJ/dg on the box, per output
    std::vector<Field> tractions_;          // y
    int iterations_ = 0;
    double residual_ = 0;
    bool converged_ = true;
    Stopwatch stopwatch_;
};

}  // namespace

Adjoints solve_adjoints(FrozenContact& contact, const std::vector<OutputWeights>& outputs, bool has_friction,
                        const Observer& observer) {
    return AdjointSolver(contact, outputs, has_friction, observer).solve(outputs.front().pressure.size());
}

}  // namespace contactd
