#include "builder.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <reproc++/reproc.hpp>
#include <string_view>

#include "builder_environment.hpp"
#include "contactd/error.hpp"
#include "contactd/proto/codec.hpp"

namespace contactd::server {
namespace {

using namespace std::chrono_literals;

constexpr auto poll_interval = reproc::milliseconds(100);
constexpr std::size_t longest_line = 1 << 20;
constexpr std::size_t kept_error_bytes = 4096;

/// What the child says: JSON lines on standard output, words on standard error.
class Listener {
   public:
    Listener(Job& job, const std::function<void(const JobProgress&)>& on_progress)
        : job_(job), on_progress_(on_progress) {}

    void hear_output(std::string_view bytes) {
        line_ += bytes;
        for (std::size_t end; (end = line_.find('\n')) != std::string::npos; line_.erase(0, end + 1))
            hear_line(std::string_view(line_).substr(0, end));
        if (line_.size() > longest_line) line_.clear();
    }
    void hear_error(std::string_view bytes) {
        words_ += bytes;
        if (words_.size() > kept_error_bytes) words_.erase(0, words_.size() - kept_error_bytes);
    }
    /// The builder's own sentence when it gave one, else the end of what it wrote to standard error.
    std::string complaint() const {
        if (!complaint_.empty()) return complaint_;
        std::string words = words_;
        while (!words.empty() && std::isspace(static_cast<unsigned char>(words.back()))) words.pop_back();
        return words;
    }

   private:
    void hear_line(std::string_view line) {
        const auto json = nlohmann::json::parse(line, nullptr, false);
        if (!json.is_object()) return;  // a launcher may chat
        if (const auto error = json.find("error"); error != json.end() && error->is_object())
            complaint_ = error->value("message", std::string());
        if (!json.contains("stage") || !json["stage"].is_string()) return;
        const auto number = [&](const char* name) {
            const auto at = json.find(name);
            return at != json.end() && at->is_number() ? at->get<double>() : 0.0;
        };
        const JobProgress progress{json["stage"].get<std::string>(), std::clamp(number("fraction"), 0.0, 1.0),
                                   static_cast<int>(number("iteration")), number("residual")};
        job_.set_progress(progress);
        on_progress_(progress);
    }

    Job& job_;
    const std::function<void(const JobProgress&)>& on_progress_;
    std::string line_, words_, complaint_;
};

/// How the child ended, in words. reproc gives 128 + signal for a signal.
std::string ending(int status) {
    if (status > 128) return "was ended by signal " + std::to_string(status - 128);
    return "ended with status " + std::to_string(status);
}

void check(const std::error_code& error, const char* doing) {
    if (error) throw Error(std::string("Cannot ") + doing + " the builder: " + error.message() + ".");
}

/// Writes everything. A child that ended already is no error here: its own words say more.
void send(reproc::process& child, std::string_view text) {
    while (!text.empty()) {
        const auto [written, error] = child.write(reinterpret_cast<const uint8_t*>(text.data()), text.size());
        if (error == std::errc::broken_pipe) return;
        check(error, "talk to");
        text.remove_prefix(written);
    }
}

/// Reads until both streams end or the job is cancelled.
void listen(reproc::process& child, Listener& listener, const Job& job) {
    std::array<uint8_t, 4096> buffer;
    for (;;) {
        if (job.cancelled()) throw Cancelled("The build was cancelled.");
        const auto [events, poll_error] = child.poll(reproc::event::out | reproc::event::err, poll_interval);
        if (poll_error == std::errc::broken_pipe) return;
        check(poll_error, "listen to");
        for (const auto stream : {reproc::stream::out, reproc::stream::err}) {
            const bool is_output = stream == reproc::stream::out;
            if (!(events & (is_output ? reproc::event::out : reproc::event::err))) continue;
            const auto [size, error] = child.read(stream, buffer.data(), buffer.size());
            if (error) continue;  // this stream has ended; poll says when both have
            const std::string_view bytes(reinterpret_cast<const char*>(buffer.data()), size);
            is_output ? listener.hear_output(bytes) : listener.hear_error(bytes);
        }
    }
}

int wait_for(reproc::process& child, const Job& job) {
    for (;;) {
        const auto [status, error] = child.wait(poll_interval);
        if (!error) return status;
        if (error != std::errc::timed_out) check(error, "wait for");
        if (job.cancelled()) throw Cancelled("The build was cancelled.");
    }
}

}  // namespace

void run_builder(const BuilderCommand& command, const IcSpec& spec, const std::filesystem::path& output, Job& job,
                 const std::function<void(const JobProgress&)>& on_progress) {
    std::vector<std::string> arguments = command.launcher;
    arguments.insert(arguments.end(),
                     {command.program.string(), "-", "--output", output.string(), "--exit-with-stdin"});

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
    options.stop = {{reproc::stop::terminate, 800ms}, {reproc::stop::kill, 2000ms}, {}};

    reproc::process child;
    check(child.start(arguments, options), "start");
    Listener listener(job, on_progress);
    int status = 0;
    try {
        send(child, proto::dump(proto::encode_ic_spec(spec)) + "\n");
        listen(child, listener, job);
        status = wait_for(child, job);
    } catch (...) {
        child.stop(options.stop);
        throw;
    }
    if (status == 0) return;
    const std::string complaint = listener.complaint();
    throw Error("The builder " + ending(status) + (complaint.empty() ? "." : ": " + complaint));
}

}  // namespace contactd::server
