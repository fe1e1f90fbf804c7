// Splits a byte stream into lines, however it is divided into chunks.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace usar::protocol {

/// Takes bytes as they arrive and delivers whole lines without their terminators. CR, LF and any run of them end a
/// line; empty lines are not reported. A line longer than the cap is dropped up to its terminator and counted once;
/// reading continues after it. Each connection owns one splitter and uses it in its own thread.
class LineSplitter {
public:
    /// 4 MiB. No server limits its lines, and depth images reach hundreds of kilobytes (protocol.md 1.1).
    static constexpr std::size_t default_cap_bytes = 4u << 20;

    explicit LineSplitter(std::size_t cap_bytes = default_cap_bytes) : cap_bytes_(cap_bytes) {}

    /// Calls `take(std::string_view line)` for every line that `bytes` completes. The view is valid during the call
    /// only.
    template <class Take>
    void feed(std::string_view bytes, Take&& take);
    /// The same for whoever wants to see all lines before taking the first: replaces `lines` by every line that `bytes`
    /// completes. The views are valid as long as `bytes`, and until the next call of this.
    void split(std::string_view bytes, std::vector<std::string_view>& lines);

    /// Number of lines dropped because they were longer than the cap.
    std::size_t overlongCount() const { return overlong_count_; }
    /// Text of the line that has not ended yet; empty while an overlong line is being dropped. Valid until the next
    /// call of `feed` or `reset`.
    std::string_view pending() const { return pending_; }
    /// Discards the unfinished line, as needed after a reconnect; the count stays. Must not be called from `take`.
    void reset();

private:
    /// Removes the part up to the first terminator from `bytes`. Returns true if there was a terminator; `line` is then
    /// the line that it ended: a view into `bytes` if the line came in one piece, else into the pending text, and empty
    /// if the line was dropped.
    bool takePiece(std::string_view& bytes, std::string_view& line);

    std::size_t cap_bytes_;
    std::string pending_;
    std::string joined_;    ///< the line of the last `split` that did not come in one piece
    bool dropping_ = false; ///< the current line is too long; its rest is discarded
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
