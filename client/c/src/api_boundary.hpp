// Implements the boundary of the interface, which no exception leaves.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "connection.hpp"
#include "contact.hpp"
#include "contactd.h"
#include "handle_guard.hpp"
#include "handles.hpp"
#include "wheel.hpp"

namespace contactd::c {

using Connections = Handles<Connection, contactd_connection>;
using Contacts = Handles<Contact, contactd_contact>;
using Wheels = Handles<Wheel, contactd_wheel>;
/// Holds the objects of the process. They are not destroyed at its end.
Connections& connections();
Contacts& contacts();
Wheels& wheels();

/// Stores the current exception as the failure of a handle, and of `object`, which may be null; returns its code.
template <class Object>
std::int32_t failed(const void* handle, Object* object) noexcept {
    Failure failure = current_failure();
    const std::int32_t code = failure.code;
    try {
        if (object != nullptr) object->keep(failure);
    } catch (...) {  // without memory for the message, only the code is returned
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

/// Also reports to the object's log, for exceptions thrown while this thread used the object.
template <class Object>
std::int32_t failed_under_guard(const void* handle, Object& object) noexcept {
    try {
        if (object.log()) object.log()(CONTACTD_LOG_ERROR, current_failure().sentence);
    } catch (...) {  // thrown by the log
        return failed(handle, &object);
    }
    return failed(handle, &object);
}

/// Calls `body` with one of the objects, which this thread then uses.
template <class Object, class Handle, class Body>
std::int32_t with_guard(const Handles<Object, Handle>& all, Handle* handle, const Body& body) noexcept {
    std::shared_ptr<Object> object;
    try {
        object = all.find(handle);
        const HandleGuard turn(object->user);
        try {
            body(*object);
        } catch (...) {
            return failed_under_guard(handle, *object);
        }
        return CONTACTD_OK;
    } catch (...) {
        return failed(handle, object.get());
    }
}
template <class Body>
std::int32_t with(contactd_contact* handle, const Body& body) noexcept {
    return with_guard(contacts(), handle, body);
}
template <class Body>
std::int32_t with(contactd_wheel* handle, const Body& body) noexcept {
    return with_guard(wheels(), handle, body);
}

/// Cancels the running call of one of the objects, from any thread.
template <class Object, class Handle>
std::int32_t cancel(const Handles<Object, Handle>& all, Handle* handle) noexcept {
    std::shared_ptr<Object> object;
    try {
        object = all.find(handle);
        object->cancel();
        return CONTACTD_OK;
    } catch (...) {
        return failed(handle, object.get());
    }
}

/// Calls `body` with the contact or the wheel of the handle.
template <class Body>
std::int32_t with_any(void* handle, const Body& body) noexcept {
    if (contacts().find_any(handle)) return with(static_cast<contactd_contact*>(handle), body);
    if (wheels().find_any(handle)) return with(static_cast<contactd_wheel*>(handle), body);
    try {
        throw not_a_handle("handle", handle);
    } catch (...) {
        return failed<Contact>(handle, nullptr);
    }
}

inline StatusError nothing_of(const char* what) {
    return {StatusCode::not_found, no_result, std::string("The last step has no ") + what + "."};
}

}  // namespace contactd::c
