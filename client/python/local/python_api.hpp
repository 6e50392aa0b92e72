// Wraps parts of Python's C interface that require care in C++: references, the interpreter's lock, exceptions, and
// values inside a Python object. It uses only the stable interface of Python 3.10, so one module serves this version
// and all later ones.
#pragma once

#define Py_LIMITED_API 0x030A0000
#include <Python.h>
#include <cxxabi.h>

#include <chrono>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "contactd/error.hpp"

namespace contactd::python {

/// Reports that a Python exception is set, which the caller receives.
struct ExceptionIsSet {};

/// Owns a reference. Throws ExceptionIsSet for an object that could not be created.
class Reference {
   public:
    explicit Reference(PyObject* owned) : object_(owned) {
        if (object_ == nullptr) throw ExceptionIsSet();
    }
    ~Reference() { Py_XDECREF(object_); }
    Reference(Reference&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
    Reference(const Reference&) = delete;
    Reference& operator=(const Reference&) = delete;

    PyObject* get() const { return object_; }
    PyObject* release() { return std::exchange(object_, nullptr); }

   private:
    PyObject* object_;
};

/// Lets other threads of Python run during its lifetime.
class Unlocked {
   public:
    Unlocked() : state_(PyEval_SaveThread()) {}
    /// Up to Python 3.13, a thread that requests the lock of an ending interpreter is ended there by unwinding.
    /// Unwinding must not pass a destructor, and would drop references without the lock. Such a thread sleeps until the
    /// process ends.
    ~Unlocked() {
        try {
            PyEval_RestoreThread(state_);
        } catch (const abi::__forced_unwind&) {
            for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
        }
    }
    Unlocked(const Unlocked&) = delete;
    Unlocked& operator=(const Unlocked&) = delete;

   private:
    PyThreadState* state_;
};

/// Returns the result of `act`. Exceptions of contactd become the Python exception `error`, others become one of
/// Python's own; the result is then null.
template <class Act>
PyObject* answer(PyObject* error, const Act& act) {
    try {
        return act();
    } catch (const ExceptionIsSet&) {
    } catch (const Error& problem) {
        PyErr_SetString(error, problem.what());
    } catch (const std::bad_alloc&) {
        PyErr_NoMemory();
    } catch (const std::exception& problem) {
        PyErr_SetString(PyExc_RuntimeError, problem.what());
    }
    return nullptr;
}

inline PyObject* none() {
    Py_INCREF(Py_None);
    return Py_None;
}

inline Reference bytes(std::string_view text) {
    return Reference(PyBytes_FromStringAndSize(text.data(), static_cast<Py_ssize_t>(text.size())));
}

/// Converts a text of any origin; invalid UTF-8 in it is replaced.
inline Reference words(std::string_view text) {
    return Reference(PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

/// Returns the content of a bytes object. Throws ExceptionIsSet (TypeError) for other objects.
inline std::string text_of(PyObject* object) {
    char* data = nullptr;
    Py_ssize_t size = 0;
    if (PyBytes_AsStringAndSize(object, &data, &size) != 0) throw ExceptionIsSet();
    return {data, static_cast<std::size_t>(size)};
}

inline void append(const Reference& list, const Reference& item) {
    if (PyList_Append(list.get(), item.get()) != 0) throw ExceptionIsSet();
}

/// A Python object that owns a T.
template <class T>
struct Holder {
    PyObject_HEAD T* held;
};

template <class T>
T& held_by(PyObject* self) {
    return *reinterpret_cast<Holder<T>*>(self)->held;
}

/// Creates an object of `type`, which must be one of Holder<T>.
template <class T>
PyObject* hold(PyTypeObject* type, std::unique_ptr<T> value) {
    const auto allocate = reinterpret_cast<allocfunc>(PyType_GetSlot(type, Py_tp_alloc));
    Reference object(allocate(type, 0));
    reinterpret_cast<Holder<T>*>(object.get())->held = value.release();
    return object.release();
}

/// Destroys an object of Holder<T>, as its tp_dealloc.
template <class T>
void let_go(PyObject* self) {
    PyTypeObject* const type = Py_TYPE(self);
    delete reinterpret_cast<Holder<T>*>(self)->held;
    reinterpret_cast<freefunc>(PyType_GetSlot(type, Py_tp_free))(self);
    Py_DECREF(type);
}

}  // namespace contactd::python
