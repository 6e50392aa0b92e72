// Converts structs to JSON and back by their lists of fields (contactd/fields.hpp).
//
// Writing includes every present field; reading does not change missing fields. A type whose form on the wire differs
// from that of its fields has a hook (field_hooks.cpp).
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "contactd/error.hpp"
#include "contactd/fields.hpp"
#include "contactd/grid.hpp"
#include "contactd/proto/answer_text.hpp"
#include "contactd/proto/message.hpp"

namespace contactd::proto {

/// Holds the path of a value, as a list from the inside out; its text is only created for an error.
class MemberPath {
   public:
    explicit MemberPath(std::string_view name) : name_(name) {}
    MemberPath(const MemberPath& above, std::string_view name) : above_(&above), name_(name) {}
    MemberPath(const MemberPath& list, std::size_t index) : above_(&list), index_(index) {}

    /// "setup.rail_slices[2].x"
    std::string text() const;

   private:
    const MemberPath* above_ = nullptr;
    std::string_view name_{};
    std::size_t index_ = 0;
};

/// Context for writing a message; arrays over the grid are omitted without a grid.
struct Writing {
    ArrayWriter* arrays = nullptr;  ///< null for a message without them
    const Grid* grid = nullptr;
};

struct Reading {
    const Frames& frames;
    const Grid* grid = nullptr;
};

/// Defines the form on the wire of values of one type. Values for which `write` returns discarded are omitted. Without
/// functions, a field of this type is skipped, because its message depends on more than its value. Without one of them,
/// its fields are used.
struct FieldHook {
    const FieldType* type;
    nlohmann::json (*write)(const void* value, const MemberPath& path, const Writing& with);
    void (*read)(const nlohmann::json& source, void* value, const MemberPath& path, const Reading& with);
};

/// Returns null if the fields of a type are sufficient.
const FieldHook* hook_of(const FieldType& type);

/// Throws InvalidArgument naming the path of a number that is not finite.
nlohmann::json write_fields(const FieldType& type, const void* value, const MemberPath& path, const Writing& with);
/// Does the same without the type's own hook.
nlohmann::json write_object(const FieldType& type, const void* owner, const MemberPath& path, const Writing& with);
/// `source` has passed its schema.
void read_fields(const nlohmann::json& source, const FieldType& type, void* value, const MemberPath& path,
                 const Reading& with);
/// Does the same without the type's own hook.
void read_object(const nlohmann::json& source, const FieldType& type, void* owner, const MemberPath& path,
                 const Reading& with);

void read_fields(const AnswerValue& source, const FieldType& type, void* value, const MemberPath& path,
                 const Reading& with);

template <class T>
nlohmann::json write_fields(const T& value, const MemberPath& path, const Writing& with = {}) {
    return write_fields(type_of<T>(), &value, path, with);
}
template <class Source, class T>
void read_fields(const Source& source, T& value, const MemberPath& path, const Reading& with = {{}}) {
    read_fields(source, type_of<T>(), &value, path, with);
}

/// Returns the value in `source`, with the defaults of its type; `name` is the name of its field.
template <class T>
T read_value(const nlohmann::json& source, std::string_view name, const Reading& with = {{}}) {
    T value;
    read_fields(source, value, MemberPath(name), with);
    return value;
}

/// write_fields for results: a number that is not finite is an Error, not an invalid request.
template <class T>
nlohmann::json write_answer(const T& answer, const MemberPath& path) {
    try {
        return write_fields(answer, path);
    } catch (const InvalidArgument& error) {
        throw Error(error.what());
    }
}

}  // namespace contactd::proto
