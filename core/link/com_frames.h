// What a robot says on a data link of the ComServer (usarsim-protocol 6.3): "SEND 5 hello;" and "CLOSE;".
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace usar::link {

/// Takes bytes in any chunks and gives the payload as it comes, so a message of any length needs no room. A payload may
/// hold any bytes; the one behind it is swallowed whatever it is. An unknown word is skipped to its semicolon.
class ComFrames {
public:
    using Take = std::function<void(std::string_view payload)>;

    /// False once CLOSE has been said; what comes behind it is not looked at.
    bool feed(std::string_view bytes, const Take& take);

private:
    enum class State { Between, Word, Length, Payload, End, Skip, Closed };
    void takeOne(char c);

    State state_ = State::Between;
    std::string word_; ///< or the digits of a length
    std::size_t left_ = 0;
};

} // namespace usar::link
