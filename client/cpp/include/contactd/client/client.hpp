// A client of the contactd daemon.
//
//     contactd::client::Client client("ipc:///run/contactd.sock");
//     contactd::ContactProblem problem = ...;
//     const auto reply = client.solve(problem);
//     std::cout << reply.solution.forces.Fn << " N\n";
//
// Units are the caller's, consistently (the documentation uses N and mm).
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
    std::chrono::milliseconds connect_timeout{5'000};    ///< for somebody to listen at the endpoint
    std::chrono::milliseconds timeout{60'000};           ///< of a call
    std::chrono::milliseconds build_timeout{3'600'000};  ///< of calls that may wait for tables by finite elements
    MessageLimits limits{};                              ///< checked before a message is sent
    /// Files of CURVE keys for an encrypted connection (docs/security.md), or neither: the daemon's public key, and the
    /// secret key of this client, which the daemon has to know.
    std::filesystem::path server_key{}, own_key{};
    /// How long a call looks for its answer before its thread sleeps. Waking it takes 20 to 50 us, which this saves
    /// while it keeps a processor busy (docs/performance.md).
    std::chrono::microseconds spin{};
    /// Receives the warnings of an answer, all at once: whole sentences, which of several problems, steps or patches
    /// begin with the part that they are of ("problems[3]: "). Called in the calling thread before the call
    /// returns; it must neither throw nor use this client. Empty: each sentence goes to standard error, once for each
    /// client. `[](const auto&) {}` silences them; answers have them all the same.
    std::function<void(const std::vector<std::string>& sentences)> on_warnings{};
};

/// How far the work of a call is.
struct Progress {
    std::string job;                              ///< for cancel_job; empty when the daemon names none
    std::string stage;                            ///< "pcg", "normal", ...
    double fraction = 0;                          ///< of the whole work, 0..1, an estimate
    int iteration = 0;                            ///< within the stage
    double residual = 0;                          ///< the figure that the stage's stopping criterion compares
    std::string state{};                          ///< of watch_health
    std::optional<double> seconds_left{};         ///< time to go for the whole work (s), where there is an estimate
    std::optional<std::uint64_t> memory_bytes{};  ///< the most that a build will take, where there is an estimate
};

struct CallOptions {
    /// The timeout in place of the client's own. It is sent to the daemon, which answers DEADLINE_EXCEEDED, and
    /// enforced here half a second later, should no answer come.
    std::optional<std::chrono::milliseconds> timeout{};
    /// Called in the calling thread while the call waits. An exception it throws ends the call.
    std::function<void(const Progress&)> on_progress{};
    /// Ends the call with StatusError (CANCELLED) soon after a stop is requested, from any thread. The daemon learns of
    /// it, as it is when a call times out or on_progress throws; a build goes on for its cache.
    std::stop_token stop{};
};

/// One connection, for one call at a time: use one client per thread, and another one in on_progress. A call while
/// another one of the same client runs throws ConcurrencyError; threads may hand a client on between calls. A process
/// that was forked goes on with a connection of its own. Nothing is sent before the first call. Every call throws
/// ConnectionError, TimeoutError, ProtocolError or StatusError; the object stays usable after each of them.
class Client {
   public:
    /// `endpoint` as ZeroMQ writes it: "ipc:///path" or "tcp://host:port". Throws ConnectionError when it is malformed,
    /// Error when a key file cannot be used.
    explicit Client(const std::string& endpoint, ClientOptions options = {});
    ~Client();
    Client(Client&&) noexcept;
    Client& operator=(Client&&) noexcept;

    /// Version, limits, counters, ...
    ServerInfo info(const CallOptions& options = {});
    /// "serving" or "stopping".
    std::string health(const CallOptions& options = {});
    /// Calls `on_state` with the state now and with each change, until the daemon ends; gives the last one, "stopping".
    std::string watch_health(const std::function<void(const std::string&)>& on_state, CallOptions options = {});
    /// The OpenRPC document of the service, JSON as text.
    std::string describe(const CallOptions& options = {});
    /// Metrics of the daemon.
    std::vector<Metric> metrics(const CallOptions& options = {});
    /// The configuration of the daemon but for secrets and what names files, programs, variables and addresses, JSON as
    /// text.
    std::string config(const CallOptions& options = {});

    /// The influence coefficients of one body in mm^3/N. Waits for a build when the daemon has no such table. One that
    /// is too large for a message comes in several, each with the same timeout.
    IcReply get_ic(const IcSpec& spec, const CallOptions& options = {});

    /// The table of get_ic as the content of a file: the store's HDF5 (docs/ic-tables.md), or the text in which the
    /// CONTACT program takes the coefficients of a pair of bodies, of which `lower` is the second (none: as the first).
    std::string export_ic(const IcSpec& spec, FileFormat format = FileFormat::hdf5,
                          const std::optional<Material>& lower = {}, const CallOptions& options = {});

    /// The table of get_ic as import_ic takes it: the file of export_ic, taken apart.
    FileContents export_contents(const IcSpec& spec, const CallOptions& options = {});

    /// Puts a table into the daemon's store: one of export_contents, of this daemon or another, or what a program has
    /// read from an IC file. What the daemon has already stays. Throws StatusError (INVALID_ARGUMENT) for what is no
    /// such table, one that errs by more than it states, or one of a closed form.
    IcImport import_ic(const FileContents& contents, const CallOptions& options = {});

    /// The tables in the daemon's store, by name; asked for a thousand at a time. With `evidence` each says how it was
    /// made, which takes its file to be read: asked for a hundred at a time.
    std::vector<StoredIc> stored_ics(const CallOptions& options = {}, bool evidence = false);
    /// Tables whose builds failed too often, the latest first: requests for them throw StatusError
    /// (FAILED_PRECONDITION).
    std::vector<QuarantinedIc> quarantined_ics(const CallOptions& options = {});
    /// Removes the tables of a key from the daemon's store and ends its quarantine; gives the number of tables that
    /// went. Throws StatusError (NOT_FOUND) when there was nothing to do.
    int delete_ic(const std::string& key, const CallOptions& options = {});

    /// Solves a contact problem. A solution that missed its tolerance is returned and says so (converged()).
    /// Arrays that `fields` does not name are empty; forces need none.
    SolveReply solve(const ContactProblem& problem, const CallOptions& options = {},
                     const SolutionFields& fields = all_solution_fields);

    /// Solves 1 to 1000 contact problems at once, on all workers of the daemon. The answers have the order of the
    /// problems; instead of a solution comes the status of a problem that failed, which does not fail the others.
    /// Arrays that several problems have in common (tables, gaps) are sent once. Throws InvalidArgument naming
    /// problems[i].FIELD for one that cannot be solved as stated.
    std::vector<ReplyOrStatus> solve_many(std::span<const ContactProblem> problems, const CallOptions& options = {},
                                          const SolutionFields& fields = all_solution_fields);

    /// Stresses inside a body under the tractions of a solution. The request's points and the stresses are in the frame
    /// of that body: z <= 0 is inside, for the upper one too. Throws InvalidArgument naming an array that does not fit
    /// the grid.
    SubsurfaceReply subsurface(const SubsurfaceRequest& request, const CallOptions& options = {});

    /// Temperatures of both surfaces under the tractions and slips of a solution that rolls steadily along x. Throws
    /// InvalidArgument naming an array that does not fit the grid.
    SurfaceTemperatures temperature(const TemperatureRequest& request, const CallOptions& options = {});

    /// The contact of a wheel with its rail: patches, and forces on the rail; no contact is an answer. Bodies are
    /// half-spaces in closed form. A set-up that was asked for before costs less. Arrays of the patches that `fields`
    /// does not name are empty, and so are their gaps unless `gap` asks for them. Throws InvalidArgument naming
    /// "setup.track.gauge", "state.position.roll", ...
    WheelRailSolution wheel_rail(const WheelRailSetup& setup, const WheelRailState& state,
                                 const CallOptions& options = {}, const SolutionFields& fields = all_solution_fields,
                                 bool gap = false);
    /// Both wheels of a wheelset that is free to roll: each presses on its rail as the state says, and height and roll
    /// are found. Throws InvalidArgument naming "setup.track.gauge", "left.rail.points", "state.left_rail.y", ...
    WheelsetSolution wheelset(const WheelsetSetup& setup, const WheelsetState& state, const CallOptions& options = {},
                              const SolutionFields& fields = all_solution_fields, bool gap = false);
    /// The search for contacts alone, in up to 1000 states; where one has Fz, at the height at which Hertz's theory
    /// expects that force.
    std::vector<WheelRailGeometry> wheel_rail_geometry(const WheelRailSetup& setup,
                                                       std::span<const WheelRailState> states,
                                                       const CallOptions& options = {});

    /// The equivalent conicity of a rigid wheelset, for each amplitude.
    std::vector<EquivalentConicity> equivalent_conicities(const WheelsetSetup& setup, const ConicityRequest& request,
                                                          const CallOptions& options = {});
    /// Contact points of a rigid wheelset on rigid rails, for each lateral shift.
    std::vector<WheelsetContacts> wheelset_contacts(const WheelsetSetup& setup, const ContactsRequest& request,
                                                    const CallOptions& options = {});
    /// The profiles as the daemon has read them, and where they lie, for drawings.
    ProfilesOfSides placed_profiles(const WheelsetSetup& setup, const CallOptions& options = {});

    /// The open sessions, oldest first.
    std::vector<SessionSummary> sessions(const CallOptions& options = {});

    /// The last solves of the same user, the latest first: a user is a key or, without keys, an address or, over ipc, a
    /// user of the machine.
    std::vector<RecentSolve> recent_solves(const CallOptions& options = {});
    /// The pressures of one of them, by its number: of each of its grids. Throws StatusError (NOT_FOUND) when the
    /// daemon does not have them, or no longer has them.
    std::vector<RecentPatch> recent_pressures(std::int64_t number, const CallOptions& options = {});

    std::vector<Job> jobs(const CallOptions& options = {});
    /// Ends a job; everyone waiting for it gets CANCELLED. Throws StatusError (NOT_FOUND) when there is none.
    void cancel_job(const std::string& job, const CallOptions& options = {});

   private:
    friend class AnySession;
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace contactd::client
