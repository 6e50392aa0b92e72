// JSON <-> plain values: ic.import, and requests for tables whose sections hold arrays.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactd/ic_import.hpp"
#include "contactd/proto/message.hpp"

namespace contactd::proto {

/// As decode_ic_spec and decode_ic_export, of requests that come with frames.
IcSpec decode_ic_spec(const nlohmann::json& params, const Frames& frames);
IcExport decode_ic_export(const nlohmann::json& params, const Frames& frames);

nlohmann::json encode_ic_import(std::string_view file, ArrayWriter& arrays);
/// The bytes of the file. Throws StatusError (ARRAY_INVALID).
std::vector<unsigned char> decode_ic_import(const nlohmann::json& params, const Frames& frames);
nlohmann::json encode_import_reply(const IcImport& imported);
IcImport decode_import_reply(const nlohmann::json& result);

}  // namespace contactd::proto
