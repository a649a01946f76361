// SPDX-License-Identifier: MIT
// What the layer remembers of the program's OpenCL objects.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>

namespace stagelight {

// From handles to records, for use from any thread. No lock is held while OpenCL, OpenGL or the
// destructor of a record runs: those may call back into the layer.
template <typename Handle, typename Record> class Records {
public:
    // A handle that a driver uses again replaces what it stood for.
    void add(Handle handle, std::shared_ptr<Record> record) {
        Entry entry{std::move(record), 1};
        const std::scoped_lock lock(mutex_);
        std::swap(entries_[handle], entry);
    }

    std::shared_ptr<Record> find(Handle handle) const {
        const std::scoped_lock lock(mutex_);
        const auto found = entries_.find(handle);
        return found == entries_.end() ? nullptr : found->second.record;
    }

    // The program's own references: a driver's count holds its internal ones too.
    void retain(Handle handle) {
        const std::scoped_lock lock(mutex_);
        const auto found = entries_.find(handle);
        if (found != entries_.end()) {
            ++found->second.references;
        }
    }

    // To be called before the driver's release, after which the handle may be a new object's.
    void release(Handle handle) {
        Entry last;
        const std::scoped_lock lock(mutex_);
        const auto found = entries_.find(handle);
        if (found != entries_.end() && --found->second.references == 0) {
            last = std::move(found->second);
            entries_.erase(found);
        }
    }

    void erase(Handle handle) {
        Entry last;
        const std::scoped_lock lock(mutex_);
        const auto found = entries_.find(handle);
        if (found != entries_.end()) {
            last = std::move(found->second);
            entries_.erase(found);
        }
    }

    std::size_t size() const {
        const std::scoped_lock lock(mutex_);
        return entries_.size();
    }

private:
    struct Entry {
        std::shared_ptr<Record> record;
        unsigned references = 0;
    };

    mutable std::mutex mutex_;
    std::unordered_map<Handle, Entry> entries_;
};

}  // namespace stagelight
