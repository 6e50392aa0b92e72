// Holds the contents of an IC file as plain values, as stored by HDF5 and as ic.import receives them on the wire.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "contactd/unset_array.hpp"

namespace contactd {

/// Holds attributes and datasets by their paths, such as "spec/body". Names of the file's own attributes have no slash.
/// docs/ic-tables.md lists them.
struct FileContents {
    using Value = std::variant<double, long long, std::string, std::vector<double>, std::vector<std::string>>;
    struct Array {
        std::vector<std::size_t> shape{};
        UnsetArray values{};  ///< in C order: the last axis runs fastest
    };

    std::map<std::string, Value> attributes{};
    std::map<std::string, Array> datasets{};
};

/// These limits of a file allow readers to refuse larger ones.
inline constexpr std::size_t most_file_attributes = 1000, most_file_datasets = 20, most_file_axes = 5,
                             longest_file_path = 100, longest_file_list = 10'000, longest_file_text = 100'000;

}  // namespace contactd
