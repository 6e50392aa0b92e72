// Plastic flow of a layer between the bodies, as Newton's method on the friction law takes it.
#pragma once

#include <optional>
#include <vector>

#include "contact/support/contact_elements.hpp"
#include "linearisation.hpp"
#include "operators/upstream.hpp"

namespace contactd {

// A layer that hardens or softens as it flows, on the elements in contact.
struct FlowLaw {
    double first = 0;                  // yield stress of particles that enter (N/mm^2)
    double hardening = 0;              // k: the yield stress rises by that times the length of the flow; not zero
    double least = 0;                  // yield stress that softening leaves
    std::vector<double> before;        // yield stress of the particles before the step; of steady rolling empty
    std::optional<Upstream> upstream;  // of steady rolling: the elements that particles come from

    // What interpolation between particles leaves of an element's own yield stress.
    double diagonal() const { return upstream ? upstream->diagonal() : 1; }

    // Takes yield stresses from leading to trailing edges, or each by itself: value(e, v) is the one behind element e
    // where v came to it.
    template <class Value>
    void travel(const Value& value, std::vector<double>& behind) const {
        if (upstream) return upstream->travel(first, value, behind);
        for (std::size_t e = 0; e < before.size(); ++e) behind[e] = value(e, before[e]);
    }
};

// The elements that flow: |p| = v + k |t|, below g, with t the flow over the step against p and v the yield stress that
// the particle brings. Where v >= g the law is Coulomb's; where |p| would exceed g the layer slips, too.
class PlasticFlow {
   public:
    // `self`: displacement by a traction on an element there, of the bodies and not of their steps. `law` and `contact`
    // outlive this.
    PlasticFlow(const FlowLaw& law, const Contact& contact, const std::vector<double>& self);

    const std::vector<char>& flows() const { return flows_; }
    void forget() { std::fill(flows_.begin(), flows_.end(), 0); }
    // Divides the contact by the sizes of the tractions, brings those to the bounds that lie there, and says which
    // slip.
    void divide_by_size(Field& p, std::vector<char>& slips);
    // Divides it by the slip, too: flow ends where t is along the traction by more than `push`, slip begins where the
    // yield stress has risen to the bound of friction.
    void divide_by_slip(Field& p, const Field& s, double push, std::vector<char>& slips);
    // Divides it by what tractions and slip together say, `stiffness` (N/mm^3) turning slip into traction; returns how
    // many tractions moved.
    std::size_t divide_at_start(Field& p, const Field& s, const std::vector<double>& flexibility,
                                std::vector<char>& slips);

    // The direction of flow, its tangent stiffness, and the residual there: across the direction that of slip, along it
    // how far the traction is off, in units of slip. Adds to what linearise_law() found, for which these elements
    // adhere. Returns the sum of squares of slip along the tractions, which would be flow back.
    double linearise(const Field& p, const Field& s, Linearisation& law, Field& r);
    // Makes of the image of a step, in which the elements that flow adhere, the right one.
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
    std::vector<double> incoming_, behind_;  // yield stresses that come to the elements, and leave them
    mutable std::vector<double> change_;     // of those that leave them
};

}  // namespace contactd
