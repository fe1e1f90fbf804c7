// Framing of what a robot sends on a data link of the ComServer (protocol.md 6.3): "SEND 5 hello;" and "CLOSE;".
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace usar::server {

/// Extracts payloads from bytes that are fed in chunks of any size. Payload bytes are passed on as they arrive, so a
/// message of any length needs no buffer. A payload may hold any bytes; the one byte after it is swallowed whatever it
/// is. An unknown word is skipped up to its semicolon.
class ComFrames {
public:
    using Take = std::function<void(std::string_view payload)>;

    /// Passes payload bytes to `take`, possibly in several pieces; the views are valid during the call only. Returns
    /// false once CLOSE has arrived; bytes after it are ignored.
    bool feed(std::string_view bytes, const Take& take);

private:
    enum class State { Between, Word, Length, Payload, End, Skip, Closed };
    void takeOne(char c);

    State state_ = State::Between;
    std::string word_;     ///< word read so far, or the digits of a length
    std::size_t left_ = 0; ///< bytes of the payload still to come
};

} // namespace usar::server
