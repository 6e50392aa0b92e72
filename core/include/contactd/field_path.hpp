// Finds a value by a path of its names on the wire, such as "setup.track.springs.y" or "patches[0].forces.track.Fz".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contactd/fields.hpp"

namespace contactd {

/// Represents the path from a struct to a value below it. Its text is parsed only on construction.
class FieldPath {
   public:
    /// Throws InvalidArgument with the text as its field if the path is unknown; the message lists the valid names.
    FieldPath(const FieldType& root, std::string text);

    /// Returns the value below `root`, or null if an optional value or an entry of a list on the path is absent.
    const void* find(const void* root) const;
    /// Returns the value below `root` for writing. Absent optional values on the path get their defaults. A list gets
    /// its next entry if the path names that. Throws InvalidArgument for entries beyond it.
    void* make(void* root) const;
    /// Makes the last field absent, or a list empty. Throws InvalidArgument if the field is required.
    void clear(void* root) const;

    const std::string& text() const { return text_; }
    const FieldType& type() const { return *type_; }             ///< of the value
    const Field& field() const { return *steps_.back().field; }  ///< the last one on the path

   private:
    struct Step {
        const Field* field;
        std::optional<std::size_t> index;  ///< index of an entry, if the field is a list
    };

    std::string text_;
    std::vector<Step> steps_;
    const FieldType* type_;
};

/// Sets the number at the path: 0 or 1 for a flag, a whole number for an integer. Throws InvalidArgument for other
/// kinds, and for numbers outside the field's bounds.
void set_number(const FieldPath& path, void* root, double value);
/// Sets a keyword or a text. Throws InvalidArgument, which names the valid keywords.
void set_text(const FieldPath& path, void* root, std::string_view text);
/// Returns the number, integer, flag (0 or 1) or length of a list at the path, if present. Throws InvalidArgument for
/// other kinds.
std::optional<double> number_at(const FieldPath& path, const void* root);
/// Returns the keyword or text at the path, if present.
std::optional<std::string> text_at(const FieldPath& path, const void* root);

}  // namespace contactd
