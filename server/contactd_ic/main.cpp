// contactd-ic: computes one table of influence coefficients and writes it as an IC file.
//
//     contactd-ic spec.json --output table.h5
//     mpirun -np 4 contactd-ic spec.json --output table.h5
//     contactd-ic spec.json --mesh section.vtk
//
// spec.json contains the parameters of ic.get (docs/protocol.md):
//
//     {"material": {"G": 82000, "nu": 0.28},
//      "grid": {"nx": 10, "ny": 10, "dx": 0.8, "dy": 0.8},
//      "ics": {"source": "fem", "preset": "paper-test3", "L_over_h": 1280}}
//
// The table is that of the dimensionless spec (G = 1, dx = 1). The program writes its progress to standard output, one
// JSON object per line: {"stage", "fraction", "iteration", "residual", "seconds_left", "memory_bytes"}. The last line
// is {"done": true, "output", "evidence"} or {"error": {"field", "message", "kind"}}, with the kind invalid_argument if
// a field of the spec is invalid. With --exit-with-stdin every process also writes {"heartbeat": rank, "processes"},
// four times a second. Exit statuses: 0: success; 2: the spec or the command line is invalid; 3: a solve did not
// converge; 4: no memory is left; 128 + n: signal n ended the build; 129: signal 1, or the end of standard input; 1:
// any other failure. The file is written completely or not at all.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <functional>
#include <iostream>

#include "contactd/closed_form_record.hpp"
#include "contactd/fem/ic_builder.hpp"
#include "contactd/ic_exchange.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/json_reader.hpp"
#include "contactd/proto/schema.hpp"
#include "guard.hpp"
#include "memory.hpp"

namespace contactd::ic {
namespace {

namespace fs = std::filesystem;

struct Options {
    std::string spec;
    std::string output;
    std::string mesh;
    bool exit_with_stdin = false;
    bool or_print = false;
    std::uint64_t max_memory = 0;
};

/// Holds the context of every process: options, its rank, and functions to report and to end.
struct Context {
    const Options& options;
    const fem::Runtime& runtime;
    Lines& lines;
    ProgressLines& progress;
    Guard& guard;
    std::uint64_t max_memory;  ///< for all processes on this machine together
};

/// Runs `work` on the first process. Returns its text, or throws its InvalidArgument or StoreError, on all processes.
std::string on_first(const fem::Runtime& runtime, const std::function<std::string()>& work) {
    std::string outcome, field;
    char kind = '=';
    if (runtime.rank() == 0) {
        try {
            outcome = work();
        } catch (const InvalidArgument& error) {
            kind = 'a';
            field = error.field();
            outcome = error.problem();
        } catch (const StoreError& error) {
            kind = 's';
            outcome = error.what();
        }
    }
    outcome = runtime.broadcast(kind + outcome);
    field = runtime.broadcast(field);
    kind = outcome.front();
    outcome.erase(0, 1);
    if (kind == 'a') throw InvalidArgument(field, outcome);
    if (kind == 's') throw StoreError(outcome);
    return outcome;
}

constexpr std::size_t most_spec_bytes = 16 << 20;

/// Reads the first line, or everything, up to the largest size of a spec. Unbuffered, because the guard continues to
/// read from there.
std::string read_standard_input(bool first_line_only) {
    std::string text;
    char c;
    while (text.size() <= most_spec_bytes && ::read(STDIN_FILENO, &c, 1) == 1) {
        if (first_line_only && c == '\n') break;
        text += c;
    }
    return text;
}

/// Reads regular files only, because a device may never end.
std::string read_spec(const Options& options) {
    if (options.spec == "-") return read_standard_input(options.exit_with_stdin);
    std::ifstream file(options.spec);
    std::string text(most_spec_bytes + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (text.empty()) throw InvalidArgument("SPEC", "is " + options.spec + "; give a readable file that is not empty");
    if (text.size() > most_spec_bytes)
        throw InvalidArgument("SPEC", "is " + options.spec + ", which exceeds the limit of 16 MiB");
    return text;
}

IcSpec parse_spec(const std::string& text) {
    constexpr std::size_t max_values = 10'000 + 2 * most_profile_points;  // exceeds any spec
    nlohmann::json json;
    try {
        proto::read_json(text, max_values, json, "SPEC");
    } catch (const proto::StatusError& error) {
        if (!error.status().violations.empty()) throw;
        throw InvalidArgument("SPEC", "is not JSON; it must contain the parameters of ic.get");
    }
    if (!json.is_object())
        throw InvalidArgument("SPEC", "is not a JSON object; it must contain the parameters of ic.get");
    proto::check_params("ic.get", json);
    const IcSpec spec = proto::decode_ic_spec(json);
    validate(spec);
    return spec;
}

void check_file(const char* option, const fs::path& path) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code error;
    if (!fs::is_directory(folder, error))
        throw InvalidArgument(option, "is " + path.string() + ", but its folder does not exist");
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        throw InvalidArgument(option, "is " + path.string() + ", but its folder is not writable");
    if (fs::is_directory(path, error)) throw InvalidArgument(option, "is " + path.string() + ", a folder");
}

void write_mesh(const std::string& path, const IcSpec& spec) {
    check_file("--mesh", path);
    std::ofstream file(path, std::ios::binary);
    if (!(file << fem::section_mesh(spec) << std::flush)) throw StoreError(path + " could not be written.");
}

IcRecord make_record(const Context& context, const IcSpec& spec) {
    if (spec.source == IcSource::fem) {
        context.progress.expect_memory(fem::predicted_memory(spec));
        return fem::build_ic_table(spec, context.progress, context.max_memory);
    }
    IcRecord record = closed_form_record(spec);
    record.evidence.processes = context.runtime.processes();
    return record;
}

void write_or_print(const Context& context, const IcRecord& record) {
    try {
        write_ic_file(context.options.output, record);
    } catch (const StoreError& error) {
        if (!context.options.or_print) throw;
        context.lines.write_table(to_ic_file(record), error.what());
    }
}

void run(const Context& context) {
    const Options& options = context.options;
    if (options.exit_with_stdin)
        context.guard.beat(context.runtime.rank(), context.runtime.processes(), context.progress);
    const std::string text = on_first(context.runtime, [&] {
        std::string read = read_spec(options);
        // Under mpirun standard input belongs to the first process; the others end with it.
        if (options.exit_with_stdin) context.guard.watch_standard_input();
        return read;
    });
    const IcSpec spec = parse_spec(text);
    on_first(context.runtime, [&] {
        if (!options.mesh.empty())
            write_mesh(options.mesh, spec);
        else if (!options.or_print)
            check_file("--output", options.output);
        return std::string();
    });
    if (!options.mesh.empty()) {
        context.guard.stand_down();
        if (context.runtime.rank() == 0) context.lines.write({{"done", true}, {"mesh", options.mesh}});
        return;
    }
    const IcRecord record = make_record(context, spec);
    on_first(context.runtime, [&] {
        const std::lock_guard lock(context.guard.writing());
        write_or_print(context, record);
        context.guard.stand_down();
        return std::string();
    });
    if (context.runtime.rank() == 0)
        context.lines.write(
            {{"done", true}, {"output", options.output}, {"evidence", proto::encode_evidence(record.evidence)}});
}

std::uint64_t usable_memory() {
    return static_cast<std::uint64_t>(usable_share * static_cast<double>(machine_memory()));
}

int guarded_run(const Context& context) {
    const auto everywhere = [&](const std::string& field, const char* message, int code, const char* kind = "") {
        if (context.runtime.rank() == 0) context.lines.write_error({field, message, kind});
        return code;
    };
    const auto refuse = [&](const std::string& field, const std::string& problem, const char* message) -> int {
        const bool of_command_line = field.empty() || field == "SPEC" || field.starts_with("--");
        if (of_command_line) return everywhere(field, message, bad_input);
        if (context.runtime.rank() == 0) context.lines.write_error({field, message, "invalid_argument", problem});
        return bad_input;
    };
    try {
        run(context);
        return success;
    } catch (const proto::StatusError& error) {
        const auto& violations = error.status().violations;
        const proto::Violation violation = violations.empty() ? proto::Violation{} : violations.front();
        return refuse(violation.field, violation.description, error.what());
    } catch (const InvalidArgument& error) {
        return refuse(error.field(), error.problem(), error.what());
    } catch (const OutOfMemory& error) {
        return everywhere(error.field(), error.what(), out_of_memory, "out_of_memory");
    } catch (const NotConverged& error) {
        return everywhere("", error.what(), not_converged);
    } catch (const StoreError& error) {
        return everywhere("", error.what(), failure);
    } catch (const std::bad_alloc&) {
        context.lines.write_error(
            {"", "The build ran out of memory: the machine has no free memory.", "out_of_memory"});
        if (context.runtime.processes() > 1) context.runtime.abort(out_of_memory);
        return out_of_memory;
    } catch (const std::exception& error) {  // an error of MFEM or hypre, perhaps on this process alone
        context.lines.write_error({"", std::string("The build failed: ") + error.what()});
    }
    if (context.runtime.processes() > 1) context.runtime.abort(failure);
    return failure;
}

}  // namespace
}  // namespace contactd::ic

