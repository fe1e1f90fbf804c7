// Fills a list anew without giving back what its elements have allocated.
#pragma once

#include <cstddef>
#include <vector>

namespace usar::protocol {

/// `next` gives the next element, which may hold old values: overwrite all of it. What is not asked for goes at the end
/// of this object's life.
template <class T>
class Refill {
public:
    explicit Refill(std::vector<T>& list) : list_(list) {}
    ~Refill() { list_.resize(used_); }
    Refill(const Refill&) = delete;
    Refill& operator=(const Refill&) = delete;

    T& next() {
        if (used_ == list_.size())
            list_.emplace_back();
        return list_[used_++];
    }
    /// Takes the last one back.
    void drop() { --used_; }
    std::size_t count() const { return used_; }

private:
    std::vector<T>& list_;
    std::size_t used_ = 0;
};

} // namespace usar::protocol
