// Provides a client of the contactd daemon.
//
//     contactd::client::Client client("ipc:///run/contactd.sock");
//     contactd::ContactProblem problem = ...;
//     const auto reply = client.solve(problem);
//     std::cout << reply.solution.forces.Fn << " N\n";
//
// Use any consistent units (the documentation uses N and mm); wheels on rails require N, mm and rad.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "contactd/client/errors.hpp"
#include "contactd/client/server_info.hpp"
#include "contactd/conicity.hpp"
#include "contactd/contact.hpp"
#include "contactd/contact_file_run.hpp"
#include "contactd/file_contents.hpp"
#include "contactd/ic_import.hpp"
#include "contactd/ic_reply.hpp"
#include "contactd/ic_spec.hpp"
#include "contactd/solve_reply.hpp"
#include "contactd/subsurface_stress.hpp"
#include "contactd/temperature.hpp"
#include "contactd/wheel_rail_setup.hpp"
#include "contactd/wheel_rail_solution.hpp"
#include "contactd/wheel_rail_state.hpp"

namespace contactd::client {

struct ClientOptions {
    std::chrono::milliseconds connect_timeout{5'000};    ///< timeout of the connection to the daemon
    std::chrono::milliseconds timeout{60'000};           ///< of a call
    std::chrono::milliseconds build_timeout{3'600'000};  ///< for calls that may wait for tables by finite elements
    MessageLimits limits{};                              ///< checked before a message is sent
    /// Files of CURVE keys for an encrypted connection (docs/security.md), or neither: the daemon's public key, and
    /// the secret key of this client, whose public key must be registered with the daemon.
    std::filesystem::path server_key{}, own_key{};
    /// Time for which a call polls for its answer before its thread sleeps. Polling saves the 20 to 50 us of waking
    /// the thread, but keeps a processor busy (docs/performance.md).
    std::chrono::microseconds spin{};
    /// Receives all warnings of an answer in one call. With several problems, steps or patches a warning begins with
    /// its part ("problems[3]: "). Called in the calling thread before the call returns; it must neither throw nor use
    /// this client. If empty, each warning is written to standard error once per client. `[](const auto&) {}` silences
    /// them. The answers contain them in any case.
    std::function<void(const std::vector<std::string>& sentences)> on_warnings{};
};

/// Describes the progress of the work of a call.
struct Progress {
    std::string job;                              ///< for cancel_job; empty if there is no job
    std::string stage;                            ///< "pcg", "normal", ...
    double fraction = 0;                          ///< estimated fraction of the whole work, 0..1
    int iteration = 0;                            ///< within the stage
    double residual = 0;                          ///< the value that the stage's stopping criterion compares
    std::string state{};                          ///< of watch_health
    std::optional<double> seconds_left{};         ///< estimated remaining time of the whole work (s)
    std::optional<std::uint64_t> memory_bytes{};  ///< estimated largest memory of a build
};

struct CallOptions {
    /// Replaces the client's timeout. It is sent to the daemon, which answers DEADLINE_EXCEEDED, and enforced here
    /// half a second later if no answer arrives.
    std::optional<std::chrono::milliseconds> timeout{};
    /// Called in the calling thread while the call waits. An exception it throws ends the call.
    std::function<void(const Progress&)> on_progress{};
    /// Ends the call with StatusError (CANCELLED) soon after a stop is requested, from any thread. The daemon is
    /// notified, as it is when a call times out or on_progress throws; a build continues for the cache.
    std::stop_token stop{};
};

/// Holds one connection, for one call at a time: use one client per thread, and another one in on_progress. A call
/// during another call of the same client throws ConcurrencyError; threads may use a client in turn. A forked process
/// continues with its own connection. Nothing is sent before the first call. Every call throws ConnectionError,
/// TimeoutError, ProtocolError or StatusError on failure; the object stays usable after each of them.
class Client {
   public:
    /// Creates a client. `endpoint` is an address of ZeroMQ: "ipc:///path" or "tcp://host:port". Throws
    /// ConnectionError if it is malformed, Error if a key file cannot be used.
    explicit Client(const std::string& endpoint, ClientOptions options = {});
    ~Client();
    Client(Client&&) noexcept;
    Client& operator=(Client&&) noexcept;

    /// Returns version, limits, counters and so on.
    ServerInfo info(const CallOptions& options = {});
    /// Returns "serving" or "stopping".
    std::string health(const CallOptions& options = {});
    /// Calls `on_state` with the current state and with each change, until the daemon ends. Returns the last state,
    /// "stopping".
    std::string watch_health(const std::function<void(const std::string&)>& on_state, CallOptions options = {});
    /// Returns the OpenRPC document of the service as JSON text.
    std::string describe(const CallOptions& options = {});
    /// Returns the metrics of the daemon.
    std::vector<Metric> metrics(const CallOptions& options = {});
    /// Returns the configuration of the daemon as JSON text, without secrets and without names of files, programs,
    /// variables and addresses.
    std::string config(const CallOptions& options = {});

    /// Returns the influence coefficients of one body in mm^3/N. Waits for a build if the daemon has no such table. A
    /// table that is too large for a message is requested in parts, each with the same timeout.
    IcReply get_ic(const IcSpec& spec, const CallOptions& options = {});

    /// Returns the table of get_ic as the content of a file: the store's HDF5 (docs/ic-tables.md), or the text file of
    /// the CONTACT program for a pair of bodies. `lower` is the second body of the pair, by default equal to the
    /// first.
    std::string export_ic(const IcSpec& spec, FileFormat format = FileFormat::hdf5,
                          const std::optional<Material>& lower = {}, const CallOptions& options = {});

    /// Returns the table of get_ic in the form that import_ic accepts: the attributes and datasets of the file.
    FileContents export_contents(const IcSpec& spec, const CallOptions& options = {});

    /// Imports a table into the daemon's store: a result of export_contents, from this daemon or another one, or the
    /// contents of an IC file. A table that the daemon already has is kept. Throws StatusError (INVALID_ARGUMENT) if
    /// the contents are not a table, if its error exceeds the stated one, or if it has a closed form.
    IcImport import_ic(const FileContents& contents, const CallOptions& options = {});

    /// Returns the tables in the daemon's store, by name, in requests of a thousand. With `evidence` the daemon reads
    /// the file of each table to report how it was made, in requests of a hundred.
    std::vector<StoredIc> stored_ics(const CallOptions& options = {}, bool evidence = false);
    /// Returns the tables whose builds failed too often, the most recent first. Requests for them throw StatusError
    /// (FAILED_PRECONDITION).
    std::vector<QuarantinedIc> quarantined_ics(const CallOptions& options = {});
    /// Removes the tables of a key from the daemon's store and ends its quarantine. Returns the number of removed
    /// tables. Throws StatusError (NOT_FOUND) if there are neither tables nor a quarantine.
    int delete_ic(const std::string& key, const CallOptions& options = {});

    /// Solves a contact problem. A solution that missed its tolerance is returned; converged() reports it. Arrays that
    /// `fields` does not name are empty; forces require none.
    SolveReply solve(const ContactProblem& problem, const CallOptions& options = {},
                     const SolutionFields& fields = all_solution_fields);

    /// Solves 1 to 1000 contact problems at once, on all workers of the daemon. Returns, in the order of the problems,
    /// a solution or the status of a failure, which does not affect the other problems. Arrays that several problems
    /// share (tables, gaps) are sent once. Throws InvalidArgument naming problems[i].FIELD for invalid input.
    std::vector<ReplyOrStatus> solve_many(std::span<const ContactProblem> problems, const CallOptions& options = {},
                                          const SolutionFields& fields = all_solution_fields);

    /// Returns the stresses inside a body under the tractions of a solution. Points and stresses are in the frame of
    /// that body: z <= 0 is inside, also for the upper body. Throws InvalidArgument naming an array that does not fit
    /// the grid.
    SubsurfaceReply subsurface(const SubsurfaceRequest& request, const CallOptions& options = {});

    /// Returns the temperatures (degrees Celsius) of both surfaces in steady rolling along x. Throws
    /// InvalidArgument naming an array that does not fit the grid.
    SurfaceTemperatures temperature(const TemperatureRequest& request, const CallOptions& options = {});

    /// Computes the requested cases of an input file of the CONTACT program: forces, patches and arrays by CONTACT's
    /// names. Solutions have the arrays that `fields` names. Errors of a case are its outcome. A long run takes several
    /// requests, each with the timeout. Throws StatusError (INVALID_ARGUMENT) for a text that cannot be read.
    std::vector<ContactFileOutcome> run_contact_file(const ContactFileInput& input, const CallOptions& options = {},
                                                     const SolutionFields& fields = all_solution_fields);
    /// Converts the requested cases to problems of solve and wheel_rail, without solving them. Throws as
    /// run_contact_file.
    std::vector<ContactFileProblem> convert_contact_file(const ContactFileInput& input,
                                                         const CallOptions& options = {});

    /// Solves the contact of a wheel with its rail: patches, and forces on the rail (N). Without contact there are no
    /// patches, which is not an error. A repeated set-up costs less. Arrays of the patches that `fields` does not name
    /// are empty, and so are their gaps without `gap`. Throws InvalidArgument naming the field, such as
    /// "setup.track.gauge" or "state.position.roll".
    WheelRailSolution wheel_rail(const WheelRailSetup& setup, const WheelRailState& state,
                                 const CallOptions& options = {}, const SolutionFields& fields = all_solution_fields,
                                 bool gap = false);
    /// Solves both wheels of a wheelset that is free to roll, each under its own force. Height and roll are computed.
    /// Throws InvalidArgument naming the field, such as "left.rail.points" or "state.left_rail.y".
    WheelsetSolution wheelset(const WheelsetSetup& setup, const WheelsetState& state, const CallOptions& options = {},
                              const SolutionFields& fields = all_solution_fields, bool gap = false);
    /// Searches for contacts without a solve, in up to 1000 states. A state with Fz has the height at which Hertz's
    /// theory predicts that force.
    std::vector<WheelRailGeometry> wheel_rail_geometry(const WheelRailSetup& setup,
                                                       std::span<const WheelRailState> states,
                                                       const CallOptions& options = {});

    /// Returns the equivalent conicity of a rigid wheelset for each amplitude.
    std::vector<EquivalentConicity> equivalent_conicities(const WheelsetSetup& setup, const ConicityRequest& request,
                                                          const CallOptions& options = {});
    /// Returns the contact points of a rigid wheelset on rigid rails for each lateral shift.
    std::vector<WheelsetContacts> wheelset_contacts(const WheelsetSetup& setup, const ContactsRequest& request,
                                                    const CallOptions& options = {});
    /// Returns the profiles as the daemon read them, with their positions, for drawings.
    ProfilesOfSides placed_profiles(const WheelsetSetup& setup, const CallOptions& options = {});

    /// Returns the open sessions, oldest first.
    std::vector<SessionSummary> sessions(const CallOptions& options = {});

    /// Returns the last solves of the same user, the most recent first. A user is a key or, without keys, an address
    /// or, over ipc, a user of the machine.
    std::vector<RecentSolve> recent_solves(const CallOptions& options = {});
    /// Returns the pressures of a recent solve on each of its grids. Throws StatusError (NOT_FOUND) if the daemon does
    /// not have them, or no longer has them.
    std::vector<RecentPatch> recent_pressures(std::int64_t number, const CallOptions& options = {});

    std::vector<Job> jobs(const CallOptions& options = {});
    /// Cancels a job; all its callers receive CANCELLED. Throws StatusError (NOT_FOUND) if there is no such job.
    void cancel_job(const std::string& job, const CallOptions& options = {});

   private:
    friend class AnySession;
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace contactd::client
