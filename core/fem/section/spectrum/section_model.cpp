#include "section_model.hpp"

#include <algorithm>
#include <cmath>

namespace contactd::fem {

SectionModel::SectionModel(const SectionOutline& outline, const SectionMesh& mesh, int order, double nu)
    : matrices_(mesh, order, nu),
      loads_(strip_loads(outline, mesh, matrices_)),
      observations_(strip_observations(outline, mesh, matrices_)),
      factor_(matrices_.pattern()) {}

WaveResponse SectionModel::at(double xi) {
    factor_.factorise(matrices_.at(xi));
    const std::vector<double> full = factor_.response(observations_, loads_);
    const std::size_t n = loads_.columns.size();
    WaveResponse result;
    result.values.reserve(n * (n + 1) / 2);
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b <= a; ++b) {
            const double one = full[a + b * n], other = full[b + a * n];
            result.values.push_back((one + other) / 2);
            result.reciprocity_defect = std::max(result.reciprocity_defect, std::abs(one - other));
        }
    return result;
}

}  // namespace contactd::fem
