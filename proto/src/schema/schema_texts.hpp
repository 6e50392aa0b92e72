// Contains the files of proto/schema at the time of the build.
#pragma once

#include <string_view>
#include <vector>

namespace contactd::proto {

struct SchemaText {
    std::string_view name;  ///< of the file, without ".json"
    std::string_view text;
};
const std::vector<SchemaText>& schema_texts();

}  // namespace contactd::proto
