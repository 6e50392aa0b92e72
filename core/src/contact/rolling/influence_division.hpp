// Division by A, near enough for a preconditioner: of all elements in contact, or of those near adhesion.
#pragma once

#include <optional>
#include <vector>

#include "contact/newton/flow_preconditioner.hpp"
#include "contact/newton/linearisation.hpp"
#include "contact/support/contact_elements.hpp"
#include "contactd/influence_operator.hpp"
#include "operators/restriction.hpp"

namespace contactd {

// q ~ A^-1 r where the tangent stiffness is small, r over A's diagonal where it is not.
class InfluenceDivision {
   public:
    // `self`: A's diagonal of each element in contact. The operator and the contact outlive this.
    InfluenceDivision(const InfluenceOperator& influence, const Contact& contact, const std::vector<double>& self,
                      double diagonal_of_transport);

    void linearise(const Linearisation& law);
    // From here on all elements count, or those that adhere and their neighbours: A^-1 decays as the third power of the
    // distance. True when others count than before.
    bool take_all();
    bool take_adhesion(const std::vector<char>& slips);
    // Whether an element in contact counts.
    bool counts(std::size_t e) const { return box_->contains(contact_.elements[e]); }

    // q and r may be the same. Elements that do not count get r over the diagonal, weighted likewise.
    void divide(const Field& r, Field& q);

   private:
    ElementBox box_of_adhesion(const std::vector<char>& slips) const;
    void take(const ElementBox& needed);
    // Where a layer flows all elements count.
    void divide_with_flow(const Field& r, Field& q);

    const InfluenceOperator& influence_;
    const Contact& contact_;
    std::optional<Restriction> box_;
    std::vector<Contact::Run> runs_;         // of the elements that count, on the box
    Field full_in_, full_out_;               // on the box
    std::vector<double> weight_, diagonal_;  // of A^-1 and of what stands in for it, per element
    const Linearisation* law_ = nullptr;
    FlowPreconditioner along_flow_;
    Field rows_, rest_;
    std::vector<double> stiff_, to_diagonal_;  // tangent stiffness that rules the Jacobian; slip to traction of one
};

}  // namespace contactd
