// Open tables of creep forces. Their handles are found without a lock, because evaluation takes less than a
// microsecond.
#pragma once

#include <array>
#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "contactd.h"
#include "handles.hpp"

namespace contactd::c {

/// A table at one Poisson's ratio. Any thread may evaluate it.
class OpenCreepTable {
   public:
    virtual ~OpenCreepTable() = default;
    virtual double nu() const = 0;
    virtual std::array<double, 2> ratios() const = 0;
    virtual std::string description() const = 0;
    /// Reads a, b, G, mu, Fn and the three creepages, and writes three forces, nine derivatives, and two bounds.
    /// `jacobian` and `bounds` may be null. Does not allocate. Throws InvalidArgument ("a", ..., "creepages").
    virtual void forces(const double* contact, const double* creepages, double* forces, double* jacobian,
                        double* bounds) const = 0;
};

/// Opens a file. Each library defines it; libcontactd throws StatusError (UNIMPLEMENTED). Throws InvalidArgument ("nu")
/// and StatusError: NOT_FOUND, DATA_LOSS for a damaged file, FAILED_PRECONDITION for a newer one.
std::unique_ptr<const OpenCreepTable> open_creep_table(const std::filesystem::path& path, double nu);

/// The open tables of the process. Their numbers are 7 modulo 8, and name a place and how often it was used.
class CreepTables {
   public:
    contactd_creep_table* add(std::unique_ptr<const OpenCreepTable> table) {
        const std::lock_guard lock(mutex_);
        for (std::uintptr_t place = 0; place < most; ++place) {
            if (places_[place].number != 0) continue;
            const std::uintptr_t number = 8 * (++opened_ * most + place) + 7;
            places_[place].table = std::move(table);
            places_[place].number.store(number, std::memory_order_release);
            return reinterpret_cast<contactd_creep_table*>(number);
        }
        throw StatusError(StatusCode::resource_exhausted, reason::limit_exceeded,
                          "This process has opened 256 tables of creep forces. Close those it does not need.");
    }

    bool holds(const void* handle) const {
        const auto number = reinterpret_cast<std::uintptr_t>(handle);
        return number != 0 && place_of(number).number.load(std::memory_order_acquire) == number;
    }

    /// Returns the table, which must not be closed meanwhile. Throws StatusError for an invalid handle.
    const OpenCreepTable& find(const contactd_creep_table* handle) const {
        if (!holds(handle)) throw not_a_handle("table", handle);
        return *place_of(reinterpret_cast<std::uintptr_t>(handle)).table;
    }

    void remove(const contactd_creep_table* handle) {
        const std::lock_guard lock(mutex_);
        find(handle);
        Place& place = places_[place_number(reinterpret_cast<std::uintptr_t>(handle))];
        place.number = 0;
        place.table.reset();
    }

   private:
    static constexpr std::uintptr_t most = 256;
    struct Place {
        std::atomic<std::uintptr_t> number = 0;
        std::unique_ptr<const OpenCreepTable> table{};
    };

    static std::uintptr_t place_number(std::uintptr_t number) { return number / 8 % most; }
    const Place& place_of(std::uintptr_t number) const { return places_[place_number(number)]; }

    std::mutex mutex_;  // of opening and closing
    std::uintptr_t opened_ = 0;
    std::array<Place, most> places_{};
};

/// The tables of the process. They are not destroyed at its end.
CreepTables& creep_tables();

}  // namespace contactd::c
