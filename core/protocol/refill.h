// Refills a list without freeing the memory that its elements have allocated.
#pragma once

#include <cstddef>
#include <vector>

namespace usar::protocol {

/// Reuses the elements of `list` from the first one on. Elements that `next` has not returned by the time this object
/// is destroyed are removed. The list must outlive this object.
template <class T>
class Refill {
public:
    explicit Refill(std::vector<T>& list) : list_(list) {}
    ~Refill() { list_.resize(used_); }
    Refill(const Refill&) = delete;
    Refill& operator=(const Refill&) = delete;

    /// The next element, which may hold old values: overwrite all of it. Valid until the next call.
    T& next() {
        if (used_ == list_.size())
            list_.emplace_back();
        return list_[used_++];
    }
    /// Takes back the element that `next` returned last; there must be one.
    void drop() { --used_; }
    std::size_t count() const { return used_; }

private:
    std::vector<T>& list_;
    std::size_t used_ = 0;
};

} // namespace usar::protocol
