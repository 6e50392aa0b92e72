// Tests the program contactd-ic in the way users run it.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "contactd/ic_store.hpp"
#include "support/temporary_folder.hpp"

using namespace contactd;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
namespace fs = std::filesystem;

namespace {

const std::string program = CONTACTD_IC;
const std::string small_spec =
    R"({"material": {"G": 82000, "nu": 0.28}, "grid": {"nx": 5, "ny": 4, "dx": 0.8, "dy": 0.5},)"
    R"( "ics": {"source": "fem", "preset": "paper-test2", "h_over_hs": 2, "L_over_h": 20}})";
const std::string slow = R"({"material": {"G": 82000, "nu": 0.28}, "grid": {"nx": 5, "ny": 4, "dx": 0.8, "dy": 0.8},)"
                         R"( "ics": {"source": "fem", "preset": "paper-test3", "L_over_h": 1280}})";

const std::string section =
    R"({"material": {"G": 82000, "nu": 0.28}, "grid": {"nx": 5, "ny": 4, "dx": 0.5, "dy": 0.5}, "ics": {"source": "fem",)"
    R"( "body": "longitudinally_uniform", "accuracy": 1e-2, "section": {"edge_block": {"width": 20, "height": 10}}}})";

std::string launcher(int processes) {
    return MPIRUN " --oversubscribe -np " + std::to_string(processes) + " ";
}

int exit_code(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// Provides a temporary folder; commands run in it, with standard output in out.txt and standard error in err.txt.
class Folder {
   public:
    Folder() {
        ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
        ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    }

    fs::path operator/(const char* name) const { return folder_.path() / name; }
    void write(const char* name, const std::string& text) const { std::ofstream(folder_.path() / name) << text; }
    std::string read(const char* name) const {
        std::ostringstream text;
        text << std::ifstream(folder_.path() / name).rdbuf();
        return text.str();
    }
    std::string redirected(const std::string& command) const {
        return "cd '" + folder_.path().string() + "' && exec " + command + " > out.txt 2> err.txt";
    }
    int run(const std::string& command) const { return exit_code(std::system(redirected(command).c_str())); }
    std::string last_line() const {
        std::string text = read("out.txt");
        if (!text.empty()) text.pop_back();
        return text.substr(text.find_last_of('\n') + 1);
    }
    /// Waits until standard output contains `token`.
    bool wait_for(const char* token) const {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
        while (std::chrono::steady_clock::now() < end) {
            if (read("out.txt").find(token) != std::string::npos) return true;
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
        return false;
    }
    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder_.path()))
            names.push_back(entry.path().filename().string());
        std::sort(names.begin(), names.end());
        return names;
    }

   private:
    TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("contactd-ic writes the table and says so", "[contactd-ic]") {
    const Folder folder;
    folder.write("spec.json", small_spec);
    REQUIRE(folder.run(program + " spec.json --output table.h5") == 0);
    const IcRecord record = read_ic_file(folder / "table.h5");
    CHECK(record.spec.nx == 5);
    CHECK(record.spec.dx == 1);
    CHECK(record.evidence.load_cases.size() == 3);
    CHECK_THAT(folder.read("out.txt"),
               ContainsSubstring(R"("stage":"assembly")") && ContainsSubstring(R"("stage":"pcg")"));
    CHECK_THAT(folder.last_line(), ContainsSubstring(R"("done":true)") && ContainsSubstring(R"("output":"table.h5")"));
    CHECK(folder.read("err.txt").empty());
    CHECK(folder.files() == std::vector<std::string>{"err.txt", "out.txt", "spec.json", "table.h5"});
}

TEST_CASE("contactd-ic writes the mesh of a section", "[contactd-ic]") {
    const Folder folder;
    folder.write("spec.json", R"({"material": {"G": 1, "nu": 0.3}, "grid": {"nx": 2, "ny": 4, "dx": 0.5, "dy": 0.5},
                                  "ics": {"source": "fem", "body": "longitudinally_uniform", "accuracy": 1e-2,
                                          "section": {"slab": {"thickness": 2, "width": 8}}}})");
    REQUIRE(folder.run(program + " spec.json --mesh section.vtk") == 0);
    CHECK_THAT(folder.last_line(), ContainsSubstring(R"("mesh":"section.vtk")"));
    std::istringstream text(folder.read("section.vtk"));
    std::string token;
    while (text >> token && token != "POINTS") {
    }
    std::size_t count = 0;
    text >> count >> token;
    REQUIRE(count > 100);
    double left = 0, right = 0, bottom = 0, top = -1;
    for (std::size_t i = 0; i < count; ++i) {
        double y = 0, z = 0, none = 0;
        text >> y >> z >> none;
        left = std::min(left, y);
        right = std::max(right, y);
        bottom = std::min(bottom, z);
        top = std::max(top, z);
    }
    CHECK_THAT(left, WithinAbs(-4, 1e-9));
    CHECK_THAT(right, WithinAbs(4, 1e-9));
    CHECK_THAT(bottom, WithinAbs(-2, 1e-9));
    CHECK_THAT(top, WithinAbs(0, 1e-9));
}

