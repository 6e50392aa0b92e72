// Represents normal contact whose elements face the approach at angles, in quantities along the approach.
#pragma once

#include <memory>
#include <vector>

#include "contactd/influence_operator.hpp"
#include "operators/lazy.hpp"

namespace contactd {

/// With c the cosine between an element's normal and the approach, q = c p and u/c replace pressure and displacement.
/// Then an approach delta closes the gap h/c by delta, and q sums to the normal force. A becomes c^-1 A c^-1, which is
/// symmetric and positive definite like A, so that NORM does not depend on angles. Only normal components are
/// supported.
class ApproachOperator final : public InfluenceOperator {
   public:
    /// `cosine` > 0 is that of each element. `inner` must outlive this object.
    ApproachOperator(const InfluenceOperator& inner, std::vector<double> cosine);
    ~ApproachOperator() override;

    /// Convert values along the normal to values along the approach, and back.
    std::vector<double> times_cosine(std::vector<double> values) const;
    std::vector<double> over_cosine(std::vector<double> values) const;

    std::size_t size() const override { return inner_.size(); }
    bool is_symmetric() const override { return inner_.is_symmetric(); }
    void normal(std::span<const double> pz, std::span<double> uz) const override;
    void tangential(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                    std::span<double> uy) const override;
    std::vector<double> diagonal(Axis i) const override;
    void precondition(Axis i, std::span<const double> r, std::span<double> z) const override;
    std::size_t bytes() const override { return inner_.bytes() + size() * sizeof(double); }
    const CoarserGrid* coarser() const override;
    const ElementBoxes* boxes() const override { return boxes_.get(); }

   private:
    class Boxes;
    class Part;
    const InfluenceOperator& inner_;
    const std::vector<double> cosine_;
    std::unique_ptr<const ElementBoxes> boxes_;
    mutable Lazy<std::unique_ptr<const CoarserGrid>> coarser_;
};

}  // namespace contactd
