// The edge of the interface: no exception leaves, whatever comes in.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "connection.hpp"
#include "contact.hpp"
#include "contactd.h"
#include "handles.hpp"
#include "turn.hpp"

namespace contactd::c {

using Connections = Handles<Connection, contactd_connection>;
using Contacts = Handles<Contact, contactd_contact>;
/// Those of the process. They stay at its end: what is not given back then ends with it.
Connections& connections();
Contacts& contacts();

/// Keeps the exception that is being handled as the failure of a handle, and of `object`, which may be null; its code.
template <class Object>
std::int32_t failed(const void* handle, Object* object) noexcept {
    Failure failure = current_failure();
    const std::int32_t code = failure.code;
    try {
        if (object != nullptr) object->keep(failure);
    } catch (...) {  // no memory for the sentence; the code is the answer all the same
    }
    keep_failure(handle, std::move(failure));
    return code;
}

/// Calls `body` with the connection.
template <class Body>
std::int32_t with(contactd_connection* handle, const Body& body) noexcept {
    std::shared_ptr<Connection> connection;
    try {
        connection = connections().find(handle);
        body(*connection);
        return CONTACTD_OK;
    } catch (...) {
        return failed(handle, connection.get());
    }
}

/// Calls `body` with the contact, for which it is this thread's turn.
template <class Body>
std::int32_t with(contactd_contact* handle, const Body& body) noexcept {
    std::shared_ptr<Contact> contact;
    try {
        contact = contacts().find(handle);
        const Turn turn(contact->user);
        try {
            body(*contact);
        } catch (...) {
            if (contact->log()) contact->log()(CONTACTD_LOG_ERROR, current_failure().sentence);
            throw;
        }
        return CONTACTD_OK;
    } catch (...) {
        return failed(handle, contact.get());
    }
}

/// The same, of a contact that was not started.
template <class Body>
std::int32_t set_up(contactd_contact* handle, const char* what, const Body& body) noexcept {
    return with(handle, [&](Contact& contact) {
        contact.require_set_up(what);
        body(contact.said);
    });
}

/// The same of a load, which may be said at any time.
template <class Body>
std::int32_t load(contactd_contact* handle, const Body& body) noexcept {
    return with(handle, [&](Contact& contact) { body(contact.said); });
}

// --- what comes in: each throws InvalidArgument naming `field`
// ---------------------------------------------------------

template <class Pointee>
Pointee* given(Pointee* pointer, const char* field) {
    if (pointer == nullptr) throw InvalidArgument(field, "is NULL");
    return pointer;
}

inline double finite(double value, const char* field) {
    if (!std::isfinite(value)) throw InvalidArgument(field, "is not finite; it must be a number");
    return value;
}

/// As finite, but infinite is a value, too.
inline double number(double value, const char* field) {
    if (std::isnan(value)) throw InvalidArgument(field, "is not a number");
    return value;
}

/// One of the words 0..last.
inline std::int32_t word(std::int32_t value, std::int32_t last, const char* field) {
    if (value < 0 || value > last)
        throw InvalidArgument(field, "is " + std::to_string(value) +
                                         "; it must be one of the words of contactd.h, 0 to " + std::to_string(last));
    return value;
}

inline std::vector<double> array(const double* values, std::int32_t count, const char* field) {
    given(values, field);
    if (count < 1) throw InvalidArgument("count", "is " + std::to_string(count) + "; it must be at least 1");
    return {values, values + count};
}

// --- what goes out
// -----------------------------------------------------------------------------------------------------

/// `text`, cut to what `length` bytes hold with their end.
void put_text(const std::string& source, char* text, std::int32_t length);

inline StatusError nothing_of(const char* what) {
    return {StatusCode::not_found, no_result, std::string("The last step has no ") + what + "."};
}

}  // namespace contactd::c