int main(int argc, char** argv) {
    using namespace contactd;
    ic::hold_signals_back();
    const fem::Runtime runtime(argc, argv);

    ic::Options options;
    CLI::App app("Computes one table of influence coefficients and writes it as an IC file.", "contactd-ic");
    app.add_option("SPEC", options.spec,
                   "JSON file with the parameters of ic.get; - reads standard input (its first line with "
                   "--exit-with-stdin)")
        ->required();
    const CLI::Option* output =
        app.add_option("-o,--output", options.output, "Output file; it is written completely or not at all");
    const CLI::Option* mesh = app.add_option(
        "--mesh", options.mesh, "Write only the mesh of a body's cross-section (VTK), without building a table");
    app.add_flag("--exit-with-stdin", options.exit_with_stdin,
                 "Exit when standard input ends, because the process that started the build has ended");
    app.add_flag("--or-print", options.or_print,
                 "If the file cannot be written, print {\"table_bytes\": n, \"problem\"} and then its n bytes");
    app.add_option("--max-memory", options.max_memory,
                   "Memory limit in bytes for all processes on one machine together; 0: four fifths of the memory of "
                   "the machine or the control group");
    app.set_version_flag("--version", fem::fem_version());

    ic::Lines lines;
    try {
        app.parse(argc, argv);
        if (output->empty() == mesh->empty()) throw CLI::RequiredError("One of --output and --mesh");
    } catch (const CLI::Success& asked_for_help) {
        return runtime.rank() == 0 ? app.exit(asked_for_help) : 0;
    } catch (const CLI::ParseError& error) {
        if (runtime.rank() == 0) lines.write_error({"", error.what()});
        return ic::bad_input;
    }
    ic::volunteer_for_the_kernel();
    const std::vector<int> here = runtime.processes_here();
    const std::uint64_t max_memory = options.max_memory > 0 ? options.max_memory : ic::usable_memory();
    ic::ProgressLines progress(lines);
    ic::Guard guard(lines, runtime.processes() > 1);
    // One process checks the memory of all processes on its machine.
    if (here.front() == ::getpid()) guard.watch_memory({here.begin(), here.end()}, max_memory);
    return ic::guarded_run({options, runtime, lines, progress, guard, max_memory});
}
