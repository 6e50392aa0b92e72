// Accesses values of an IC file by name: numbers, whole numbers, texts, and lists of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contactd/enum_words.hpp"
#include "contactd/file_contents.hpp"
#include "contactd/ic_store.hpp"

namespace contactd {

/// Represents a group or a dataset of a file that is written; `prefix` is its path with a slash, empty for the file
/// itself.
struct WritableGroup {
    FileContents& contents;
    std::string prefix{};

    WritableGroup below(const std::string& name) const { return {contents, prefix + name + '/'}; }
};

/// Represents a group or a dataset of a file that is read.
struct Group {
    const FileContents& contents;
    std::string prefix{};

    Group below(const std::string& name) const { return {contents, prefix + name + '/'}; }
    bool has(const std::string& name) const { return contents.attributes.contains(prefix + name); }
    bool has_group(const std::string& name) const;
};

void put(const WritableGroup& at, const char* name, double value);
void put(const WritableGroup& at, const char* name, long long value);
void put(const WritableGroup& at, const char* name, std::string_view value);
/// Lists have one axis; an empty one is not written.
void put(const WritableGroup& at, const char* name, const std::vector<double>& values);
void put(const WritableGroup& at, const char* name, const std::vector<std::string>& values);

/// These throw DamagedTable if the value is missing; a missing list is empty instead.
double number(const Group& at, const char* name);
long long long_integer(const Group& at, const char* name);
int integer(const Group& at, const char* name);
std::string text(const Group& at, const char* name);
std::vector<double> numbers(const Group& at, const char* name);
std::vector<std::string> texts(const Group& at, const char* name);

/// Returns the enumerator with the stored name. Throws DamagedTable if there is none.
template <HasWords Enum>
Enum named(const Group& at, const char* name) {
    Enum value{};
    if (!from_name(text(at, name), value)) throw DamagedTable(at.prefix + name + " of the file is not supported.");
    return value;
}

/// Writes fields of other types as one of those above. Absent optional numbers have no attribute.
template <HasWords Enum>
void put(const WritableGroup& at, const char* name, Enum value) {
    put(at, name, name_of(value));
}
void put(const WritableGroup& at, const char* name, int value);
void put(const WritableGroup& at, const char* name, const std::optional<double>& value);

/// Sets `value` to the stored one.
template <HasWords Enum>
void get(const Group& at, const char* name, Enum& value) {
    value = named<Enum>(at, name);
}
void get(const Group& at, const char* name, double& value);
void get(const Group& at, const char* name, int& value);
void get(const Group& at, const char* name, long long& value);
void get(const Group& at, const char* name, std::optional<double>& value);

/// Returns the dataset of that name. Throws DamagedTable if it is missing or has another number of axes.
const FileContents::Array& array(const Group& at, const char* name, std::size_t axes);

}  // namespace contactd
