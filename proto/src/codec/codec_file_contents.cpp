// Encodes and decodes the contents of an IC file: attributes and datasets by their paths.
#include <string>

#include "codec_parts.hpp"
#include "contactd/proto/import_codec.hpp"
#include "contactd/proto/status.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

json encode(double value) {
    return finite(value, "A number of a file");
}
json encode(long long value) {
    return value;
}
json encode(const std::string& value) {
    return value;
}
template <class Value>
json encode(const std::vector<Value>& list) {
    json result = json::array();
    for (const Value& value : list) result.push_back(encode(value));
    return result;
}

std::vector<double> numbers_of(const json& list, const std::string& field) {
    std::vector<double> numbers;
    for (const json& value : list) {
        if (!value.is_number()) throw invalid_field(field, "mixes numbers with other values");
        numbers.push_back(value.get<double>());
    }
    return numbers;
}

std::vector<std::string> texts_of(const json& list, const std::string& field) {
    std::vector<std::string> texts;
    for (const json& value : list) {
        if (!value.is_string()) throw invalid_field(field, "mixes strings with other values");
        texts.push_back(value.get<std::string>());
    }
    return texts;
}

/// Returns whether the path consists of names of letters, digits and _, joined by slashes.
void check_path(const std::string& path, const char* field) {
    const auto is_of_name = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    bool is_path = !path.empty() && path.size() <= longest_file_path && path.back() != '/';
    char before = '/';
    for (const char c : path) {
        is_path = is_path && (is_of_name(c) || (c == '/' && before != '/'));
        before = c;
    }
    if (!is_path)
        throw invalid_field(
            field, "has " +
                       json(path.substr(0, longest_file_path)).dump(-1, ' ', true, json::error_handler_t::replace) +
                       "; its names are paths of letters, digits and _, such as \"spec/body\"");
}

FileContents::Value decode_value(const json& value, const std::string& field) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_array()) {
        if (!value.empty() && value.front().is_string()) return texts_of(value, field);
        return numbers_of(value, field);
    }
    if (value.is_number_integer()) return value.get<long long>();
    return value.get<double>();
}

}  // namespace

json encode_file_contents(const FileContents& contents, ArrayWriter& arrays) {
    json attributes = json::object(), datasets = json::object();
    for (const auto& [path, value] : contents.attributes)
        attributes[path] = std::visit([](const auto& given) { return encode(given); }, value);
    for (const auto& [path, array] : contents.datasets)
        datasets[path] = arrays.write(std::span<const double>(array.values), array.shape);
    return {{"attributes", std::move(attributes)}, {"datasets", std::move(datasets)}};
}

FileContents decode_file_contents(const json& params, const Frames& frames) {
    FileContents contents;
    for (const auto& [path, value] : params["attributes"].items()) {
        check_path(path, "attributes");
        contents.attributes.emplace(path, decode_value(value, "attributes." + path));
    }
    for (const auto& [path, source] : params["datasets"].items()) {
        check_path(path, "datasets");
        FileContents::Array& array = contents.datasets[path];
        array.shape = claimed_shape(source, most_file_axes);
        array.values = read_unset_array(source, frames, array.shape, "datasets." + path);
    }
    return contents;
}

}  // namespace contactd::proto
