#include <string>

#include "../../types/number_text.hpp"
#include "contactd/ic_store.hpp"
#include "sha256.hpp"

namespace contactd {
namespace {

/// Canonical JSON: members in alphabetical order, no white space, numbers by their shortest text.
class CanonicalObject {
   public:
    void add(const char* name, double number) { put(name, number_text(number)); }
    void add(const char* name, std::string_view word) { put(name, '"' + std::string(word) + '"'); }
    void add_object(const char* name, const CanonicalObject& object) { put(name, object.text()); }
    void add_true(const char* name) { put(name, "true"); }
    std::string text() const { return "{" + members_ + "}"; }

   private:
    void put(const char* name, const std::string& value) {
        members_ += (members_.empty() ? "\"" : ",\"") + std::string(name) + "\":" + value;
    }
    std::string members_;
};

/// How meshes are chosen for an accuracy. A new number when tables of an earlier choice should not be served any more:
/// when they miss the accuracy or state other errors than they have. Those that are finer than need be may stay.
constexpr int accuracy_recipe = 2;

/// Only what decides the numbers: max_iterations ends a build or has no effect.
CanonicalObject canonical(const FemSpec& fem) {
    CanonicalObject json;
    json.add("L_over_h", fem.L_over_h);
    json.add("diagonal", name_of(fem.diagonal));
    json.add("f", fem.f);
    json.add("far_boundary", name_of(fem.far_boundary));
    json.add("h_over_hs", fem.h_over_hs);
    json.add("l_over_h", fem.l_over_h);
    json.add("max_dofs", static_cast<double>(fem.max_dofs));
    json.add("mesh", name_of(fem.mesh));
    json.add("order", fem.order);
    json.add("sampling", name_of(fem.sampling));
    json.add("solver", name_of(fem.solver));
    json.add("stop_test", name_of(fem.stop_test));
    if (fem.strength_threshold) json.add("strength_threshold", *fem.strength_threshold);
    json.add("t1_over_hs", fem.t1_over_hs);
    json.add("tolerance", fem.tolerance);
    return json;
}

CanonicalObject canonical(const IcSpec& spec) {
    CanonicalObject json;
    if (spec.accuracy != 0) json.add("accuracy", spec.accuracy);
    if (spec.any_nu) json.add_true("any_nu");
    json.add("body", name_of(spec.body));
    json.add("dy_over_dx", spec.dy);
    if (spec.source == IcSource::fem && spec.accuracy == 0) json.add_object("fem", canonical(spec.fem));
    if (spec.accuracy != 0 && spec.body == BodyShape::block) {
        CanonicalObject size;  // of the body; the mesh is chosen later
        size.add("L_over_h", spec.fem.L_over_h);
        json.add_object("fem", size);
    }
    if (spec.line_contact) {
        CanonicalObject line;
        line.add("datum", spec.line_contact->datum);
        json.add_object("line_contact", line);
    }
    json.add("load_shape", name_of(spec.load_shape));
    if (!spec.any_nu) json.add("nu", spec.material.nu);
    if (spec.accuracy != 0) json.add("recipe", accuracy_recipe);
    json.add("source", name_of(spec.source));
    return json;
}

}  // namespace

std::string ic_key(const IcSpec& spec) {
    const std::string text = canonical(dimensionless(spec)).text();
    return sha256_hex({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

bool is_ic_key(std::string_view text) {
    return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace contactd
