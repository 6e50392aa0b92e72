// Implements the transposed compliance of steady rolling.
#pragma once

#include <cstddef>
#include <vector>

#include "reflection.hpp"
#include "rolling_compliance.hpp"

namespace contactd {

// K^T and its preconditioner are those of the reflected contact (see Reflection).
class TransposedCompliance final : public Compliance {
   public:
    TransposedCompliance(const RollingBodies& bodies, const Contact& contact, Reflection::Axes axes);

    void apply(const Field& p, Field& u) override;
    const std::vector<double>& self() const override { return self_; }
    // The law must not contain a flow.
    void linearise(const Linearisation& law) override;
    void precondition(const Field& r, Field& z, Residual kind, int iteration) override;
    bool is_far_reaching() const override { return rolling_.is_far_reaching(); }
    std::string_view stage() const override { return rolling_.stage(); }

   private:
    void reflect(const Field& from, Field& to) const;
    void reflect_back(const Field& from, Field& to) const;

    const Reflection reflection_;
    const Contact reflected_;
    const std::vector<std::size_t> image_;  // element of the contact for each element of the reflected one
    RollingCompliance rolling_;
    Linearisation law_;
    Field in_, out_;
    std::vector<double> self_;
};

}  // namespace contactd