TEST_CASE("contactd-ic writes either a table or a mesh, and of sections alone", "[contactd-ic]") {
    const Folder folder;
    folder.write("spec.json", small_spec);
    CHECK(folder.run(program + " spec.json") == 2);
    CHECK_THAT(folder.last_line(), ContainsSubstring("One of --output and --mesh"));
    CHECK(folder.run(program + " spec.json --output table.h5 --mesh section.vtk") == 2);
    CHECK(folder.run(program + " spec.json --mesh section.vtk") == 2);
    CHECK_THAT(folder.last_line(), ContainsSubstring("ics.body"));
    CHECK(folder.run(program + " spec.json --mesh missing/section.vtk") == 2);
    CHECK_THAT(folder.last_line(), ContainsSubstring("--mesh"));
}

TEST_CASE("contactd-ic reads its spec from standard input", "[contactd-ic]") {
    const Folder folder;
    folder.write("spec.json", R"({"material": {"G": 1, "nu": 0.5}, "grid": {"nx": 3, "ny": 2, "dx": 1, "dy": 1},
                                  "ics": {"source": "analytic"}})");
    REQUIRE(folder.run(program + " - --output table.h5 < spec.json") == 0);
    CHECK(read_ic_file(folder / "table.h5").evidence.source == "analytic");
}

TEST_CASE("Under mpirun contactd-ic makes the same table", "[contactd-ic][mpi]") {
    const Folder folder;
    folder.write("spec.json", small_spec);
    REQUIRE(folder.run(program + " spec.json --output one.h5") == 0);
    const int processes = GENERATE(2, 3, 4);
    CAPTURE(processes);
    REQUIRE(folder.run(launcher(processes) + program + " spec.json --output many.h5") == 0);
    const IcRecord one = read_ic_file(folder / "one.h5"), many = read_ic_file(folder / "many.h5");
    CHECK(many.evidence.processes == processes);
    CHECK(many.spec == one.spec);
    double largest = 0, difference = 0;
    for (std::size_t i = 0; i < one.table().values.size(); ++i) {
        largest = std::max(largest, std::abs(one.table().values[i]));
        difference = std::max(difference, std::abs(one.table().values[i] - many.table().values[i]));
    }
    CHECK(difference <= 1e-6 * largest);
}

TEST_CASE("A spec that cannot be used is named", "[contactd-ic]") {
    const Folder folder;
    const auto refused = [&](const std::string& spec, const std::string& field) {
        CAPTURE(spec);
        folder.write("spec.json", spec);
        CHECK(folder.run(program + " spec.json --output table.h5") == 2);
        CHECK_THAT(folder.last_line(), ContainsSubstring(R"("error")") && ContainsSubstring("\"field\":\"" + field));
        CHECK_THAT(folder.read("err.txt"), ContainsSubstring(field));
        CHECK_FALSE(fs::exists(folder / "table.h5"));
    };
    const auto with = [](const std::string& from, const std::string& to) {
        std::string spec = small_spec;
        return spec.replace(spec.find(from), from.size(), to);
    };
    refused("no JSON", "SPEC");
    refused("[]", "SPEC");
    refused(with(R"("nu": 0.28)", R"("nu": 0.5)"), "material.nu");
    refused(with(R"("nx": 5, )", ""), "grid.nx");
    refused(with(R"("nx": 5, )", R"("nx": 4, "nx": 5, )"), "grid.nx");
    refused(with(R"("nx": 5)", R"("nx": 5.5)"), "grid.nx");
    refused(with(R"("h_over_hs": 2)", R"("h_over_hs": 3)"), "ics.h_over_hs");
    refused(with(R"("preset")", R"("prest")"), "ics.prest");
}

