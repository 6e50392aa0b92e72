#include "transposed_compliance.hpp"

namespace contactd {
namespace {

using Values = std::vector<double>;

Contact reflected(const Contact& contact, const Reflection& reflection, std::size_t size) {
    Values bound(size), image(size);
    contact.scatter(contact.bound, bound);
    reflection.take(bound, 1, image);
    return {image, bound, bound};  // Rigid slips are not used.
}

std::vector<std::size_t> images(const Contact& contact, const Contact& reflected, const Reflection& reflection,
                                std::size_t size) {
    std::vector<std::size_t> number(size), image;
    for (std::size_t e = 0; e < contact.size(); ++e) number[contact.elements[e]] = e;
    image.reserve(reflected.size());
    for (const std::size_t i : reflected.elements) image.push_back(number[reflection.image(i)]);
    return image;
}

}  // namespace

TransposedCompliance::TransposedCompliance(const RollingBodies& bodies, const Contact& contact, Reflection::Axes axes)
    : reflection_(bodies.grid, axes),
      reflected_(reflected(contact, reflection_, bodies.grid.size())),
      image_(images(contact, reflected_, reflection_, bodies.grid.size())),
      rolling_(bodies, reflected_, PreconditionerLevels::never),
      law_(contact.size()),
      in_(contact.size()),
      out_(contact.size()),
      self_(contact.size()) {
    for (std::size_t e = 0; e < image_.size(); ++e) self_[image_[e]] = rolling_.self()[e];
}

void TransposedCompliance::reflect(const Field& from, Field& to) const {
    for (std::size_t e = 0; e < image_.size(); ++e) {
        to.x[e] = Reflection::sign_x * from.x[image_[e]];
        to.y[e] = reflection_.sign_y() * from.y[image_[e]];
    }
}

void TransposedCompliance::reflect_back(const Field& from, Field& to) const {
    for (std::size_t e = 0; e < image_.size(); ++e) {
        to.x[image_[e]] = Reflection::sign_x * from.x[e];
        to.y[image_[e]] = reflection_.sign_y() * from.y[e];
    }
}

void TransposedCompliance::apply(const Field& p, Field& u) {
    reflect(p, in_);
    rolling_.apply(in_, out_);
    reflect_back(out_, u);
}

void TransposedCompliance::linearise(const Linearisation& law) {
    reflect(law.normal, law_.normal);
    for (std::size_t e = 0; e < image_.size(); ++e) {
        law_.slips[e] = law.slips[image_[e]];
        law_.tangent_stiffness[e] = law.tangent_stiffness[image_[e]];
    }
    rolling_.linearise(law_);
}

void TransposedCompliance::precondition(const Field& r, Field& z, Residual kind, int iteration) {
    reflect(r, in_);
    rolling_.precondition(in_, out_, kind, iteration);
    reflect_back(out_, z);
}

}  // namespace contactd
