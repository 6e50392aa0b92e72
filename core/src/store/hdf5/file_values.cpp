#include "file_values.hpp"

#include <cmath>
#include <limits>

namespace contactd {
namespace {

[[noreturn]] void refuse(const Group& at, const char* name, const char* why) {
    throw DamagedTable(at.prefix + name + " of the file " + why + ".");
}

const FileContents::Value* find(const Group& at, const char* name) {
    const auto found = at.contents.attributes.find(at.prefix + name);
    return found == at.contents.attributes.end() ? nullptr : &found->second;
}

const FileContents::Value& value_of(const Group& at, const char* name) {
    const FileContents::Value* value = find(at, name);
    if (value == nullptr) refuse(at, name, "is missing");
    return *value;
}

}  // namespace

bool Group::has_group(const std::string& name) const {
    const std::string beginning = prefix + name + '/';
    const auto first = contents.attributes.lower_bound(beginning);
    return first != contents.attributes.end() && first->first.starts_with(beginning);
}

void put(const WritableGroup& at, const char* name, double value) {
    at.contents.attributes[at.prefix + name] = value;
}
void put(const WritableGroup& at, const char* name, long long value) {
    at.contents.attributes[at.prefix + name] = value;
}
void put(const WritableGroup& at, const char* name, std::string_view value) {
    at.contents.attributes[at.prefix + name] = std::string(value);
}
void put(const WritableGroup& at, const char* name, const std::vector<double>& values) {
    if (!values.empty()) at.contents.attributes[at.prefix + name] = values;
}
void put(const WritableGroup& at, const char* name, const std::vector<std::string>& values) {
    if (!values.empty()) at.contents.attributes[at.prefix + name] = values;
}
void put(const WritableGroup& at, const char* name, int value) {
    put(at, name, static_cast<long long>(value));
}
void put(const WritableGroup& at, const char* name, const std::optional<double>& value) {
    if (value) put(at, name, *value);
}

double number(const Group& at, const char* name) {
    const FileContents::Value& value = value_of(at, name);
    if (const auto* whole = std::get_if<long long>(&value)) return static_cast<double>(*whole);
    const auto* found = std::get_if<double>(&value);
    if (found == nullptr) refuse(at, name, "is not a number");
    if (!std::isfinite(*found)) refuse(at, name, "is not finite");
    return *found;
}
long long long_integer(const Group& at, const char* name) {
    const FileContents::Value& value = value_of(at, name);
    if (const auto* whole = std::get_if<long long>(&value)) return *whole;
    refuse(at, name, "is not a whole number");
}
int integer(const Group& at, const char* name) {
    const long long value = long_integer(at, name);
    if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
        refuse(at, name, "is too large");
    return static_cast<int>(value);
}
std::string text(const Group& at, const char* name) {
    const auto* found = std::get_if<std::string>(&value_of(at, name));
    if (found == nullptr) refuse(at, name, "is not a string");
    return *found;
}
std::vector<double> numbers(const Group& at, const char* name) {
    const FileContents::Value* value = find(at, name);
    if (value == nullptr) return {};
    const auto* found = std::get_if<std::vector<double>>(value);
    if (found == nullptr) refuse(at, name, "is not a list of numbers");
    for (const double one : *found)
        if (!std::isfinite(one)) refuse(at, name, "contains a number that is not finite");
    return *found;
}
std::vector<std::string> texts(const Group& at, const char* name) {
    const FileContents::Value* value = find(at, name);
    if (value == nullptr) return {};
    const auto* found = std::get_if<std::vector<std::string>>(value);
    if (found == nullptr) refuse(at, name, "is not a list of strings");
    return *found;
}

void get(const Group& at, const char* name, double& value) {
    value = number(at, name);
}
void get(const Group& at, const char* name, int& value) {
    value = integer(at, name);
}
void get(const Group& at, const char* name, long long& value) {
    value = long_integer(at, name);
}
void get(const Group& at, const char* name, std::optional<double>& value) {
    if (at.has(name)) value = number(at, name);
}

const FileContents::Array& array(const Group& at, const char* name, std::size_t axes) {
    const auto found = at.contents.datasets.find(at.prefix + name);
    if (found == at.contents.datasets.end()) refuse(at, name, "is missing");
    if (found->second.shape.size() != axes)
        throw DamagedTable(at.prefix + name + " of the file has " + std::to_string(found->second.shape.size()) +
                           " axes; it must have " + std::to_string(axes) + ".");
    return found->second;
}

}  // namespace contactd
