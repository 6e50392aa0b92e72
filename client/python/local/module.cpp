// contactd_local: the service in the process of Python. The package contactd asks for it by this name, and is all that
// does: what is exchanged are the messages of docs/protocol.md.
//
// The threads of the service never touch Python. Who asks waits without the interpreter's lock, and looks for signals
// (Ctrl-C) meanwhile; lines of the log wait until they are fetched.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <deque>
#include <memory>
#include <mutex>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/version.hpp"
#include "service/in_process.hpp"

namespace py = pybind11;
using contactd::server::Exchange;
using contactd::server::InProcess;

namespace {

constexpr auto look_for_signals = std::chrono::milliseconds(50);
constexpr std::size_t kept_lines = 1000;

/// The last lines of the log that nobody has fetched.
class Lines {
   public:
    using Line = std::pair<int, std::string>;  // level as Python's logging has it, sentence

    void put(InProcess::Level level, const std::string& sentence) {
        const std::scoped_lock lock(mutex_);
        if (lines_.size() >= kept_lines) lines_.pop_front();
        lines_.emplace_back(20 + 10 * static_cast<int>(level), sentence);
    }
    std::deque<Line> take() {
        const std::scoped_lock lock(mutex_);
        return std::exchange(lines_, {});
    }

   private:
    std::mutex mutex_;
    std::deque<Line> lines_;
};

class Service {
   public:
    explicit Service(const std::string& config)
        : service_(std::make_unique<InProcess>(
              config, [lines = lines_](InProcess::Level level, const std::string& line) { lines->put(level, line); })) {
    }
    std::unique_ptr<Exchange> ask(const std::string& envelope, std::vector<std::string> frames) {
        return service_->ask(envelope, std::move(frames));
    }
    void close() { service_->close(); }
    std::deque<Lines::Line> take_log() { return lines_->take(); }

   private:
    const std::shared_ptr<Lines> lines_ = std::make_shared<Lines>();
    const std::unique_ptr<InProcess> service_;
};

/// The next message as a list of bytes. Raises what a handler of a signal raises.
py::list next(Exchange& exchange) {
    std::optional<Exchange::Message> message;
    for (;;) {
        {
            const py::gil_scoped_release release;
            message = exchange.next(Exchange::Clock::now() + look_for_signals);
        }
        if (message) break;
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
    py::list frames;
    for (const std::string& frame : *message) frames.append(py::bytes(frame));
    return frames;
}

}  // namespace

PYBIND11_MODULE(contactd_local, module) {
    module.doc() = "contactd's engine in process, for contactd.local().";
    module.attr("__version__") = contactd::version();
    py::register_exception<contactd::Error>(module, "Error", PyExc_RuntimeError);

    using Release = py::call_guard<py::gil_scoped_release>;
    py::class_<Exchange>(module, "Exchange", "One request on its way.")
        .def("next", &next, "The next message, progress or at last the answer: its envelope and array frames.")
        .def("cancel", &Exchange::cancel, Release(), "Ends the request, unless it is answered.");
    py::class_<Service>(module, "Service", "The engine, its tables and its sessions.")
        .def(py::init<std::string>(), py::arg("config"), Release(), "`config`: JSON, as the daemon's configuration.")
        .def("ask", &Service::ask, py::arg("envelope"), py::arg("frames"), Release(), "Begins a request.")
        .def("take_log", &Service::take_log, "Level and sentence of what has happened since the last time.")
        .def("close", &Service::close, Release(), "Ends all requests and sessions. May be called twice.");
}