TEST_CASE("Of several processes the first one factorises, and refines, alone", "[contactd-ic][mpi]") {
    const Folder folder;
    const std::string begin = R"({"material": {"G": 82000, "nu": 0.28}, )"
                              R"("grid": {"nx": 5, "ny": 4, "dx": 0.8, "dy": 0.8}, "ics": {"source": "fem", )";
    const auto [ics, solver] = GENERATE(std::pair(R"("accuracy": 1e-2}})", "direct"),
                                        std::pair(R"("order": 2, "solver": "direct", "f": 2}})", "direct"),
                                        std::pair(R"("mesh": "adaptive", "max_dofs": 6000}})", "amg_pcg"));
    CAPTURE(ics);
    folder.write("spec.json", begin + ics);
    REQUIRE(folder.run(program + " spec.json --output one.h5") == 0);
    REQUIRE(folder.run(launcher(2) + program + " spec.json --output many.h5") == 0);
    const IcRecord one = read_ic_file(folder / "one.h5"), many = read_ic_file(folder / "many.h5");
    CHECK(many.evidence.solver == solver);
    CHECK(many.evidence.processes == 1);
    CHECK(many.table().values == one.table().values);
}

TEST_CASE("Who uses more memory than allowed is ended, and says so", "[contactd-ic]") {
    const Folder folder;
    folder.write("spec.json", slow);
    const std::string command = GENERATE(program, launcher(2) + program);
    CHECK(folder.run(command + " spec.json --output table.h5 --max-memory 320000000") == 4);
    CHECK_THAT(folder.read("out.txt"), ContainsSubstring(R"("kind":"out_of_memory")") && ContainsSubstring("it uses") &&
                                           ContainsSubstring("320000000 bytes (builds.max_memory_bytes)"));
    CHECK_FALSE(fs::exists(folder / "table.h5"));
}

TEST_CASE("What would take far more memory than allowed is not begun", "[contactd-ic]") {
    const Folder folder;
    folder.write("spec.json", slow);
    const std::string command = GENERATE(program, launcher(2) + program);
    // Two processes use 130 MB before they begin, and the build would take 470 MB.
    CHECK(folder.run(command + " spec.json --output table.h5 --max-memory 220000000") == 4);
    CHECK_THAT(folder.last_line(), ContainsSubstring(R"("field":"ics")") && ContainsSubstring("unknowns"));
}

TEST_CASE("A long step is reported again and again with the time that is left", "[contactd-ic]") {
    const Folder folder;
    const std::string command = folder.redirected(program + " - --output table.h5 --exit-with-stdin");
    FILE* pipe = ::popen(command.c_str(), "w");
    REQUIRE(pipe != nullptr);
    std::fputs(R"({"material": {"G": 1, "nu": 0.28}, "grid": {"nx": 5, "ny": 5, "dx": 1, "dy": 1}, )"
               R"("ics": {"source": "fem", "order": 3, "f": 1.2, "solver": "direct"}})"
               "\n",
               pipe);
    std::fflush(pipe);
    REQUIRE(folder.wait_for(R"("done")"));
    CHECK(exit_code(::pclose(pipe)) == 0);
    int reports = 0;
    std::istringstream lines(folder.read("out.txt"));
    for (std::string line; std::getline(lines, line);)
        reports += line.find(R"("stage":"factorisation")") != std::string::npos &&
                   line.find("seconds_left") != std::string::npos;
    CHECK(reports > 4);  // has two load cases of some seconds each
}

