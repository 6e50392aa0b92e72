// Fuzzes a configuration: it is refused with every problem found, or read; a read one is the same after it is written
// and read.
#include "config/config.hpp"

#include "contactd/error.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using contactd::server::config_from_json;
    const auto given = nlohmann::json::parse(fuzz::bytes_of(data, size), nullptr, false);
    if (given.is_discarded()) return 0;
    try {
        const nlohmann::json all = to_json(config_from_json(given));
        fuzz::require(to_json(config_from_json(all)) == all, "a configuration with its defaults means the same");
    } catch (const contactd::Error& error) {
        fuzz::require(std::string(error.what()).size() < 50'000, "a refusal says why, and not at length");
    }
    return 0;
}
