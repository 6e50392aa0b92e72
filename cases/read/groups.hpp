// Groups of values: what CONTACT reads at once, over as many lines as the values take.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "contactd/read_contact_file.hpp"
#include "input_lines.hpp"

namespace contactd::contact_files {

/// A case while it is read.
struct Reading {
    InputLines& lines;
    ContactCase& result;

    int digit(std::string_view name) const;
    /// A value in memory, 0 where there is none.
    int integer(std::string_view name) const;
    double real(std::string_view name) const;
    bool has(std::string_view name) const { return result.values.contains(name); }

    void set(std::string_view name, ContactValue value);
    /// Takes values out of memory; `names` has blanks between them.
    void forget(std::string_view names);
    /// Puts into memory what was read now.
    void take(std::string_view name, ContactValue value);
    /// Notes a warning, or why the case cannot be computed; where the reader stands comes in front.
    void warn(const std::string& sentence);
    void fail_case(const std::string& sentence);
};

/// Reads the values of a group, from the next line on. What follows on the last line is ignored. `group` has their
/// names, with blanks between them: reals, or
///     NAME#           an integer
///     NAME^           an angle
///     NAME'           a text in quotation marks
///     {NAME=1 ..}     at the end, on the last line: each may be left out, and is 1 then, or not there without a value
///     {+NAME=1 ..}    the same, and all of them must be there or none is taken
/// Throws InvalidArgument for a word that does not fit.
ByName<ContactValue> read_values(Reading& reading, std::string_view group);
/// Reads them likewise, and puts them into the memory of the case.
void read_group(Reading& reading, std::string_view group);

/// Reads `count` numbers in any layout of lines; the rest of the last line is ignored. `what` names them. `kinds` says
/// what they are in turn: blanks for reals, # and ^ as of a group.
std::vector<double> read_array(Reading& reading, std::string_view what, std::size_t count,
                               std::string_view kinds = " ");

/// One of several columns that stand side by side in an array.
std::vector<double> column_of(const std::vector<double>& array, std::size_t column, std::size_t columns);
ContactNumbers shared(std::vector<double> numbers);

}  // namespace contactd::contact_files
