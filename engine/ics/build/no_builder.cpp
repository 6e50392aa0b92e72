// Replaces the builder on platforms without it. There, tables by finite elements come from a store that a builder on
// Linux filled.
#include "builder.hpp"

namespace contactd::engine {

BuiltTable run_builder(const BuilderCommand&, const IcSpec&, const std::filesystem::path&, const Job&,
                       const std::function<void(const JobProgress&)>&, const std::function<void()>&) {
    throw BuilderUnusable(
        "Tables by finite elements are built on Linux only, and the store contains none for this request. Build it "
        "there, and copy its file into the folder CONTACTD_STORE.");
}

}  // namespace contactd::engine
