// Tables of creep forces in process.
#include <algorithm>

#include "contactd/creep_table.hpp"
#include "contactd/ic_store.hpp"
#include "creep_tables.hpp"

namespace contactd::c {
namespace {

class LocalCreepTable final : public OpenCreepTable {
   public:
    explicit LocalCreepTable(CreepTable table) : table_(std::move(table)) {}

    double nu() const override { return table_.nu(); }
    std::array<double, 2> ratios() const override { return table_.ratios(); }
    std::string description() const override { return std::string(table_.description()); }

    void forces(const double* contact, const double* creepages, double* forces, double* jacobian,
                double* bounds) const override {
        const CreepForces found = table_.forces({contact[0], contact[1], contact[2], contact[3], contact[4]},
                                                {creepages[0], creepages[1], creepages[2]});
        std::ranges::copy(found.forces, forces);
        if (jacobian != nullptr)
            for (const auto& row : found.by_creepage) jacobian = std::ranges::copy(row, jacobian).out;
        if (bounds != nullptr) std::ranges::copy(std::array{found.force_bound, found.moment_bound}, bounds);
    }

   private:
    CreepTable table_;
};

}  // namespace

std::unique_ptr<const OpenCreepTable> open_creep_table(const std::filesystem::path& path, double nu) {
    try {
        return std::make_unique<LocalCreepTable>(CreepTable(path, nu));
    } catch (const NewerFormat& error) {
        throw StatusError(StatusCode::failed_precondition, "NEWER_FORMAT", error.what());
    } catch (const DamagedTable& error) {
        throw StatusError(StatusCode::data_loss, "DAMAGED_TABLE", error.what());
    } catch (const StoreError& error) {
        throw StatusError(StatusCode::not_found, "TABLE_UNREADABLE", error.what());
    }
}

}  // namespace contactd::c