TEST_CASE("Without the module that meshes sections only sections are missed, by a sentence", "[contactd-ic]") {
    const Folder folder;
    fs::copy_file(program, folder / "contactd-ic");
    folder.write("spec.json", small_spec);
    CHECK(folder.run("./contactd-ic spec.json --output table.h5") == 0);
    folder.write("spec.json", section);
    CHECK(folder.run("./contactd-ic spec.json --output table.h5") == 1);
    CHECK_THAT(folder.last_line(), ContainsSubstring("contactd-gmsh.so, which meshes sections, is missing"));
    CHECK(folder.run(program + " spec.json --output table.h5") == 0);
    folder.write("contactd-gmsh.so", "no module");
    CHECK(folder.run("./contactd-ic spec.json --output table.h5") == 1);
    CHECK_THAT(folder.last_line(), ContainsSubstring("cannot be used") && ContainsSubstring("contactd-gmsh.so"));
}

TEST_CASE("A command line that cannot be used is named", "[contactd-ic]") {
    const Folder folder;
    folder.write("spec.json", small_spec);
    CHECK(folder.run(program) == 2);
    CHECK(folder.run(program + " spec.json --output missing/table.h5") == 2);
    CHECK_THAT(folder.last_line(), ContainsSubstring(R"("field":"--output")"));
    CHECK(folder.run(program + " missing.json --output table.h5") == 2);
    CHECK(folder.run(program + " --help") == 0);
    CHECK(folder.run(program + " --version") == 0);
    CHECK_THAT(folder.read("out.txt"), ContainsSubstring("MFEM"));
}

TEST_CASE("A solve that does not converge has a status of its own", "[contactd-ic]") {
    const Folder folder;
    std::string spec = small_spec;
    folder.write("spec.json", spec.replace(spec.find(R"("L_over_h")"), 0, R"("max_iterations": 2, )"));
    const std::string command = GENERATE(program, launcher(2) + program);
    CHECK(folder.run(command + " spec.json --output table.h5") == 3);
    CHECK_THAT(folder.read("out.txt"), ContainsSubstring("did not converge"));
    CHECK_FALSE(fs::exists(folder / "table.h5"));
}

TEST_CASE("A signal ends contactd-ic at once and leaves no file", "[contactd-ic]") {
    const Folder folder;
    folder.write("spec.json", slow);
    const auto [name, status] = GENERATE(std::pair("TERM", 143), std::pair("INT", 130));
    // A shell ignores INT in programs that it starts in the background, so the program is started by the shell's exec.
    std::ofstream(folder / "run.sh") << "echo $$ > pid\nexec " << program << " spec.json --output table.h5\n";
    int code = 0;
    std::thread runner([&] { code = folder.run("sh run.sh"); });
    const bool started = folder.wait_for("amg_setup");
    std::system(("kill -" + std::string(name) + " " + folder.read("pid")).c_str());
    const auto start = std::chrono::steady_clock::now();
    runner.join();
    CHECK(started);
    CHECK(code == status);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(2));
    CHECK_THAT(folder.last_line(), ContainsSubstring("SIG" + std::string(name)));
    CHECK(folder.files() == std::vector<std::string>{"err.txt", "out.txt", "pid", "run.sh", "spec.json"});
}

TEST_CASE("The end of standard input ends contactd-ic when it is the lifeline", "[contactd-ic]") {
    const Folder folder;
    const std::string command = GENERATE(program, launcher(2) + program);
    FILE* pipe = ::popen(folder.redirected(command + " - --output table.h5 --exit-with-stdin").c_str(), "w");
    REQUIRE(pipe != nullptr);
    std::fputs((slow + "\n").c_str(), pipe);
    std::fflush(pipe);
    const bool started = folder.wait_for("amg_setup");
    const auto start = std::chrono::steady_clock::now();
    const int status = ::pclose(pipe);
    CHECK(started);
    CHECK(exit_code(status) == 129);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
    CHECK(folder.files() == std::vector<std::string>{"err.txt", "out.txt"});
}
