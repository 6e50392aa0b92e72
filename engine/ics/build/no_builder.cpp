// Where MFEM's builder is not to be had: tables by finite elements come from a store, which a builder on Linux has filled.
#include "builder.hpp"

namespace contactd::engine {

BuiltTable run_builder(const BuilderCommand&, const IcSpec&, const std::filesystem::path&, const Job&,
                       const std::function<void(const JobProgress&)>&, const std::function<void()>&) {
    throw BuilderUnusable(
        "Tables by finite elements are built on Linux only, and none that serves this request is in the store; have it "
        "built there, and copy its file into the folder that CONTACTD_STORE names.");
}

}  // namespace contactd::engine
