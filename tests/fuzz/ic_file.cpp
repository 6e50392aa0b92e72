// Fuzzes an IC file up to its digest: HDF5, which is not made for malicious files, must never read one that fails.
#include "contactd/ic_store.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        (void)contactd::from_ic_file({data, size}, "the file");
    } catch (const contactd::StoreError&) {
    }
    return 0;
}
