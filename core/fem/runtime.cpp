#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include <mfem.hpp>

#include "build/first_process.hpp"
#include "contactd/fem/ic_builder.hpp"
#include "contactd/version.hpp"

// Exists if MFEM and hypre use OpenBLAS or an OpenMP runtime.
extern "C" {
[[gnu::weak]] void openblas_set_num_threads(int);
[[gnu::weak]] void omp_set_num_threads(int);
}

namespace contactd::fem {
namespace {

/// With one BLAS thread per core on a busy machine, a factorisation of 0.6 s took 151 s.
void use_one_thread() {
    if (std::getenv("OMP_NUM_THREADS") != nullptr) return;
    if (omp_set_num_threads != nullptr) omp_set_num_threads(1);
    if (openblas_set_num_threads != nullptr && std::getenv("OPENBLAS_NUM_THREADS") == nullptr)
        openblas_set_num_threads(1);
}

/// Returns whether a launcher (mpirun, srun) has started this process, from its environment, before MPI is initialised.
bool has_launcher() {
    constexpr std::array marks{"PMIX_NAMESPACE", "PMIX_RANK", "PMI_RANK", "PMI_FD", "OMPI_COMM_WORLD_RANK"};
    return std::any_of(marks.begin(), marks.end(), [](const char* mark) { return std::getenv(mark) != nullptr; });
}

/// Calls MPI_Init without a launcher. Open MPI would leave a folder in the temporary folder and, for processes it never
/// communicates with, a segment of shared memory, even after a normal end. Therefore it gets no shared memory, and a
/// temporary folder that is removed before this returns, because Open MPI does not need it later.
void init_alone(int& argc, char**& argv) {
    ::setenv("OMPI_MCA_btl", "self", 0);
    std::string folder = (std::filesystem::temp_directory_path() / "contactd-mpi-XXXXXX").string();
    const char* given = std::getenv("TMPDIR");
    const std::optional<std::string> before = given == nullptr ? std::nullopt : std::optional<std::string>(given);
    const bool made = ::mkdtemp(folder.data()) != nullptr;
    if (made) ::setenv("TMPDIR", folder.c_str(), 1);
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    if (!made) return;
    before ? ::setenv("TMPDIR", before->c_str(), 1) : ::unsetenv("TMPDIR");
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
}

void init(int& argc, char**& argv) {
    if (!has_launcher()) return init_alone(argc, argv);
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
}

}  // namespace

Runtime::Runtime(int& argc, char**& argv) {
    init(argc, argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &processes_);
    use_one_thread();
    mfem::Hypre::Init();
    mfem::out.Disable();  // MFEM reports errors by exceptions; standard output belongs to the program.
}

Runtime::~Runtime() {
    mfem::Hypre::Finalize();
    MPI_Finalize();
}

std::string Runtime::broadcast(std::string text) const {
    return quiet_broadcast(MPI_COMM_WORLD, std::move(text));
}

std::vector<int> Runtime::processes_here() const {
    MPI_Comm here = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &here);
    int count = 1;
    MPI_Comm_size(here, &count);
    std::vector<int> result(static_cast<std::size_t>(count));
    const int own = ::getpid();
    MPI_Allgather(&own, 1, MPI_INT, result.data(), 1, MPI_INT, here);
    MPI_Comm_free(&here);
    return result;
}

void Runtime::abort(int exit_code) const {
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::_Exit(exit_code);
}

std::string fem_version() {
    return "contactd " + version() + ", MFEM " MFEM_VERSION_STRING ", hypre " HYPRE_RELEASE_VERSION ", " +
           transform_library();
}

}  // namespace contactd::fem
