// contactd.h: wheels on rails from their making to their end.
#include <filesystem>
#include <memory>
#include <utility>

#include "contactd/fields/profile_spec.hpp"
#include "contactd/read_profile.hpp"
#include "edge.hpp"

using namespace contactd::c;
using contactd::InvalidArgument;

std::int32_t contactd_wheel_new(contactd_connection* connection, contactd_wheel** wheel) {
    return with(connection, [&](Connection& made_with) {
        *given(wheel, "wheel") = nullptr;
        *wheel = wheels().add(std::make_shared<Wheel>(made_with));
    });
}

std::int32_t contactd_wheel_free(contactd_wheel* wheel) {
    return with(wheel, [&](Wheel&) { wheels().remove(wheel); });
}

std::int32_t contactd_wheel_read_profile(contactd_wheel* wheel, const char* path, const char* file) {
    using contactd::ProfileKind;
    return with(wheel, [&](Wheel& changed) {
        const contactd::FieldPath& profile = changed.paths.find(PathCache::input, path).path;
        if (&profile.type() != &contactd::type_of<contactd::ProfileSpec>())
            throw InvalidArgument(profile.text(),
                                  "is no profile; setup.wheel and setup.rail are, and profile of each slice");
        const auto kind = profile.text().starts_with("setup.rail") ? ProfileKind::rail : ProfileKind::wheel;
        contactd::ProfileSpec read = contactd::read_profile(std::filesystem::path(given(file, "file")), kind);
        *static_cast<contactd::ProfileSpec*>(profile.make(&changed.said)) = std::move(read);
    });
}

std::int32_t contactd_wheel_solve(contactd_wheel* wheel) {
    return with(wheel, [](Wheel& solved) { solved.solve(); });
}

std::int32_t contactd_wheel_solve_wheelset(contactd_wheel* right, contactd_wheel* left) {
    return with(right, [&](Wheel& right_wheel) {
        const std::shared_ptr<Wheel> left_wheel = wheels().find(left);
        if (left_wheel.get() == &right_wheel)
            throw InvalidArgument("left", "is the right wheel, too; make another one");
        const Turn turn(left_wheel->user);
        Wheel::solve_wheelset(right_wheel, *left_wheel);
    });
}

std::int32_t contactd_wheel_cancel(contactd_wheel* wheel) {
    return cancel(wheels(), wheel);
}
