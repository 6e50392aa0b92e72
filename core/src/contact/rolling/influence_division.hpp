// Divides by A approximately for a preconditioner, on all elements in contact, or on those near adhesion.
#pragma once

#include <optional>
#include <vector>

#include "contact/newton/flow_preconditioner.hpp"
#include "contact/newton/linearisation.hpp"
#include "contact/support/contact_elements.hpp"
#include "contactd/influence_operator.hpp"
#include "operators/restriction.hpp"

namespace contactd {

// Computes q ~ A^-1 r where the tangent stiffness is small, and r over A's diagonal where it is not.
class InfluenceDivision {
   public:
    // `self` is A's diagonal of each element in contact. The operator and the contact must outlive this object.
    InfluenceDivision(const InfluenceOperator& influence, const Contact& contact, const std::vector<double>& self,
                      double diagonal_of_transport);

    void linearise(const Linearisation& law);
    // Selects all elements, or those that adhere and their neighbours, because A^-1 decays as the third power of the
    // distance. Returns true if the selection has changed.
    bool take_all();
    bool take_adhesion(const std::vector<char>& slips);
    // Returns whether an element in contact is selected.
    bool counts(std::size_t e) const { return box_->contains(contact_.elements[e]); }

    // Divides; q and r may be the same. Elements that are not selected get r over the diagonal, with the same weight.
    void divide(const Field& r, Field& q);

   private:
    ElementBox box_of_adhesion(const std::vector<char>& slips) const;
    void take(const ElementBox& needed);
    // If a layer flows, all elements are selected.
    void divide_with_flow(const Field& r, Field& q);

    const InfluenceOperator& influence_;
    const Contact& contact_;
    std::optional<Restriction> box_;
    std::vector<Contact::Run> runs_;         // runs of the selected elements, on the box
    Field full_in_, full_out_;               // on the box
    std::vector<double> weight_, diagonal_;  // values of A^-1 and of its substitute, per element
    const Linearisation* law_ = nullptr;
    FlowPreconditioner along_flow_;
    Field rows_, rest_;
    // Hold the tangent stiffness that dominates the Jacobian, and the factor from slip to traction of one element.
    std::vector<double> stiff_, to_diagonal_;
};

}  // namespace contactd
