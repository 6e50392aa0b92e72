// Implements contactd.h: creation, steps and end of contacts.
#include <memory>

#include "api_boundary.hpp"

using namespace contactd::c;

std::int32_t contactd_new(contactd_connection* connection, contactd_contact** contact) {
    return with(connection, [&](Connection& made_with) {
        *given(contact, "contact") = nullptr;
        *contact = contacts().add(std::make_shared<Contact>(made_with));
    });
}

std::int32_t contactd_free(contactd_contact* contact) {
    return with(contact, [&](Contact& ended) {
        contacts().remove(contact);
        ended.close();
    });
}

std::int32_t contactd_start(contactd_contact* contact) {
    return with(contact, [](Contact& started) { started.start(); });
}

std::int32_t contactd_step(contactd_contact* contact) {
    return with(contact, [](Contact& stepping) { stepping.step(); });
}

std::int32_t contactd_cancel(contactd_contact* contact) {
    return cancel(contacts(), contact);
}
