// Attributes of HDF5 objects: numbers, whole numbers, texts, and lists of them.
#pragma once

#include <H5Cpp.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contactd/ic_store.hpp"

namespace contactd {

void put(H5::H5Object& at, const char* name, double value);
void put(H5::H5Object& at, const char* name, long long value);
void put(H5::H5Object& at, const char* name, std::string_view value);
/// Lists have one axis; an empty one is not written.
void put(H5::H5Object& at, const char* name, const std::vector<double>& values);
void put(H5::H5Object& at, const char* name, const std::vector<std::string>& values);

/// These throw H5::Exception when there is no such attribute, the lists but return nothing then.
double number(const H5::H5Object& at, const char* name);
long long long_integer(const H5::H5Object& at, const char* name);
int integer(const H5::H5Object& at, const char* name);
std::string text(const H5::H5Object& at, const char* name);
std::vector<double> numbers(const H5::H5Object& at, const char* name);
std::vector<std::string> texts(const H5::H5Object& at, const char* name);

/// The enumerator whose name stands there. Throws DamagedTable when none has it.
template <HasWords Enum>
Enum named(const H5::H5Object& at, const char* name) {
    Enum value{};
    if (!from_name(text(at, name), value)) throw DamagedTable(std::string(name) + " of the file is not known.");
    return value;
}

/// Fields of other types, written as one of those above; of a number that may be left out no attribute means none.
template <HasWords Enum>
void put(H5::H5Object& at, const char* name, Enum value) {
    put(at, name, name_of(value));
}
void put(H5::H5Object& at, const char* name, int value);
void put(H5::H5Object& at, const char* name, const std::optional<double>& value);

/// Sets `value` to what stands there.
template <HasWords Enum>
void get(const H5::H5Object& at, const char* name, Enum& value) {
    value = named<Enum>(at, name);
}
void get(const H5::H5Object& at, const char* name, double& value);
void get(const H5::H5Object& at, const char* name, int& value);
void get(const H5::H5Object& at, const char* name, long long& value);
void get(const H5::H5Object& at, const char* name, std::optional<double>& value);

}  // namespace contactd
