// Cuts a byte stream into lines, whatever the chunks.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace usar::protocol {

/// Takes bytes as they arrive and gives whole lines without their terminator. CR, LF and any run of them end a line;
/// empty lines are not reported. A line longer than the cap is dropped to its terminator, counted once, and reading
/// goes on behind it. Owned by one connection; not a value; no thread of its own.
class LineSplitter {
public:
    /// Four MiB: no server limits its lines; depth images reach hundreds of kilobytes (usarsim-protocol 1.1).
    static constexpr std::size_t default_cap_bytes = 4u << 20;

    explicit LineSplitter(std::size_t cap_bytes = default_cap_bytes);

    /// Calls `take(std::string_view line)` for every line that `bytes` completes. The view lives during the call.
    template <class Take>
    void feed(std::string_view bytes, Take&& take);

    /// Lines that were longer than the cap.
    std::size_t overlongCount() const { return overlong_count_; }
    /// Bytes of the line that has not ended.
    std::size_t pendingBytes() const { return pending_.size(); }
    std::string_view pending() const { return pending_; }
    /// Forgets the unfinished line, as after a reconnect; the count stays. Not to be called from `take`.
    void reset();

private:
    /// Cuts the part up to the first terminator off `bytes`. True when there was one; `line` is then what it ended: a
    /// view into `bytes` when the line came in one piece, else into the pending text; empty when it was dropped.
    bool takePiece(std::string_view& bytes, std::string_view& line);

    std::size_t cap_bytes_;
    std::string pending_;
    bool dropping_ = false;
    std::size_t overlong_count_ = 0;
};

template <class Take>
void LineSplitter::feed(std::string_view bytes, Take&& take) {
    std::string_view line;
    while (takePiece(bytes, line)) {
        if (!line.empty())
            take(line);
        pending_.clear();
    }
}

} // namespace usar::protocol
