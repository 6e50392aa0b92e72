// Handles plastic flow of a layer between the bodies in Newton's method on the friction law.
#pragma once

#include <optional>
#include <vector>

#include "contact/support/contact_elements.hpp"
#include "linearisation.hpp"
#include "operators/upstream.hpp"

namespace contactd {

// Describes a layer that hardens or softens as it flows, on the elements in contact.
struct FlowLaw {
    double first = 0;                  // yield stress of particles that enter (N/mm^2)
    double hardening = 0;              // k, not zero: the yield stress increases by k times the length of the flow
    double least = 0;                  // least yield stress after softening
    std::vector<double> before;        // yield stress of the particles before the step; empty for steady rolling
    std::optional<Upstream> upstream;  // for steady rolling: the elements that particles come from

    // Returns the weight of an element's own yield stress in the interpolation between particles.
    double diagonal() const { return upstream ? upstream->diagonal() : 1; }

    // Computes yield stresses from leading to trailing edges, or separately for each element. value(e, v) is the yield
    // stress behind element e for an incoming one of v.
    template <class Value>
    void travel(const Value& value, std::vector<double>& behind) const {
        if (upstream) return upstream->travel(first, value, behind);
        for (std::size_t e = 0; e < before.size(); ++e) behind[e] = value(e, before[e]);
    }
};

// Determines the elements that flow: |p| = v + k |t|, below g, with t the flow over the step against p, and v the yield
// stress of the incoming particle. If v >= g, the law is Coulomb's; if |p| would exceed g, the layer slips, too.
class PlasticFlow {
   public:
    // `self` is the displacement of the bodies at an element under its own traction, without those of a step. `law` and
    // `contact` must outlive this object.
    PlasticFlow(const FlowLaw& law, const Contact& contact, const std::vector<double>& self);

    const std::vector<char>& flows() const { return flows_; }
    void forget() { std::fill(flows_.begin(), flows_.end(), 0); }
    // Divides the contact by the sizes of the tractions, moves those at the bounds to them, and determines which
    // elements slip.
    void divide_by_size(Field& p, std::vector<char>& slips);
    // Divides the contact by the slip as well: flow ends where t is along the traction by more than `push`, and slip
    // begins where the yield stress has increased to the bound of friction.
    void divide_by_slip(Field& p, const Field& s, double push, std::vector<char>& slips);
    // Divides the contact by tractions and slip together, where `stiffness` (N/mm^3) converts slip to traction. Returns
    // the number of tractions that moved.
    std::size_t divide_at_start(Field& p, const Field& s, const std::vector<double>& flexibility,
                                std::vector<char>& slips);

    // Computes the direction of flow, its tangent stiffness and its residual. Across the direction, the residual is
    // that of slip; along it, it is the error of the traction in units of slip. Adds to the result of linearise_law(),
    // for which these elements adhere. Returns the sum of squares of slip along the tractions, which would be reverse
    // flow.
    double linearise(const Field& p, const Field& s, Linearisation& law, Field& r);
    // Corrects the image of a step that was computed as if the elements that flow adhered.
    void correct_image(const Linearisation& law, const Vectors& step, const Vectors& response,
                       const MutableVectors& image) const;

   private:
    double size(const Field& p, std::size_t e) const;
    void scale(Field& p, std::size_t e, double length) const;
    double behind(std::size_t e, double v, double length, bool slips) const;

    const FlowLaw& law_;
    const std::vector<double>& g_;
    const std::size_t m_;
    std::vector<double> self_;
    std::vector<char> flows_;
    std::vector<double> incoming_, behind_;  // yield stresses before and behind each element
    mutable std::vector<double> change_;     // change of those behind
};

}  // namespace contactd
