// Implements 64-bit FNV-1a, which identifies lists of variables and damaged states.
#pragma once

#include <cstdint>
#include <string_view>

namespace contactd::fmu {

class Digest {
   public:
    void add(std::string_view text) {
        for (const char letter : text) value_ = (value_ ^ static_cast<unsigned char>(letter)) * prime;
        value_ = (value_ ^ 0xff) * prime;  // a terminator that UTF-8 text does not contain
    }
    std::uint64_t value() const { return value_; }

   private:
    static constexpr std::uint64_t prime = 0x100000001b3;
    std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace contactd::fmu
