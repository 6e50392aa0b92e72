// Implements contactd_local: the service in the process of Python. Only the package contactd imports it, by this name.
// They exchange the messages of docs/protocol.md.
//
// The threads of the service never call Python. A caller waits without the interpreter's lock and checks for signals
// (Ctrl-C) meanwhile; lines of the log wait until they are fetched.
#include "python_api.hpp"  // comes first, because its macros must be defined before Python.h is included

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contactd/version.hpp"
#include "creep_tables.hpp"
#include "lines.hpp"
#include "service/in_process.hpp"

namespace contactd::python {
namespace {

using server::Exchange;
using server::InProcess;

constexpr auto look_for_signals = std::chrono::milliseconds(50);

/// belongs to the module; each interpreter has its own
struct State {
    PyObject* error;         // class Error(RuntimeError)
    PyTypeObject* exchange;  // class Exchange
};

State& state_of(PyTypeObject* type) {
    return *static_cast<State*>(PyType_GetModuleState(type));
}
PyObject* error_of(PyObject* self) {
    return state_of(Py_TYPE(self)).error;
}

// --- Exchange --------------------------------------------------------------------------------------------------------

/// Returns the next message as a list of bytes. Raises the exceptions of signal handlers.
PyObject* next(PyObject* self, PyObject*) {
    return answer(error_of(self), [&] {
        std::optional<Exchange::Message> message;
        for (;;) {
            {
                const Unlocked unlocked;
                message = held_by<Exchange>(self).next(Exchange::Clock::now() + look_for_signals);
            }
            if (message) break;
            if (PyErr_CheckSignals() != 0) throw ExceptionIsSet();
        }
        Reference frames(PyList_New(0));
        for (const proto::Frame& frame : *message) append(frames, bytes(frame.bytes()));
        return frames.release();
    });
}

PyObject* cancel(PyObject* self, PyObject*) {
    return answer(error_of(self), [&] {
        {
            const Unlocked unlocked;
            held_by<Exchange>(self).cancel();
        }
        return none();
    });
}

PyMethodDef exchange_methods[] = {
    {"next", &next, METH_NOARGS,
     "Returns envelope and array frames of the next message: progress, and finally the answer."},
    {"cancel", &cancel, METH_NOARGS, "Cancels the request if it has not been answered."},
    {nullptr, nullptr, 0, nullptr}};

PyType_Slot exchange_slots[] = {{Py_tp_doc, const_cast<char*>("A request in progress.")},
                                {Py_tp_methods, exchange_methods},
                                {Py_tp_dealloc, reinterpret_cast<void*>(&let_go<Exchange>)},
                                {0, nullptr}};
PyType_Spec exchange_spec = {"contactd_local.Exchange", sizeof(Holder<Exchange>), 0,
                             Py_TPFLAGS_DEFAULT | Py_TPFLAGS_DISALLOW_INSTANTIATION, exchange_slots};

// --- Service ---------------------------------------------------------------------------------------------------------

struct Service {
    explicit Service(const std::string& config)
        : service(config, [lines = lines](InProcess::Level level, const std::string& line) {
              lines->put(20 + 10 * static_cast<int>(level), line);
          }) {}

