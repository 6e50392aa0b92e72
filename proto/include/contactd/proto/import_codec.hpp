// Converts JSON to plain values and back: ic.import, and requests for tables whose sections contain arrays.
#pragma once

#include <nlohmann/json.hpp>

#include "contactd/file_contents.hpp"
#include "contactd/ic_import.hpp"
#include "contactd/proto/message.hpp"

namespace contactd::proto {

/// Decode as decode_ic_spec and decode_ic_export of codec.hpp, for requests that come with frames.
IcSpec decode_ic_spec(const nlohmann::json& params, const Frames& frames);
IcExport decode_ic_export(const nlohmann::json& params, const Frames& frames);

/// Attributes and datasets by their paths: the parameters of ic.import, and the "contents" of ic.export.
nlohmann::json encode_file_contents(const FileContents& contents, ArrayWriter& arrays);
/// Throws StatusError (INVALID_FIELD, ARRAY_INVALID) naming "attributes.spec/body", "datasets.transform", ...
FileContents decode_file_contents(const nlohmann::json& params, const Frames& frames);
nlohmann::json encode_contents_reply(const FileContents& contents, const IcUse& body, ArrayWriter& arrays);

nlohmann::json encode_import_reply(const IcImport& imported);
IcImport decode_import_reply(const nlohmann::json& result);

}  // namespace contactd::proto
