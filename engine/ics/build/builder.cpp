#include "builder.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <ctime>
#include <fstream>
#include <reproc++/reproc.hpp>
#include <string_view>

#include "builder_environment.hpp"
#include "builder_listener.hpp"
#include "contactd/error.hpp"
#include "contactd/proto/codec.hpp"

namespace contactd::engine {
namespace {

using namespace std::chrono_literals;

constexpr auto poll_interval = reproc::milliseconds(100);

/// Describes how the child ended. reproc returns 128 + signal for a signal.
std::string ending(int status) {
    if (status > 128) return "was terminated by signal " + std::to_string(status - 128);
    return "ended with status " + std::to_string(status);
}

void check(const std::error_code& error, const char* doing) {
    if (error) throw BuilderUnusable(std::string("Cannot ") + doing + " the builder: " + error.message() + ".");
}

/// Blocks SIGPIPE in this thread, because the process may belong to another program. A closed pipe is then an ordinary
/// error.
class NoPipeSignal {
   public:
    NoPipeSignal() {
        sigemptyset(&pipe_);
        sigaddset(&pipe_, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
    }
    ~NoPipeSignal() {
        constexpr timespec at_once{};
        if (sigismember(&before_, SIGPIPE) == 0) sigtimedwait(&pipe_, nullptr, &at_once);  // one that came meanwhile
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    NoPipeSignal(const NoPipeSignal&) = delete;
    NoPipeSignal& operator=(const NoPipeSignal&) = delete;

   private:
    sigset_t pipe_, before_;
};

/// Writes everything. A child that has already ended is not an error here, because its own message is more specific.
void send(reproc::process& child, std::string_view text) {
    const NoPipeSignal no_signal;
    while (!text.empty()) {
        const auto [written, error] = child.write(reinterpret_cast<const uint8_t*>(text.data()), text.size());
        if (error == std::errc::broken_pipe) return;
        check(error, "talk to");
        text.remove_prefix(written);
    }
}

/// Throws if there is a reason to end the child.
class Watch {
   public:
    Watch(const BuilderCommand& command, const BuilderListener& listener, const Job& job,
          const std::function<void()>& on_tick)
        : command_(command), listener_(listener), job_(job), on_tick_(on_tick) {}

    void check() const {
        if (job_.cancelled()) throw Cancelled("The build was cancelled.");
        on_tick_();
        if (command_.stall > 0s && listener_.silence() > command_.stall)
            throw Error("The builder made no progress for " + std::to_string(command_.stall.count()) +
                        " s (builds.stall_seconds) and was terminated: it sent no progress, or exceeded the time of a "
                        "single step.");
        if (command_.longest > 0s && std::chrono::steady_clock::now() - begin_ > command_.longest)
            throw Error("The build took longer than " + std::to_string(command_.longest.count()) +
                        " s (builds.max_seconds) and was terminated.");
    }

   private:
    const BuilderCommand& command_;
    const BuilderListener& listener_;
    const Job& job_;
    const std::function<void()>& on_tick_;
    const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

/// Reads until both streams end.
void listen(reproc::process& child, BuilderListener& listener, const Watch& watch) {
    std::array<uint8_t, 1 << 16> buffer;
    for (;;) {
        watch.check();
        const auto [events, poll_error] = child.poll(reproc::event::out | reproc::event::err, poll_interval);
        if (poll_error == std::errc::broken_pipe) return;
        check(poll_error, "listen to");
        for (const auto stream : {reproc::stream::out, reproc::stream::err}) {
            const bool is_output = stream == reproc::stream::out;
            if (!(events & (is_output ? reproc::event::out : reproc::event::err))) continue;
            const auto [size, error] = child.read(stream, buffer.data(), buffer.size());
            if (error) continue;  // This stream has ended; poll reports the end of both.
            const std::string_view bytes(reinterpret_cast<const char*>(buffer.data()), size);
            is_output ? listener.hear_output(bytes) : listener.hear_error(bytes);
        }
    }
}

int wait_for(reproc::process& child, const Watch& watch) {
    for (;;) {
        const auto [status, error] = child.wait(poll_interval);
        if (!error) return status;
        if (error != std::errc::timed_out) check(error, "wait for");
        watch.check();
    }
}

/// Returns the number of processes that the kernel has killed for lack of memory since this machine started.
long long ended_by_kernel() {
    std::ifstream file("/proc/vmstat");
    std::string name;
    for (long long count = 0; file >> name >> count;)
        if (name == "oom_kill") return count;
    return 0;
}

std::vector<std::string> arguments_of(const BuilderCommand& command, const std::filesystem::path& output) {
    std::vector<std::string> arguments = command.launcher;
    arguments.insert(arguments.end(), {command.program.string(), "-", "--output", output.string(), "--exit-with-stdin",
                                       "--or-print", "--max-memory", std::to_string(command.max_memory_bytes)});
    return arguments;
}

/// Returns the started program with the field that names it.
std::string first_program(const BuilderCommand& command) {
    if (command.launcher.empty()) return "builds.program is " + command.program.string();
    return "builds.launcher begins with " + command.launcher.front();
}

/// Explains why the first program, or the one started by a launcher, could not be started, and where to get it.
std::string cannot_be_started(const std::string& what, const std::string& reason) {
    const std::string end = reason.ends_with('.') ? "" : ".";
    return what + "; it cannot be started: " + reason + end +
           " The builder is contactd-ic; set builds.program to its path, or CONTACTD_IC in process. To get it, install "
           "Debian's package contactd, or run pip install \"contactd[daemon]\" for Python.";
}

/// Returns whether this is the status of shells and launchers for a program that was not found or cannot be executed.
bool is_of_launcher(int status) {
    return status == 126 || status == 127;
}

}  // namespace

BuiltTable run_builder(const BuilderCommand& command, const IcSpec& spec, const std::filesystem::path& output,
                       const Job& job, const std::function<void(const JobProgress&)>& on_progress,
                       const std::function<void()>& on_tick) {
    reproc::options options;
    options.redirect.in.type = options.redirect.out.type = options.redirect.err.type = reproc::redirect::pipe;
    options.env.behavior = reproc::env::empty;
    Environment environment = passed_on(command.environment);
    // Threads inside BLAS slow a build down by orders of magnitude on a busy machine.
    for (const char* name : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"}) {
        std::erase_if(environment, [&](const auto& variable) { return variable.first == name; });
        environment.emplace_back(name, "1");
    }
    options.env.extra = environment;
    // A stopped process does not receive SIGTERM. A launcher needs time to end the processes that it started.
    options.stop = {{reproc::stop::terminate, 800ms}, {reproc::stop::kill, 2000ms}, {}};

    const long long ended_before = ended_by_kernel();
    reproc::process child;
    if (const std::error_code error = child.start(arguments_of(command, output), options))
        throw BuilderUnusable(cannot_be_started(first_program(command), error.message() + "."));
    BuilderListener listener(!command.launcher.empty(), on_progress);
    const Watch watch(command, listener, job, on_tick);
    int status = 0;
    try {
        send(child, proto::dump(proto::encode_ic_spec(spec)) + "\n");
        listen(child, listener, watch);
        status = wait_for(child, watch);
    } catch (...) {
        child.stop(options.stop);
        throw;
    }
    if (status == 0) return listener.take_table();
    const std::string complaint = listener.complaint();
    if (listener.ran_out_of_memory()) throw BuilderOutOfMemory(complaint, listener.field());
    if (listener.refused() && !listener.problem().empty()) throw InvalidArgument(listener.field(), listener.problem());
    if (status == 128 + SIGKILL && ended_by_kernel() > ended_before)
        throw BuilderOutOfMemory(
            "The build ran out of memory: the kernel terminated it because the machine had no free memory.", "");
    if (!command.launcher.empty() && is_of_launcher(status) && !complaint.empty())
        throw BuilderUnusable(cannot_be_started(
            "builds.program is " + command.program.string() + ", started by " + command.launcher.front(), complaint));
    throw Error("The builder " + ending(status) + (complaint.empty() ? "." : ": " + complaint));
}

}  // namespace contactd::engine
