#include "resilient_store.hpp"

#include <algorithm>
#include <format>
#include <utility>

namespace contactd::engine {
namespace {

constexpr auto attempt_interval = std::chrono::seconds(2);

}  // namespace

ResilientStore::ResilientStore(IcStore store, const Budgets& budgets, EngineLog log)
    : store_(std::move(store)), budgets_(budgets), log_(std::move(log)) {
    if (const int swept = store_.sweep()) log_.warn(std::format("swept {} left-over files from the store", swept));
    store_.settle_times();
    set_problem(store_.problem());
}

bool ResilientStore::may_have(const IcSpec& spec, const TableOwner& owner) {
    try {
        return store_.may_have(spec, owner);
    } catch (const std::exception& error) {
        set_problem(error.what());
        return false;
    }
}

std::optional<IcRecord> ResilientStore::find(const IcSpec& spec, const TableOwner& owner) {
    try {
        return store_.find(spec, owner);
    } catch (const std::exception& error) {
        set_problem(error.what());
        return std::nullopt;
    }
}

void ResilientStore::note_use(const std::string& key, const IcRecord& record, const TableOwner& owner) {
    if (record.spec.source != IcSource::fem) return;
    const auto [nx, ny] = extent_of(record.tables);
    uses_.note(store_.path_of(key, nx, ny, owner));
}

void ResilientStore::note_stored(const IcSpec& spec, const std::vector<std::string>& kept, const TableOwner& owner) {
    try {
        store_.note_use(store_.path_to_write(ic_key(spec), spec.nx, spec.ny, owner), store_.time_of_use());
        store_.remove_covered_by(spec, owner);
        if (budgets_.disk_bytes == 0) return;
        uses_.write();
        for (const StoredTable& table : store_.evict(budgets_.disk_bytes, kept))
            log_.info(std::format("store: evicted {} for store.disk_budget_bytes", table.path.filename().string()));
    } catch (const std::exception& error) {
        set_problem(error.what());
    }
}

ResilientStore::Record ResilientStore::keep_unsaved(IcRecord record, const std::string& why) {
    set_problem(why.empty() ? "A table could not be stored." : why);
    IcRecord answered = record;
    answered.evidence.warnings.push_back("This table could not be stored and exists in the daemon's memory only. " +
                                         why);
    const std::scoped_lock lock(mutex_);
    unsaved_bytes_ += bytes_of(record.tables);
    unsaved_.push_back(std::make_shared<const IcRecord>(std::move(record)));
    while (unsaved_bytes_ > budgets_.unsaved_bytes && !unsaved_.empty()) {
        log_.warn("store: too many tables wait for the disk; the oldest will not be stored");
        unsaved_bytes_ -= bytes_of(unsaved_.front()->tables);
        unsaved_.pop_front();
    }
    return std::make_shared<const IcRecord>(std::move(answered));
}

bool ResilientStore::save(const IcRecord& record) {
    try {
        write_ic_file(store_.path_to_write(ic_key(record.spec), record.spec.nx, record.spec.ny), record);
        return true;
    } catch (const std::exception& error) {
        set_problem(error.what());
        return false;
    }
}

std::vector<ResilientStore::Record> ResilientStore::recover() {
    if (!has_problem_) return {};
    std::list<Record> waiting;
    {
        const std::scoped_lock lock(mutex_);
        const auto now = std::chrono::steady_clock::now();
        if (now < next_attempt_) return {};
        next_attempt_ = now + attempt_interval;
        waiting.swap(unsaved_);
        unsaved_bytes_ = 0;
    }
    std::string problem = store_.problem();
    std::vector<Record> saved;
    while (problem.empty() && !waiting.empty() && save(*waiting.front())) {
        saved.push_back(waiting.front());
        waiting.pop_front();
    }
    if (problem.empty() && waiting.empty()) {
        set_problem("");
        log_.info(std::format("store: {} can be used again, {} tables were stored late", store_.folder().string(),
                              saved.size()));
    }
    const std::scoped_lock lock(mutex_);
    for (const Record& record : waiting) unsaved_bytes_ += bytes_of(record->tables);
    unsaved_.splice(unsaved_.begin(), waiting);
    return saved;
}

int ResilientStore::remove(const std::string& key, const TableOwner& owner) {
    int removed = store_.remove(key, owner);
    const std::scoped_lock lock(mutex_);
    std::erase_if(unsaved_, [&](const Record& record) {
        if (ic_key(record->spec) != key) return false;
        unsaved_bytes_ -= bytes_of(record->tables);
        ++removed;
        return true;
    });
    return removed;
}

std::string ResilientStore::problem() const {
    const std::scoped_lock lock(mutex_);
    return problem_;
}

void ResilientStore::set_problem(const std::string& sentence) {
    const std::scoped_lock lock(mutex_);
    if (!sentence.empty() && sentence != problem_)
        log_.warn(std::format("store {}: {}", store_.folder().string(), sentence));
    problem_ = sentence;
    has_problem_ = !sentence.empty();
}

}  // namespace contactd::engine
