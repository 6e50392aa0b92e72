// Implements the common part of the client.
#pragma once

#include <iostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "connection.hpp"
#include "contactd/client/client.hpp"
#include "contactd/proto/status.hpp"
#include "warnings.hpp"

namespace contactd::client {

using nlohmann::json;

/// Names the event that a call waits for, which determines its timeout.
enum class Wait { for_answer, for_build };

/// Returns a wait for a build if the solve may need finite-element tables.
inline Wait wait_of(const ContactSetup& setup) {
    if (setup.model != Model::full || setup.bodies.pair) return Wait::for_answer;
    for (const Body* body : {&setup.bodies.upper, &setup.bodies.lower})
        if (const Ics* ics = body->computed(); ics != nullptr && ics->source == IcSource::fem) return Wait::for_build;
    return Wait::for_answer;
}

inline Wait wait_of(const IcSpec& spec) {
    return spec.source == IcSource::fem ? Wait::for_build : Wait::for_answer;
}

inline Wait wait_of(const WheelRailSetup& setup) {
    return setup.model == Model::full && setup.conformal == Conformal::fem ? Wait::for_build : Wait::for_answer;
}

inline Wait wait_of(const WheelsetSetup& setup) {
    return setup.left && wait_of(*setup.left) == Wait::for_build ? Wait::for_build : wait_of(setup.setup);
}

/// Holds the result of a call, with the frames of its arrays.
struct Reply {
    json result;
    proto::Frames frames;
};

class Client::Impl {
   public:
    Impl(const std::string& endpoint, ClientOptions options)
        : endpoint_(endpoint),
          options_(std::move(options)),
          connection_(endpoint, options_.connect_timeout, options_.limits,
                      load_curve_keys(options_.server_key, options_.own_key), options_.spin) {}

    Reply call(const std::string& method, json params, proto::Frames frames, const CallOptions& options,
               Wait wait = Wait::for_answer) {
        Answer answer = answer_to(method, std::move(params), std::move(frames), options, wait);
        return {answer.result.json(), std::move(answer.frames)};
    }
    /// Returns the unparsed answer, without a nlohmann-json document.
    Answer answer_to(const std::string& method, json params, proto::Frames frames, const CallOptions& options,
                     Wait wait = Wait::for_answer) {
        const bool builds = wait == Wait::for_build;
        std::string build;
        ProgressHandler on_progress;
        if (options.on_progress || builds)
            on_progress = [&](const json& progress) {
                if (const std::string job = progress.value("job", ""); job.starts_with("build-")) build = job;
                if (options.on_progress) options.on_progress(report_of(progress));
            };
        const auto timeout = options.timeout.value_or(builds ? options_.build_timeout : options_.timeout);
        try {
            Answer reply =
                connection_.call(method, std::move(params), std::move(frames), timeout, on_progress, options.stop);
            tell(warnings_in(method, reply.result));
            return reply;
        } catch (const TimeoutError& error) {
            if (!builds) throw;
            throw TimeoutError(error.what() + build_goes_on(build));
        } catch (const StatusError& error) {
            if (!builds || error.status().code != StatusCode::deadline_exceeded) throw;
            Status status = error.status();
            status.message += build_goes_on(build);
            throw StatusError(std::move(status));
        }
    }

    json result_of(const std::string& method, const CallOptions& options, json params = json::object()) {
        return call(method, std::move(params), {}, options).result;
    }

    const ClientOptions& options() const { return options_; }
    /// Returns whether both have the same daemon and user.
    bool speaks_for(const Impl& other) const {
        return endpoint_ == other.endpoint_ && options_.own_key == other.options_.own_key;
    }

   private:
    static Progress report_of(const json& progress) {
        Progress report{progress.value("job", ""),          progress["stage"].get<std::string>(),
                        progress["fraction"].get<double>(), progress.value("iteration", 0),
                        progress.value("residual", 0.0),    progress.value("state", "")};
        if (progress.contains("seconds_left")) report.seconds_left = progress["seconds_left"].get<double>();
        if (progress.contains("memory_bytes")) report.memory_bytes = progress["memory_bytes"].get<std::uint64_t>();
        return report;
    }

    /// Returns a sentence about the build `job` (empty: unknown) that a call has waited for.
    static std::string build_goes_on(const std::string& job) {
        const std::string what = job.empty() ? " The build that it waited for continues in the daemon"
                                             : " The build continues in the daemon as job " + job;
        return what +
               ". jobs() reports its progress, cancel_job() ends it, and repeating the call joins it or returns " +
               "its table.";
    }

    void tell(const std::vector<std::string>& sentences) {
        constexpr std::size_t most = 1000;  // a program that runs for months must not keep more
        if (sentences.empty()) return;
        if (options_.on_warnings) return options_.on_warnings(sentences);
        for (const std::string& sentence : sentences)
            if (warned_.size() < most && warned_.insert(sentence).second)
                std::cerr << "contactd: warning: " + sentence + "\n";
    }

    const std::string endpoint_;
    ClientOptions options_;
    Connection connection_;
    std::set<std::string> warned_;
};

/// Throws ProtocolError if requested pressures are missing.
void check_pressures(const WheelRailSolution& solution, const SolutionFields& fields);

/// A wrong array in the answer is an error of the daemon, not of the caller.
template <class Decode>
auto decoded(const Decode& decode) {
    try {
        return decode();
    } catch (const StatusError& error) {
        throw ProtocolError(std::string("The daemon's answer cannot be read: ") + error.what() + ".");
    }
}

}  // namespace contactd::client
