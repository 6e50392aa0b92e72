#include "edge.hpp"

#include <algorithm>
#include <cstring>

namespace contactd::c {

Connections& connections() {
    static auto* const all = new Connections("connection", 1);
    return *all;
}

Contacts& contacts() {
    static auto* const all = new Contacts("contact", 3);
    return *all;
}

void put_text(const std::string& source, char* text, std::int32_t length) {
    given(text, "text");
    if (length < 1) throw InvalidArgument("length", "is " + std::to_string(length) + "; it must be at least 1");
    const std::size_t kept = std::min(source.size(), static_cast<std::size_t>(length) - 1);
    std::memcpy(text, source.data(), kept);
    text[kept] = '\0';
}

}  // namespace contactd::c
