#include "transposed_step.hpp"

namespace contactd {

void TransposedStep::tangential(const Field& p, Field& u) {
    reflection_.take(p.x, Reflection::sign_x, in_.x);
    reflection_.take(p.y, reflection_.sign_y(), in_.y);
    step_.tangential(in_.x, in_.y, out_.x, out_.y);
    reflection_.take(out_.x, Reflection::sign_x, u.x);
    reflection_.take(out_.y, reflection_.sign_y(), u.y);
}

// Each component of the tractions is treated as a pressure, whose displacement along that component is its product.
void TransposedStep::pressures(const Field& p, std::span<double> result) {
    reflection_.take(p.x, 1, in_.x);
    step_.tangential_of_normal(in_.x, out_.x, out_.y);
    reflection_.take(out_.x, 1, result);
    reflection_.take(p.y, 1, in_.y);
    step_.tangential_of_normal(in_.y, out_.x, out_.y);
    reflection_.take(out_.y, 1, in_.x);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += in_.x[i];
}

}  // namespace contactd