    const std::shared_ptr<Lines> lines = std::make_shared<Lines>();
    InProcess service;
};

PyObject* new_service(PyTypeObject* type, PyObject* arguments, PyObject* keywords) {
    return answer(state_of(type).error, [&] {
        static char name[] = "config";
        static char* names[] = {name, nullptr};
        const char* text = nullptr;  // not by its length, "s#": versions of Python differ in what that takes
        if (PyArg_ParseTupleAndKeywords(arguments, keywords, "s:Service", names, &text) == 0) throw ExceptionIsSet();
        const std::string config(text);
        std::unique_ptr<Service> service;
        {
            const Unlocked unlocked;
            service = std::make_unique<Service>(config);
        }
        return hold(type, std::move(service));
    });
}

PyObject* ask(PyObject* self, PyObject* arguments) {
    return answer(error_of(self), [&] {
        PyObject *envelope = nullptr, *frames = nullptr;
        if (PyArg_ParseTuple(arguments, "SO:ask", &envelope, &frames) == 0) throw ExceptionIsSet();
        const std::string message = text_of(envelope);
        const Py_ssize_t count = PySequence_Size(frames);
        if (count < 0) throw ExceptionIsSet();
        proto::Frames arrays;
        for (Py_ssize_t i = 0; i < count; ++i)
            arrays.emplace_back(text_of(Reference(PySequence_GetItem(frames, i)).get()));
        std::unique_ptr<Exchange> exchange;
        {
            const Unlocked unlocked;
            exchange = held_by<Service>(self).service.ask(message, std::move(arrays));
        }
        return hold(state_of(Py_TYPE(self)).exchange, std::move(exchange));
    });
}

PyObject* take_log(PyObject* self, PyObject*) {
    return answer(error_of(self), [&] {
        Reference taken(PyList_New(0));
        for (const auto& [level, sentence] : held_by<Service>(self).lines->take())
            append(taken, Reference(Py_BuildValue("iN", level, words(sentence).release())));
        return taken.release();
    });
}

PyObject* close(PyObject* self, PyObject*) {
    return answer(error_of(self), [&] {
        {
            const Unlocked unlocked;
            held_by<Service>(self).service.close();
        }
        return none();
    });
}

PyMethodDef service_methods[] = {
    {"ask", &ask, METH_VARARGS, "ask(envelope, frames): starts a request; both consist of bytes."},
    {"take_log", &take_log, METH_NOARGS, "Returns level and text of the log messages since the last call."},
    {"close", &close, METH_NOARGS, "Ends all requests and sessions. May be called twice."},
    {nullptr, nullptr, 0, nullptr}};

PyType_Slot service_slots[] = {
    {Py_tp_doc, const_cast<char*>("Service(config): the engine, its tables and its sessions; `config` is JSON, as the "
                                  "daemon's configuration.")},
    {Py_tp_methods, service_methods},
    {Py_tp_new, reinterpret_cast<void*>(&new_service)},
    {Py_tp_dealloc, reinterpret_cast<void*>(&let_go<Service>)},
    {0, nullptr}};
PyType_Spec service_spec = {"contactd_local.Service", sizeof(Holder<Service>), 0, Py_TPFLAGS_DEFAULT, service_slots};

// --- the module ------------------------------------------------------------------------------------------------------

int fill(PyObject* module) {
    State& state = *static_cast<State*>(PyModule_GetState(module));
    const auto add = [&](const char* name, PyObject* object) {
        return object != nullptr && PyModule_AddObjectRef(module, name, object) == 0;
    };
    state.error = PyErr_NewException("contactd_local.Error", PyExc_RuntimeError, nullptr);
    state.exchange = reinterpret_cast<PyTypeObject*>(PyType_FromModuleAndSpec(module, &exchange_spec, nullptr));
    PyObject* const service = PyType_FromModuleAndSpec(module, &service_spec, nullptr);
    const bool filled = add("Error", state.error) && add("Exchange", reinterpret_cast<PyObject*>(state.exchange)) &&
                        add("Service", service) &&
                        PyModule_AddStringConstant(module, "__version__", version().c_str()) == 0;
    Py_XDECREF(service);
    return filled ? 0 : -1;
}

int visit_state(PyObject* module, visitproc visit, void* arg) {
    const State& state = *static_cast<State*>(PyModule_GetState(module));
    Py_VISIT(state.error);
    Py_VISIT(state.exchange);
    return 0;
}

int clear_state(PyObject* module) {
    State& state = *static_cast<State*>(PyModule_GetState(module));
    Py_CLEAR(state.error);
    Py_CLEAR(state.exchange);
    return 0;
}

PyModuleDef_Slot slots[] = {{Py_mod_exec, reinterpret_cast<void*>(&fill)}, {0, nullptr}};
PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "contactd_local",    "contactd's engine in process, for contactd.local().",
    sizeof(State),         creep_table_methods, slots,
    &visit_state,          &clear_state,        [](void* module) { clear_state(static_cast<PyObject*>(module)); }};

}  // namespace
}  // namespace contactd::python

PyMODINIT_FUNC PyInit_contactd_local() {
    return PyModuleDef_Init(&contactd::python::definition);
}
