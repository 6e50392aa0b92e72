// Encodes and decodes tables that leave or enter: ic.export, and coefficients given with contact.solve.
#include "codec_parts.hpp"
#include "contactd/fields/ic_reply.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/import_codec.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;
using Shape = std::vector<std::size_t>;

constexpr std::size_t table_axes = 4;
std::string in_json(const Shape& shape) {
    return json(shape).dump();
}

}  // namespace

json encode_given_ics(const GivenIcs& ics, ArrayWriter& arrays) {
    const auto nx = static_cast<std::size_t>(ics.table.nx), ny = static_cast<std::size_t>(ics.table.ny);
    return {{"source", "table"},
            {"table", arrays.write(std::span<const double>(ics.table.values), {3, 3, ny, nx})},
            {"dx", finite(ics.dx, "ics.dx")},
            {"dy", finite(ics.dy, "ics.dy")}};
}

GivenIcs decode_given_ics(const json& source, const Frames& frames, const Grid& grid, const std::string& field) {
    const std::string table_field = field + ".table";
    const Shape shape = claimed_shape(source["table"], table_axes + 1);
    const auto nx = static_cast<std::size_t>(grid.nx), ny = static_cast<std::size_t>(grid.ny);
    if (shape.size() == table_axes + 1)
        throw invalid_field(
            table_field,
            "has shape " + in_json(shape) +
                ", that of a longitudinally uniform body, whose table cannot be part of a request: pass the file of "
                "ic.export to ic.import, and give the section in ics (source fem, body longitudinally_uniform)",
            reason::array_invalid);
    if (shape.size() != table_axes || shape[0] != 3 || shape[1] != 3 || shape[2] < ny || shape[3] < nx)
        throw invalid_field(table_field,
                            "has shape " + in_json(shape) + "; it must be [3,3,ny,nx] with at least the grid's ny, " +
                                std::to_string(ny) + ", and nx, " + std::to_string(nx),
                            reason::array_invalid);
    GivenIcs ics;
    ics.table.values = read_unset_array(source["table"], frames, shape, table_field);
    ics.table.ny = static_cast<int>(shape[2]);
    ics.table.nx = static_cast<int>(shape[3]);
    ics.dx = source["dx"].get<double>();
    ics.dy = source["dy"].get<double>();
    return ics;
}

json encode_ic_export(const IcExport& requested) {
    json params = encode_ic_spec(requested.spec);
    params["format"] = name_of(requested.format);
    if (requested.lower) params["lower"] = encode_material(*requested.lower);
    return params;
}

IcExport decode_ic_export(const json& params) {
    return decode_ic_export(params, {});
}

IcExport decode_ic_export(const json& params, const Frames& frames) {
    IcExport requested;
    requested.spec = decode_ic_spec(params, frames);
    if (requested.spec.line_contact)
        throw invalid_field("ics.line_contact", "is not supported by these files; use ic.get for such a table");
    read_name(params["format"], requested.format);
    if (params.contains("lower")) requested.lower = decode_material(params["lower"]);
    return requested;
}

json encode_hdf5_reply(std::span<const unsigned char> file, const IcUse& body, ArrayWriter& arrays) {
    return {{"format", "hdf5"},
            {"file", arrays.write(file, {file.size()})},
            {"ics", write_answer(IcUses{body}, MemberPath("ics"))}};
}

json encode_contents_reply(const FileContents& contents, const IcUse& body, ArrayWriter& arrays) {
    json result = encode_file_contents(contents, arrays);
    result["format"] = "contents";
    result["ics"] = write_answer(IcUses{body}, MemberPath("ics"));
    return result;
}

json encode_contact_text_reply(std::string text, const IcUse& upper, const IcUse& lower) {
    return {{"format", "contact"},
            {"text", std::move(text)},
            {"ics", write_answer(IcUses{upper, lower}, MemberPath("ics"))}};
}

std::string decode_ic_file(const json& result, const Frames& frames) {
    if (result.contains("text")) return result["text"].get<std::string>();
    const std::vector<unsigned char> bytes =
        read_byte_array(result["file"], frames, claimed_shape(result["file"], 1), "file");
    return {bytes.begin(), bytes.end()};
}

json encode_import_reply(const IcImport& imported) {
    return {{"spec", encode_ic_spec(imported.spec)},
            {"ics", write_answer(imported.use, MemberPath("ics"))},
            {"new", imported.is_new}};
}

IcImport decode_import_reply(const json& result) {
    IcImport imported{decode_ic_spec(result["spec"]), {}, result["new"].get<bool>()};
    read_fields(result["ics"], imported.use, MemberPath("ics"));
    return imported;
}

}  // namespace contactd::proto
